#include "tests/ui/windowbench.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QClipboard>
#include <QDialog>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSplitter>
#include <QTabWidget>
#include <QTableView>
#include <QTreeView>
#include <QtTest>

using namespace gorizont;

/// The window as an operator uses it: real, offscreen, its widgets found by their names.
class TestMainWindow : public QObject, protected test::WindowBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { useOwnSettings(); }
    void init() { begin(); }
    void cleanup() { end(); }

    /// Manual 000, sections 4.1 – 4.5: a tab exists only while its element is selected.
    void tabsFollowTheTree()
    {
        QCOMPARE(tabs("stateTabs"), QStringList({QStringLiteral("Ports"), QStringLiteral("Sensors")}));
        m_window->select(SiteItem::line(0));
        QCOMPARE(tabs("stateTabs"), QStringList({QStringLiteral("Port")}));
        m_window->select(SiteItem::sensor(0));
        QCOMPARE(tabs("stateTabs"), QStringList({QStringLiteral("Sensor")}));
        m_window->select(SiteItem::server());
        QCOMPARE(tabs("stateTabs").size(), 2);
        QCOMPARE(
            tabs("infoTabs"),
            QStringList({QStringLiteral("Settings"), QStringLiteral("Measurements"), QStringLiteral("Journal")}));
    }

    void valuesAppear()
    {
        trigger("goAction2");
        QCOMPARE(cell("sensorsTable", 0, 1), QStringLiteral("—"));
        m_registry->update({test::sampleReading(std::chrono::steady_clock::now())});
        QTRY_COMPARE(cell("sensorsTable", 0, 1), QStringLiteral("-1.000"));
        m_window->select(SiteItem::sensor(0));
        QCOMPARE(cell("sensorTable", 2, 1), QStringLiteral("-1.000 +0.756 (-3599.5 +2720.5)"));
        Reading next = test::sampleReading(std::chrono::steady_clock::now());
        next.tilt = Tilt{3600, 0};
        m_registry->update({next});
        QTRY_COMPARE(cell("sensorTable", 2, 1), QStringLiteral("+1.000 +0.000 (+3600.0 +0.0)"));
    }

    void settingsFollowTheTree()
    {
        QCOMPARE(cell("settingsTable", 0, 0), QStringLiteral("[Server]"));
        m_window->select(SiteItem::line(0));
        QCOMPARE(cell("settingsTable", 0, 0), QStringLiteral("[Port]"));
        m_window->select(SiteItem::sensor(1));
        QCOMPARE(cell("settingsTable", 0, 0), QStringLiteral("[Sensor]"));
        QCOMPARE(cell("settingsTable", 4, 1), QStringLiteral("24"));
    }

    void shortcutsGoEverywhere()
    {
        m_window->select(SiteItem::sensor(2));
        trigger("goAction3");
        QCOMPARE(currentNode(), QStringLiteral("COM9"));
        trigger("goAction4");
        QCOMPARE(currentNode(), QStringLiteral("3 ИН-Д3 [5]"));
        trigger("goAction1");
        QCOMPARE(currentNode(), QStringLiteral("Server"));
        m_window->select(SiteItem::line(0));
        trigger("goAction4");
        QCOMPARE(currentNode(), QStringLiteral("1 АН-Д3 [Этаж 2] [12]"));
        QCOMPARE(find<QAction>("goAction4")->shortcut(), QKeySequence(QStringLiteral("Ctrl+4")));
    }

    void doubleClickSelectsInTheTree()
    {
        trigger("goAction2");
        auto *table = find<QTableView>("sensorsTable");
        const QRect row = table->visualRect(table->model()->index(2, 1));
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, row.center());
        QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, row.center());
        QCOMPARE(currentNode(), QStringLiteral("3 ИН-Д3 [5]"));
    }

    void searchFindsSensors()
    {
        trigger("findAction");
        auto *search = find<QLineEdit>("treeSearch");
        QTest::keyClicks(search, QStringLiteral("-"));
        QCOMPARE(currentNode(), QStringLiteral("1 АН-Д3 [Этаж 2] [12]"));
        QTest::keyClick(search, Qt::Key_Return);
        QCOMPARE(currentNode(), QStringLiteral("2 ИН-Д3 [24]"));
        search->clear();
        QTest::keyClicks(search, QStringLiteral("[5]"));
        QCOMPARE(currentNode(), QStringLiteral("3 ИН-Д3 [5]"));
    }

    void copyGivesTabSeparatedRows()
    {
        trigger("goAction1");
        auto *table = find<QTableView>("portsTable");
        table->selectAll();
        table->setFocus();
        QTest::keySequence(table, QKeySequence::Copy);
        QCOMPARE(
            QGuiApplication::clipboard()->text(),
            QStringLiteral("COM4\tOpening\t—\t0\t0\t0\nCOM9\tOpening\t—\t0\t0\t0\nCOM2\tOff\t—\t0\t0\t0"));
    }

    void measurementsFollowTheEndUntilScrolledAway()
    {
        trigger("goAction6");
        auto *table = find<QTableView>("measurementsTable");
        for (int i = 0; i < 59; ++i) {
            m_window->appendMeasurement(QString::number(i));
        }
        QTRY_VERIFY(table->verticalScrollBar()->maximum() > 0);
        QTRY_COMPARE(table->verticalScrollBar()->value(), table->verticalScrollBar()->maximum());
        table->verticalScrollBar()->setValue(0);
        m_window->appendMeasurement(QStringLiteral("59"));
        QTest::qWait(20);
        QCOMPARE(table->verticalScrollBar()->value(), 0);
        m_window->appendMeasurement(QStringLiteral("60"));
        QCOMPARE(table->model()->rowCount(), 60); // MemoCount, MemoDel
        QCOMPARE(cell("measurementsTable", 0, 0), QStringLiteral("1"));
    }

    void journalIsColouredAndFiltered()
    {
        m_journal->add(JournalKind::On, QStringLiteral("on"));
        m_journal->add(JournalKind::Error, QStringLiteral("error"));
        const auto *model = find<QTableView>("journalTable")->model();
        QCOMPARE(model->rowCount(), 2);
        const QColor error = model->index(1, 0).data(Qt::ForegroundRole).value<QColor>();
        QVERIFY(error.red() > error.green() && error.red() > error.blue());
        find<QCheckBox>("showErrors")->click();
        QCOMPARE(model->rowCount(), 1);
        QVERIFY(model->index(0, 0).data().toString().endsWith(QStringLiteral("   on")));
    }

    void statusBarCounts()
    {
        Reading silent = test::tiltReading(2, 0, 0, std::chrono::steady_clock::now());
        silent.status = 0x3700;
        m_registry->update({test::sampleReading(std::chrono::steady_clock::now()), silent});
        QTRY_COMPARE(
            find<QLabel>("sensorCounts")->text(),
            QStringLiteral("Sensors good: 1, with errors: 1, starting: 1, off: 1"));
        m_window->setServerStatus(QStringLiteral("Modbus: 3"));
        QCOMPARE(find<QLabel>("serverStatus")->text(), QStringLiteral("Modbus: 3"));
    }

    /// What is wrong, where, and from there to the element in the tree.
    void bannerLeadsToTheListAndTheSensor()
    {
        const auto *banner = find<QWidget>("attentionBanner");
        QVERIFY(!banner->isVisible());
        Reading silent = test::tiltReading(3, 0, 0, std::chrono::steady_clock::now());
        silent.status = 0x3700;
        m_registry->update({silent});
        QTRY_VERIFY(banner->isVisible());
        find<QAbstractButton>("attentionShow")->click();
        const auto *dialog = find<QDialog>("attentionDialog");
        QVERIFY(dialog->isVisible() && !dialog->isModal());
        QCOMPARE(currentNode(), QStringLiteral("Server")); // the list is beside the work, not in its way
        auto *table = find<QTableView>("attentionTable");
        const QRect row = table->visualRect(table->model()->index(0, 1));
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, row.center());
        QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, row.center());
        QCOMPARE(currentNode(), QStringLiteral("3 ИН-Д3 [5]"));
        find<QAbstractButton>("attentionAccept")->click();
        QVERIFY(!banner->isVisible());
        QVERIFY(find<QTreeView>("siteTree")
                    ->currentIndex()
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains(QStringLiteral("No answer"))); // the sensor stays marked
        find<QAbstractButton>("attentionClose")->click();
        QVERIFY(!dialog->isVisible());
        trigger("goAction8");
        QVERIFY(dialog->isVisible());
        QCOMPARE(find<QAction>("goAction8")->shortcut(), QKeySequence(QStringLiteral("Ctrl+8")));
    }

    void aboutTellsVersionAndLicence()
    {
        trigger("aboutAction");
        const auto *box = find<QMessageBox>("aboutDialog");
        QVERIFY(box->isVisible());
        QVERIFY(box->text().contains(QStringLiteral(GORIZONT_VERSION)));
        QVERIFY(box->informativeText().contains(QStringLiteral("GNU General Public License")));
        find<QAbstractButton>("aboutClose")->click();
        QTRY_VERIFY(!m_window->findChild<QMessageBox *>());
    }

    void registerMapIsAskedFor()
    {
        const QSignalSpy asked(m_window.get(), &MainWindow::registerMapRequested);
        trigger("registerMapAction");
        QCOMPARE(asked.size(), 1);
    }

    void opcTagsAreAskedForWhereTheyAreServed()
    {
        QVERIFY(!m_window->findChild<QAction *>(QStringLiteral("opcTagsAction")));
        m_config.servesOpc = true;
        open({});
        const QSignalSpy asked(m_window.get(), &MainWindow::opcTagsRequested);
        trigger("opcTagsAction");
        QCOMPARE(asked.size(), 1);
    }

    void complaintsAreShownOnce()
    {
        open({Complaint{
            QStringLiteral("Timers"), QStringLiteral("TmRun"), 3, QStringLiteral("bad."), QStringLiteral("ok.")}});
        QTRY_VERIFY(m_window->findChild<QDialog *>(QStringLiteral("complaintsDialog")));
        QPointer<QDialog> dialog = m_window->findChild<QDialog *>(QStringLiteral("complaintsDialog"));
        QVERIFY(dialog->isVisible() && !dialog->isModal());
        dialog->close();
        QTRY_VERIFY(!dialog);
        m_window->hide();
        m_window->raiseWindow();
        QTest::qWait(20);
        QVERIFY(!m_window->findChild<QDialog *>(QStringLiteral("complaintsDialog")));
    }

    /// Tests and scripts find everything by name.
    void everythingHasAName()
    {
        for (const QWidget *widget : m_window->findChildren<QWidget *>()) {
            const bool isOurs = qobject_cast<const QAbstractItemView *>(widget)
                || qobject_cast<const QAbstractButton *>(widget) || qobject_cast<const QLineEdit *>(widget)
                || qobject_cast<const QTabWidget *>(widget) || qobject_cast<const QSplitter *>(widget);
            const bool isPart = widget->parentWidget()->inherits("QAbstractItemView")
                || widget->parentWidget()->inherits("QTabBar") || widget->parentWidget()->inherits("QLineEdit")
                || widget->inherits("QHeaderView");
            if (isOurs && !isPart) {
                QVERIFY2(!widget->objectName().isEmpty(), widget->metaObject()->className());
            }
        }
    }

private:
    QString cell(const char *table, int row, int column) const
    {
        return find<QTableView>(table)->model()->index(row, column).data().toString();
    }

    QString currentNode() const { return find<QTreeView>("siteTree")->currentIndex().data().toString(); }

    QStringList tabs(const char *name) const
    {
        const auto *widget = find<QTabWidget>(name);
        QStringList titles;
        for (int i = 0; i < widget->count(); ++i) {
            if (widget->isTabVisible(i)) {
                titles += widget->tabText(i);
            }
        }
        return titles;
    }
};

QTEST_MAIN(TestMainWindow)
#include "tst_mainwindow.moc"
