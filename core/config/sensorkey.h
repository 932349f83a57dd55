#pragma once

#include <QString>

#include <optional>

namespace gorizont {

/// A key of the section of a port that belongs to one of its sensors: `adr12` is `adr` of sensor 12.
struct SensorKey
{
    QString name; ///< lower case, without the index
    int index = 0; ///< of the sensor within its port, 1…
    bool operator==(const SensorKey &) const = default;
};

/// Empty for the keys of the port itself. All digits at the end are the index, but that the name of `SND3` ends in one:
/// `SND31` is `SND3` of sensor 1, `SND310` that of sensor 10. An index with a leading zero is none.
std::optional<SensorKey> sensorKey(const QString &key);

} // namespace gorizont
