#include "core/mqtt/mqtttopics.h"

#include <algorithm>

namespace gorizont::mqtttopic {

QByteArray status()
{
    return QByteArrayLiteral("status");
}

QByteArray sensorReading(int number)
{
    return "sensor/" + QByteArray::number(number) + "/reading";
}

QByteArray sensorState(int number)
{
    return "sensor/" + QByteArray::number(number) + "/state";
}

QByteArray portState(int port)
{
    return "port/" + QByteArray::number(port) + "/state";
}

QByteArray under(const QString &prefix, const QByteArray &topic)
{
    return prefix.toUtf8() + '/' + topic;
}

QString level(const QString &name)
{
    QString text = name.trimmed();
    std::replace_if(
        text.begin(), text.end(),
        [](QChar c) { return c == u'/' || c == u'+' || c == u'#' || c == u'$' || c.isSpace() || !c.isPrint(); }, u'_');
    return text;
}

} // namespace gorizont::mqtttopic
