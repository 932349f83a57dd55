#pragma once

#include "core/line/line.h"

#include <QTcpSocket>

namespace gorizont {

/// A line through a serial device server in raw TCP mode, or to a device that speaks over TCP itself.
class TcpLine : public Line
{
public:
    TcpLine(const QString &host, quint16 port, std::chrono::milliseconds pauseTick);
    ~TcpLine() override;

    Result<void> open() override;
    void close() override;
    bool isOpen() const override;

protected:
    Result<void> writeAll(QByteArrayView bytes, std::chrono::milliseconds timeout) override;
    Result<QByteArray> readSome(std::chrono::microseconds timeout) override;

private:
    Fault closeBroken();

    QString m_host;
    quint16 m_port;
    QTcpSocket m_socket;
};

} // namespace gorizont
