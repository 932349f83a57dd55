#include "ui/plots/seriesfeed.h"

#include "core/values/statusword.h"

#include <QFutureWatcher>

#include <algorithm>

namespace gorizont {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds panningPause(120);
constexpr std::chrono::microseconds shortestRefresh = 5s;
constexpr std::chrono::microseconds longestRefresh = 5min;
constexpr std::chrono::microseconds leastStepBack = 1s; ///< less is no other clock, but the same reading told twice

/// A quarter is asked for on either side, so that a short movement finds something there.
constexpr int marginsOfSpan = 4;

/// While the edge moves on, its history is asked for anew this often.
std::chrono::microseconds refreshPeriod(std::chrono::microseconds span)
{
    return std::clamp(span / 100, shortestRefresh, longestRefresh);
}

/// Of a sensor that cannot be read nothing is known, whatever the last values were.
bool isOutOfReach(quint16 status)
{
    const StatusCode code = statusCode(status);
    return status & statusbit::NotPolled || (code >= StatusCode::PortOff && code <= StatusCode::CrcErrors);
}

std::optional<SeriesBucket> bucketOf(const Reading &reading, Quantity quantity)
{
    if (!readingQuantities().contains(quantity)) {
        return {}; // samples come in blocks, and from the source alone
    }
    const std::optional<double> value = isOutOfReach(reading.status) ? std::nullopt : valueOf(reading, quantity);
    if (!value) {
        return SeriesBucket{reading.time, 0, 0, 0, 1, 0};
    }
    return reading.isAnswer ? std::optional(SeriesBucket{reading.time, *value, *value, *value, 1, 1}) : std::nullopt;
}

} // namespace

SeriesFeed::SeriesFeed(Clock clock, QObject *parent)
    : QObject(parent)
    , m_clock(std::move(clock))
{
    m_pause.setSingleShot(true);
    connect(&m_pause, &QTimer::timeout, this, &SeriesFeed::ask);
}

SeriesFeed::~SeriesFeed()
{
    if (m_watcher) {
        m_watcher->cancel();
    }
}

void SeriesFeed::setSource(SeriesSource source, bool isLive)
{
    forgetQuestion();
    m_source = std::move(source);
    m_isLive = isLive;
    m_asked = {};
    m_history.clear();
    m_live.clear();
    m_hasFailed = false;
    Q_EMIT historyChanged();
    if (!m_wish.keys.isEmpty()) {
        ask();
    }
}

/// The question that was asked last answers this wish too, finely enough.
bool SeriesFeed::isCovered(const Wish &wish) const
{
    const auto isAsked = [this](const SeriesKey &key) { return m_asked.keys.contains(key); };
    if (!std::all_of(wish.keys.cbegin(), wish.keys.cend(), isAsked) || m_hasFailed || wish.from < m_asked.from) {
        return false;
    }
    const auto span = [](const Wish &of) { return std::max(1.0, static_cast<double>((of.to - of.from).count())); };
    const double wanted = wish.width / span(wish);
    const double had = m_asked.width / span(m_asked);
    if (had < 0.8 * wanted || had > 4 * wanted) {
        return false;
    }
    const std::chrono::microseconds age = m_clock() - m_askedAt;
    if (age.count() < 0) {
        return false; // the clock was set back
    }
    if (!m_isLive || wish.to <= m_askedAt || m_asked.to < m_askedAt) {
        return wish.to <= m_asked.to;
    }
    // At the edge a question is never too old before it has been answered: an archive that needs longer than the period
    // would never come to an end.
    return isWaiting() || age < refreshPeriod(wish.to - wish.from);
}

void SeriesFeed::want(const Wish &wish)
{
    const bool isNew = wish.keys != m_wish.keys;
    m_wish = wish;
    if (isNew) {
        const auto isForgotten = [&wish](const auto &entry) { return !wish.keys.contains(entry.key()); };
        m_live.removeIf(isForgotten);
        m_history.removeIf(isForgotten);
    }
    if (wish.keys.isEmpty()) {
        forgetQuestion();
        m_asked = {};
        m_pause.stop();
        return;
    }
    if (!m_source || isCovered(wish)) {
        m_pause.stop();
    } else if (isNew) {
        ask();
    } else {
        m_pause.start(panningPause); // begins anew with every movement
    }
}

