// What the window costs the main thread on the largest site: 16 ports × 255 sensors, all values changing at 10 Hz, one
// batch a port. `bench_window [seconds]` prints the share of one core, visible on each page and hidden; the readings come from
// another thread, as they do in the program. `bench_window --shots FOLDER [ru|en]` writes pictures of a small site instead.

#include "core/alarms/alarmwatch.h"
#include "ui/firstrundialog.h"
#include "ui/mainwindow.h"

#include "tests/ui/samplesite.h"
#include "translations/translation.h"

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QTabWidget>
#include <QTableView>
#include <QThread>
#include <QTimer>

#include <cmath>
#include <cstdio>
#include <ctime>

using namespace gorizont;

namespace {

constexpr int ports = 16;
constexpr int sensorsOfPort = 255;

QList<LineConfig> largestSite()
{
    QList<LineConfig> lines;
    const SensorConfig sample = test::sampleConfig().lines.first().sensors.first();
    for (int port = 1; port <= ports; ++port) {
        LineConfig line;
        line.index = port;
        line.com = port;
        line.isOn = true;
        for (int index = 1; index <= sensorsOfPort; ++index) {
            SensorConfig sensor = sample;
            sensor.port = port;
            sensor.index = index;
            sensor.number = (port - 1) * sensorsOfPort + index;
            sensor.address = index;
            line.sensors.append(sensor);
        }
        lines.append(line);
    }
    return lines;
}

/// One port's thread: a batch of new values ten times a second.
void feed(SensorRegistry &registry, QObject &clock, int port)
{
    auto *timer = new QTimer(&clock);
    timer->setTimerType(Qt::PreciseTimer);
    QObject::connect(timer, &QTimer::timeout, &clock, [&registry, port, turn = 0]() mutable {
        ++turn;
        Readings batch;
        batch.reserve(sensorsOfPort);
        const SteadyTime now = std::chrono::steady_clock::now();
        for (int i = 1; i <= sensorsOfPort; ++i) {
            Reading reading = test::sampleReading(now);
            reading.number = (port - 1) * sensorsOfPort + i;
            reading.tilt = Tilt{3600 * std::sin(turn + i), 3600 * std::cos(turn + i)};
            reading.temperature = 20 + std::sin(0.1 * turn + i);
            batch.append(reading);
        }
        QMetaObject::invokeMethod(
            &registry, [&registry, batch] { registry.update(batch); }, Qt::QueuedConnection);
    });
    timer->start(100);
}

double threadSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void measure(const char *what, int seconds)
{
    QEventLoop loop;
    QTimer::singleShot(1000, &loop, &QEventLoop::quit); // what the change of page itself costs is not meant
    loop.exec();
    const double before = threadSeconds();
    QTimer::singleShot(seconds * 1000, &loop, &QEventLoop::quit);
    loop.exec();
    std::printf("%-24s %5.2f %% of a core\n", what, 100 * (threadSeconds() - before) / seconds);
    std::fflush(stdout);
}

void bench(int seconds)
{
    ServerConfig config = test::sampleConfig();
    config.lines = largestSite();
    SensorRegistry registry(config.lines, StatusRules());
    AlarmWatch alarms(registry);
    Journal journal;
    const double before = threadSeconds();
    MainWindow window(registry, journal, alarms, config, {});
    std::printf("%-24s %5.0f ms\n", "to build the window", 1000 * (threadSeconds() - before));
    QThread thread;
    auto *clock = new QObject;
    for (int port = 1; port <= ports; ++port) {
        registry.updateLine(test::openLine(port, std::chrono::steady_clock::now()));
    }
    clock->moveToThread(&thread);
    QObject::connect(&thread, &QThread::finished, clock, &QObject::deleteLater);
    QObject::connect(&thread, &QThread::started, clock, [&registry, clock] {
        for (int port = 1; port <= ports; ++port) {
            feed(registry, *clock, port);
        }
    });
    thread.start();
    measure("no window yet", seconds);
    window.show();
    measure("visible, ports", seconds);
    window.findChild<QTabWidget *>(QStringLiteral("stateTabs"))->setCurrentIndex(1);
    measure("visible, sensors", seconds);
    window.showMaximized();
    measure("maximised, sensors", seconds);
    window.select(SiteItem::sensor(7));
    measure("visible, one sensor", seconds);
    window.hide();
    measure("hidden", seconds);
    thread.quit();
    thread.wait();
}

void shoot(QWidget &window, const QString &folder, const QString &name)
{
    QEventLoop loop;
    QTimer::singleShot(400, &loop, &QEventLoop::quit);
    loop.exec();
    window.grab().save(QDir(folder).filePath(name + QStringLiteral(".png")));
}

void takeShots(const QString &folder)
{
    ServerConfig config = test::sampleConfig();
    config.timing.run = std::chrono::milliseconds(100);
    config.closesSilently = false;
    config.replaced.insert(QStringLiteral("timers/tmrun"), QStringLiteral("-100"));
    SensorRegistry registry(config.lines, StatusRules());
    AlarmWatch alarms(registry);
    Journal journal;
    MainWindow window(registry, journal, alarms, config, {});
    const SteadyTime now = std::chrono::steady_clock::now();
    registry.updateLine(test::openLine(1, now - std::chrono::seconds(238)));
    registry.updateLine(test::openLine(2, now - std::chrono::seconds(4000)));
    Reading silent = test::tiltReading(3, 0, 0, now);
    silent.status = 0x3700;
    Reading heating = test::tiltReading(2, 100, -7200, now);
    registry.update({test::sampleReading(now), heating, silent});
    journal.add(JournalKind::Info, QStringLiteral("Программа запущена"));
    journal.add(JournalKind::On, QStringLiteral("COM4: опрос включен"));
    journal.add(JournalKind::Off, QStringLiteral("COM2: опрос отключен"));
    journal.add(JournalKind::Error, QStringLiteral("COM9: датчик 3 не отвечает"));
    for (int i = 0; i < 20; ++i) {
        window.appendMeasurement(
            QStringLiteral("18:33:%1 07.02.18\t3300\t  -264.0\t -6644.6\t\t     0.0\t 0 0011 0011 1000"
                           "\t -3599.5\t -3599.5\t   21.38\t     0.0\t 0 0000 0001 1000"
                           "\t\t\t\t     0.0\t 3 0111 0000 0000\t\t\t\t     0.0\t 0 1111 0000 0000")
                .arg(i, 2, 10, QLatin1Char('0')));
    }
    window.setServerStatus(QStringLiteral("Modbus TCP: 502"));
    window.show();
    shoot(window, folder, QStringLiteral("server-ports"));
    window.findChild<QTabWidget *>(QStringLiteral("stateTabs"))->setCurrentIndex(1);
    window.findChild<QTabWidget *>(QStringLiteral("infoTabs"))->setCurrentIndex(1);
    window.findChild<QTableView *>(QStringLiteral("sensorsTable"))->sortByColumn(3, Qt::DescendingOrder);
    shoot(window, folder, QStringLiteral("server-sensors"));
    window.select(SiteItem::line(0));
    window.findChild<QTabWidget *>(QStringLiteral("infoTabs"))->setCurrentIndex(2);
    shoot(window, folder, QStringLiteral("port"));
    window.select(SiteItem::sensor(0));
    window.findChild<QTabWidget *>(QStringLiteral("infoTabs"))->setCurrentIndex(0);
    shoot(window, folder, QStringLiteral("sensor"));
    FirstRunDialog firstRun({QStringLiteral("/opt/gorizont/GorizontServer.ini")});
    firstRun.show();
    shoot(firstRun, folder, QStringLiteral("first-run"));
    firstRun.hide();
    window.close();
    shoot(*window.findChild<QDialog *>(QStringLiteral("exitQuestion")), folder, QStringLiteral("exit-question"));
}

void makeDark()
{
    QPalette dark;
    dark.setColor(QPalette::Window, QColor(0x2b, 0x2e, 0x33));
    dark.setColor(QPalette::WindowText, QColor(0xe6, 0xe6, 0xe6));
    dark.setColor(QPalette::Base, QColor(0x1f, 0x22, 0x26));
    dark.setColor(QPalette::AlternateBase, QColor(0x25, 0x28, 0x2d));
    dark.setColor(QPalette::Text, QColor(0xe6, 0xe6, 0xe6));
    dark.setColor(QPalette::Button, QColor(0x35, 0x39, 0x3f));
    dark.setColor(QPalette::ButtonText, QColor(0xe6, 0xe6, 0xe6));
    dark.setColor(QPalette::PlaceholderText, QColor(0x9a, 0xa0, 0xa8));
    dark.setColor(QPalette::Disabled, QPalette::Text, QColor(0x80, 0x85, 0x8c));
    dark.setColor(QPalette::Highlight, QColor(0x2f, 0x6f, 0xb5));
    QApplication::setPalette(dark);
}

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == QStringLiteral("--shots")) {
        installTranslation(arguments.value(3));
        if (arguments.value(4) == QStringLiteral("dark")) {
            makeDark();
        }
        takeShots(arguments.value(2, QStringLiteral(".")));
        return 0;
    }
    bench(std::max(1, arguments.value(1, QStringLiteral("5")).toInt()));
    return 0;
}
