#include "core/alarms/alarmwatch.h"
#include "tests/ui/samplesite.h"
#include "ui/mainwindow.h"

#include <QAction>
#include <QSettings>
#include <QSplitter>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QtTest>

using namespace gorizont;

/// Pages that need the whole height of the window, beside the tabs of the manual.
class TestWidePages : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_settings.isValid());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
    }
    void init();
    void cleanup();

    void standsBesideTheTabsOfEverySelection();
    void takesTheHeightOfTheLowerPanel();
    void staysWhileSomethingElseIsSelected();
    void keysOfOtherTabsLeaveIt();
    void theWindowKeepsItsDivision();

private:
    QTabWidget *tabs() const { return m_window->findChild<QTabWidget *>(QStringLiteral("stateTabs")); }
    QWidget *lower() const { return m_window->findChild<QSplitter *>(QStringLiteral("rowsSplitter"))->widget(1); }
    QStringList visibleTabs() const;
    void press(Qt::Key key) { QTest::keyClick(m_window.get(), key, Qt::ControlModifier); }

    QTemporaryDir m_settings;
    std::unique_ptr<SensorRegistry> m_registry;
    Journal m_journal;
    std::unique_ptr<AlarmWatch> m_alarms;
    std::unique_ptr<MainWindow> m_window;
    QWidget *m_page = nullptr;
};

void TestWidePages::init()
{
    const ServerConfig config = test::sampleConfig();
    m_registry = std::make_unique<SensorRegistry>(config.lines, StatusRules());
    m_alarms = std::make_unique<AlarmWatch>(*m_registry);
    m_window = std::make_unique<MainWindow>(*m_registry, m_journal, *m_alarms, config, QList<Complaint>());
    m_page = new QWidget;
    m_page->setObjectName(QStringLiteral("curves"));
    m_window->addWidePage(m_page, QStringLiteral("Curves"), QKeySequence(Qt::Key_F6));
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
}

void TestWidePages::cleanup()
{
    m_window.reset();
    m_alarms.reset();
    m_registry.reset();
}

QStringList TestWidePages::visibleTabs() const
{
    QStringList titles;
    for (int i = 0; i < tabs()->count(); ++i) {
        if (tabs()->isTabVisible(i)) {
            titles += tabs()->tabText(i);
        }
    }
    return titles;
}

void TestWidePages::standsBesideTheTabsOfEverySelection()
{
    m_window->select(SiteItem::server());
    QCOMPARE(
        visibleTabs(), QStringList({QStringLiteral("Ports"), QStringLiteral("Sensors"), QStringLiteral("Curves")}));
    m_window->select(SiteItem::line(0));
    QCOMPARE(visibleTabs(), QStringList({QStringLiteral("Port"), QStringLiteral("Curves")}));
    QCOMPARE(tabs()->tabText(tabs()->currentIndex()), QStringLiteral("Port"));
    m_window->select(SiteItem::sensor(1));
    QCOMPARE(visibleTabs(), QStringList({QStringLiteral("Sensor"), QStringLiteral("Curves")}));
    QCOMPARE(tabs()->tabText(tabs()->currentIndex()), QStringLiteral("Sensor"));
}

void TestWidePages::takesTheHeightOfTheLowerPanel()
{
    QVERIFY(lower()->isVisible());
    QTest::keyClick(m_window.get(), Qt::Key_F6);
    QCOMPARE(tabs()->currentWidget(), m_page);
    QVERIFY(!lower()->isVisible());
    tabs()->setCurrentIndex(1);
    QVERIFY(lower()->isVisible());
}

void TestWidePages::staysWhileSomethingElseIsSelected()
{
    QTest::keyClick(m_window.get(), Qt::Key_F6);
    for (const SiteItem item : {SiteItem::sensor(0), SiteItem::line(1), SiteItem::server(), SiteItem::sensor(2)}) {
        m_window->select(item);
        QCOMPARE(tabs()->currentWidget(), m_page);
    }
    QCOMPARE(visibleTabs(), QStringList({QStringLiteral("Sensor"), QStringLiteral("Curves")}));
}

void TestWidePages::keysOfOtherTabsLeaveIt()
{
    const QList<QPair<Qt::Key, QString>> keys{
        {Qt::Key_1, QStringLiteral("Ports")},
        {Qt::Key_2, QStringLiteral("Sensors")},
        {Qt::Key_3, QStringLiteral("Port")},
        {Qt::Key_4, QStringLiteral("Sensor")}};
    for (const auto &[key, title] : keys) {
        QTest::keyClick(m_window.get(), Qt::Key_F6);
        QCOMPARE(tabs()->currentWidget(), m_page);
        press(key);
        QCOMPARE(tabs()->tabText(tabs()->currentIndex()), title);
    }
    QTest::keyClick(m_window.get(), Qt::Key_F6);
    press(Qt::Key_7);
    QCOMPARE(tabs()->tabText(tabs()->currentIndex()), QStringLiteral("Sensor"));
    QVERIFY(lower()->isVisible());
}

void TestWidePages::theWindowKeepsItsDivision()
{
    auto *rows = m_window->findChild<QSplitter *>(QStringLiteral("rowsSplitter"));
    rows->setSizes({300, 350});
    const QList<int> sizes = rows->sizes();
    QTest::keyClick(m_window.get(), Qt::Key_F6);
    press(Qt::Key_1);
    QTRY_COMPARE(rows->sizes(), sizes);
    QTest::keyClick(m_window.get(), Qt::Key_F6);
    QVERIFY(m_window->close());
    cleanup();
    init();
    rows = m_window->findChild<QSplitter *>(QStringLiteral("rowsSplitter"));
    QTRY_COMPARE(rows->sizes(), sizes);
}

QTEST_MAIN(TestWidePages)

#include "tst_widepages.moc"
