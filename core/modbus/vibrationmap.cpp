#include "core/modbus/vibrationmap.h"

#include <QtGlobal>

#include <algorithm>
#include <deque>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace gorizont {

namespace {

using namespace vibrationarea;
using Value = std::optional<double>;
using enum RegisterType;

constexpr int firstArea = 65000;
constexpr int areaStep = 500;
constexpr int mostAreas = 60;
constexpr double absent = std::numeric_limits<double>::quiet_NaN();
constexpr int noData = static_cast<int>(ChannelState::NoData);

static_assert(firstMeasurement + measurements * measurementStep <= channelStep);
static_assert(channels * channelStep <= relays && relays + 5 <= areaStep);

/// nullptr: not known now.
const VibrationChannel *channelOf(const SlotState &s, int channel)
{
    if (!s.isCurrent || !s.reading.vibration) {
        return nullptr;
    }
    const auto &known = s.reading.vibration->channels;
    const auto found = std::ranges::find(known, channel, &VibrationChannel::channel);
    return found != known.end() ? &*found : nullptr;
}

/// nullptr: not known now, or not in use.
const VibrationMeasurement *measurementOf(const SlotState &s, int channel, int index)
{
    const VibrationChannel *owner = channelOf(s, channel);
    if (owner == nullptr || !owner->isEnabled) {
        return nullptr;
    }
    const auto found = std::ranges::find(owner->measurements, index, &VibrationMeasurement::index);
    return found != owner->measurements.end() ? &*found : nullptr;
}

template <typename Thing> double word(std::span<const VibrationBit<Thing>> bits, const Thing *thing)
{
    unsigned result = 0;
    for (const VibrationBit<Thing> &bit : bits) {
        result |= thing != nullptr && bit.isSet(*thing) ? 1U << bit.bit : 0U;
    }
    return result;
}

template <int channel> Value state(const SlotState &s)
{
    const VibrationChannel *known = channelOf(s, channel);
    return known != nullptr && known->isEnabled ? static_cast<int>(known->state) : noData;
}
template <int channel> Value flagsOfChannel(const SlotState &s)
{
    return word(channelFlags(), channelOf(s, channel));
}
template <int channel> Value countInUse(const SlotState &s)
{
    const VibrationChannel *known = channelOf(s, channel);
    return known != nullptr && known->isEnabled ? static_cast<double>(known->measurements.size()) : 0;
}

template <int channel, int index> Value type(const SlotState &s)
{
    const VibrationMeasurement *known = measurementOf(s, channel, index);
    return known != nullptr ? known->type : 0;
}
template <int channel, int index> Value flags(const SlotState &s)
{
    return word(measurementFlags(), measurementOf(s, channel, index));
}
template <int channel, int index, Value VibrationMeasurement::*member> Value number(const SlotState &s)
{
    const VibrationMeasurement *known = measurementOf(s, channel, index);
    return known != nullptr ? (known->*member).value_or(absent) : absent;
}

bool hasRelays(const SlotState &s)
{
    return s.isCurrent && s.reading.vibration && !s.reading.vibration->relays.isEmpty();
}
Value areRelaysKnown(const SlotState &s)
{
    return hasRelays(s) ? 0xFF : 0;
}
template <bool Relay::*member> Value relayWord(const SlotState &s)
{
    unsigned result = 0;
    for (const Relay &relay : hasRelays(s) ? s.reading.vibration->relays : QList<Relay>()) {
        result |= relay.*member ? 1U << relay.index : 0U;
    }
    return result;
}

/// Builds the table: the same rows for every channel and every measurement, in ascending order of registers.
class Table
{
public:
    Table()
    {
        addChannels(std::make_integer_sequence<int, channels>());
        add(relays, UInt16, "relays_known", QT_TRANSLATE_NOOP("RegisterMap", "Relays: bit R: relay R is known"),
            areRelaysKnown);
        add(relays + 1, UInt16, "relays_logical",
            QT_TRANSLATE_NOOP("RegisterMap", "Relays: bit R: what the module has decided"),
            relayWord<&Relay::isLogical>);
        add(relays + 2, UInt16, "relays_physical",
            QT_TRANSLATE_NOOP("RegisterMap", "Relays: bit R: what the output shows"), relayWord<&Relay::isPhysical>);
        add(relays + 3, UInt16, "relays_error", QT_TRANSLATE_NOOP("RegisterMap", "Relays: bit R: error"),
            relayWord<&Relay::hasError>);
        add(relays + 4, UInt16, "relays_enabled", QT_TRANSLATE_NOOP("RegisterMap", "Relays: bit R: enabled"),
            relayWord<&Relay::isEnabled>);
    }

    std::span<const SlotField> fields() const { return m_fields; }

private:
    using Function = Value (*)(const SlotState &);

    void add(int offset, RegisterType type, const std::string &name, const char *meaning, Function value)
    {
        m_names.push_back(name);
        m_fields.push_back({offset, type, 1, m_names.back().c_str(), "", meaning, value});
    }

    template <int... channel> void addChannels(std::integer_sequence<int, channel...>) { (addChannel<channel>(), ...); }

