#include "core/alarms/alarmtext.h"

#include "core/values/statustext.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <numeric>

namespace gorizont::alarmtext {

namespace {

/// The translation context of the messages.
struct AlarmText
{
    Q_DECLARE_TR_FUNCTIONS(AlarmText)
};

constexpr qsizetype namedInNotice = 3;

QString portMeaning(const Alarm &alarm)
{
    switch (alarm.line) {
    case LineState::OpenFailed: return AlarmText::tr("The port cannot be opened");
    case LineState::Lost: return AlarmText::tr("The connection to the port is lost");
    default: return statusText(alarm.code);
    }
}

QString portAdvice(LineState line)
{
    switch (line) {
    case LineState::Off: return AlarmText::tr("Switch the port on in the configuration file.");
    case LineState::OpenFailed:
        return AlarmText::tr("Check that the adapter is plugged in and powered, and the number of the port.");
    default:
        return AlarmText::tr("Check the adapter, its cable and its power. The program opens the port again by itself.");
    }
}

} // namespace

QString subject(const Alarm &alarm)
{
    return alarm.place.isEmpty() ? alarm.title : QStringLiteral("%1, %2").arg(alarm.title, alarm.place);
}

QString meaning(const Alarm &alarm)
{
    return alarm.isWholePort()
        ? AlarmText::tr("%1; sensors without data: %2").arg(portMeaning(alarm)).arg(alarm.sensors)
        : alarm.cause.isEmpty() ? statusText(alarm.code)
                                : alarm.cause;
}

QString advice(const Alarm &alarm)
{
    if (alarm.isWholePort()) {
        return portAdvice(alarm.line);
    }
    switch (alarm.code) {
    case StatusCode::NoAnswer: return AlarmText::tr("Check the power of the sensor, its cable and its address.");
    case StatusCode::CrcErrors:
        return AlarmText::tr("Check the terminating resistor and the cable for interference, and that no two sensors "
                             "have the same address.");
    case StatusCode::TransducerSilent:
        if (alarm.type == SensorType::Mk14) {
            return AlarmText::tr(
                "Check the power supply of the weather station: none of its values is good without it.");
        }
        if (alarm.type == SensorType::LVims) {
            return AlarmText::tr(
                "Check the cable and the connectors from the module to the sensors of these channels. A "
                "channel without a sensor can be switched off in the settings of the module.");
        }
        return AlarmText::tr("Check the supply voltage and the cable of the transducer, restart the sensor. If that "
                             "does not help, it needs repair.");
    case StatusCode::TransducerCrc: return AlarmText::tr("Restart the sensor. If that does not help, it needs repair.");
    case StatusCode::TransducerRange:
        return AlarmText::tr(
            "Look at the structure and at how the sensor is fixed: it is inclined or moves beyond what "
            "it can measure.");
    case StatusCode::TemperatureSensor:
        return AlarmText::tr("The sensor goes on without a temperature. Plan its repair.");
    case StatusCode::TemperatureRange:
        return AlarmText::tr("Check the temperature at the sensor. If it is usual, the sensor needs repair.");
    case StatusCode::Fan:
        return AlarmText::tr("Check the fan of the thermostat: dirt, ice, its cable. The readings may drift.");
    case StatusCode::Thermostat:
        return AlarmText::tr(
            "Check the heating and the cover of the sensor: it may be too cold there. The readings may "
            "drift.");
    case StatusCode::Good:
    case StatusCode::PortOff:
    case StatusCode::PortError: break;
    }
    return AlarmText::tr("Look at the status word of the sensor.");
}

QString sentence(const Alarm &alarm)
{
    return QStringLiteral("%1: %2").arg(subject(alarm), meaning(alarm));
}

QString sensorsNeedAttention(const Alarms &alarms)
{
    const int sensors = std::accumulate(alarms.begin(), alarms.end(), 0, [](int sum, const Alarm &alarm) {
        return sum + alarm.sensors;
    });
    return AlarmText::tr("%n sensor(s) need attention", nullptr, sensors);
}

Notice notice(const Alarms &alarms)
{
    if (alarms.size() == 1) {
        const Alarm &alarm = alarms.first();
        return {subject(alarm), QStringLiteral("%1.\n%2").arg(meaning(alarm), advice(alarm))};
    }
    QStringList lines;
    for (qsizetype i = 0; i < std::min(namedInNotice, alarms.size()); ++i) {
        lines += sentence(alarms.at(alarms.size() - 1 - i));
    }
    if (alarms.size() > namedInNotice) {
        lines += AlarmText::tr("and more: %1").arg(alarms.size() - namedInNotice);
    }
    return {sensorsNeedAttention(alarms), lines.join(u'\n')};
}

} // namespace gorizont::alarmtext
