#include "app/tool/historyimport.h"

#include "core/archive/rollup.h"
#include "core/history/samplerecords.h"

#include <QDir>
#include <QFileInfo>

namespace gorizont::tool {

namespace {

constexpr std::chrono::microseconds hour = std::chrono::hours(1);
constexpr qsizetype mostNamed = 10; ///< damaged lines of a file

bool isWhole(const std::optional<HistoryRow> &row, qsizetype groups)
{
    if (!row || row->groups() != groups) {
        return false;
    }
    for (qsizetype i = 0; i < groups; ++i) {
        if (!row->group(i)) {
            return false;
        }
    }
    return true;
}

} // namespace

HistoryImport::HistoryImport(const HistoryFolder &folder, const ArchiveConfig &archive, Progress progress)
    : m_folder(folder)
    , m_progress(std::move(progress))
    , m_recorder(archive, [this](JournalKind, const QString &text) { m_report.complaints.append(text); })
{
    for (const SensorConfig &sensor : folder.sensors) {
        m_quantities.insert(sensor.number, quantitiesOf(sensor));
    }
}

ImportReport HistoryImport::run(UtcTime now)
{
    m_report = {};
    m_now = now;
    const auto all = months();
    const SampleRecords samples(m_folder.path + QStringLiteral("/Bin"), m_folder.zone, m_folder.gravity);
    const QString name = QDir::toNativeSeparators(m_folder.path);
    if (all.empty() && !samples.span()) {
        m_report.failure = m_report.foreign > 0
            ? tr("No file in %1 is of this configuration. Name the one they were made with by --config.").arg(name)
            : tr("There are no old records in %1. Name the folder with files like 2018_02_data.txt.").arg(name);
        return m_report;
    }
    if (!m_recorder.open(now)) {
        m_report.failure = m_recorder.error();
        return m_report;
    }
    bool isGood = true;
    for (const auto &[start, month] : all) {
        isGood = isGood && importMonth(month);
    }
    isGood = isGood && importSamples();
    ArchiveInbox nothing;
    if (!isGood || !m_recorder.finish(nothing, now)) {
        m_report.failure = m_recorder.error();
    }
    m_recorder.close();
    m_report.added = m_recorder.backfilled();
    return m_report;
}

/// By `2018_02`.
std::map<QString, HistoryImport::Month> HistoryImport::months()
{
    constexpr qsizetype size = 7;
    std::map<QString, Month> all;
    for (const MonthFile kind : {MonthFile::Data, MonthFile::Acceleration}) {
        for (const QString &path : monthFiles(m_folder.path, kind)) {
            const QString good = accepted(path, kind);
            if (!good.isEmpty()) {
                Month &month = all[QFileInfo(path).fileName().first(size)];
                (kind == MonthFile::Data ? month.data : month.acceleration) = good;
            }
        }
    }
    return all;
}

/// \a path; empty: nothing can be read there.
QString HistoryImport::accepted(const QString &path, MonthFile kind)
{
    const qsizetype columns = historyColumns(m_folder.sensors, kind).size();
    const MonthRecords records(path, m_folder.zone);
    const QString name = QFileInfo(path).fileName();
    if (!records.first()) {
        m_report.complaints.append(tr("%1 holds no records and is left out.").arg(name));
        return {};
    }
    if (records.groups() != columns) {
        ++m_report.foreign;
        m_report.complaints.append(
            tr("%1 holds %2 sensors and the configuration has %3: it is left out, because nobody knows whose the "
               "values are.")
                .arg(name)
                .arg(records.groups())
                .arg(columns));
        return {};
    }
    ++m_report.files;
    survey(path, columns);
    return path;
}

/// Counts the records and names the lines that are none.
void HistoryImport::survey(const QString &path, qsizetype groups)
{
    QFile file(path);
    QStringList named;
    qint64 damaged = 0;
    if (!file.open(QIODevice::ReadOnly)) {
        return;
    }
    for (qint64 number = 1; !file.atEnd(); ++number) {
        if (isWhole(HistoryRow::parse(file.readLine()), groups)) {
            ++m_report.records;
            continue;
        }
        ++damaged;
        if (named.size() < mostNamed) {
            named.append(QString::number(number));
        }
    }
    if (damaged > 0) {
        m_report.damaged += damaged;
        m_report.complaints.append(
            tr("%1: damaged lines, %2 in all, are left out: %3.")
                .arg(QFileInfo(path).fileName())
                .arg(damaged)
                .arg(named.join(QStringLiteral(", ")) + (damaged > named.size() ? QStringLiteral(" …") : QString())));
    }
}

bool HistoryImport::importMonth(const Month &month)
{
    std::optional<MonthRecords> data;
    std::optional<MonthRecords> acceleration;
    if (!month.data.isEmpty()) {
        data.emplace(month.data, m_folder.zone);
    }
    if (!month.acceleration.isEmpty()) {
        acceleration.emplace(month.acceleration, m_folder.zone);
    }
    const QList<int> columns = historyColumns(m_folder.sensors, MonthFile::Data);
    const QList<int> accelerationColumns = historyColumns(m_folder.sensors, MonthFile::Acceleration);
    const MonthRecords &main = data ? *data : *acceleration;
    const QString source = QFileInfo(data ? month.data : month.acceleration).fileName();
    UtcTime from = *main.first();
    UtcTime to = *main.last();
    if (acceleration) {
        from = std::min(from, *acceleration->first());
        to = std::max(to, *acceleration->last());
    }
    for (UtcTime at = floored(from, hour); at <= to; at += hour) {
        m_progress(source, static_cast<int>(100 * (at - from).count() / std::max<qint64>(1, (to - from).count())));
        Readings readings;
        takeHour(data, MonthFile::Data, columns, at, readings);
        takeHour(acceleration, MonthFile::Acceleration, accelerationColumns, at, readings);
        if (!commit(backfillsOf(readings, source, main.period()))) {
            return false;
        }
    }
    return true;
}

void HistoryImport::takeHour(
    const std::optional<MonthRecords> &records, MonthFile kind, const QList<int> &columns, UtcTime from,
    Readings &readings)
{
    if (!records) {
        return;
    }
    records->read(from, from + hour, [&](UtcTime time, const HistoryRow &row) {
        for (qsizetype i = 0; i < columns.size() && row.groups() == columns.size(); ++i) {
            const std::optional<HistoryGroup> group = row.group(i);
            if (!group) {
                continue;
            }
            Reading &reading = readings[columns.at(i)][time];
            if (kind == MonthFile::Data) {
                reading = tiltReading(*group);
            } else {
                reading.acceleration = accelerationReading(*group).acceleration;
                reading.status = group->status; // the same as that of its tilt
                reading.isAnswer = true;
            }
            reading.number = columns.at(i);
            reading.time = time;
        }
        return true;
    });
}

QList<Backfill> HistoryImport::backfillsOf(
    const Readings &readings, const QString &source, std::chrono::microseconds period) const
{
    QList<Backfill> backfills;
    for (const auto &[number, byTime] : readings) {
        Backfill backfill{number, source, period, {}, {}, {}};
        for (const auto &[time, reading] : byTime) {
            backfill.readings.append(keptReading(reading, m_quantities.value(number)));
        }
        backfills.append(backfill);
    }
    return backfills;
}

bool HistoryImport::importSamples()
{
    const SampleRecords samples(m_folder.path + QStringLiteral("/Bin"), m_folder.zone, m_folder.gravity);
    bool isGood = true;
    samples.readBlocks([&](const SampleBlock &block) {
        m_report.files += block.followsPrevious ? 0 : 1;
        if (!block.followsPrevious) {
            m_progress(QStringLiteral("Bin"), 0);
        }
        isGood = commit({Backfill{block.number, {}, {}, {}, {}, {block}}});
        return isGood;
    });
    return isGood;
}

bool HistoryImport::commit(const QList<Backfill> &backfills)
{
    ArchiveInbox::Contents contents;
    contents.backfills = backfills;
    m_recorder.take(contents, m_now);
    return m_recorder.commit(m_now);
}

} // namespace gorizont::tool
