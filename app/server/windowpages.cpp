#include "app/server/windowpages.h"

#include "app/archivesource.h"
#include "core/archive/archivereader.h"
#include "core/config/serverconfig.h"
#include "core/registry/sensorregistry.h"
#include "ui/displacement/displacementpage.h"
#include "ui/history/historypage.h"
#include "ui/mainwindow.h"
#include "ui/plots/trendspage.h"

#include <QCoreApplication>
#include <QDir>

namespace gorizont {

namespace {

QString title(const char *text)
{
    return QCoreApplication::translate("WindowPages", text);
}

} // namespace

void addWindowPages(MainWindow &window, const PageSources &sources)
{
    const bool isArchived = sources.config.archive.isOn;
    auto *trends = new TrendsPage(sources.registry, isArchived ? sources.archive.source() : SeriesSource());
    window.addWidePage(trends, title(QT_TRANSLATE_NOOP("WindowPages", "Trends")), QKeySequence(Qt::Key_F6));
    auto *history = new HistoryPage(sources.registry, sources.config.name);
    if (isArchived) {
        history->setSource(archiveSource(sources.archive));
    }
    window.addWidePage(history, title(QT_TRANSLATE_NOOP("WindowPages", "History")), QKeySequence(Qt::Key_F7));
    if (!sources.registry.chains().isEmpty()) {
        const QString zeros = QDir(sources.dataFolder).filePath(QStringLiteral("Zero"));
        auto *displacement = new DisplacementPage(sources.registry, zeros);
        window.addWidePage(
            displacement, title(QT_TRANSLATE_NOOP("WindowPages", "Displacement")), QKeySequence(Qt::Key_F8));
    }
}

} // namespace gorizont
