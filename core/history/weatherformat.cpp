#include "core/history/weatherformat.h"

namespace gorizont {

namespace {

constexpr char tab = '\t';
constexpr int decimals = 2;

void appendWeather(QByteArray &record, const Weather &weather)
{
    constexpr int hexDigits = 8;
    record += tab + QByteArray::number(weather.digital, 16).rightJustified(hexDigits, '0').toUpper() + tab;
    if (!weather.events.isEmpty()) {
        const PrecipitationEvent &event = weather.events.first();
        record += QByteArray::number(event.isStart ? event.time : -event.time);
    }
    for (const WeatherParameter &parameter : weather.parameters) {
        record += tab + QString(parameter.code).toUtf8() + QByteArray::number(parameter.number);
        for (const auto &value :
             {parameter.mean, parameter.instant, parameter.minimum, parameter.maximum, parameter.maxPeriod,
              parameter.deviation}) {
            record += tab + historyField(value, decimals);
        }
    }
}

} // namespace

QByteArray weatherRecord(const QDateTime &local, const QByteArray &channels, const SensorColumns &station)
{
    QByteArray record = recordBeginning(local, channels) + tab + QByteArray::number(station.config.number) + tab
        + statusDigits(station.reading.status);
    if (station.reading.weather) {
        appendWeather(record, *station.reading.weather);
    } else {
        record += QByteArray(2, tab);
    }
    return record + "\r\n";
}

QByteArray weatherRecords(const QDateTime &local, const QByteArray &channels, const QList<SensorColumns> &sensors)
{
    QByteArray records;
    for (const SensorColumns &sensor : sensors) {
        if (sensor.config.measuresWeather) {
            records += weatherRecord(local, channels, sensor);
        }
    }
    return records;
}

} // namespace gorizont
