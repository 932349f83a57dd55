#include "core/values/vibrationjson.h"

#include <QJsonArray>

namespace gorizont {

namespace {

template <typename T> QJsonValue valueOrNull(const std::optional<T> &value)
{
    return value ? QJsonValue(*value) : QJsonValue(QJsonValue::Null);
}

QJsonObject objectOf(const VibrationMeasurement &measurement)
{
    return {
        {QStringLiteral("index"), measurement.index},
        {QStringLiteral("type"), measurement.type},
        {QStringLiteral("value"), valueOrNull(measurement.value)},
        {QStringLiteral("percent"), valueOrNull(measurement.percent)},
        {QStringLiteral("fault"), valueOrNull(measurement.fault)},
        {QStringLiteral("warning"), valueOrNull(measurement.warning)},
        {QStringLiteral("stop"), valueOrNull(measurement.stop)},
        {QStringLiteral("baselineValid"), measurement.baseline.has_value()},
        {QStringLiteral("baselineExceeded"), measurement.isBaselineExceeded},
    };
}

QJsonObject objectOf(const VibrationChannel &channel)
{
    QJsonArray measurements;
    for (const VibrationMeasurement &measurement : channel.measurements) {
        measurements.append(objectOf(measurement));
    }
    return {
        {QStringLiteral("channel"), channel.channel},
        {QStringLiteral("state"), static_cast<int>(channel.state)},
        {QStringLiteral("measurements"), measurements},
    };
}

QJsonObject objectOf(const Relay &relay)
{
    return {
        {QStringLiteral("index"), relay.index},         {QStringLiteral("logical"), relay.isLogical},
        {QStringLiteral("physical"), relay.isPhysical}, {QStringLiteral("error"), relay.hasError},
        {QStringLiteral("enabled"), relay.isEnabled},
    };
}

template <typename T> QJsonArray arrayOf(const QList<T> &items)
{
    QJsonArray array;
    for (const T &item : items) {
        array.append(objectOf(item));
    }
    return array;
}

} // namespace

void insertVibration(QJsonObject &object, const Vibration &vibration)
{
    object.insert(QStringLiteral("channels"), arrayOf(vibration.channels));
    object.insert(QStringLiteral("relays"), arrayOf(vibration.relays));
}

} // namespace gorizont
