#include "core/history/historywriter.h"

#include "core/history/vibrationformat.h"
#include "core/history/weatherformat.h"
#include "core/values/statusword.h"

#include <algorithm>
#include <cmath>

namespace gorizont {

namespace {

constexpr std::chrono::milliseconds shortestInterval{10}; // TmSave=0 is not an order to fill the disk
constexpr std::chrono::hours betweenSweeps{1}; // of old captures

SteadyTime steadyNow()
{
    return std::chrono::steady_clock::now();
}

QList<LineStatus> initialStatuses(const QList<LineConfig> &lines)
{
    QList<LineStatus> statuses;
    for (const LineConfig &line : lines) {
        LineStatus status;
        status.port = line.index;
        status.state = line.isOn ? LineState::Opening : LineState::Off;
        statuses.append(status);
    }
    return statuses;
}

QList<SensorColumns> initialColumns(const QList<LineConfig> &lines)
{
    QList<SensorColumns> sensors;
    for (const LineConfig &line : lines) {
        for (const SensorConfig &sensor : line.sensors) {
            Reading reading;
            reading.number = sensor.number;
            reading.status = initialSensorWord(line, sensor, {});
            sensors.append({sensor, reading});
        }
    }
    std::stable_sort(sensors.begin(), sensors.end(), [](const SensorColumns &a, const SensorColumns &b) {
        return a.config.number < b.config.number;
    });
    return sensors;
}

} // namespace

HistoryWriter::HistoryWriter(const HistoryConfig &config, Clock clock, QObject *parent)
    : QObject(parent)
    , m_config(config)
    , m_clock(std::move(clock))
    , m_inbox(config.samplesPerRing())
    , m_files(config, [this](JournalKind kind, const QString &text) { note(kind, text); })
    , m_captures(config, [this](JournalKind kind, const QString &text) { note(kind, text); })
    , m_sensors(initialColumns(config.lines))
    , m_lines(initialStatuses(config.lines))
    , m_cadence(steadyNow(), std::max(config.saveInterval, shortestInterval))
{
    for (qsizetype i = 0; i < m_sensors.size(); ++i) {
        m_indexOfNumber.insert(m_sensors.at(i).config.number, i);
        m_hasAccelerometers |= m_sensors.at(i).config.measuresAcceleration;
        m_hasVibration |= hasVibrationColumns(m_sensors.at(i).config);
        m_hasWeatherStations |= m_sensors.at(i).config.measuresWeather;
    }
    m_tickTimer.setSingleShot(true);
    m_tickTimer.setTimerType(Qt::PreciseTimer);
    connect(&m_tickTimer, &QTimer::timeout, this, &HistoryWriter::tick);
    m_retryTimer.setInterval(config.retryInterval);
    connect(&m_retryTimer, &QTimer::timeout, this, [this] { m_files.writeEvents(); });
}

void HistoryWriter::updateReadings(const QList<Reading> &batch)
{
    m_inbox.put(batch);
}

void HistoryWriter::updateLine(const LineStatus &status)
{
    m_inbox.put(status);
}

void HistoryWriter::appendBlock(const SampleBlock &block)
{
    if (m_config.savesFiles && m_inbox.put(block)) {
        QMetaObject::invokeMethod(this, &HistoryWriter::flush, Qt::QueuedConnection);
    }
}

void HistoryWriter::appendJournal(const JournalEntry &entry)
{
    if (m_config.savesFiles && m_inbox.put(entry)) {
        QMetaObject::invokeMethod(this, &HistoryWriter::flush, Qt::QueuedConnection);
    }
}

void HistoryWriter::appendCapture(const SignalCapture &captured)
{
    if (m_config.savesFiles && m_inbox.put(captured)) {
        QMetaObject::invokeMethod(this, &HistoryWriter::flush, Qt::QueuedConnection);
    }
}

void HistoryWriter::start()
{
    const SteadyTime now = steadyNow();
    m_cadence = Cadence(now, std::max(m_config.saveInterval, shortestInterval));
    m_due = m_cadence.next(now);
    m_clockWatch.step(m_clock(), now);
    if (m_config.savesFiles) {
        m_files.open(wallTime().date());
        m_captures.open();
        m_sweepAt = now;
        m_retryTimer.start();
    }
    armTick();
}

void HistoryWriter::flush()
{
    const HistoryInbox::Contents contents = m_inbox.take();
    for (const Reading &reading : contents.readings) {
        if (const qsizetype index = m_indexOfNumber.value(reading.number, -1); index >= 0) {
            m_sensors[index].reading = reading;
        }
    }
    for (LineStatus &line : m_lines) {
        line = contents.lines.value(line.port, line);
    }
    for (const QList<SampleBlock> &blocks : contents.blocks) {
        quint64 samples = 0;
        for (const SampleBlock &block : blocks) {
            samples = m_files.save(block);
        }
        Q_EMIT packetsSaved(blocks.first().number, samples / HistoryConfig::samplesPerPacket);
    }
    for (const SignalCapture &captured : contents.captures) {
        m_captures.save(captured);
    }
    m_files.addEvents(contents.entries);
    noteDropped(contents);
    m_files.writeEvents();
}

void HistoryWriter::stop()
{
    m_tickTimer.stop();
    m_retryTimer.stop();
    flush();
    m_files.close();
}

/// A timer may fire a fraction of a millisecond early; the record is due all the same only once.
void HistoryWriter::tick()
{
    const SteadyTime now = steadyNow();
    if (now >= m_due) {
        m_due = m_cadence.next(now);
        noteClockStep(now);
        flush();
        writeRecords();
        sweepCaptures(now);
    }
    armTick();
}

void HistoryWriter::armTick()
{
    const auto wait = std::chrono::ceil<std::chrono::milliseconds>(m_due - steadyNow());
    m_tickTimer.start(std::max(wait, std::chrono::milliseconds(0)));
}

void HistoryWriter::writeRecords()
{
    const QDateTime local = wallTime();
    const QByteArray channels = channelDigits(m_lines);
    const QByteArray record = dataRecord(local, channels, m_sensors);
    if (m_config.savesFiles) {
        m_files.writeData(local.date(), record);
    }
    if (m_config.savesFiles && m_hasAccelerometers) {
        m_files.writeAcceleration(local.date(), accelerationRecord(local, channels, m_sensors));
    }
    if (m_config.savesFiles && m_hasVibration) {
        m_files.writeVibration(local.date(), vibrationRecord(local, channels, m_sensors));
    }
    if (m_config.savesFiles && m_hasWeatherStations) {
        m_files.writeWeather(local.date(), weatherRecords(local, channels, m_sensors));
    }
    Q_EMIT dataLineWritten(QString::fromLatin1(record).chopped(2));
}

void HistoryWriter::sweepCaptures(SteadyTime now)
{
    if (m_config.savesFiles && m_captures.isInUse() && now >= m_sweepAt) {
        m_sweepAt = now + betweenSweeps;
        m_captures.removeOld(m_clock());
    }
}

void HistoryWriter::noteClockStep(SteadyTime now)
{
    const auto step = m_clockWatch.step(m_clock(), now);
    if (!step) {
        return;
    }
    const QString seconds = QString::number(std::abs(std::chrono::duration<double>(*step).count()), 'f', 1);
    note(
        JournalKind::Info,
        step->count() > 0 ? tr("The clock of the computer was set forward by %1 s.").arg(seconds)
                          : tr("The clock of the computer was set back by %1 s.").arg(seconds));
}

void HistoryWriter::noteDropped(const HistoryInbox::Contents &contents)
{
    if (contents.samplesDropped + contents.entriesDropped > 0) {
        note(
            JournalKind::Error,
            tr("The disk was busy for too long: %1 samples and %2 events were not saved.")
                .arg(contents.samplesDropped)
                .arg(contents.entriesDropped));
    }
    if (contents.capturesDropped > 0) {
        note(
            JournalKind::Error,
            tr("The disk was busy for too long: %1 captures of L-VIMS were not saved.").arg(contents.capturesDropped));
    }
}

void HistoryWriter::note(JournalKind kind, const QString &text)
{
    Q_EMIT journal({kind, m_clock(), text});
}

} // namespace gorizont
