#include "core/alarms/alarmwatch.h"
#include "core/config/inifile.h"
#include "ui/mainwindow.h"

#include <QMessageBox>
#include <QSettings>
#include <QTableView>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeView>
#include <QtTest>

using namespace gorizont;

/// The keys of the ini that the window obeys, from the file to what the operator sees (manual 000, section 5). How the
/// question at the end and the tray work is in tst_mainwindow.
class TestWindowKeys : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_settings.isValid());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
    }
    void cleanup()
    {
        m_window.reset();
        m_journal.reset();
        m_registry.reset();
    }

    void captionIsTheTitle()
    {
        open("[Common]\nCaption=Башня «Восток»");
        QCOMPARE(m_window->windowTitle(), QStringLiteral("Башня «Восток»"));
        open("[Common]\n");
        QCOMPARE(m_window->windowTitle(), QStringLiteral("Gorizont Server"));
    }

    void canHideHidesAtTheStart()
    {
        open("[Common]\nCanHide=0");
        m_window->showAtStart();
        QVERIFY(m_window->isVisible() && !m_window->isMinimized());
        open("[Common]\nCanHide=1");
        m_window->showAtStart();
        QVERIFY(m_window->isMinimized()); // no tray here
        open("[Common]\nCanHide=1");
        m_window->setHidesToTray(true);
        m_window->showAtStart();
        QVERIFY(!m_window->isVisible());
    }

    void canCloseDecidesAboutTheQuestion()
    {
        open("[Common]\nCanClose=1");
        m_window->showAtStart();
        QVERIFY(m_window->close());
        open("[Common]\nCanClose=0");
        m_window->showAtStart();
        QVERIFY(!m_window->close());
        QVERIFY(m_window->findChild<QMessageBox *>(QStringLiteral("exitQuestion")));
    }

    /// Nobody reads faster than four times a second, whatever the ini says.
    void tmUpdateIntIsThePeriodOfTheWindow()
    {
        const auto interval = [this] {
            return m_window->findChild<QTimer *>(QStringLiteral("refreshTimer"))->interval();
        };
        open("[Timers]\nTmUpdateInt=100");
        QCOMPARE(interval(), 250);
        open("[Timers]\nTmUpdateInt=1300");
        QCOMPARE(interval(), 1300);
    }

    void memoCountAndMemoDelAreTheMeasurements()
    {
        open("[Common]\nMemoCount=5\nMemoDel=3");
        QCOMPARE(shownAfter(5), QStringLiteral("01234"));
        open("[Common]\nMemoCount=5\nMemoDel=3");
        QCOMPARE(shownAfter(6), QStringLiteral("345"));
        open("[Common]\nMemoCount=4");
        QCOMPARE(shownAfter(6), QStringLiteral("2345"));
    }

    void placeStandsInTheTree()
    {
        open("[Common]\nNumOfPorts=1\n[Port1]\nNum=4\nNumOfSensors=1\nName1=ИН-Д3\nN1=7\nadr1=24\nPlace1=Этаж 2");
        m_window->select(SiteItem::sensor(0));
        const auto *tree = m_window->findChild<QTreeView *>(QStringLiteral("siteTree"));
        QCOMPARE(tree->currentIndex().data().toString(), QStringLiteral("7 ИН-Д3 [Этаж 2] [24]"));
    }

private:
    void open(const QByteArray &ini)
    {
        const ServerConfig config = readServerConfig(IniFile::fromBytes(ini)).config;
        m_window.reset();
        m_alarms.reset();
        m_registry = std::make_unique<SensorRegistry>(config.lines, StatusRules());
        m_journal = std::make_unique<Journal>();
        m_alarms = std::make_unique<AlarmWatch>(*m_registry);
        m_window = std::make_unique<MainWindow>(*m_registry, *m_journal, *m_alarms, config, QList<Complaint>());
    }

    QString shownAfter(int count)
    {
        for (int i = 0; i < count; ++i) {
            m_window->appendMeasurement(QString::number(i));
        }
        const auto *model = m_window->findChild<QTableView *>(QStringLiteral("measurementsTable"))->model();
        QString text;
        for (int row = 0; row < model->rowCount(); ++row) {
            text += model->index(row, 0).data().toString();
        }
        return text;
    }

    QTemporaryDir m_settings;
    std::unique_ptr<SensorRegistry> m_registry;
    std::unique_ptr<AlarmWatch> m_alarms;
    std::unique_ptr<Journal> m_journal;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(TestWindowKeys)
#include "tst_windowkeys.moc"
