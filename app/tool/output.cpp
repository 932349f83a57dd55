#include "app/tool/output.h"

#include <QDateTime>
#include <QJsonDocument>

#include <cstdio>

namespace gorizont::tool {

namespace {

void printBytes(const QByteArray &line)
{
    std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stdout);
    std::fputc('\n', stdout);
    std::fflush(stdout);
}

} // namespace

void print(const QString &line)
{
    printBytes(line.toLocal8Bit());
}

void print(const QJsonObject &object)
{
    printBytes(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

void complain(const QString &sentence)
{
    std::fprintf(stderr, "gorizont-tool: %s\n", qPrintable(sentence));
}

QString fixed(double value, int decimals)
{
    return QString::number(value, 'f', decimals);
}

void insertNulls(QJsonObject &object, const QStringList &keys)
{
    for (const QString &key : keys) {
        object.insert(key, QJsonValue::Null);
    }
}

QString timestamp()
{
    return QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs);
}

} // namespace gorizont::tool
