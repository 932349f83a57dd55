#include "core/export/csvtable.h"

#include "core/export/exportnames.h"
#include "core/values/sensortype.h"

#include <QCoreApplication>
#include <QDateTime>

#include <algorithm>
#include <cmath>

namespace gorizont {

namespace {

constexpr double arcSecondsOfADegree = 3600;
constexpr int digitsOfADegree = 4; ///< that it needs more than an arc-second

QList<CsvColumn> columnsOf(const ExportRequest &request)
{
    QList<CsvColumn> columns;
    for (const SeriesKey &key : exportedSeries(request)) {
        const auto sensor =
            std::find_if(request.sensors.begin(), request.sensors.end(), [&key](const SensorConfig &candidate) {
                return candidate.number == key.number;
            });
        columns << csvColumn(*sensor, key.quantity, request.format, request.every != ExportEvery::Reading);
    }
    return columns;
}

} // namespace

CsvColumn csvColumn(
    const SensorConfig &sensor, Quantity quantity, ExportFormat format, bool hasBounds, bool isInDegrees)
{
    const bool isRussian = format == ExportFormat::CsvRussian;
    const bool isTurned = isInDegrees && (quantity == Quantity::TiltX || quantity == Quantity::TiltY);
    const Quantity unit = isTurned ? Quantity::AccelDirection : quantity; // which is in degrees
    QString title = QString::number(sensor.number) + u' ' + (isRussian ? modelInRussian(sensor.model) : sensor.model);
    if (!sensor.place.isEmpty()) {
        title += QStringLiteral(" [") + sensor.place + u']';
    }
    if (isRussian) {
        title += u' ' + exportname::quantity(quantity) + QStringLiteral(", ") + exportname::unit(unit);
    } else {
        title += u' ' + exportname::key(quantity) + QStringLiteral(" (") + exportname::unitKey(unit) + u')';
    }
    const int decimals = exportname::decimals(quantity);
    return {title, isTurned ? 1 / arcSecondsOfADegree : 1, isTurned ? decimals + digitsOfADegree : decimals, hasBounds};
}

CsvTable::CsvTable(ExportFormat format, const QTimeZone &zone, const QList<CsvColumn> &columns)
    : m_isRussian(format == ExportFormat::CsvRussian)
    , m_zone(zone)
    , m_columns(columns)
{
}

CsvTable::CsvTable(const ExportRequest &request)
    : CsvTable(request.format, request.zone, columnsOf(request))
{
}

QByteArray CsvTable::header() const
{
    QByteArray line = m_isRussian ? QByteArrayLiteral("\xEF\xBB\xBF") : QByteArray();
    line += quoted(m_isRussian ? QCoreApplication::translate("Export", "Time") : QStringLiteral("time"));
    for (const CsvColumn &column : m_columns) {
        for (const QString &bound : bounds(column)) {
            line += (m_isRussian ? ';' : ',') + quoted(column.title + bound);
        }
    }
    return line + (m_isRussian ? "\r\n" : "\n");
}

QByteArray CsvTable::row(const SeriesRow &row) const
{
    const char separator = m_isRussian ? ';' : ',';
    QByteArray line = timeText(row.time);
    for (qsizetype i = 0; i < m_columns.size(); ++i) {
        const CsvColumn &column = m_columns.at(i);
        const std::optional<SeriesBucket> &cell = row.cells.at(i);
        if (!cell) { // most cells of most rows
            line.append(column.hasBounds ? 3 : 1, separator);
        } else if (column.hasBounds) {
            line += separator + number(cell->minimum, column) + separator + number(cell->mean, column) + separator
                + number(cell->maximum, column);
        } else {
            line += separator + number(cell->mean, column);
        }
    }
    return line + (m_isRussian ? "\r\n" : "\n");
}

/// What follows a title in each of its columns.
QStringList CsvTable::bounds(const CsvColumn &column) const
{
    if (!column.hasBounds) {
        return {QString()};
    }
    if (!m_isRussian) {
        return {QStringLiteral(" min"), QStringLiteral(" mean"), QStringLiteral(" max")};
    }
    return {
        QStringLiteral(", ") + QCoreApplication::translate("Export", "min"),
        QStringLiteral(", ") + QCoreApplication::translate("Export", "mean"),
        QStringLiteral(", ") + QCoreApplication::translate("Export", "max")};
}

QByteArray CsvTable::timeText(UtcTime time) const
{
    const auto ms = std::chrono::floor<std::chrono::milliseconds>(time.time_since_epoch()).count();
    if (!m_isRussian) {
        return QDateTime::fromMSecsSinceEpoch(ms, Qt::UTC).toString(Qt::ISODateWithMs).toLatin1();
    }
    const QDateTime local =
        m_zone.isValid() ? QDateTime::fromMSecsSinceEpoch(ms, m_zone) : QDateTime::fromMSecsSinceEpoch(ms);
    return local.toString(QStringLiteral("dd.MM.yyyy HH:mm:ss,zzz")).toLatin1();
}

QByteArray CsvTable::number(double value, const CsvColumn &column) const
{
    if (!std::isfinite(value)) {
        return {};
    }
    QByteArray text = QByteArray::number(value * column.scale, 'f', column.decimals);
    if (text.startsWith('-') && text.count('0') == text.size() - 2) {
        text.remove(0, 1); // -0.000
    }
    return m_isRussian ? text.replace('.', ',') : text;
}

QByteArray CsvTable::quoted(const QString &text) const
{
    const bool needsQuotes = std::any_of(text.begin(), text.end(), [this](QChar c) {
        return c == u'"' || c == u'\r' || c == u'\n' || c == (m_isRussian ? u';' : u',');
    });
    QString field = text;
    return (needsQuotes ? u'"' + field.replace(u'"', QStringLiteral("\"\"")) + u'"' : field).toUtf8();
}

} // namespace gorizont
