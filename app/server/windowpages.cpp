#include "app/server/windowpages.h"

#include "core/registry/sensorregistry.h"
#include "ui/displacement/displacementpage.h"
#include "ui/mainwindow.h"
#include "ui/plots/trendspage.h"

#include <QCoreApplication>
#include <QDir>

namespace gorizont {

void addWindowPages(MainWindow &window, SensorRegistry &registry, const PageSources &sources)
{
    window.addWidePage(
        new TrendsPage(registry, sources.series), QCoreApplication::translate("WindowPages", "Trends"),
        QKeySequence(Qt::Key_F6));
    if (!registry.chains().isEmpty()) {
        const QString zeros = QDir(sources.dataFolder).filePath(QStringLiteral("Zero"));
        window.addWidePage(
            new DisplacementPage(registry, zeros), QCoreApplication::translate("WindowPages", "Displacement"),
            QKeySequence(Qt::Key_F8));
    }
}

} // namespace gorizont
