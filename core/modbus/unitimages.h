#pragma once

#include "core/modbus/accelerationimage.h"
#include "core/modbus/modbusconfig.h"
#include "core/modbus/tiltimage.h"

namespace gorizont {

/// The registers of every unit. Pure; the only place that knows which unit is what.
class UnitImages
{
public:
    static constexpr int tiltUnit = 3;
    static constexpr int accelerationUnit = 6;

    explicit UnitImages(const ModbusConfig &config);

    /// The input registers of \a unit; nullptr: there is no such unit.
    const RegisterBlock *inputRegisters(int unit) const;

    void update(const Reading &reading);
    void updateLine(const LineStatus &status);

    /// Site numbers that found no room in one of the units, ascending.
    QList<int> unreachable() const;

private:
    UnitImages(const ModbusConfig &config, const SensorSlots &tilts, const SensorSlots &accelerations);
    void setChannels();

    QList<LineStatus> m_lines;
    TiltImage m_tilt;
    AccelerationImage m_acceleration;
    QList<int> m_unreachable;
};

} // namespace gorizont
