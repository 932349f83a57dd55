#include "ui/models/statetext.h"

#include "core/values/statustext.h"
#include "core/values/vibrationtext.h"

#include <QCoreApplication>
#include <QStringList>

namespace gorizont::statetext {

namespace {

/// The translation context of every state.
struct State
{
    Q_DECLARE_TR_FUNCTIONS(State)
};

/// What is wrong with the channels of a vibration module that works.
QStringList shortcomings(const Vibration &vibration)
{
    QStringList list{vibrationtext::lineFaults(vibration)};
    bool isWaiting = false;
    bool isRaised = false;
    for (const VibrationChannel &channel : vibration.channels) {
        isWaiting = isWaiting || (channel.isEnabled && channel.state == ChannelState::NoData);
        isRaised = isRaised || channel.isAnythingRaised();
    }
    list += isWaiting ? State::tr("a channel has no data") : QString();
    list += isRaised ? State::tr("fault, warning or stop of a measurement") : QString();
    list.removeAll(QString());
    return list;
}

/// What an answering sensor lacks, by the flags of its status word.
QStringList shortcomings(const SensorConfig &sensor, const Reading &reading)
{
    using namespace statusbit;
    const quint16 status = reading.status;
    QStringList list;
    if (reading.vibration) {
        list += shortcomings(*reading.vibration);
    }
    if (status & Rebooted && !isTiltValid(status)) {
        list += State::tr("restarted");
    }
    if (status & RingOverrun) {
        list += State::tr("samples were lost");
    }
    if (status & SyncError) {
        list += State::tr("samples do not follow each other");
    }
    if (sensor.measuresTilt && !isTiltValid(status)) {
        list += State::tr("tilt is not ready");
    }
    if (sensor.measuresTemperature && !isTemperatureValid(status)) {
        list += State::tr("temperature is not ready");
    }
    if (sensor.measuresAcceleration && !isAccelerationValid(status)) {
        list += State::tr("acceleration is not ready");
    }
    if (sensor.hasThermostat && (status & ThermostatUnsettled)) {
        list += State::tr("the thermostat has not settled");
    }
    return list;
}

} // namespace

QString line(LineState state)
{
    switch (state) {
    case LineState::Off: return State::tr("Off");
    case LineState::Opening: return State::tr("Opening");
    case LineState::Open: return State::tr("Open, polling");
    case LineState::OpenFailed: return State::tr("Cannot be opened");
    case LineState::Lost: return State::tr("Connection lost");
    case LineState::Service: return State::tr("Service mode, polling is suspended");
    }
    return {};
}

QString sensor(const SensorRegistry::Sensor &sensor, LineState line)
{
    const quint16 status = sensor.reading.status;
    if (sensor.config.type == SensorType::None) {
        return State::tr("Unknown type of sensor, not polled");
    }
    if (status & statusbit::NotPolled) {
        return State::tr("Polling is off");
    }
    switch (sensorHealth(sensor, line)) {
    case Health::Service: return State::tr("Service mode, polling is suspended");
    case Health::Unknown: return State::tr("Waiting for the first answer");
    case Health::Good: return State::tr("Answering");
    case Health::Warning:
        return State::tr("Answering: %1").arg(shortcomings(sensor.config, sensor.reading).join(QStringLiteral(", ")));
    case Health::Off:
    case Health::Error: break;
    }
    return statusText(sensor.reading);
}

QString health(Health health)
{
    switch (health) {
    case Health::Off: return State::tr("Off");
    case Health::Good: return State::tr("Everything works");
    case Health::Unknown: return State::tr("Starting");
    case Health::Service: return State::tr("Service mode");
    case Health::Warning: return State::tr("There are warnings");
    case Health::Error: return State::tr("There are errors");
    }
    return {};
}

QString sensorTitle(const SensorConfig &sensor)
{
    const QString model = sensor.model.isEmpty() ? sensor.name : modelInRussian(sensor.model);
    const QString place = sensor.place.isEmpty() ? QString() : QStringLiteral(" [%1]").arg(sensor.place);
    return QStringLiteral("%1 %2%3 [%4]")
        .arg(QString::number(sensor.number), model, place, QString::number(sensor.address));
}

QString counts(const HealthCounts &counts)
{
    QStringList parts{State::tr("Sensors good: %1").arg(counts[Health::Good])};
    const auto add = [&parts](const char *text, int count) {
        if (count > 0) {
            parts += State::tr(text).arg(count);
        }
    };
    add(QT_TRANSLATE_NOOP("State", "with errors: %1"), counts[Health::Error]);
    add(QT_TRANSLATE_NOOP("State", "with warnings: %1"), counts[Health::Warning]);
    add(QT_TRANSLATE_NOOP("State", "starting: %1"), counts[Health::Unknown]);
    add(QT_TRANSLATE_NOOP("State", "in service: %1"), counts[Health::Service]);
    add(QT_TRANSLATE_NOOP("State", "off: %1"), counts[Health::Off]);
    return parts.join(QStringLiteral(", "));
}

QString yesNo(bool isYes)
{
    return isYes ? State::tr("yes") : State::tr("no");
}

} // namespace gorizont::statetext
