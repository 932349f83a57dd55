#pragma once

#include "core/line/line.h"
#include "core/values/lineconfig.h"

#include <QSerialPort>

namespace gorizont {

/// A line on a serial port. Every error of the port but a time-out means that it is gone: it is closed at once, because
/// a vanished tty makes QSerialPort report errors without end (spec/traps.md, 4).
class SerialLine : public Line
{
public:
    SerialLine(const QString &device, const LineConfig &config, std::chrono::milliseconds pauseTick);
    ~SerialLine() override;

    Result<void> open() override;
    void close() override;
    bool isOpen() const override;
    std::optional<PortSettings> port() const override;
    Result<void> setPort(const PortSettings &port) override;

protected:
    Result<void> writeAll(QByteArrayView bytes, std::chrono::milliseconds timeout) override;
    Result<QByteArray> readSome(std::chrono::microseconds timeout) override;

private:
    bool configure(const PortSettings &port);
    bool isNodePresent() const;
    bool hasFailed() const;
    Fault closeBroken();

    QSerialPort m_port;
    const LineConfig m_config;
    PortSettings m_settings; ///< of now
};

} // namespace gorizont
