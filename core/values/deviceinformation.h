#pragma once

#include <QMetaType>
#include <QString>

#include <optional>

namespace gorizont {

/// What a device says of itself when it is asked for more than its values (CanInfo=1). It comes seldom and bit by bit;
/// what has not come yet is empty.
struct DeviceInformation
{
    int number = 0; ///< N, the sensor
    QString firmware; ///< version, sub-version, build: `2.3.12`
    /// As the device gives them, without a unit: their description names none.
    std::optional<quint32> systemClock;
    std::optional<quint32> heaterPower;
    std::optional<quint32> fanPower;
    std::optional<quint32> innerTransducer; ///< its address and command
    std::optional<quint32> responseTime; ///< of the inner transducer
    bool operator==(const DeviceInformation &) const = default;
};

} // namespace gorizont

Q_DECLARE_METATYPE(gorizont::DeviceInformation)
