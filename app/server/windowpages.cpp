#include "app/server/windowpages.h"

#include "core/archive/archivereader.h"
#include "core/config/serverconfig.h"
#include "core/export/historysource.h"
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

HistorySource historyOf(ArchiveReader &archive)
{
    HistorySource source;
    source.gaps = [&archive](const QList<int> &numbers, UtcTime from, UtcTime to) {
        return archive.gaps(numbers, from, to);
    };
    source.completeness = [&archive](const QList<int> &numbers, QDate first, QDate last) {
        return archive.completeness(numbers, first, last);
    };
    source.events = [&archive](UtcTime from, UtcTime to, int most) { return archive.events(from, to, most); };
    source.series = archive.source();
    source.blocks = [&archive](int number, UtcTime from, UtcTime to) { return archive.blocks(number, from, to); };
    return source;
}

} // namespace

void addWindowPages(MainWindow &window, const PageSources &sources)
{
    const bool isArchived = sources.config.archive.isOn;
    auto *trends = new TrendsPage(sources.registry, isArchived ? sources.archive.source() : SeriesSource());
    window.addWidePage(trends, title(QT_TRANSLATE_NOOP("WindowPages", "Trends")), QKeySequence(Qt::Key_F6));
    auto *history = new HistoryPage(sources.registry, sources.config.name);
    if (isArchived) {
        history->setSource(historyOf(sources.archive));
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
