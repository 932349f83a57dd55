#include "core/station/sources/sourcerunner.h"

#include <QCoreApplication>

namespace gorizont::station {

namespace {

class Text
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::SourceWatch)
};

} // namespace

SourceWatch::SourceWatch(const QList<MakeSource> &sources, std::chrono::seconds watchdog, Tell tell, SteadyTime now)
    : m_watchdog(watchdog)
    , m_tell(std::move(tell))
{
    for (const MakeSource &make : sources) {
        m_sources.push_back({make, {}, {}, {}, {}, false});
        start(m_sources.back(), now);
    }
}

void SourceWatch::start(Watched &watched, SteadyTime now)
{
    watched.runner = std::make_unique<SourceRunner>(watched.make());
    watched.runner->setOutputs(m_outputs);
    watched.name = watched.runner->name();
    watched.lastHeard = now;
}

RawSample SourceWatch::take(SteadyTime now)
{
    RawSample sum;
    for (Watched &watched : m_sources) {
        if (watched.runner) {
            takeFrom(watched, now, sum);
        } else if (now >= watched.restartAt) {
            start(watched, now);
        }
    }
    return sum;
}

void SourceWatch::takeFrom(Watched &watched, SteadyTime now, RawSample &sum)
{
    if (const auto sample = watched.runner->take()) {
        fillFrom(sum, *sample);
        watched.lastHeard = now;
        if (watched.isToldDead) {
            watched.isToldDead = false;
            m_tell(true, Text::tr("Source %1 works again.").arg(watched.name));
        }
    }
    if (const QString why = watched.runner->problem(); !why.isEmpty()) {
        bury(watched, why, now);
    } else if (m_watchdog.count() > 0 && now - watched.lastHeard > m_watchdog) {
        watched.runner->abandon();
        bury(watched, Text::tr("it has said nothing for %1 s").arg(m_watchdog.count()), now);
    }
}

void SourceWatch::bury(Watched &watched, const QString &why, SteadyTime now)
{
    watched.runner.reset();
    watched.restartAt = now + restartPause;
    if (!watched.isToldDead) {
        watched.isToldDead = true;
        m_tell(
            false,
            Text::tr("Source %1 has failed: %2. Its parameters have no value; it is started again every %3 s.")
                .arg(watched.name, why)
                .arg(restartPause.count()));
    }
}

void SourceWatch::setOutputs(quint32 outputs)
{
    m_outputs = outputs;
    for (Watched &watched : m_sources) {
        if (watched.runner) {
            watched.runner->setOutputs(outputs);
        }
    }
}

} // namespace gorizont::station
