#include "core/modbus/sensorslots.h"

#include <algorithm>

namespace gorizont {

namespace {

QList<SensorSlot> membersByNumber(const QList<LineConfig> &lines, const StatusRules &rules, SensorSlots::Member member)
{
    QList<SensorSlot> members;
    for (const LineConfig &line : lines) {
        for (const SensorConfig &sensor : line.sensors) {
            if (member == nullptr || sensor.*member) {
                members.append({sensor, line.isOn, initialSensorWord(line, sensor, rules)});
            }
        }
    }
    std::stable_sort(members.begin(), members.end(), [](const SensorSlot &a, const SensorSlot &b) {
        return a.sensor.number < b.sensor.number;
    });
    return members;
}

int largestNumber(const QList<LineConfig> &lines)
{
    int largest = 0;
    for (const LineConfig &line : lines) {
        for (const SensorConfig &sensor : line.sensors) {
            largest = std::max(largest, sensor.number);
        }
    }
    return largest;
}

} // namespace

SensorSlots::SensorSlots(
    const QList<LineConfig> &lines, const StatusRules &rules, Member member, ModbusPacking packing, int limit)
{
    const QList<SensorSlot> members = membersByNumber(lines, rules, member);
    const bool isByNumber = packing == ModbusPacking::ByNumber;
    const int wanted = isByNumber ? largestNumber(lines) : static_cast<int>(members.size());
    m_slots.resize(std::min(wanted, limit));
    int next = 0;
    for (const SensorSlot &candidate : members) {
        const int number = candidate.sensor.number;
        const int slot = isByNumber ? number - 1 : next++;
        if (slot < 0 || slot >= count()) {
            m_unreachable.append(number);
        } else if (!m_slotOfNumber.contains(number)) {
            m_slotOfNumber.insert(number, slot);
            m_slots[slot] = candidate;
        }
        // Of two sensors with one number only the first is polled; the slot of the second stays a hole.
    }
}

std::optional<int> SensorSlots::slotOf(int number) const
{
    const auto found = m_slotOfNumber.constFind(number);
    return found == m_slotOfNumber.constEnd() ? std::nullopt : std::optional(*found);
}

} // namespace gorizont
