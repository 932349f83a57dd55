#pragma once

#include "core/values/series.h"

#include <QDate>
#include <QString>

#include <optional>

namespace gorizont {

/// Why there is no valid data. The numbers stand in archives: they are never given a second meaning.
enum class GapReason : quint8 {
    SensorOff = 1, ///< On=0 of the sensor
    PortOff = 2, ///< On=0 of its port
    PortError = 3, ///< the port cannot be opened, was lost, or does not take what is written
    NoAnswer = 4,
    Crc = 5,
    DeviceFault = 6, ///< the sensor answers that its values are not valid
    Service = 7, ///< the port was in a service dialog
    ProgramStopped = 8, ///< ended in an orderly way, was killed, or the computer was off
    Clock = 9, ///< the clock was set
    Disk = 10, ///< there was data, and it could not be written
};

/// A stretch without valid data of a sensor.
struct Gap
{
    int number = 0; ///< N, the sensor
    UtcTime from;
    std::optional<UtcTime> to; ///< empty: it goes on
    GapReason reason = GapReason::NoAnswer;
    QString filledFrom; ///< where the missing data came from afterwards; empty: it is missing
    bool operator==(const Gap &) const = default;
};

/// How much of a day is there.
struct DayCompleteness
{
    int number = 0; ///< N, the sensor
    QDate day; ///< local
    std::chrono::microseconds valid{0}; ///< with valid data, or with a filled gap
    std::chrono::microseconds length{0}; ///< of the day so far, since the sensor was first known
    bool operator==(const DayCompleteness &) const = default;

    double share() const
    {
        return length.count() > 0 ? static_cast<double>(valid.count()) / static_cast<double>(length.count()) : 0;
    }
};

} // namespace gorizont