    template <int channel> void addChannel()
    {
        const int at = channel * channelStep;
        const std::string name = "channel" + std::to_string(channel);
        add(at, UInt16, name + "_state",
            QT_TRANSLATE_NOOP(
                "RegisterMap",
                "Line to the sensor: 0 good, 1 shorted, 2 broken; 65535 no data, not in use or not known now"),
            state<channel>);
        add(at + 1, UInt16, name + "_flags", QT_TRANSLATE_NOOP("RegisterMap", "Flags of the channel"),
            flagsOfChannel<channel>);
        add(at + 2, UInt16, name + "_measurements",
            QT_TRANSLATE_NOOP("RegisterMap", "How many measurements are in use"), countInUse<channel>);
        addMeasurements<channel>(std::make_integer_sequence<int, measurements>());
    }

    template <int channel, int... index> void addMeasurements(std::integer_sequence<int, index...>)
    {
        (addMeasurement<channel, index>(), ...);
    }

    template <int channel, int index> void addMeasurement()
    {
        const int at = channel * channelStep + firstMeasurement + index * measurementStep;
        const std::string name = "channel" + std::to_string(channel) + "_m" + std::to_string(index);
        add(at, UInt16, name + "_type",
            QT_TRANSLATE_NOOP("RegisterMap", "Type of the measurement, 1…16; 0: not in use"), type<channel, index>);
        add(at + 1, UInt16, name + "_flags", QT_TRANSLATE_NOOP("RegisterMap", "Flags of the measurement"),
            flags<channel, index>);
        add(at + 2, Float32, name + "_value", QT_TRANSLATE_NOOP("RegisterMap", "Value in the unit of the type"),
            number<channel, index, &VibrationMeasurement::value>);
        add(at + 4, Float32, name + "_percent",
            QT_TRANSLATE_NOOP("RegisterMap", "Share of the scale, %; without PercentCode the code of the module"),
            number<channel, index, &VibrationMeasurement::percent>);
        add(at + 6, Float32, name + "_baseline",
            QT_TRANSLATE_NOOP("RegisterMap", "Baseline, as the share of the scale"),
            number<channel, index, &VibrationMeasurement::baseline>);
    }

    std::deque<std::string> m_names; // they stay where they are
    std::vector<SlotField> m_fields;
};

} // namespace

std::span<const VibrationBit<VibrationChannel>> channelFlags()
{
    static constexpr std::array<VibrationBit<VibrationChannel>, 3> bits{{
        {0, QT_TRANSLATE_NOOP("RegisterMap", "the channel is known now"),
         [](const VibrationChannel &) { return true; }},
        {1, QT_TRANSLATE_NOOP("RegisterMap", "it is in use"), [](const VibrationChannel &c) { return c.isEnabled; }},
        {2, QT_TRANSLATE_NOOP("RegisterMap", "the line to its sensor is shorted or broken"),
         [](const VibrationChannel &c) { return c.hasLineFault(); }},
    }};
    return bits;
}

std::span<const VibrationBit<VibrationMeasurement>> measurementFlags()
{
    using M = VibrationMeasurement;
    static constexpr std::array<VibrationBit<M>, 11> bits{{
        {0, QT_TRANSLATE_NOOP("RegisterMap", "the measurement is in use"), [](const M &) { return true; }},
        {1, QT_TRANSLATE_NOOP("RegisterMap", "its value is valid"), [](const M &m) { return m.value.has_value(); }},
        {2, QT_TRANSLATE_NOOP("RegisterMap", "its share of the scale is valid"),
         [](const M &m) { return m.percent.has_value(); }},
        {3, QT_TRANSLATE_NOOP("RegisterMap", "its baseline is valid"),
         [](const M &m) { return m.baseline.has_value(); }},
        {4, QT_TRANSLATE_NOOP("RegisterMap", "it is far from its baseline"),
         [](const M &m) { return m.isBaselineExceeded; }},
        {5, QT_TRANSLATE_NOOP("RegisterMap", "fault"), [](const M &m) { return m.fault.value_or(false); }},
        {6, QT_TRANSLATE_NOOP("RegisterMap", "warning"), [](const M &m) { return m.warning.value_or(false); }},
        {7, QT_TRANSLATE_NOOP("RegisterMap", "stop"), [](const M &m) { return m.stop.value_or(false); }},
        {8, QT_TRANSLATE_NOOP("RegisterMap", "the module knows whether there is a fault"),
         [](const M &m) { return m.fault.has_value(); }},
        {9, QT_TRANSLATE_NOOP("RegisterMap", "it knows whether there is a warning"),
         [](const M &m) { return m.warning.has_value(); }},
        {10, QT_TRANSLATE_NOOP("RegisterMap", "it knows whether there is a stop"),
         [](const M &m) { return m.stop.has_value(); }},
    }};
    return bits;
}

const AreaPart &vibrationAreas()
{
    static const Table table;
    static const AreaPart areas{
        QT_TRANSLATE_NOOP("RegisterMap", "Channels and relays of L-VIMS"),           firstArea,     areaStep, mostAreas,
        [](const SensorConfig &sensor) { return sensor.type == SensorType::LVims; }, table.fields()};
    return areas;
}

} // namespace gorizont
