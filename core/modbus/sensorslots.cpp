#include "core/modbus/sensorslots.h"

#include <algorithm>

namespace gorizont {

namespace {

struct Candidate
{
    int number = 0;
    quint16 word = 0;
};

QList<Candidate> membersByNumber(const QList<LineConfig> &lines, const StatusRules &rules, SensorSlots::Member member)
{
    QList<Candidate> members;
    for (const LineConfig &line : lines) {
        for (const SensorConfig &sensor : line.sensors) {
            if (sensor.*member) {
                members.append({sensor.number, initialSensorWord(line, sensor, rules)});
            }
        }
    }
    std::stable_sort(members.begin(), members.end(), [](const Candidate &a, const Candidate &b) {
        return a.number < b.number;
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
    const QList<Candidate> members = membersByNumber(lines, rules, member);
    const bool isByNumber = packing == ModbusPacking::ByNumber;
    const int wanted = isByNumber ? largestNumber(lines) : static_cast<int>(members.size());
    m_initialWords.fill(holeWord, std::min(wanted, limit));
    int next = 0;
    for (const Candidate &sensor : members) {
        const int slot = isByNumber ? sensor.number - 1 : next++;
        if (slot < 0 || slot >= count()) {
            m_unreachable.append(sensor.number);
        } else if (!m_slotOfNumber.contains(sensor.number)) {
            m_slotOfNumber.insert(sensor.number, slot);
            m_initialWords[slot] = sensor.word;
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
