#include "core/opc/opclines.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>

namespace gorizont::opclines {

using namespace Qt::Literals::StringLiterals;

namespace {

QByteArray lineOf(const QJsonObject &object)
{
    return QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n';
}

QJsonObject objectOf(const OpcTag &tag)
{
    QJsonObject object{{u"name"_s, tag.name}, {u"type"_s, opcTypeName(tag.type)}, {u"description"_s, tag.description}};
    if (!tag.aliases.isEmpty()) {
        object.insert(u"aliases"_s, QJsonArray::fromStringList(tag.aliases));
    }
    return object;
}

QByteArray textOf(const OpcValue &value)
{
    if (const bool *isSet = std::get_if<bool>(&value)) {
        return *isSet ? "true" : "false";
    }
    if (const double *number = std::get_if<double>(&value)) {
        return QByteArray::number(*number, 'g', QLocale::FloatingPointShortest);
    }
    return "null";
}

} // namespace

QByteArray hello(const QString &caption, const QList<OpcTag> &tags)
{
    return lineOf({
        {u"hello"_s, u"GorizontServer"_s},
        {u"protocol"_s, 1},
        {u"version"_s, QStringLiteral(GORIZONT_VERSION)},
        {u"caption"_s, caption},
        {u"hash"_s, QString::fromLatin1(opcTagsHash(tags))},
        {u"count"_s, tags.size()},
    });
}

QList<QByteArray> tagLines(const QList<OpcTag> &tags)
{
    QList<QByteArray> lines;
    QJsonArray array;
    for (const OpcTag &tag : tags) {
        array.append(objectOf(tag));
        if (array.size() == mostTags) {
            lines.append(lineOf({{u"tags"_s, array}}));
            array = {};
        }
    }
    if (!array.isEmpty()) {
        lines.append(lineOf({{u"tags"_s, array}}));
    }
    return lines;
}

QByteArray ready()
{
    return QByteArrayLiteral("{\"ready\":true}\n");
}

QByteArray ping()
{
    return QByteArrayLiteral("{\"ping\":true}\n");
}

QByteArray end()
{
    return QByteArrayLiteral("{\"end\":true}\n");
}

QByteArray beginValues()
{
    return QByteArrayLiteral("{\"v\":[");
}

void appendValue(QByteArray &line, int index, const OpcSample &sample)
{
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(sample.time.time_since_epoch());
    if (!line.endsWith('[')) {
        line += ',';
    }
    line += '[' + QByteArray::number(index) + ',' + textOf(sample.value) + ','
        + QByteArray::number(static_cast<int>(sample.quality)) + ',' + QByteArray::number(qint64{ms.count()}) + ']';
}

void endValues(QByteArray &line)
{
    line += "]}\n";
}

std::optional<Greeting> greeting(QByteArrayView line)
{
    const QJsonObject object = QJsonDocument::fromJson(line.toByteArray()).object();
    const QJsonValue client = object.value(u"client"_s);
    if (!client.isString()) {
        return std::nullopt;
    }
    return Greeting{
        client.toString(), object.value(u"version"_s).toString(), object.value(u"pid"_s).toInteger(),
        object.value(u"registered"_s).toString().toLatin1()};
}

} // namespace gorizont::opclines
