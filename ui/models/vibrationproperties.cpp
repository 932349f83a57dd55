#include "ui/models/vibrationproperties.h"

#include "core/values/vibrationkinds.h"
#include "core/values/vibrationtext.h"
#include "ui/models/valuetext.h"

#include <QCoreApplication>

namespace gorizont {

namespace {

/// The translation context of the rows.
struct VibrationPage
{
    Q_DECLARE_TR_FUNCTIONS(VibrationPage)
};

/// The module says codes of a scale that it keeps to itself: they are per cent only where the ini says what 100 % is.
QString share(const SensorConfig &config, const std::optional<double> &percent)
{
    if (!percent) {
        return valuetext::absent();
    }
    return config.options.contains(QStringLiteral("percentcode"))
        ? VibrationPage::tr("%1 %").arg(QString::number(*percent, 'f', 1))
        : VibrationPage::tr("code %1").arg(QString::number(*percent, 'f', 0));
}

QString nameOf(const VibrationMeasurement &measurement)
{
    const QString name = measurementName(measurement.type);
    return VibrationPage::tr("%1: type %2 %3").arg(measurement.index).arg(measurement.type).arg(name).trimmed();
}

QString valueOf(const SensorConfig &config, const MeasurementUnits &units, const VibrationMeasurement &measurement)
{
    QStringList parts{
        measurement.value ? QStringLiteral("%1 %2")
                                .arg(vibrationtext::number(*measurement.value), units.of(measurement.type))
                                .trimmed()
                          : valuetext::absent(),
        share(config, measurement.percent)};
    for (const QString &words : {vibrationtext::raised(measurement), vibrationtext::unknown(measurement)}) {
        if (!words.isEmpty()) {
            parts.append(words);
        }
    }
    if (measurement.baseline) {
        parts.append(VibrationPage::tr("baseline %1").arg(share(config, measurement.baseline)));
    }
    return parts.join(QStringLiteral("; "));
}

Health healthOf(const VibrationChannel &channel)
{
    if (!channel.isEnabled) {
        return Health::Off;
    }
    switch (channel.state) {
    case ChannelState::Good: return Health::Good;
    case ChannelState::NoData: return Health::Unknown;
    case ChannelState::ShortCircuit:
    case ChannelState::Break: break;
    }
    return Health::Error;
}

QString relayValue(const Relay &relay)
{
    QStringList parts{
        relay.isEnabled ? VibrationPage::tr("enabled") : VibrationPage::tr("off"),
        VibrationPage::tr("logical %1").arg(relay.isLogical ? 1 : 0),
        VibrationPage::tr("physical %1").arg(relay.isPhysical ? 1 : 0)};
    if (relay.hasError) {
        parts.append(VibrationPage::tr("error"));
    }
    return parts.join(QStringLiteral("; "));
}

/// \a isKnown: the module answers; otherwise the rows stay and say nothing, so that the page does not jump.
void addChannel(Properties &rows, const SensorConfig &config, const VibrationChannel &channel, bool isKnown)
{
    rows.append(Property::section(VibrationPage::tr("Channel %1").arg(channel.channel)));
    Property state{
        VibrationPage::tr("State of the channel"), isKnown ? vibrationtext::stateText(channel) : valuetext::absent(),
        VibrationPage::tr("state of the line to the sensor of the channel")};
    state.health = isKnown ? healthOf(channel) : Health::Unknown;
    rows.append(state);
    const MeasurementUnits units(config);
    for (const VibrationMeasurement &measurement : channel.measurements) {
        Property row{
            nameOf(measurement), isKnown ? valueOf(config, units, measurement) : valuetext::absent(),
            VibrationPage::tr("value; share of the scale; what is raised (with a question mark: the module does not "
                              "know it); the baseline, if it is valid")};
        if (isKnown && measurement.isRaised()) {
            row.health = Health::Warning;
        }
        rows.append(row);
    }
}

} // namespace

Properties vibrationProperties(const SensorRegistry::Sensor &sensor)
{
    if (!sensor.reading.vibration) {
        return {};
    }
    const bool isKnown = validVibration(sensor.reading).has_value();
    Properties rows;
    for (const VibrationChannel &channel : sensor.reading.vibration->channels) {
        addChannel(rows, sensor.config, channel, isKnown);
    }
    rows.append(Property::section(VibrationPage::tr("Relays")));
    for (const Relay &relay : sensor.reading.vibration->relays) {
        Property row{
            VibrationPage::tr("Relay %1").arg(relay.index), isKnown ? relayValue(relay) : valuetext::absent(),
            VibrationPage::tr("what the module has decided (logical), what its output shows (physical)")};
        if (isKnown && relay.hasError) {
            row.health = Health::Error;
        }
        rows.append(row);
    }
    return rows;
}

QString vibrationSummary(const Reading &reading)
{
    QStringList lines;
    const auto vibration = validVibration(reading);
    for (const VibrationChannel &channel : vibration ? vibration->channels : QList<VibrationChannel>()) {
        lines.append(VibrationPage::tr("channel %1: %2").arg(channel.channel).arg(vibrationtext::stateText(channel)));
    }
    return lines.join(u'\n');
}

} // namespace gorizont
