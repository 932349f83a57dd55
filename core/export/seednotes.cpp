#include "core/export/seednotes.h"

#include <QCoreApplication>
#include <QDateTime>

#include <algorithm>

namespace gorizont {

namespace {

QString sensorTitle(const ExportRequest &request, int number)
{
    const auto sensor = std::find_if(request.sensors.begin(), request.sensors.end(), [number](const SensorConfig &one) {
        return one.number == number;
    });
    const QString title = QString::number(number) + u' ' + sensor->model;
    return sensor->place.isEmpty() ? title : title + QStringLiteral(" [") + sensor->place + u']';
}

QString line(const ExportRequest &request, const SeedScale &scale, bool isX)
{
    const SeedCodes &codes = request.seed;
    const QStringList channel{
        codes.network, codes.station, seedLocation(scale.number), isX ? codes.channelX : codes.channelY};
    const auto ms = std::chrono::floor<std::chrono::milliseconds>(scale.from.time_since_epoch()).count();
    const QStringList fields{
        channel.join(u'.'),
        sensorTitle(request, scale.number),
        isX ? QStringLiteral("X") : QStringLiteral("Y"),
        QString::number(scale.rate),
        QString::number(scale.scale, 'g', 9),
        QDateTime::fromMSecsSinceEpoch(ms, Qt::UTC).toString(Qt::ISODateWithMs)};
    return fields.join(u'\t') + u'\n';
}

} // namespace

QByteArray seedNotes(const ExportRequest &request, const QList<SeedScale> &scales)
{
    QString text = QCoreApplication::translate(
                       "Export",
                       "The samples are in raw units of the device, along its own axes: neither turned nor inverted.\n"
                       "Acceleration, mm/s² = sample × scale.")
        + QStringLiteral("\n\n");
    const QStringList headings{QCoreApplication::translate("Export", "Channel"),
                               QCoreApplication::translate("Export", "Sensor"),
                               QCoreApplication::translate("Export", "Axis"),
                               QCoreApplication::translate("Export", "Samples a second"),
                               QCoreApplication::translate("Export", "Scale"),
                               QCoreApplication::translate("Export", "Since")};
    text += headings.join(u'\t') + u'\n';
    for (const SeedScale &scale : scales) {
        text += line(request, scale, true) + line(request, scale, false);
    }
    return text.toUtf8();
}

} // namespace gorizont
