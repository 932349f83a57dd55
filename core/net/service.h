#pragma once

#include "core/net/answers.h"

#include <QString>
#include <QStringList>

#include <chrono>

namespace gorizont {

/// What is offered at a desk: all that distinguishes one request-and-answer protocol from another.
struct Service
{
    QString name; ///< `Modbus TCP`, as sentences call it
    QString portKey; ///< `IPPort1`, the key of the ini that gives the port
    AnswerFunction answer;
    qint64 readLimit = 4096; ///< bytes a turn and client, at most ClientPeer::mostRead; bounds the answers of a turn
    /// A part of a request that is not continued for so long is dropped as a request of a wrong length; 0: never.
    std::chrono::milliseconds patience{0};
};

/// Who is served at a desk and for how long.
struct DeskConfig
{
    int clients = 64; ///< ModbusClients: connections at a time, 1…
    std::chrono::milliseconds idle{std::chrono::minutes(10)}; ///< ModbusIdle: without a request; 0: never cut off
    QString bind; ///< ModbusBind: address to listen on; empty: all, IPv4 and IPv6
    QStringList allow; ///< ModbusAllow: addresses and CIDR blocks; empty: everybody

    std::chrono::milliseconds retry{5000}; ///< between two attempts to take the port
    std::chrono::milliseconds stall{5000}; ///< a client with a full backlog that takes nothing for so long is dropped
    std::chrono::milliseconds acceptPause{1000}; ///< after a connection could not be accepted

    bool operator==(const DeskConfig &) const = default;
};

} // namespace gorizont
