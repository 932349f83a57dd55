#pragma once

#include "core/values/timing.h"

#include <QHostAddress>
#include <QMetaType>

#include <optional>

namespace gorizont {

/// One connected client as the clients page shows it.
struct ClientInfo
{
    QHostAddress address;
    quint16 port = 0; ///< of the client; with the address it names the connection
    UtcTime since; ///< when it connected
    std::optional<UtcTime> lastRequest; ///< empty: none so far
    quint64 requests = 0; ///< answered
    quint64 errors = 0; ///< requests answered with an exception or not at all
    quint64 bytesReceived = 0;
    quint64 bytesSent = 0;

    bool operator==(const ClientInfo &) const = default;
};

} // namespace gorizont

Q_DECLARE_METATYPE(gorizont::ClientInfo)
