#pragma once

#include "core/values/timing.h"

#include <QHash>
#include <QHostAddress>
#include <QList>

namespace gorizont {

/// What may be told about a client beside its coming and going.
enum class ClientTrouble : quint8 {
    Refused, ///< not in ModbusAllow
    Malformed, ///< sent what makes the next request impossible to find
    Unanswered, ///< sent something that is no request, and stays
    Stalled, ///< asks and does not take the answers
    Idle, ///< connected and silent
    GaveWay, ///< was the longest idle when all places were taken
};

/// Decides what of the coming and going of clients is worth a line in the journal. Pure; the caller brings the clock.
/// Many SCADA systems connect, read and disconnect every second, so a client is its address and not its connection:
/// it is told when the address is first seen, and gone when it has stayed away for ten minutes; a trouble is told
/// once and again after ten minutes without it. The diary is bounded: while it is full, newcomers pass untold.
class ClientDiary
{
public:
    static constexpr std::chrono::minutes forgetAfter{10};
    static constexpr qsizetype capacity = 1024;

    struct Departure
    {
        QHostAddress address;
        SteadyTime left;
    };

    /// A connection came; true: tell it.
    bool arrives(const QHostAddress &address, SteadyTime now);
    /// A connection went.
    void leaves(const QHostAddress &address, SteadyTime now);
    /// Something happened with a client; true: tell it.
    bool isNews(ClientTrouble trouble, const QHostAddress &address, SteadyTime now);
    /// Those who have now been away for ten minutes: tell them. They are forgotten by this call.
    QList<Departure> departures(SteadyTime now);

private:
    struct Visit
    {
        int connections = 0;
        SteadyTime left;
    };

    QHash<QHostAddress, Visit> m_visits;
    QHash<std::pair<QHostAddress, int>, SteadyTime> m_troubles; ///< when last; int: a ClientTrouble
};

} // namespace gorizont
