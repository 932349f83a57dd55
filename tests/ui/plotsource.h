#pragma once

#include "core/values/series.h"

#include <QPromise>

#include <memory>
#include <vector>

namespace gorizont::test {

/// A source that answers when the test says so.
class PlotSource
{
public:
    struct Question
    {
        SeriesQuery query;
        std::shared_ptr<QPromise<QList<Series>>> promise;
        bool isCancelled() const { return promise->isCanceled(); }
    };

    SeriesSource source()
    {
        return [this](const SeriesQuery &query) {
            auto promise = std::make_shared<QPromise<QList<Series>>>();
            promise->start();
            questions.push_back({query, promise});
            return promise->future();
        };
    }

    void answer(std::size_t question, const QList<Series> &series)
    {
        questions.at(question).promise->addResult(series);
        questions.at(question).promise->finish();
    }

    /// Of every question so far.
    std::vector<Question> questions;
};

inline SeriesBucket reading(UtcTime time, double value)
{
    return {time, value, value, value, 1, 1};
}

} // namespace gorizont::test
