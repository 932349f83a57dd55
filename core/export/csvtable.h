#pragma once

#include "core/export/seriesrows.h"

namespace gorizont {

/// The text of a table of values. Pure, and the same in every locale.
///
///     CsvRussian, UTF-8 with BOM, CRLF, clock on the wall      CsvIso, UTF-8, LF, UTC
///     Время;1 АН-Д3 [Этаж 2] Наклон X, угл. с                  time,1 AN-D3 [Этаж 2] tilt-x (arcsec)
///     07.02.2018 18:33:03.250;-264,000                         2018-02-07T15:33:03.250Z,-264.000
///
/// Minutes, hours and days have three columns for each series: minimum, mean, maximum.
class CsvTable
{
public:
    explicit CsvTable(const ExportRequest &request);

    QByteArray header() const;
    /// \a row has a cell for each of exportedSeries().
    QByteArray row(const SeriesRow &row) const;

private:
    QString columnTitle(const SeriesKey &key) const;
    QStringList bounds() const;
    QByteArray timeText(UtcTime time) const;
    QByteArray number(double value, int decimals) const;
    QByteArray quoted(const QString &text) const;

    const ExportRequest m_request;
    const QList<SeriesKey> m_keys;
    const bool m_isRussian;
};

} // namespace gorizont
