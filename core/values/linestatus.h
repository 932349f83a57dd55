#pragma once

#include "core/values/timing.h"

#include <QMetaType>
#include <QString>

#include <optional>

namespace gorizont {

enum class LineState : quint8 {
    Off, ///< On=0: never opened
    Opening, ///< before the first attempt
    Open, ///< polled
    OpenFailed, ///< cannot be opened; tried again every PReOpen
    Lost, ///< was open and went away, or does not take what is written; opened again after PClose
    Service, ///< open, polling suspended for a service dialog
};

/// What manual 000, section 4.4, shows of a port. Counters count from the start of the program.
struct LineStatus
{
    int port = 0; ///< LineConfig::index
    LineState state = LineState::Opening;
    std::optional<SteadyTime> openedAt; ///< while open
    std::optional<SteadyTime> pollingAt; ///< while polled without a break
    quint64 bytesSent = 0;
    quint64 bytesReceived = 0;
    quint64 failedOpens = 0;
    quint64 writeErrors = 0;
    quint64 readErrors = 0;
    quint64 crcErrors = 0;
    int lastErrorCode = 0; ///< QSerialPort::SerialPortError or QAbstractSocket::SocketError; 0: none so far
    QString lastError; ///< the system's sentence for it

    bool operator==(const LineStatus &) const = default;
};

} // namespace gorizont

Q_DECLARE_METATYPE(gorizont::LineStatus)
