#include "core/values/statustext.h"

#include <QCoreApplication>

namespace gorizont {

namespace {

QString translate(const char *text)
{
    return QCoreApplication::translate("gorizont::StatusText", text);
}

} // namespace

QString statusText(StatusCode code)
{
    switch (code) {
    case StatusCode::Good: return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "works normally"));
    case StatusCode::PortOff: return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "its port is switched off"));
    case StatusCode::PortError: return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "its port has failed"));
    case StatusCode::NoAnswer: return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "does not answer"));
    case StatusCode::CrcErrors:
        return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "answers with wrong check sums"));
    case StatusCode::TransducerSilent:
        return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "its transducer does not answer"));
    case StatusCode::TransducerCrc:
        return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "its transducer sends wrong check sums"));
    case StatusCode::TransducerRange:
        return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "its transducer is out of range"));
    case StatusCode::TemperatureSensor:
        return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "its temperature sensor does not work"));
    case StatusCode::TemperatureRange:
        return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "its temperature is out of range"));
    case StatusCode::Fan: return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "its fan does not turn"));
    case StatusCode::Thermostat:
        return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "its thermostat takes too long to settle"));
    }
    return {};
}

QString lineStateText(LineState state)
{
    switch (state) {
    case LineState::Off: return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "switched off"));
    case LineState::Opening: return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "opening"));
    case LineState::Open: return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "open"));
    case LineState::OpenFailed: return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "cannot be opened"));
    case LineState::Lost: return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "connection lost"));
    case LineState::Service: return translate(QT_TRANSLATE_NOOP("gorizont::StatusText", "service"));
    }
    return {};
}

QString sensorTitle(const SensorConfig &sensor, const LineConfig &line)
{
    return QCoreApplication::translate("gorizont::StatusText", "%1 No. %2 (%3, address %4)")
        .arg(modelInRussian(sensor.model))
        .arg(sensor.number)
        .arg(line.title())
        .arg(sensor.address);
}

} // namespace gorizont
