// L-VIMS: four channels of eight measurements, eight relays (manual 003), numbered from 0 as everywhere.

#include "core/opc/opcfields.h"

#include <QCoreApplication>

#include <algorithm>

namespace gorizont {

namespace {

using namespace Qt::Literals::StringLiterals;

constexpr int channels = 4;
constexpr int measurements = 8;
constexpr int relays = 8;

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(OpcTags)
};

constexpr OpcFieldValue outOfService{{}, OpcQuality::OutOfService};

template <typename T> OpcValue valueOf(const std::optional<T> &value)
{
    return value ? OpcValue(*value) : OpcValue();
}

/// What \a read makes of a channel; one that is switched off is out of service.
template <typename Read> auto onChannel(int index, Read read)
{
    return [index, read](const Reading &reading) -> OpcFieldValue {
        if (!reading.vibration) {
            return {};
        }
        const auto &all = reading.vibration->channels;
        const auto channel = std::ranges::find(all, index, &VibrationChannel::channel);
        return channel != all.end() && channel->isEnabled ? read(*channel) : outOfService;
    };
}

/// What \a read makes of a measurement; one that is not in use is out of service.
template <typename Read> auto onMeasurement(int channel, int index, Read read)
{
    return onChannel(channel, [index, read](const VibrationChannel &known) -> OpcFieldValue {
        const auto found = std::ranges::find(known.measurements, index, &VibrationMeasurement::index);
        return found != known.measurements.end() ? read(known, *found) : outOfService;
    });
}

template <typename Read> auto onRelay(int index, Read read)
{
    return [index, read](const Reading &reading) -> OpcFieldValue {
        if (!reading.vibration) {
            return {};
        }
        const auto &all = reading.vibration->relays;
        const auto relay = std::ranges::find(all, index, &Relay::index);
        return relay != all.end() && relay->isEnabled ? OpcFieldValue{read(*relay)} : outOfService;
    };
}

OpcFieldValue stateIs(const VibrationChannel &channel, ChannelState state)
{
    if (channel.state == ChannelState::NoData) {
        return {{}, OpcQuality::WaitingForInitialData};
    }
    return {channel.state == state};
}

/// A value of a channel whose line is shorted or broken is none.
OpcFieldValue measured(const VibrationChannel &channel, const std::optional<double> &value)
{
    switch (channel.state) {
    case ChannelState::Good: break;
    case ChannelState::NoData: return {valueOf(value), OpcQuality::WaitingForInitialData};
    default: return {valueOf(value), OpcQuality::SensorFailure};
    }
    return {valueOf(value), value ? OpcQuality::Good : OpcQuality::SensorFailure};
}

/// Empty: the module does not know (yet).
OpcFieldValue flag(const std::optional<bool> &value)
{
    return {valueOf(value), value ? OpcQuality::Good : OpcQuality::WaitingForInitialData};
}

using Read = std::function<OpcFieldValue(const Reading &)>;

OpcField field(const QString &path, OpcType type, const QString &description, Read read)
{
    return {path, {}, description, type, std::move(read)};
}

QList<OpcField> stateOfChannel(int c)
{
    using Measurement = VibrationMeasurement;
    const QString path = u"STATE.Channel_%1."_s.arg(c);
    const QString title = Text::tr("channel %1: ").arg(c);
    QList<OpcField> fields{
        field(
            path + u"ShortCircuit"_s, OpcType::Bool, title + Text::tr("short circuit of the sensor line"),
            onChannel(c, [](const auto &channel) { return stateIs(channel, ChannelState::ShortCircuit); })),
        field(
            path + u"Break"_s, OpcType::Bool, title + Text::tr("break of the sensor line"),
            onChannel(c, [](const auto &channel) { return stateIs(channel, ChannelState::Break); })),
    };
    for (int m = 0; m < measurements; ++m) {
        const QString leaf = path + u"Meas_%1."_s.arg(m);
        const QString name = title + Text::tr("measurement %1: ").arg(m);
        fields.append(field(
            leaf + u"Fault"_s, OpcType::Bool, name + Text::tr("fault"),
            onMeasurement(c, m, [](const auto &, const Measurement &known) { return flag(known.fault); })));
        fields.append(field(
            leaf + u"Warning"_s, OpcType::Bool, name + Text::tr("warning"),
            onMeasurement(c, m, [](const auto &, const Measurement &known) { return flag(known.warning); })));
        fields.append(field(
            leaf + u"Stop"_s, OpcType::Bool, name + Text::tr("emergency stop"),
            onMeasurement(c, m, [](const auto &, const Measurement &known) { return flag(known.stop); })));
        fields.append(field(
            leaf + u"Baseline"_s, OpcType::Bool, name + Text::tr("the baseline is exceeded"),
            onMeasurement(c, m, [](const auto &, const Measurement &known) {
                return known.baseline ? OpcFieldValue{known.isBaselineExceeded} : outOfService;
            })));
    }
    return fields;
}

QList<OpcField> stateOfRelay(int r)
{
    const QString path = u"STATE.Relay_%1."_s.arg(r);
    const QString title = Text::tr("relay %1: ").arg(r);
    return {
        field(
            path + u"Logical"_s, OpcType::Bool, title + Text::tr("logical state"),
            onRelay(r, [](const Relay &relay) { return relay.isLogical; })),
        field(
            path + u"Physical"_s, OpcType::Bool, title + Text::tr("physical state"),
            onRelay(r, [](const Relay &relay) { return relay.isPhysical; })),
        field(
            path + u"Error"_s, OpcType::Bool, title + Text::tr("error"),
            onRelay(r, [](const Relay &relay) { return relay.hasError; })),
    };
}

QList<OpcField> dataOfChannel(int c)
{
    using Measurement = VibrationMeasurement;
    QList<OpcField> fields;
    for (int m = 0; m < measurements; ++m) {
        const QString leaf = u"DATA.Channel_%1.Meas_%2."_s.arg(c).arg(m);
        const QString name = Text::tr("channel %1: ").arg(c) + Text::tr("measurement %1: ").arg(m);
        fields.append(field(
            leaf + u"Type"_s, OpcType::Double, name + Text::tr("its type, MEAS_TYPE"),
            onMeasurement(c, m, [](const auto &, const Measurement &known) {
                return OpcFieldValue{static_cast<double>(known.type)};
            })));
        fields.append(field(
            leaf + u"Value"_s, OpcType::Double, name + Text::tr("value in the unit of the type"),
            onMeasurement(c, m, [](const auto &channel, const Measurement &known) {
                return measured(channel, known.value);
            })));
        fields.append(field(
            leaf + u"Percent"_s, OpcType::Double, name + Text::tr("percent of the scale"),
            onMeasurement(c, m, [](const auto &channel, const Measurement &known) {
                return measured(channel, known.percent);
            })));
    }
    return fields;
}

} // namespace

namespace opcfield {

QList<OpcField> ofVibration()
{
    QList<OpcField> fields;
    for (int channel = 0; channel < channels; ++channel) {
        fields += stateOfChannel(channel);
    }
    for (int relay = 0; relay < relays; ++relay) {
        fields += stateOfRelay(relay);
    }
    for (int channel = 0; channel < channels; ++channel) {
        fields += dataOfChannel(channel);
    }
    return fields;
}

} // namespace opcfield

} // namespace gorizont
