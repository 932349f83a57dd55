#include "core/history/historywriter.h"

#include "core/history/samplerepair.h"
#include "core/values/statusword.h"

#include <QDir>

#include <algorithm>
#include <cmath>

namespace gorizont {

namespace {

constexpr int samplesPerPacket = 32;
constexpr std::chrono::milliseconds shortestInterval{10}; // TmSave=0 is not an order to fill the disk

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
    , m_inbox(qsizetype{config.ringPackets} * samplesPerPacket)
    , m_sensors(initialColumns(config.lines))
    , m_lines(initialStatuses(config.lines))
    , m_health(config.retryInterval)
    , m_cadence(steadyNow(), std::max(config.saveInterval, shortestInterval))
{
    const qint64 samplesPerFile = qint64{config.ringPackets} * samplesPerPacket * config.packetsToSave;
    for (qsizetype i = 0; i < m_sensors.size(); ++i) {
        const SensorConfig &sensor = m_sensors.at(i).config;
        m_indexOfNumber.insert(sensor.number, i);
        if (sensor.measuresAcceleration) {
            m_hasAccelerometers = true;
            m_samples.try_emplace(
                sensor.number, pathOf(QStringLiteral("Bin")), sensor.number, samplesPerFile, config.zone);
        }
    }
    m_tickTimer.setSingleShot(true);
    m_tickTimer.setTimerType(Qt::PreciseTimer);
    connect(&m_tickTimer, &QTimer::timeout, this, &HistoryWriter::tick);
    m_retryTimer.setInterval(config.retryInterval);
    connect(&m_retryTimer, &QTimer::timeout, this, &HistoryWriter::writeLog);
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

void HistoryWriter::start()
{
    const SteadyTime now = steadyNow();
    m_cadence = Cadence(now, std::max(m_config.saveInterval, shortestInterval));
    m_due = m_cadence.next(now);
    m_clockWatch.step(m_clock(), now);
    if (m_config.savesFiles) {
        for (const QString &name : repairSampleFiles(pathOf(QStringLiteral("Bin")))) {
            noteRepaired(name);
        }
        // Opened before the first record is due, so that a folder that cannot be used is known at once.
        const QString name = monthFileName(localTime(m_clock(), m_config.zone).date(), MonthFile::Data);
        writeRecord(HistoryStream::Data, m_data, name, {});
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
        for (const SampleBlock &block : blocks) {
            saveBlock(block);
        }
    }
    m_entries += contents.entries;
    noteDropped(contents);
    writeLog();
}

void HistoryWriter::stop()
{
    m_tickTimer.stop();
    m_retryTimer.stop();
    flush();
    m_data.close();
    m_acceleration.close();
    m_log.close();
    for (auto &[number, file] : m_samples) {
        file.close();
    }
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
    const QDateTime local = localTime(m_clock(), m_config.zone);
    const QByteArray channels = channelDigits(m_lines);
    const QByteArray record = dataRecord(local, channels, m_sensors);
    if (m_config.savesFiles) {
        writeRecord(HistoryStream::Data, m_data, monthFileName(local.date(), MonthFile::Data), record);
    }
    if (m_config.savesFiles && m_hasAccelerometers) {
        const QString name = monthFileName(local.date(), MonthFile::Acceleration);
        writeRecord(
            HistoryStream::Acceleration, m_acceleration, name, accelerationRecord(local, channels, m_sensors));
    }
    Q_EMIT dataLineWritten(QString::fromLatin1(record).chopped(2));
}

void HistoryWriter::writeRecord(
    HistoryStream stream, RecordFile &file, const QString &name, const QByteArray &record)
{
    if (!m_health.mayTry(stream, steadyNow())) {
        return;
    }
    const bool isWritten = file.prepare(pathOf(name)) != RecordFile::State::Failed && file.append(record);
    if (file.takeRepaired()) {
        noteRepaired(name);
    }
    noteOutcome(stream, isWritten, file.error());
}

void HistoryWriter::saveBlock(const SampleBlock &block)
{
    const auto found = m_samples.find(block.number);
    if (found == m_samples.end()) {
        return;
    }
    SampleFile &file = found->second;
    if (!m_health.mayTry(HistoryStream::Samples, steadyNow())) {
        file.close(); // this block is lost, and the pair of the next one shows it
        return;
    }
    const quint64 before = file.samplesSaved();
    const bool isWritten = file.append(block);
    noteOutcome(HistoryStream::Samples, isWritten, file.error());
    if (file.samplesSaved() != before) {
        Q_EMIT packetsSaved(block.number, file.samplesSaved() / samplesPerPacket);
    }
}

/// An event belongs to the month in which it happened. What cannot be written now waits.
void HistoryWriter::writeLog()
{
    while (!m_entries.isEmpty() && m_health.mayTry(HistoryStream::Log, steadyNow())) {
        const JournalEntry &entry = m_entries.first();
        const QString name = monthFileName(localTime(entry.time, m_config.zone).date(), MonthFile::Log);
        const bool isWritten = m_log.append(pathOf(name), logRecord(entry, m_config.zone));
        if (isWritten) {
            m_entries.removeFirst();
        }
        if (m_log.takeRepaired()) {
            noteRepaired(name);
        }
        noteOutcome(HistoryStream::Log, isWritten, m_log.error());
    }
    if (m_entries.size() > HistoryInbox::mostEntries) {
        m_entries.remove(0, m_entries.size() - HistoryInbox::mostEntries);
    }
}

void HistoryWriter::noteClockStep(SteadyTime now)
{
    const auto step = m_clockWatch.step(m_clock(), now);
    if (!step) {
        return;
    }
    const QString seconds = QString::number(std::abs(std::chrono::duration<double>(*step).count()), 'f', 1);
    note(JournalKind::Info, step->count() > 0 ? tr("The clock of the computer was set forward by %1 s.").arg(seconds)
                                              : tr("The clock of the computer was set back by %1 s.").arg(seconds));
}

void HistoryWriter::noteDropped(const HistoryInbox::Contents &contents)
{
    if (contents.samplesDropped + contents.entriesDropped > 0) {
        note(JournalKind::Error, tr("The disk was busy for too long: %1 samples and %2 events were not saved.")
                                     .arg(contents.samplesDropped)
                                     .arg(contents.entriesDropped));
    }
}

void HistoryWriter::noteRepaired(const QString &name)
{
    note(JournalKind::Info, tr("%1 did not end with a whole record; what was unfinished has been removed.").arg(name));
}

/// One event when the first file cannot be written, one when the last can be written again, none between.
void HistoryWriter::noteOutcome(HistoryStream stream, bool isWritten, const QString &error)
{
    if (isWritten && m_health.succeeded(stream)) {
        m_retryTimer.stop();
        note(JournalKind::Info, tr("The history is being saved again."));
    } else if (!isWritten && m_health.failed(stream, steadyNow())) {
        m_retryTimer.start();
        note(JournalKind::Error, tr("The history is not being saved: %1. It is tried again every few seconds.")
                                     .arg(error));
    }
}

void HistoryWriter::note(JournalKind kind, const QString &text)
{
    Q_EMIT journal({kind, m_clock(), text});
}

} // namespace gorizont
