#pragma once

#include "core/values/archivesource.h"

#include <QDateTime>
#include <QPromise>

#include <memory>

namespace gorizont::test {

/// A question that waits for its answer.
template <typename Answer> struct Asked
{
    QList<int> numbers;
    UtcTime from;
    UtcTime to;
    std::shared_ptr<QPromise<Answer>> promise = std::make_shared<QPromise<Answer>>();

    void answer(const Answer &value) const
    {
        promise->addResult(value);
        promise->finish();
    }
};

/// A ArchiveSource that answers when the test says so.
class SlowSource
{
public:
    struct Months
    {
        QList<int> numbers;
        QDate first;
        QDate last;
        std::shared_ptr<QPromise<QList<DayCompleteness>>> promise =
            std::make_shared<QPromise<QList<DayCompleteness>>>();

        void answer(const QList<DayCompleteness> &value) const
        {
            promise->addResult(value);
            promise->finish();
        }
    };

    ArchiveSource source()
    {
        ArchiveSource source;
        source.completeness = [this](const QList<int> &numbers, QDate first, QDate last) {
            months.append(Months{numbers, first, last});
            months.last().promise->start();
            return months.last().promise->future();
        };
        source.gaps = [this](const QList<int> &numbers, UtcTime from, UtcTime to) {
            gaps.append(Asked<QList<Gap>>{numbers, from, to});
            gaps.last().promise->start();
            return gaps.last().promise->future();
        };
        source.events = [this](UtcTime from, UtcTime to, int) {
            events.append(Asked<QList<JournalEntry>>{{}, from, to});
            events.last().promise->start();
            return events.last().promise->future();
        };
        source.series = [this](const SeriesQuery &query) {
            if (!isExportFast) {
                series.append(std::make_shared<QPromise<QList<Series>>>());
                series.last()->start();
                return series.last()->future();
            }
            QList<Series> answer;
            for (const SeriesKey &key : query.keys) {
                answer << Series{key, {}, {{query.from, 1, 2, 3, 1, 1}}, {}};
            }
            return QtFuture::makeReadyFuture(answer);
        };
        return source;
    }

    QList<Months> months;
    QList<Asked<QList<Gap>>> gaps;
    QList<Asked<QList<JournalEntry>>> events;
    QList<std::shared_ptr<QPromise<QList<Series>>>> series;
    bool isExportFast = true;
};

/// The local midnight.
inline UtcTime utcOf(QDate day)
{
    return UtcTime(std::chrono::milliseconds(day.startOfDay().toMSecsSinceEpoch()));
}

} // namespace gorizont::test
