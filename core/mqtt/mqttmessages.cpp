#include "core/mqtt/mqttmessages.h"

#include "core/values/readingjson.h"
#include "core/values/statusword.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace gorizont::mqttmessage {

namespace {

QString stateName(LineState state)
{
    switch (state) {
    case LineState::Off: return QStringLiteral("off");
    case LineState::Opening: return QStringLiteral("opening");
    case LineState::Open: return QStringLiteral("open");
    case LineState::OpenFailed: return QStringLiteral("openFailed");
    case LineState::Lost: return QStringLiteral("lost");
    case LineState::Service: return QStringLiteral("service");
    }
    return {};
}

QByteArray compact(const QJsonObject &object)
{
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

} // namespace

QByteArray reading(const QByteArray &json, quint64 sequence)
{
    return json.chopped(1) + ",\"seq\":" + QByteArray::number(sequence) + '}';
}

QByteArray sensorState(const Reading &reading, const SensorConfig &sensor, const LineConfig &line)
{
    return compact({
        {QStringLiteral("time"), isoTime(reading.time)},
        {QStringLiteral("number"), reading.number},
        {QStringLiteral("name"), sensor.name},
        {QStringLiteral("place"), sensor.place},
        {QStringLiteral("type"), sensor.model},
        {QStringLiteral("port"), line.title()},
        {QStringLiteral("address"), sensor.address},
        {QStringLiteral("status"), reading.status},
        {QStringLiteral("code"), static_cast<int>(statusCode(reading.status))},
    });
}

QByteArray portState(UtcTime time, const LineStatus &status, const LineConfig &line)
{
    QJsonObject object{
        {QStringLiteral("time"), isoTime(time)},
        {QStringLiteral("port"), line.title()},
        {QStringLiteral("index"), line.index},
        {QStringLiteral("name"), line.name},
        {QStringLiteral("state"), stateName(status.state)},
    };
    if (status.state == LineState::OpenFailed || status.state == LineState::Lost) {
        object.insert(QStringLiteral("error"), status.lastError);
    }
    return compact(object);
}

} // namespace gorizont::mqttmessage
