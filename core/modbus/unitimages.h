#pragma once

#include "core/modbus/modbusconfig.h"
#include "core/modbus/unitimage.h"

#include <vector>

namespace gorizont {

/// Sensors that some units have no room for.
struct UnreachableSensors
{
    QList<int> numbers; ///< site numbers, ascending
    QList<int> units; ///< ascending

    bool isEmpty() const { return numbers.isEmpty(); }
    QString sentence() const; ///< for the journal
};

/// The registers of every unit. One thread; the only place that knows which units there are.
class UnitImages
{
public:
    static constexpr int tiltUnit = 3;

    explicit UnitImages(const ModbusConfig &config);

    const std::vector<UnitImage> &units() const { return m_images; }
    /// nullptr: there is no such unit.
    const UnitImage *unit(int unit) const;
    /// The input registers of \a unit, with the clocks as they were at its last change; nullptr: there is no such unit.
    const RegisterBlock *inputRegisters(int unit) const;

    void update(const Reading &reading);
    void updateLine(const LineStatus &status);

    const UnreachableSensors &unreachable() const { return m_unreachable; }

private:
    void setChannels();

    QList<LineStatus> m_lines;
    std::vector<UnitImage> m_images;
    UnreachableSensors m_unreachable;
};

} // namespace gorizont
