// The page of trends on a folder of old files instead of the archive.

#include "ui/plots/trendplot.h"
#include "ui/plots/trendspage.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QPromise>
#include <QThreadPool>

namespace gorizont {

namespace {

QFuture<HistoryOverview> lookInto(const HistoryFolder &folder)
{
    auto promise = std::make_shared<QPromise<HistoryOverview>>();
    promise->start();
    QFuture<HistoryOverview> future = promise->future();
    QThreadPool::globalInstance()->start([promise, folder] {
        promise->addResult(overviewOf(folder));
        promise->finish();
    });
    return future;
}

} // namespace

void TrendsPage::askOldFiles()
{
    auto *dialog = new QFileDialog(this, tr("Open old files: the folder History"));
    dialog->setObjectName(QStringLiteral("oldFilesDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, this, &TrendsPage::openOldFiles);
    dialog->open();
}

/// Returns at once; the files are shown when the folder has been looked into.
void TrendsPage::openOldFiles(const QString &path)
{
    m_folder = {};
    m_folder.path = path;
    m_folder.gravity = m_gravity;
    for (const SensorRegistry::Sensor &sensor : m_registry.sensors()) {
        m_folder.sensors.append(sensor.config);
    }
    m_overview.setFuture(lookInto(m_folder));
}

void TrendsPage::takeOverview()
{
    const HistoryOverview overview = m_overview.result();
    const QString path = QDir::toNativeSeparators(m_folder.path);
    if (overview.span) {
        showOldFiles(m_folder.path, *overview.span, historySource(m_folder));
    } else if (overview.foreign > 0) {
        tell(tr("The records in %1 hold another number of sensors than this configuration, so nobody knows whose they "
                "are. Start the program with the configuration they were made with.")
                 .arg(path));
    } else {
        tell(tr("There are no old records in %1. Choose the folder with files like 2018_02_data.txt.").arg(path));
    }
}

void TrendsPage::showOldFiles(const QString &path, const TimeSpan &span, SeriesSource source)
{
    m_files = span;
    m_filesPath = QDir::toNativeSeparators(path);
    m_now->setEnabled(false);
    m_archive->setVisible(true);
    showSpan(span);
    m_feed->setSource(std::move(source), false); // asks for this span at once
}

void TrendsPage::closeOldFiles()
{
    m_files.reset();
    m_now->setEnabled(true);
    m_archive->setVisible(false);
    const TimeSpan shown = m_plot->span();
    follow(std::chrono::round<std::chrono::seconds>(shown.to - shown.from));
    setSource(m_source);
}

void TrendsPage::showBeginning()
{
    const TimeSpan shown = m_plot->span();
    if (m_files) {
        showSpan({m_files->from, m_files->from + (shown.to - shown.from)});
    } else {
        m_plot->move(-1);
    }
}

void TrendsPage::showEnd()
{
    const TimeSpan shown = m_plot->span();
    if (m_files) {
        showSpan({m_files->to - (shown.to - shown.from), m_files->to});
    } else {
        setFollowing(true);
    }
}

} // namespace gorizont
