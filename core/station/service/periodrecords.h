#pragma once

#include "core/station/service/stationplan.h"
#include "core/values/weather.h"

#include <QDateTime>

#include <optional>
#include <vector>

namespace gorizont::station {

/// The database of a station: a text file a month for each object, `2026_11_obj007.txt`, UTF-8, tabs between the columns:
///
///     ;time⇥T01⇥T01 min⇥T01 max⇥P01⇥…⇥digital␊
///     2026-11-28 18:30:00⇥-5.31⇥-5.40⇥-5.22⇥742.1⇥…⇥00000003␊
///
/// Means, minima and maxima at the end of each period by the clock of the station, as ACK.PAR formats them (without padding), a dash
/// where there is none, the digital inputs in hexadecimal. The line with the names stands at the head and again where the
/// columns change. Pure.
namespace periodrecords {

QString fileName(qint64 clock, int object);

/// The line with the names, with its line feed.
QByteArray heading(const QList<WeatherParameter> &parameters);
/// One record, with its line feed. \a formats: one for each parameter.
QByteArray record(
    qint64 clock, const QList<WeatherParameter> &parameters, const QList<OutputFormat> &formats, quint32 digital);

/// SAFE: raw values of one second, a file a day: `2026_11_28_raw.txt`.
QString safeFileName(qint64 clock);
QByteArray safeHeading(const QList<ParameterConfig> &parameters);
QByteArray safeRecord(qint64 clock, const std::vector<std::optional<double>> &raw);

} // namespace periodrecords

/// When the records of a period are due by the clock of the station. Pure.
class PeriodTurn
{
public:
    explicit PeriodTurn(std::chrono::seconds period)
        : m_period(period.count())
    {
    }

    /// The end of a period that has come with \a clock, aligned to the clock; empty: none. When the clock was set back the
    /// period that begins there goes on without a record; the first call only looks at the clock.
    std::optional<qint64> due(qint64 clock);

private:
    qint64 m_period; ///< s
    std::optional<qint64> m_last; ///< number of the period
};

} // namespace gorizont::station
