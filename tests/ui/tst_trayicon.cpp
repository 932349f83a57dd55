#include "ui/trayicon.h"

#include "core/alarms/alarmwatch.h"
#include "tests/ui/samplesite.h"
#include "ui/mainwindow.h"
#include "ui/models/icons.h"

#include <QDialog>
#include <QtTest>

using namespace gorizont;

class TestTrayIcon : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsTheWorstState()
    {
        const SteadyTime now = std::chrono::steady_clock::now();
        m_registry.updateLine(test::openLine(1, now));
        LineStatus lost;
        lost.port = 2;
        lost.state = LineState::Lost;
        m_registry.updateLine(lost);
        m_registry.update({test::sampleReading(now), test::tiltReading(2, 0, 0, now)});
        m_tray.refresh();
        QCOMPARE(m_tray.icon().icon().cacheKey(), icons::tray(Health::Error).cacheKey());
        const QString counts = QStringLiteral("Gorizont Server (тест)\nSensors good: 2, starting: 1, off: 1");
        QCOMPARE(m_tray.icon().toolTip(), counts + QStringLiteral("\nMessages for the dispatcher: 1"));
        m_alarms.acknowledge({m_alarms.unacknowledged().first().id});
        QCOMPARE(m_tray.icon().toolTip(), counts); // at once
        QCOMPARE(m_tray.icon().icon().cacheKey(), icons::tray(Health::Error).cacheKey()); // it is not mended
    }

    void aClickOnANotificationOpensTheList()
    {
        QVERIFY(!m_window.isVisible());
        Q_EMIT m_tray.icon().messageClicked();
        QVERIFY(m_window.isVisible());
        const auto *dialog = m_window.findChild<QDialog *>(QStringLiteral("attentionDialog"));
        QVERIFY(dialog && dialog->isVisible());
    }

private:
    SensorRegistry m_registry{test::sampleConfig().lines, StatusRules()};
    AlarmWatch m_alarms{m_registry};
    Journal m_journal;
    MainWindow m_window{m_registry, m_journal, m_alarms, test::sampleConfig(), {}};
    TrayIcon m_tray{m_window, m_registry, m_alarms};
};

QTEST_MAIN(TestTrayIcon)
#include "tst_trayicon.moc"
