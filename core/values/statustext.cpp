#include "core/values/statustext.h"

#include "core/values/vibrationtext.h"

#include <QCoreApplication>

namespace gorizont {

namespace {

class StatusText
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::StatusText)
};

} // namespace

QString statusText(StatusCode code)
{
    switch (code) {
    case StatusCode::Good: return StatusText::tr("No errors");
    case StatusCode::PortOff: return StatusText::tr("The port is off");
    case StatusCode::PortError: return StatusText::tr("Port error");
    case StatusCode::NoAnswer: return StatusText::tr("No answer");
    case StatusCode::CrcErrors: return StatusText::tr("CRC errors");
    case StatusCode::TransducerSilent: return StatusText::tr("The transducer does not answer");
    case StatusCode::TransducerCrc: return StatusText::tr("CRC errors of the transducer");
    case StatusCode::TransducerRange: return StatusText::tr("The transducer is out of range");
    case StatusCode::TemperatureSensor: return StatusText::tr("The temperature sensor does not work");
    case StatusCode::TemperatureRange: return StatusText::tr("The temperature sensor is out of range");
    case StatusCode::Fan: return StatusText::tr("The fan does not work");
    case StatusCode::Thermostat: return StatusText::tr("The thermostat takes too long to settle");
    }
    return StatusText::tr("Unknown error");
}

QString causeText(const Reading &reading)
{
    if (statusCode(reading.status) != StatusCode::TransducerSilent) {
        return {};
    }
    if (reading.weather) {
        return StatusText::tr("The supply voltage of the station's sensors is bad");
    }
    return reading.vibration ? vibrationtext::lineFaults(*reading.vibration) : QString();
}

QString statusText(const Reading &reading)
{
    const QString cause = causeText(reading);
    return cause.isEmpty() ? statusText(statusCode(reading.status)) : cause;
}

QString sensorTitle(const SensorConfig &sensor, const LineConfig &line)
{
    return StatusText::tr("%1 No. %2 (%3, address %4)")
        .arg(modelInRussian(sensor.model))
        .arg(sensor.number)
        .arg(line.title())
        .arg(sensor.address);
}

} // namespace gorizont
