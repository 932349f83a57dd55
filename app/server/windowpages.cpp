#include "app/server/windowpages.h"

#include "app/archivesource.h"
#include "core/archive/archivereader.h"
#include "core/config/serverconfig.h"
#include "core/registry/sensorregistry.h"
#include "core/station/stationfolder.h"
#include "ui/displacement/displacementpage.h"
#include "ui/history/historypage.h"
#include "ui/mainwindow.h"
#include "ui/plots/trendspage.h"
#include "ui/plots/waveformpage.h"
#include "ui/plots/xypage.h"
#include "ui/vibration/vibrationpage.h"
#include "ui/weather/weatherpage.h"

#include <QCoreApplication>
#include <QDir>

#include <algorithm>

namespace gorizont {

namespace {

bool anySensor(const SensorRegistry &registry, bool SensorConfig::*measures)
{
    return std::ranges::any_of(registry.sensors(), [measures](const SensorRegistry::Sensor &sensor) {
        return sensor.config.*measures;
    });
}

bool hasVibration(const SensorRegistry &registry)
{
    return std::ranges::any_of(registry.sensors(), [](const SensorRegistry::Sensor &sensor) {
        return sensor.config.type == SensorType::LVims;
    });
}

/// Of the stations that run in this program (`Device=station:DIR`): what their files have wrong now.
void showStationFiles(WeatherPage &page, const SensorRegistry &registry)
{
    const QString scheme = QStringLiteral("station:");
    for (const SensorRegistry::Sensor &sensor : registry.sensors()) {
        const QString &device = registry.lines()[static_cast<std::size_t>(sensor.line)].config.device;
        if (sensor.config.type != SensorType::Mk14 || !device.startsWith(scheme, Qt::CaseInsensitive)) {
            continue;
        }
        const station::StationReading reading = station::readStationIn(device.sliced(scheme.size()));
        QList<StationFileComplaint> complaints;
        for (const station::StationComplaint &one : reading.complaints) {
            complaints += StationFileComplaint{one.file, one.line, one.field, one.fieldName, one.problem, one.action};
        }
        page.setFileComplaints(sensor.config.number, complaints);
    }
}

QString title(const char *text)
{
    return QCoreApplication::translate("WindowPages", text);
}

} // namespace

void addWindowPages(MainWindow &window, const PageSources &sources)
{
    const bool isArchived = sources.config.archive.isOn;
    const SeriesSource series = isArchived ? sources.archive.source() : SeriesSource();
    auto *trends = new TrendsPage(sources.registry, series);
    trends->setGravity(sources.config.gravity);
    window.addWidePage(trends, title(QT_TRANSLATE_NOOP("WindowPages", "Trends")), QKeySequence(Qt::Key_F6));
    auto *history = new HistoryPage(sources.registry, sources.config.name);
    if (isArchived) {
        history->setSource(archiveSource(sources.archive));
    }
    // A page of its own F5 would make the key ambiguous, and nobody would get it.
    QObject::connect(&window, &MainWindow::retryRequested, history, &HistoryPage::refresh);
    window.addWidePage(history, title(QT_TRANSLATE_NOOP("WindowPages", "History")), QKeySequence(Qt::Key_F7));
    if (anySensor(sources.registry, &SensorConfig::measuresTilt)) {
        window.addWidePage(
            new XyPage(sources.registry, series), title(QT_TRANSLATE_NOOP("WindowPages", "Hodograph")),
            QKeySequence(Qt::Key_F9));
    }
    if (anySensor(sources.registry, &SensorConfig::measuresAcceleration)) {
        window.addWidePage(
            new WaveformPage(sources.registry, series), title(QT_TRANSLATE_NOOP("WindowPages", "Oscillations")),
            QKeySequence(Qt::Key_F12));
    }
    if (hasVibration(sources.registry)) {
        window.addWidePage(
            new VibrationPage(sources.registry, sources.worker, sources.config.timing),
            title(QT_TRANSLATE_NOOP("WindowPages", "Vibration")), QKeySequence(Qt::Key_F11));
    }
    if (!sources.registry.chains().isEmpty()) {
        const QString zeros = QDir(sources.dataFolder).filePath(QStringLiteral("Zero"));
        auto *displacement = new DisplacementPage(sources.registry, zeros);
        window.addWidePage(
            displacement, title(QT_TRANSLATE_NOOP("WindowPages", "Displacement")), QKeySequence(Qt::Key_F8));
    }
    if (WeatherPage::hasStation(sources.registry)) {
        auto *weather = new WeatherPage(sources.registry);
        showStationFiles(*weather, sources.registry);
        QObject::connect(&window, &MainWindow::retryRequested, weather, [weather, &registry = sources.registry] {
            showStationFiles(*weather, registry);
        });
        window.addWidePage(weather, title(QT_TRANSLATE_NOOP("WindowPages", "Weather")), QKeySequence(Qt::Key_F3));
    }
}

} // namespace gorizont
