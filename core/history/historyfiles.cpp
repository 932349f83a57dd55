#include "core/history/historyfiles.h"

#include "core/history/samplerepair.h"

#include <algorithm>

namespace gorizont {

namespace {

const QString sampleFolder = QStringLiteral("Bin");

SteadyTime steadyNow()
{
    return std::chrono::steady_clock::now();
}

} // namespace

HistoryFiles::HistoryFiles(const HistoryConfig &config, Note note)
    : m_folder(config.folder)
    , m_zone(config.zone)
    , m_note(std::move(note))
    , m_health(config.retryInterval)
{
    for (const LineConfig &line : config.lines) {
        for (const SensorConfig &sensor : line.sensors) {
            if (sensor.measuresAcceleration) {
                const qint64 size = config.samplesPerRing() * config.packetsToSave;
                m_samples.try_emplace(sensor.number, pathOf(sampleFolder), sensor.number, size, config.zone);
            }
        }
    }
}

void HistoryFiles::open(QDate today)
{
    for (const QString &name : repairSampleFiles(pathOf(sampleFolder))) {
        noteRepaired(name);
    }
    writeData(today, {});
}

void HistoryFiles::close()
{
    m_data.close();
    m_acceleration.close();
    m_weather.close();
    m_log.close();
    for (auto &[number, file] : m_samples) {
        file.close();
    }
}

void HistoryFiles::writeData(QDate today, const QByteArray &record)
{
    write(HistoryStream::Data, m_data, monthFileName(today, MonthFile::Data), record);
}

void HistoryFiles::writeAcceleration(QDate today, const QByteArray &record)
{
    write(HistoryStream::Acceleration, m_acceleration, monthFileName(today, MonthFile::Acceleration), record);
}

void HistoryFiles::writeWeather(QDate today, const QByteArray &records)
{
    write(HistoryStream::Weather, m_weather, monthFileName(today, MonthFile::Weather), records);
}

void HistoryFiles::write(HistoryStream stream, RecordFile &file, const QString &name, const QByteArray &record)
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

quint64 HistoryFiles::save(const SampleBlock &block)
{
    const auto found = m_samples.find(block.number);
    if (found == m_samples.end()) {
        return 0;
    }
    SampleFile &file = found->second;
    if (m_health.mayTry(HistoryStream::Samples, steadyNow())) {
        const bool isWritten = file.append(block);
        noteOutcome(HistoryStream::Samples, isWritten, file.error());
    } else {
        file.close(); // this block is lost, and the pair that the next one begins shows it
    }
    return file.samplesSaved();
}

void HistoryFiles::writeEvents()
{
    while (!m_events.isEmpty() && m_health.mayTry(HistoryStream::Log, steadyNow())) {
        const JournalEntry &event = m_events.first();
        const QString name = monthFileName(localTime(event.time, m_zone).date(), MonthFile::Log);
        const bool isWritten = m_log.append(pathOf(name), logRecord(event, m_zone));
        if (isWritten) {
            m_events.removeFirst();
        }
        if (m_log.takeRepaired()) {
            noteRepaired(name);
        }
        noteOutcome(HistoryStream::Log, isWritten, m_log.error());
    }
    if (m_events.size() > mostEvents) {
        m_events.remove(0, m_events.size() - mostEvents);
    }
}

/// One event when the first file cannot be written, one when the last can be written again, none between.
void HistoryFiles::noteOutcome(HistoryStream stream, bool isWritten, const QString &error)
{
    if (isWritten && m_health.succeeded(stream)) {
        m_note(JournalKind::Info, tr("The history is being saved again."));
    } else if (!isWritten && m_health.failed(stream, steadyNow())) {
        m_note(
            JournalKind::Error,
            tr("The history is not being saved: %1. It is tried again every few seconds.").arg(error));
    }
}

void HistoryFiles::noteRepaired(const QString &name)
{
    m_note(
        JournalKind::Info, tr("%1 did not end with a whole record; what was unfinished has been removed.").arg(name));
}

} // namespace gorizont
