#include "core/opc/opctags.h"

#include "core/opc/opcfields.h"
#include "core/values/statustext.h"

#include <QCryptographicHash>
#include <QSet>

namespace gorizont {

using namespace Qt::Literals::StringLiterals;

QList<OpcField> opcFields(const SensorConfig &sensor, const QList<WeatherParameter> &weather)
{
    switch (sensor.type) {
    case SensorType::None: return {};
    case SensorType::InD:
    case SensorType::AnD3:
    case SensorType::UsmIsn: return opcfield::ofTilt(sensor);
    case SensorType::LVims: return opcfield::ofVibration();
    case SensorType::Mk14: return opcfield::ofWeather(weather);
    }
    return {};
}

QString opcBranch(const LineConfig &line, const SensorConfig &sensor)
{
    return u"[%1].Sensor_%2[%3][Addr:%4]"_s.arg(line.title())
        .arg(sensor.number, 3, 10, QLatin1Char('0'))
        .arg(QString(sensor.model).remove(u'-'))
        .arg(sensor.address, 3, 10, QLatin1Char('0'));
}

QString opcTypeName(OpcType type)
{
    return type == OpcType::Bool ? u"bool"_s : u"double"_s;
}

QList<OpcTag> opcTags(const QList<LineConfig> &lines, const OpcWeather &weather)
{
    QList<OpcTag> tags;
    QSet<QString> names; // a list of parameters may name one twice
    for (const LineConfig &line : lines) {
        for (const SensorConfig &sensor : line.sensors) {
            const QString branch = opcBranch(line, sensor) + u'.';
            const QString title = sensorTitle(sensor, line) + u": "_s;
            const auto known = weather.constFind(sensor.number);
            const auto parameters = known != weather.cend() ? *known : weatherParameters(sensor);
            for (const OpcField &field : opcFields(sensor, parameters)) {
                const QString name = branch + field.path;
                if (names.contains(name)) {
                    continue;
                }
                names.insert(name);
                const QStringList aliases = field.alias.isEmpty() ? QStringList() : QStringList{branch + field.alias};
                tags.append({name, aliases, title + field.description, field.type, sensor.number, field.read});
            }
        }
    }
    return tags;
}

QByteArray opcTagsHash(const QList<OpcTag> &tags)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (const OpcTag &tag : tags) {
        hash.addData((tag.name + u'\t' + opcTypeName(tag.type) + u'\n').toUtf8());
    }
    return hash.result().toHex();
}

QByteArray opcTagList(const QList<OpcTag> &tags)
{
    QByteArray list;
    for (const OpcTag &tag : tags) {
        list += (tag.name + u'\t' + opcTypeName(tag.type) + u'\t' + tag.description + u'\n').toUtf8();
    }
    return list;
}

} // namespace gorizont
