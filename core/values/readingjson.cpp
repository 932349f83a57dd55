#include "core/values/readingjson.h"

#include "core/values/statusword.h"
#include "core/values/vibrationjson.h"
#include "core/values/weatherjson.h"

#include <QDateTime>
#include <QJsonDocument>
#include <QJsonObject>

namespace gorizont {

namespace {

void insertValues(QJsonObject &object, const Reading &reading)
{
    if (reading.tilt && isTiltValid(reading.status)) {
        object.insert(QStringLiteral("tiltX"), reading.tilt->x);
        object.insert(QStringLiteral("tiltY"), reading.tilt->y);
    }
    if (reading.variation && isTiltValid(reading.status)) {
        object.insert(QStringLiteral("variationX"), reading.variation->x);
        object.insert(QStringLiteral("variationY"), reading.variation->y);
    }
    if (reading.temperature && isTemperatureValid(reading.status)) {
        object.insert(QStringLiteral("temperature"), *reading.temperature);
    }
    if (reading.heaterPower) {
        object.insert(QStringLiteral("heaterPower"), *reading.heaterPower);
    }
    if (reading.fanFrequency) {
        object.insert(QStringLiteral("fanFrequency"), *reading.fanFrequency);
    }
    if (reading.acceleration && isAccelerationValid(reading.status)) {
        object.insert(QStringLiteral("accelMax"), reading.acceleration->maximum);
        object.insert(QStringLiteral("accelDirection"), reading.acceleration->direction);
        object.insert(QStringLiteral("accelRmsX"), reading.acceleration->rmsX);
        object.insert(QStringLiteral("accelRmsY"), reading.acceleration->rmsY);
    }
    if (reading.displacement) {
        object.insert(QStringLiteral("linkX"), reading.displacement->own.x);
        object.insert(QStringLiteral("linkY"), reading.displacement->own.y);
        if (const auto &sum = reading.displacement->sum) {
            object.insert(QStringLiteral("displacementX"), sum->x);
            object.insert(QStringLiteral("displacementY"), sum->y);
        }
    }
    if (reading.rawStatus) {
        object.insert(QStringLiteral("rawStatus"), *reading.rawStatus);
    }
    if (reading.vibration) {
        insertVibration(object, *reading.vibration);
    }
    if (reading.weather) {
        insertWeather(object, *reading.weather);
    }
}

} // namespace

QString isoTime(UtcTime time)
{
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch());
    return QDateTime::fromMSecsSinceEpoch(ms.count(), Qt::UTC).toString(Qt::ISODateWithMs);
}

QByteArray readingToJson(const Reading &reading, const SensorConfig &sensor, const LineConfig &line)
{
    QJsonObject object{
        {QStringLiteral("time"), isoTime(reading.time)}, {QStringLiteral("number"), reading.number},
        {QStringLiteral("name"), sensor.name},           {QStringLiteral("type"), sensor.model},
        {QStringLiteral("port"), line.title()},          {QStringLiteral("address"), sensor.address},
        {QStringLiteral("status"), reading.status},
    };
    if (reading.isAnswer) {
        insertValues(object, reading);
    }
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

} // namespace gorizont