void SeriesFeed::ask()
{
    m_pause.stop();
    if (!m_source) {
        return;
    }
    forgetQuestion();
    const std::chrono::microseconds margin = (m_wish.to - m_wish.from) / marginsOfSpan;
    m_askedAt = m_clock();
    m_asked = {m_wish.keys, m_wish.from - margin, m_wish.to + margin, m_wish.width + 2 * m_wish.width / marginsOfSpan};
    m_watcher = new QFutureWatcher<QList<Series>>(this);
    connect(m_watcher, &QFutureWatcherBase::finished, this, &SeriesFeed::take);
    m_watcher->setFuture(m_source({m_asked.keys, m_asked.from, m_asked.to, m_asked.width}));
    Q_EMIT waitingChanged();
}

void SeriesFeed::take()
{
    const QFuture<QList<Series>> future = m_watcher->future();
    m_watcher->deleteLater();
    m_watcher = nullptr;
    m_hasFailed = future.isCanceled() || future.resultCount() == 0;
    if (!m_hasFailed) {
        for (const Series &series : future.result()) {
            if (m_wish.keys.contains(series.key)) {
                m_history.insert(series.key, series);
            }
        }
        dropLive();
        Q_EMIT historyChanged();
    }
    Q_EMIT waitingChanged();
}

/// What the history knows by now.
void SeriesFeed::dropLive()
{
    for (auto live = m_live.begin(); live != m_live.end(); ++live) {
        const Series series = m_history.value(live.key());
        if (series.buckets.isEmpty()) {
            continue;
        }
        const UtcTime end = series.buckets.last().from + series.step;
        const auto isKnown = [end](const SeriesBucket &bucket) { return bucket.from <= end; };
        const auto first = std::find_if_not(live->begin(), live->end(), isKnown);
        live->erase(live->begin(), first);
    }
}

QList<SeriesBucket> SeriesFeed::live(const SeriesKey &key) const
{
    const QList<SeriesBucket> live = m_live.value(key);
    const bool isJoined = !m_source || (!live.isEmpty() && live.first().from <= m_asked.to);
    return isJoined ? live : QList<SeriesBucket>();
}

Series SeriesFeed::whole(const SeriesKey &key) const
{
    Series series = history(key);
    const UtcTime end = series.buckets.isEmpty() ? UtcTime::min() : series.buckets.last().from + series.step;
    for (const SeriesBucket &bucket : live(key)) {
        if (bucket.from > end) {
            series.buckets.append(bucket);
        }
    }
    return series;
}

void SeriesFeed::forgetQuestion()
{
    if (m_watcher) {
        m_watcher->disconnect(this);
        m_watcher->cancel();
        m_watcher->deleteLater();
        m_watcher = nullptr;
        m_hasFailed = false;
        Q_EMIT waitingChanged();
    }
}

void SeriesFeed::append(const Readings &batch)
{
    if (!m_isLive) {
        return;
    }
    QList<SeriesKey> changed;
    bool isSetBack = false;
    for (const Reading &reading : batch) {
        for (const SeriesKey &key : std::as_const(m_wish.keys)) {
            const std::optional<SeriesBucket> bucket =
                key.number == reading.number ? bucketOf(reading, key.quantity) : std::nullopt;
            if (!bucket) {
                continue;
            }
            QList<SeriesBucket> &live = m_live[key];
            if (!live.isEmpty() && live.last().from - bucket->from > leastStepBack) {
                live.clear(); // the clock was set back
                isSetBack = true;
            } else if (!live.isEmpty() && bucket->from <= live.last().from) {
                continue; // told twice
            }
            live.append(*bucket);
            if (live.size() > mostLive) {
                live.remove(0, mostLive / 10);
            }
            changed.append(key);
        }
    }
    if (isSetBack) {
        Q_EMIT historyChanged(); // what was drawn ends later than what comes
    }
    if (!changed.isEmpty()) {
        Q_EMIT liveChanged(changed);
    }
}

} // namespace gorizont
