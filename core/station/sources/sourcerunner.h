#pragma once

#include "core/station/sources/source.h"
#include "core/values/timing.h"

#include <QList>
#include <QString>

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace gorizont::station {

/// One source in a thread of its own, asked at its rate, and what it measured since the last look. A source that hangs in the
/// system is left alone in its thread at the end: it ends when the system lets go of it.
class SourceRunner
{
public:
    explicit SourceRunner(std::unique_ptr<Source> source);
    ~SourceRunner();
    SourceRunner(const SourceRunner &) = delete;
    SourceRunner &operator=(const SourceRunner &) = delete;

    QString name() const { return m_name; }
    /// The mean of what came since the last call. Empty: nothing.
    std::optional<RawSample> take();
    /// Why it has died or could not be opened; empty: it lives.
    QString problem() const;
    void setOutputs(quint32 outputs);
    /// It hangs: the end will not wait for it.
    void abandon() { m_isAbandoned = true; }

private:
    struct Shared;
    static void run(const std::shared_ptr<Shared> &shared);

    QString m_name;
    std::shared_ptr<Shared> m_shared;
    bool m_isAbandoned = false;
};

/// All sources of a station and the watch over them: one that dies is made anew after a pause, one that says nothing for as long
/// as the watchdog allows too. Used by the thread of the station; never waits for a source.
class SourceWatch
{
public:
    using MakeSource = std::function<std::unique_ptr<Source>()>;
    using Tell = std::function<void(bool isGood, const QString &text)>; ///< a sentence for the journal

    static constexpr std::chrono::seconds restartPause{10};

    /// \a watchdog 0: a source may be silent for ever.
    SourceWatch(const QList<MakeSource> &sources, std::chrono::seconds watchdog, Tell tell, SteadyTime now);

    /// What all sources measured since the last call. To be called once a second.
    RawSample take(SteadyTime now);
    void setOutputs(quint32 outputs);

private:
    struct Watched
    {
        MakeSource make;
        std::unique_ptr<SourceRunner> runner; ///< empty: it has died, and waits
        QString name;
        SteadyTime lastHeard{};
        SteadyTime restartAt{};
        bool isToldDead = false;
    };

    void start(Watched &watched, SteadyTime now);
    void takeFrom(Watched &watched, SteadyTime now, RawSample &sum);
    void bury(Watched &watched, const QString &why, SteadyTime now);

    std::chrono::seconds m_watchdog;
    Tell m_tell;
    quint32 m_outputs = 0;
    std::vector<Watched> m_sources;
};

} // namespace gorizont::station
