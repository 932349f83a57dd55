#include "app/server/windowpages.h"
#include "core/alarms/alarmwatch.h"
#include "core/archive/archivereader.h"
#include "tests/ui/weathersite.h"
#include "ui/history/daycalendar.h"
#include "ui/mainwindow.h"
#include "ui/pages/columnlayout.h"
#include "ui/pages/tablecolumns.h"
#include "ui/pages/tableview.h"
#include "ui/plots/trendplot.h"

#include <QAction>
#include <QApplication>
#include <QSettings>
#include <QSignalSpy>
#include <QSplitter>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTreeView>
#include <QtTest>

using namespace gorizont;
using namespace Qt::Literals::StringLiterals;

/// The real pages in the real window, as the program wires them, over an archive that has no file yet.
class TestWindowPages : public QObject
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

    void everyPageHasANameAndAKey_data();
    void everyPageHasANameAndAKey();
    void complainsAboutTheFilesOfAStation();
    void arrowsMoveTheTrend();
    void layoutsOfThePagesAreKept();
    void f5AsksTheArchiveAgain_data();
    void f5AsksTheArchiveAgain();

private:
    void open();
    template <typename T> T *find(const QString &name) const
    {
        T *found = m_window->findChild<T *>(name);
        if (!found) {
            qFatal("no widget %s", qPrintable(name));
        }
        return found;
    }
    QTabWidget *tabs() const { return find<QTabWidget>(u"stateTabs"_s); }
    void press(Qt::Key key) { QTest::keyClick(m_window.get(), key); }

    QTemporaryDir m_settings;
    ServerConfig m_config;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<SensorRegistry> m_registry;
    std::unique_ptr<AlarmWatch> m_alarms;
    std::unique_ptr<ArchiveReader> m_archive;
    Journal m_journal;
    std::unique_ptr<MainWindow> m_window;
};

void TestWindowPages::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_config = test::weatherConfig();
    m_config.archive.isOn = true;
    SensorConfig vibration;
    vibration.port = m_config.lines.first().index;
    vibration.number = 99;
    vibration.index = 99;
    vibration.type = SensorType::LVims;
    m_config.lines.first().sensors.append(vibration);
    m_registry = std::make_unique<SensorRegistry>(m_config.lines, StatusRules());
    m_registry->setChains({{7, u"Колонна"_s, {{2, 2.0}, {3, 1.0}}}});
    m_alarms = std::make_unique<AlarmWatch>(*m_registry);
    ArchiveConfig archive;
    archive.file = m_folder->filePath(u"none.sqlite"_s);
    m_archive = std::make_unique<ArchiveReader>(archive);
    open();
}

void TestWindowPages::cleanup()
{
    m_window.reset();
    m_archive.reset();
    m_alarms.reset();
    m_registry.reset();
}

