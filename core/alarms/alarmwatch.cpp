#include "core/alarms/alarmwatch.h"

#include "core/alarms/alarmtext.h"

#include <QTimer>

#include <algorithm>

namespace gorizont {

namespace {

constexpr std::chrono::milliseconds changePeriod(100);
constexpr qsizetype mostJournalLines = 20; ///< of one acknowledgement

QList<LineConfig> configs(const SensorRegistry &registry)
{
    QList<LineConfig> lines;
    for (const SensorRegistry::Line &line : registry.lines()) {
        lines.append(line.config);
    }
    return lines;
}

} // namespace

AlarmWatch::AlarmWatch(const SensorRegistry &registry, const NoticePace::Limits &limits, QObject *parent)
    : QObject(parent)
    , m_board(configs(registry))
    , m_pace(limits)
    , m_changeTimer(new QTimer(this))
    , m_noticeTimer(new QTimer(this))
{
    m_changeTimer->setSingleShot(true);
    m_changeTimer->setInterval(changePeriod);
    connect(m_changeTimer, &QTimer::timeout, this, &AlarmWatch::changed);
    m_noticeTimer->setSingleShot(true);
    connect(m_noticeTimer, &QTimer::timeout, this, &AlarmWatch::giveNotice);
    for (const LineStatus &status : registry.lineStatuses()) {
        followLine(status);
    }
    apply(m_board.update(registry.readings()));
    connect(&registry, &SensorRegistry::readingsChanged, this, [this](const Readings &batch) {
        apply(m_board.update(batch));
    });
    connect(&registry, &SensorRegistry::lineChanged, this, &AlarmWatch::followLine);
}

void AlarmWatch::followLine(const LineStatus &status)
{
    apply(m_board.updateLine(status.port, status.state, utcNow()));
}

void AlarmWatch::apply(const AlarmBoard::Change &change)
{
    if (!change.isAny) {
        return;
    }
    const SteadyTime now = std::chrono::steady_clock::now();
    for (const Alarm &alarm : change.raised) {
        m_pace.add(alarm, now);
        Q_EMIT raised(alarm);
    }
    if (!change.raised.isEmpty()) {
        scheduleNotice(now);
    }
    if (!m_changeTimer->isActive()) {
        m_changeTimer->start();
    }
}

void AlarmWatch::scheduleNotice(SteadyTime now)
{
    if (const auto due = m_pace.dueAt()) {
        m_noticeTimer->start(std::chrono::ceil<std::chrono::milliseconds>(std::max(*due, now) - now));
    }
}

void AlarmWatch::giveNotice()
{
    const SteadyTime now = std::chrono::steady_clock::now();
    const Alarms alarms = m_pace.take(m_board.unacknowledged(), now);
    scheduleNotice(now);
    if (!alarms.isEmpty()) {
        Q_EMIT noticeDue(alarms);
    }
}

void AlarmWatch::acknowledge(const QList<quint64> &ids)
{
    const Alarms acknowledged = m_board.acknowledge(ids);
    if (acknowledged.isEmpty()) {
        return;
    }
    tellAcknowledged(acknowledged);
    m_changeTimer->stop();
    Q_EMIT changed();
}

/// Each by its name; a whole site at once only as a number, so that the journal stays readable.
void AlarmWatch::tellAcknowledged(const Alarms &alarms)
{
    const UtcTime now = utcNow();
    if (alarms.size() > mostJournalLines) {
        const auto count = static_cast<int>(alarms.size());
        Q_EMIT journal({JournalKind::Info, now, tr("Accepted by the dispatcher: %n message(s)", nullptr, count)});
        return;
    }
    for (const Alarm &alarm : alarms) {
        const QString text = tr("Accepted by the dispatcher: %1").arg(alarmtext::sentence(alarm));
        Q_EMIT journal({JournalKind::Info, now, text, alarm.port, alarm.number});
    }
}

} // namespace gorizont
