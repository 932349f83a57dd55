#pragma once

#include "core/station/service/door.h"
#include "core/values/lineconfig.h"

#include <QObject>
#include <QSerialPort>
#include <QTimer>

namespace gorizont::station {

/// A serial line to a dispatcher. Lives in the thread of the station, never waits. A port that cannot be opened, or is gone, is
/// tried again every few seconds; it is said once, and once when it is back.
class SerialDoor : public QObject
{
    Q_OBJECT

public:
    /// \a device: a path of the system, or COMn.
    SerialDoor(const QString &device, const LineConfig &config, Answerer answerer, QObject *parent = nullptr);
    ~SerialDoor() override;

    void open();
    bool isOpen() const { return m_port.isOpen(); }

Q_SIGNALS:
    /// Whether dispatchers can be heard; \a text is a sentence for the journal.
    void stateChanged(bool isOpen, const QString &text);

private:
    void onBytes();
    void onError();
    void checkNode();
    void close(const QString &why);
    bool configure();
    bool isNodePresent() const;

    const LineConfig m_config;
    Answerer m_answerer;
    RequestListener m_listener;
    QSerialPort m_port;
    QTimer m_watch{this}; ///< of the node while open, of the next attempt else
    bool m_isTold = false; ///< that the port is closed
};

} // namespace gorizont::station
