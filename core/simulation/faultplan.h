#pragma once

#include <QList>
#include <QString>

#include <chrono>
#include <optional>

namespace gorizont {

/// What goes wrong in a simulation, and when. Written as `KIND=VALUE[@FROM[-TO]]`, times in seconds since the start:
///
///     silent=N      the sensor with site number N does not answer
///     crc=P         P % of the answers have a wrong byte
///     garbage=P     P % of the answers come after garbage
///     pieces=P      P % of the answers come in pieces
///     late=P        P % of the answers come 1.5 s late
///     reboot=N      the sensor N restarts, once at FROM
///     overrun=N     the ring of the sensor N is overwritten, once at FROM
///     gone=n:S      the port COMn is gone for S seconds, once at FROM
struct SimulatedFault
{
    enum class Kind : quint8 { Silent, Crc, Garbage, Pieces, Late, Reboot, Overrun, Gone };
    using Time = std::chrono::microseconds; ///< since the start of the simulation

    Kind kind = Kind::Silent;
    double value = 0; ///< sensor number, port number or per cent
    Time length{0}; ///< of Gone
    Time from{0};
    Time to = Time::max();

    bool isActive(Time now) const { return now >= from && now < to; }
    bool operator==(const SimulatedFault &) const = default;
};

/// Empty when \a text is not of the form above.
std::optional<SimulatedFault> parseSimulatedFault(const QString &text);

using FaultPlan = QList<SimulatedFault>;

} // namespace gorizont
