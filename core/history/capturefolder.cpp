#include "core/history/capturefolder.h"

#include "core/files/wholefile.h"
#include "core/history/historyformat.h"
#include "core/values/captureformat.h"

#include <QDir>
#include <QDirIterator>
#include <QRegularExpression>

#include <array>

namespace gorizont {

namespace {

const QString csv = QStringLiteral("csv");
const QString wav = QStringLiteral("wav");

/// A file that was being written ends with six letters of its own.
const QStringList unfinishedNames{QStringLiteral("*_ch*.csv.??????"), QStringLiteral("*_ch*.wav.??????")};

struct CaptureName
{
    QDateTime local; ///< without a zone
    int number = 0; ///< N
};

std::optional<CaptureName> parse(const QString &name)
{
    static const QRegularExpression pattern(
        QStringLiteral(R"(^(\d\d_\d\d_\d\d_\d\d_\d\d_\d\d)_(\d{1,6})_ch\d(_5000|_200)?\.(csv|wav)$)"));
    const QRegularExpressionMatch match = pattern.match(name);
    const QDateTime local =
        QDateTime::fromString(QStringLiteral("20") + match.captured(1), QStringLiteral("yyyy_MM_dd_HH_mm_ss"));
    return match.hasMatch() && local.isValid() ? std::optional(CaptureName{local, match.captured(2).toInt()})
                                               : std::nullopt;
}

UtcTime utcOf(const QDateTime &local, const QTimeZone &zone)
{
    const QDateTime there = zone.isValid() ? QDateTime(local.date(), local.time(), zone) : local;
    return UtcTime(std::chrono::milliseconds(there.toMSecsSinceEpoch()));
}

} // namespace

QString captureFileName(const QDateTime &local, const SignalCapture &captured, const QString &suffix)
{
    static constexpr std::array<const char *, 3> kinds{"", "_5000", "_200"};
    return QStringLiteral("%1_%2_ch%3%4.%5")
        .arg(local.toString(u"yy_MM_dd_hh_mm_ss"))
        .arg(captured.number)
        .arg(captured.information.channel)
        .arg(QLatin1String(kinds.at(static_cast<std::size_t>(captured.kind))), suffix);
}

CaptureFolder::CaptureFolder(const HistoryConfig &config, Note note)
    : m_folder(config.folder + QStringLiteral("/Vims"))
    , m_zone(config.zone)
    , m_note(std::move(note))
{
    for (const LineConfig &line : config.lines) {
        for (const SensorConfig &sensor : line.sensors) {
            const CapturePlan plan = CapturePlan::from(sensor);
            if (sensor.type == SensorType::LVims && plan.isOn()) {
                m_plans.insert(sensor.number, plan);
            }
        }
    }
}

void CaptureFolder::open()
{
    QDirIterator unfinished(m_folder, unfinishedNames, QDir::Files);
    while (isInUse() && unfinished.hasNext()) {
        QFile::remove(unfinished.next());
    }
}

void CaptureFolder::save(const SignalCapture &captured)
{
    const auto plan = m_plans.constFind(captured.number);
    if (plan == m_plans.constEnd()) {
        return;
    }
    QString problem;
    if (captured.kind != CaptureKind::Waveform) {
        problem = write(captured, csv, spectrumCsv(captured.information, captured.codes));
    } else {
        if (plan->savesCsv) {
            problem = write(captured, csv, waveformCsv(captured.information, captured.codes));
        }
        if (plan->savesWav && problem.isEmpty()) {
            problem = write(captured, wav, waveformWav(captured.information, captured.codes));
        }
    }
    noteOutcome(problem);
}

/// A clock that was set back must not overwrite anything: the name is that of the next free second.
QString CaptureFolder::write(const SignalCapture &captured, const QString &suffix, const QByteArray &bytes) const
{
    constexpr int mostTries = 3600;
    QDir().mkpath(m_folder);
    QString path;
    for (int i = 0; i < mostTries; ++i) {
        const QDateTime local = localTime(captured.time + std::chrono::seconds(i), m_zone);
        path = m_folder + u'/' + captureFileName(local, captured, suffix);
        if (!QFile::exists(path)) {
            return writeWholeFile(path, bytes);
        }
    }
    return path;
}

void CaptureFolder::noteOutcome(const QString &problem)
{
    const bool isFailing = !problem.isEmpty();
    if (isFailing == std::exchange(m_isFailing, isFailing)) {
        return;
    }
    if (isFailing) {
        m_note(
            JournalKind::Error,
            tr("A capture of an L-VIMS is lost, it could not be saved: %1. So will be those that follow, until there "
               "is "
               "room for them.")
                .arg(problem));
    } else {
        m_note(JournalKind::Info, tr("The captures of the L-VIMS are being saved again."));
    }
}

void CaptureFolder::removeOld(UtcTime now)
{
    QDirIterator files(m_folder, QDir::Files);
    while (isInUse() && files.hasNext()) {
        files.next();
        const auto name = parse(files.fileName());
        const auto plan = name ? m_plans.constFind(name->number) : m_plans.constEnd();
        if (plan != m_plans.constEnd() && plan->keep.count() > 0 && utcOf(name->local, m_zone) < now - plan->keep) {
            QFile::remove(files.filePath());
        }
    }
}

} // namespace gorizont
