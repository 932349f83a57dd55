#include "core/modbus/unitimage.h"

#include <algorithm>
#include <cstring>

namespace gorizont {

namespace {

template <typename State> bool hasClock(std::span<const RegisterField<State>> fields)
{
    return std::ranges::any_of(fields, [](const auto &field) { return field.clock != nullptr; });
}

bool anyClocks(const UnitLayout &layout)
{
    return hasClock(layout.head)
        || std::ranges::any_of(layout.parts, [](const SlotPart &part) { return hasClock(part.fields); });
}

/// A copy of \a count registers, the first of which has index \a first in the block.
struct Excerpt
{
    char *bytes;
    int first;
    int count;

    bool touches(int index, int registers) const { return index < first + count && index + registers > first; }

    void write(int index, QByteArrayView value) const
    {
        const int end = 2 * (first + count);
        for (int i = 0; i < value.size(); ++i) {
            const int at = 2 * index + i;
            if (at >= 2 * first && at < end) {
                bytes[at - 2 * first] = value[i];
            }
        }
    }
};

template <typename State>
void writeClockFields(
    const Excerpt &excerpt, RegisterOrder order, std::span<const RegisterField<State>> fields, int start,
    const State &state, const Moment &now)
{
    for (const RegisterField<State> &field : fields) {
        const int index = start + field.offset;
        if (field.clock != nullptr && excerpt.touches(index, registerCount(field.type))) {
            excerpt.write(index, RegisterBytes(field.clock(state, now), field.scale, field.type, order).view());
        }
    }
}

} // namespace

int UnitLayout::limit(int base, int areaCount) const
{
    const int room = areaCount > 0 ? areas->start(areaCount - 1) : RegisterBlock::addressSpace - base;
    int most = RegisterBlock::addressSpace;
    for (auto part = parts.begin(); part != parts.end(); ++part) {
        const int end = std::next(part) == parts.end() ? room : std::next(part)->start;
        most = std::min(most, (end - part->start) / part->stride);
    }
    return most;
}

int UnitLayout::areaCount(const QList<LineConfig> &lines) const
{
    int count = 0;
    for (const LineConfig &line : lines) {
        for (const SensorConfig &sensor : line.sensors) {
            count += areas != nullptr && areas->has(sensor) ? 1 : 0;
        }
    }
    return areas != nullptr ? std::min(count, areas->most) : 0;
}

UnitImage::UnitImage(const UnitLayout &layout, int configuredBase, const SensorSlots &slotMap, int areaCount)
    : m_layout(&layout)
    , m_slots(slotMap)
    , m_block(layout.base(configuredBase), layout.size(slotMap.count(), areaCount))
    , m_hasClocks(anyClocks(layout))
{
    const Moment now = clocks();
    m_head.slotCount = m_slots.count();
    int given = 0;
    m_states.reserve(static_cast<std::size_t>(m_slots.count()));
    for (int slot = 0; slot < m_slots.count(); ++slot) {
        m_states.emplace_back(m_slots.at(slot));
        if (given < areaCount && layout.areas->has(m_slots.at(slot).sensor)) {
            m_states.back().areaAt = m_block.base() + layout.areas->start(given++);
        }
        m_head.count(m_states.back(), 1);
        writeSlot(slot, now);
    }
    writeHead(now);
}

Moment UnitImage::clocks() const
{
    return m_hasClocks ? Moment::now() : Moment();
}

template <typename State>
void UnitImage::writeFields(
    std::span<const RegisterField<State>> fields, int start, const State &state, const Moment &now)
{
    for (const RegisterField<State> &field : fields) {
        const std::optional<double> value = field.clock != nullptr ? field.clock(state, now) : field.value(state);
        if (value) {
            m_block.write(start + field.offset, RegisterBytes(*value, field.scale, field.type, m_layout->order).view());
        }
    }
}

void UnitImage::writeHead(const Moment &now)
{
    writeFields(m_layout->head, 0, m_head, now);
}

void UnitImage::writeSlot(int slot, const Moment &now)
{
    const SlotState &state = m_states[static_cast<std::size_t>(slot)];
    for (const SlotPart &part : m_layout->parts) {
        writeFields(part.fields, part.start + part.stride * slot, state, now);
    }
    if (state.areaAt != 0) {
        writeFields(m_layout->areas->fields, state.areaAt - m_block.base(), state, now);
    }
}

void UnitImage::setChannels(quint32 word)
{
    m_head.channels = word;
    writeHead(clocks());
}

void UnitImage::update(const Reading &reading)
{
    const std::optional<int> slot = m_slots.slotOf(reading.number);
    if (!slot) {
        return;
    }
    SlotState &state = m_states[static_cast<std::size_t>(*slot)];
    m_head.count(state, -1);
    state.take(reading);
    m_head.count(state, 1);
    const Moment now = clocks();
    writeSlot(*slot, now);
    writeHead(now);
}

void UnitImage::writeClocks(char *registers, int address, int count, const Moment &now) const
{
    const Excerpt excerpt{registers, address - m_block.base(), count};
    writeClockFields(excerpt, m_layout->order, m_layout->head, 0, m_head, now);
    for (const SlotPart &part : m_layout->parts) {
        const int first = std::max(0, (excerpt.first - part.start) / part.stride);
        const int last = (excerpt.first + count - 1 - part.start) / part.stride;
        for (int slot = first; slot <= last && slot < m_slots.count(); ++slot) {
            writeClockFields(
                excerpt, m_layout->order, part.fields, part.start + part.stride * slot,
                m_states[static_cast<std::size_t>(slot)], now);
        }
    }
}

} // namespace gorizont
