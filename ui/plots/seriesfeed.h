#pragma once

#include "core/values/series.h"

#include <QMap>
#include <QObject>
#include <QTimer>

#include <functional>

template <typename T> class QFutureWatcher;

namespace gorizont {

/// What a plot wants to know, asked of a source without waiting for it: history from the source, the live edge from the
/// readings. Only the last question counts; while somebody pans, questions wait until the movement ends. GUI thread.
class SeriesFeed : public QObject
{
    Q_OBJECT

public:
    using Clock = std::function<UtcTime()>;

    struct Wish
    {
        QList<SeriesKey> keys;
        UtcTime from;
        UtcTime to;
        int width = 0; ///< pixels of from … to; 0: full rate
        bool operator==(const Wish &) const = default;
    };

    /// Buckets of a key that are kept where no source ever takes them over.
    static constexpr qsizetype mostLive = 50000;

    explicit SeriesFeed(Clock clock = utcNow, QObject *parent = nullptr);
    /// Cancels its question: whoever reads for it stops.
    ~SeriesFeed() override;

    /// Forgets what the former source said. \a isLive: readings belong behind its history; without a source they are
    /// all there is.
    void setSource(SeriesSource source, bool isLive);

    /// Answers with historyChanged() if something has to be asked; at once if nothing was known before.
    void want(const Wish &wish);

    /// Keeps what \a batch says of the wanted keys.
    void append(const Readings &batch);

    /// Of a wanted key, as the source said it last; empty while it has not answered.
    Series history(const SeriesKey &key) const { return m_history.value(key); }
    /// What came since the end of history(); a bucket without a valid value: the curve ends there.
    /// Empty as long as nobody knows what lay between.
    QList<SeriesBucket> live(const SeriesKey &key) const;
    /// history() and what came since.
    Series whole(const SeriesKey &key) const;

    bool isWaiting() const { return m_watcher != nullptr; }
    /// The source gave no answer the last time it was asked.
    bool hasFailed() const { return m_hasFailed; }

Q_SIGNALS:
    void historyChanged();
    /// Of these keys something has come at the end of live().
    void liveChanged(const QList<gorizont::SeriesKey> &keys);
    void waitingChanged();

private:
    bool isCovered(const Wish &wish) const;
    void ask();
    void take();
    void dropLive();
    void forgetQuestion();

    const Clock m_clock;
    SeriesSource m_source;
    bool m_isLive = true;
    Wish m_wish;
    Wish m_asked; ///< the last question, with its margins; no keys: none
    UtcTime m_askedAt;
    QMap<SeriesKey, Series> m_history;
    QMap<SeriesKey, QList<SeriesBucket>> m_live;
    QFutureWatcher<QList<Series>> *m_watcher = nullptr; ///< of a question that waits for its answer
    bool m_hasFailed = false;
    QTimer m_pause{this};
};

} // namespace gorizont
