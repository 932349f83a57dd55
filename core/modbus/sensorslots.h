#pragma once

#include "core/config/serverconfig.h"
#include "core/values/statusword.h"

#include <QHash>
#include <QList>

#include <optional>

namespace gorizont {

/// One place in the block of a unit and the sensor it belongs to.
struct SensorSlot
{
    /// A hole is zeros that say "not polled, nothing valid".
    static constexpr quint16 holeWord = 0x0F00;

    SensorConfig sensor; ///< number 0: a hole
    bool isPortOn = false;
    quint16 initialWord = holeWord; ///< the status word before anything was polled

    bool isHole() const { return sensor.number == 0; }
};

/// Which sensor stands in which slot of the block of one unit (spec/gorizont.md, section 6). Pure; fixed for a run, so
/// that addresses never move.
///   ByType    the sensors of the unit in ascending N, switched-off ones included, without holes;
///   ByNumber  slot N − 1 is site number N in every unit, up to the largest N of all; the rest are holes.
class SensorSlots
{
public:
    /// Whether a sensor belongs to the unit; nullptr: every sensor does.
    using Member = bool SensorConfig::*;

    /// \a limit is how many slots the address space has room for.
    SensorSlots(
        const QList<LineConfig> &lines, const StatusRules &rules, Member member, ModbusPacking packing, int limit);

    int count() const { return static_cast<int>(m_slots.size()); }
    const SensorSlot &at(int slot) const { return m_slots.at(slot); }
    /// 0…count() − 1; empty: this sensor is not in the unit.
    std::optional<int> slotOf(int number) const;
    /// Site numbers that found no room below register 65536, ascending.
    const QList<int> &unreachable() const { return m_unreachable; }

private:
    QHash<int, int> m_slotOfNumber;
    QList<SensorSlot> m_slots;
    QList<int> m_unreachable;
};

} // namespace gorizont