void TestWindowPages::open()
{
    m_window = std::make_unique<MainWindow>(*m_registry, m_journal, *m_alarms, m_config, QList<Complaint>());
    addWindowPages(*m_window, {*m_registry, *m_archive, m_config, m_folder->path(), {}});
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

void TestWindowPages::everyPageHasANameAndAKey_data()
{
    QTest::addColumn<Qt::Key>("key");
    QTest::addColumn<QString>("page");
    QTest::newRow("trends") << Qt::Key_F6 << u"trendsPage"_s;
    QTest::newRow("history") << Qt::Key_F7 << u"historyPage"_s;
    QTest::newRow("displacement") << Qt::Key_F8 << u"displacementPage"_s;
    QTest::newRow("hodograph") << Qt::Key_F9 << u"xyPage"_s;
    QTest::newRow("vibration") << Qt::Key_F11 << u"vibrationPage"_s;
    QTest::newRow("weather") << Qt::Key_F3 << u"weatherPage"_s;
    QTest::newRow("oscillations") << Qt::Key_F12 << u"waveformPage"_s;
}

void TestWindowPages::everyPageHasANameAndAKey()
{
    QFETCH(const Qt::Key, key);
    QFETCH(const QString, page);
    press(key);
    QCOMPARE(tabs()->currentWidget()->objectName(), page);
    QCOMPARE(find<QAction>(page + u"Action"_s)->shortcut(), QKeySequence(key));
    QVERIFY(tabs()->currentWidget()->isAncestorOf(QApplication::focusWidget()));
}

/// The key of the page is enough: nobody has to click into the plot before its keys work.
/// Device=station:DIR: the third line of ACK.PAR has a word for a number; F5 reads the mended file.
void TestWindowPages::complainsAboutTheFilesOfAStation()
{
    const auto write = [this](const QByteArray &number) {
        QFile file(m_folder->filePath(u"ACK.PAR"_s));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            "; name units short code number type averaging format left right error c0 c1\n"
            "Supply V U U 1 A 60 %4.1f 0 20 5 0 1\n"
            "Temperature C T T "
            + number + " A 60 %6.2f -60 60 5 0 20\n");
    };
    write("x");
    cleanup();
    m_config.lines[1].device = u"station:"_s + m_folder->path();
    m_registry = std::make_unique<SensorRegistry>(m_config.lines, StatusRules());
    m_alarms = std::make_unique<AlarmWatch>(*m_registry);
    ArchiveConfig archive;
    archive.file = m_folder->filePath(u"none.sqlite"_s);
    m_archive = std::make_unique<ArchiveReader>(archive);
    open();
    const QAbstractItemModel *model = find<TableView>(u"stationFilesTable"_s)->model();
    const auto complaint = [model] {
        for (int row = 0; row < model->rowCount(); ++row) {
            if (model->index(row, 0).data().toString() == u"ACK.PAR"_s) {
                return model->index(row, 1).data().toString() + u' ' + model->index(row, 2).data().toString();
            }
        }
        return QString();
    };
    QVERIFY2(complaint().startsWith(u"3 5"_s), qPrintable(complaint()));
    write("1");
    press(Qt::Key_F5);
    QCOMPARE(complaint(), QString());
}

void TestWindowPages::arrowsMoveTheTrend()
{
    press(Qt::Key_F6);
    const auto *plot = find<TrendPlot>(u"trendPlot"_s);
    const UtcTime end = plot->span().to;
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_PageUp);
    QVERIFY(plot->span().to < end - std::chrono::minutes(50));
}

void TestWindowPages::layoutsOfThePagesAreKept()
{
    press(Qt::Key_F7);
    auto *columns = find<QSplitter>(u"historyColumns"_s);
    columns->setSizes({300, 600});
    const QList<int> sizes = columns->sizes();
    auto *table = find<TableView>(u"gapTable"_s);
    ColumnLayout layout = table->columns().layout();
    layout.widths.insert(1, 211);
    layout.sortColumn = 2;
    table->columns().setLayout(layout);
    layout = table->columns().layout();
    press(Qt::Key_F6);
    auto *curves = find<QSplitter>(u"trendColumns"_s);
    curves->setSizes({333, 600});
    const QList<int> curveSizes = curves->sizes();
    for (int start = 0; start < 2; ++start) { // what the first restores, the second must find again
        QVERIFY(m_window->close());
        m_window.reset();
        open();
        press(Qt::Key_F7);
        QTRY_COMPARE(find<QSplitter>(u"historyColumns"_s)->sizes(), sizes);
        QCOMPARE(find<TableView>(u"gapTable"_s)->columns().layout(), layout);
        press(Qt::Key_F6);
        QTRY_COMPARE(find<QSplitter>(u"trendColumns"_s)->sizes(), curveSizes);
    }
}

void TestWindowPages::f5AsksTheArchiveAgain_data()
{
    QTest::addColumn<QString>("focus");
    QTest::newRow("from the tree") << u"siteTree"_s;
    QTest::newRow("from the calendar") << u"dayCalendar"_s;
}

void TestWindowPages::f5AsksTheArchiveAgain()
{
    QFETCH(const QString, focus);
    press(Qt::Key_F7);
    const auto *gaps = find<TableView>(u"gapTable"_s);
    const QString asking = u"Looking for gaps…"_s;
    QTRY_VERIFY(gaps->emptyText() != asking);
    auto *focused = find<QWidget>(focus);
    focused->setFocus();
    QVERIFY(focused->hasFocus());
    const QSignalSpy retried(m_window.get(), &MainWindow::retryRequested);
    QTest::keyClick(focused, Qt::Key_F5);
    QCOMPARE(retried.size(), 1);
    QCOMPARE(gaps->emptyText(), asking);
}

QTEST_MAIN(TestWindowPages)
#include "tst_windowpages.moc"
