#include "core/export/csvtable.h"

#include "core/export/exportnames.h"
#include "core/values/sensortype.h"

#include <QCoreApplication>
#include <QDateTime>

#include <algorithm>
#include <cmath>

namespace gorizont {

CsvTable::CsvTable(const ExportRequest &request)
    : m_request(request)
    , m_keys(exportedSeries(request))
    , m_isRussian(request.format == ExportFormat::CsvRussian)
{
}

QByteArray CsvTable::header() const
{
    QByteArray line = m_isRussian ? QByteArrayLiteral("\xEF\xBB\xBF") : QByteArray();
    line += quoted(m_isRussian ? QCoreApplication::translate("Export", "Time") : QStringLiteral("time"));
    for (const SeriesKey &key : m_keys) {
        const QString title = columnTitle(key);
        for (const QString &bound : bounds()) {
            line += (m_isRussian ? ';' : ',') + quoted(title + bound);
        }
    }
    return line + (m_isRussian ? "\r\n" : "\n");
}

QByteArray CsvTable::row(const SeriesRow &row) const
{
    const char separator = m_isRussian ? ';' : ',';
    const qsizetype fields = m_request.every == ExportEvery::Reading ? 1 : 3;
    QByteArray line = timeText(row.time);
    for (qsizetype i = 0; i < m_keys.size(); ++i) {
        const std::optional<SeriesBucket> &cell = row.cells.at(i);
        if (!cell) { // most cells of most rows
            line.append(fields, separator);
            continue;
        }
        const int decimals = exportname::decimals(m_keys.at(i).quantity);
        if (fields == 1) {
            line += separator + number(cell->mean, decimals);
        } else {
            line += separator + number(cell->minimum, decimals) + separator + number(cell->mean, decimals) + separator
                + number(cell->maximum, decimals);
        }
    }
    return line + (m_isRussian ? "\r\n" : "\n");
}

/// What follows the title of a series in each of its columns.
QStringList CsvTable::bounds() const
{
    if (m_request.every == ExportEvery::Reading) {
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

QString CsvTable::columnTitle(const SeriesKey &key) const
{
    const auto sensor =
        std::find_if(m_request.sensors.begin(), m_request.sensors.end(), [&key](const SensorConfig &candidate) {
            return candidate.number == key.number;
        });
    QString title = QString::number(key.number) + u' ' + (m_isRussian ? modelInRussian(sensor->model) : sensor->model);
    if (!sensor->place.isEmpty()) {
        title += QStringLiteral(" [") + sensor->place + u']';
    }
    if (m_isRussian) {
        return title + u' ' + exportname::quantity(key.quantity) + QStringLiteral(", ")
            + exportname::unit(key.quantity);
    }
    return title + u' ' + exportname::key(key.quantity) + QStringLiteral(" (") + exportname::unitKey(key.quantity)
        + u')';
}

QByteArray CsvTable::timeText(UtcTime time) const
{
    const auto ms = std::chrono::floor<std::chrono::milliseconds>(time.time_since_epoch()).count();
    if (!m_isRussian) {
        return QDateTime::fromMSecsSinceEpoch(ms, Qt::UTC).toString(Qt::ISODateWithMs).toLatin1();
    }
    const QDateTime local = m_request.zone.isValid() ? QDateTime::fromMSecsSinceEpoch(ms, m_request.zone)
                                                     : QDateTime::fromMSecsSinceEpoch(ms);
    return local.toString(QStringLiteral("dd.MM.yyyy HH:mm:ss.zzz")).toLatin1();
}

QByteArray CsvTable::number(double value, int decimals) const
{
    if (!std::isfinite(value)) {
        return {};
    }
    QByteArray text = QByteArray::number(value, 'f', decimals);
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
