#pragma once

#include "core/export/seriesrows.h"

namespace gorizont {

/// What stands below one title of a table.
struct CsvColumn
{
    QString title; ///< with the unit
    double scale = 1; ///< written = value × scale
    int decimals = 3; ///< digits after the decimal mark
    bool hasBounds = false; ///< three columns: minimum, mean, maximum
};

/// `1 АН-Д3 [Этаж 2] Наклон X, угл. с`, or `1 AN-D3 [Этаж 2] tilt-x (arcsec)`. \a isInDegrees: what is kept in
/// arc-seconds is written in degrees.
CsvColumn csvColumn(
    const SensorConfig &sensor, Quantity quantity, ExportFormat format, bool hasBounds, bool isInDegrees = false);

/// The text of a table of values, the only one of the program: whoever writes CSV writes this. Pure, and the same in
/// every locale.
///
///     CsvRussian, UTF-8 with BOM, CRLF, clock on the wall      CsvIso, UTF-8, LF, UTC
///     Время;1 АН-Д3 [Этаж 2] Наклон X, угл. с                  time,1 AN-D3 [Этаж 2] tilt-x (arcsec)
///     07.02.2018 18:33:03,250;-264,000                         2018-02-07T15:33:03.250Z,-264.000
///
/// The decimal comma of Russian settings is that of the seconds too: with a point a sheet takes the moment for a text.
class CsvTable
{
public:
    /// \a format is one of the two above; \a zone: of the clock on the wall, invalid: that of the computer.
    CsvTable(ExportFormat format, const QTimeZone &zone, const QList<CsvColumn> &columns);
    /// Minutes, hours and days have three columns for each series.
    explicit CsvTable(const ExportRequest &request);

    QByteArray header() const;
    /// \a row has a cell for each column.
    QByteArray row(const SeriesRow &row) const;

private:
    QStringList bounds(const CsvColumn &column) const;
    QByteArray timeText(UtcTime time) const;
    QByteArray number(double value, const CsvColumn &column) const;
    QByteArray quoted(const QString &text) const;

    const bool m_isRussian;
    const QTimeZone m_zone;
    const QList<CsvColumn> m_columns;
};

} // namespace gorizont
