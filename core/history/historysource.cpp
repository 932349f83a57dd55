#include "core/history/historysource.h"

#include "core/history/monthfiles.h"
#include "core/history/monthrecords.h"
#include "core/history/samplerecords.h"
#include "core/history/seriesbuilder.h"

#include <QPromise>
#include <QThreadPool>

#include <algorithm>
#include <memory>
#include <vector>

namespace gorizont {

namespace {

enum class Kind : quint8 { Data, Acceleration, Samples };

Kind kindOf(Quantity quantity)
{
    switch (quantity) {
    case Quantity::TiltX:
    case Quantity::TiltY:
    case Quantity::Temperature:
    case Quantity::HeaterPower: return Kind::Data;
    case Quantity::SampleX:
    case Quantity::SampleY: return Kind::Samples;
    default: return Kind::Acceleration;
    }
}

MonthFile fileOf(Kind kind)
{
    return kind == Kind::Data ? MonthFile::Data : MonthFile::Acceleration;
}

using Answer = QPromise<QList<Series>>;

/// One curve that is being read.
struct Wanted
{
    SeriesKey key;
    qsizetype group = -1; ///< of a record
    std::optional<SeriesBuilder> builder;
};

void takeRow(UtcTime time, const HistoryRow &row, Kind kind, std::vector<Wanted> &wanted)
{
    for (Wanted &curve : wanted) {
        const std::optional<HistoryGroup> group = row.group(curve.group);
        if (!group) {
            curve.builder->add(time, std::nullopt);
            continue;
        }
        const Reading reading = kind == Kind::Data ? tiltReading(*group) : accelerationReading(*group);
        curve.builder->add(time, valueOf(reading, curve.key.quantity));
    }
}

void readMonths(
    const HistoryFolder &folder, const SeriesQuery &query, Kind kind, std::vector<Wanted> &wanted, const Answer &answer)
{
    const QList<int> columns = historyColumns(folder.sensors, fileOf(kind));
    for (Wanted &curve : wanted) {
        curve.group = columns.indexOf(curve.key.number);
    }
    for (const QString &path : monthFiles(folder.path, fileOf(kind))) {
        const MonthRecords records(path, folder.zone);
        const std::optional<UtcTime> first = records.first();
        const std::optional<UtcTime> last = records.last();
        if (!first || !last || *first >= query.to || *last < query.from || records.groups() != columns.size()) {
            continue;
        }
        for (Wanted &curve : wanted) {
            if (!curve.builder) {
                const std::chrono::microseconds period = records.period();
                curve.builder.emplace(curve.key, period, stepFor(query.to - query.from, query.width, period));
            }
        }
        records.read(query.from, query.to, [&](UtcTime time, const HistoryRow &row) {
            takeRow(time, row, kind, wanted);
            return !answer.isCanceled();
        });
    }
}

void answerQuery(const HistoryFolder &folder, const SeriesQuery &query, Answer &answer)
{
    QList<Series> all(query.keys.size());
    for (const Kind kind : {Kind::Data, Kind::Acceleration, Kind::Samples}) {
        std::vector<Wanted> wanted;
        for (const SeriesKey &key : query.keys) {
            if (kindOf(key.quantity) == kind) {
                wanted.push_back({key, -1, {}});
            }
        }
        if (wanted.empty()) {
            continue;
        }
        if (kind == Kind::Samples) {
            const SampleRecords records(folder.path + QStringLiteral("/Bin"), folder.zone, folder.gravity);
            const std::chrono::microseconds step = stepFor(query.to - query.from, query.width, SampleRecords::period);
            for (Wanted &curve : wanted) {
                curve.builder.emplace(curve.key, SampleRecords::period, step);
                records.read(curve.key, query.from, query.to, [&](UtcTime time, double value) {
                    curve.builder->add(time, value);
                    return !answer.isCanceled();
                });
            }
        } else {
            readMonths(folder, query, kind, wanted, answer);
        }
        for (Wanted &curve : wanted) {
            const Series series = curve.builder ? curve.builder->take(query.from, query.to)
                                                : Series{curve.key, {}, {}, {{query.from, query.to}}};
            all[query.keys.indexOf(curve.key)] = series;
        }
    }
    answer.addResult(all);
}

void widen(std::optional<TimeSpan> &span, UtcTime from, UtcTime to)
{
    span = span ? TimeSpan{std::min(span->from, from), std::max(span->to, to)} : TimeSpan{from, to};
}

} // namespace

HistoryOverview overviewOf(const HistoryFolder &folder)
{
    HistoryOverview overview;
    for (const Kind kind : {Kind::Data, Kind::Acceleration}) {
        const qsizetype groups = historyColumns(folder.sensors, fileOf(kind)).size();
        for (const QString &path : monthFiles(folder.path, fileOf(kind))) {
            const MonthRecords records(path, folder.zone);
            const std::optional<UtcTime> first = records.first();
            const std::optional<UtcTime> last = records.last();
            if (!first || !last) {
                continue;
            }
            if (records.groups() == groups) {
                widen(overview.span, *first, *last);
            } else {
                ++overview.foreign;
            }
        }
    }
    const SampleRecords samples(folder.path + QStringLiteral("/Bin"), folder.zone, folder.gravity);
    if (const std::optional<TimeSpan> span = samples.span()) {
        widen(overview.span, span->from, span->to);
    }
    return overview;
}

SeriesSource historySource(const HistoryFolder &folder)
{
    return [folder](const SeriesQuery &query) {
        auto answer = std::make_shared<Answer>();
        answer->start();
        QFuture<QList<Series>> future = answer->future();
        QThreadPool::globalInstance()->start([folder, query, answer] {
            answerQuery(folder, query, *answer);
            answer->finish();
        });
        return future;
    };
}

} // namespace gorizont
