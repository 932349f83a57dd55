#include "tests/ui/windowbench.h"

#include <QAbstractButton>
#include <QMessageBox>
#include <QScreen>
#include <QSignalSpy>
#include <QSplitter>
#include <QTableView>
#include <QTimer>

using namespace gorizont;

/// How the window comes, hides, ends, and comes back as it was.
class TestWindowLife : public QObject, protected test::WindowBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { useOwnSettings(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void hiddenWindowDoesNothing()
    {
        const auto *timer = find<QTimer>("refreshTimer");
        QVERIFY(timer->isActive());
        QCOMPARE(timer->interval(), 250);
        trigger("goAction2");
        QSignalSpy changed(find<QTableView>("sensorsTable")->model(), &QAbstractItemModel::dataChanged);
        m_window->hide();
        QVERIFY(!timer->isActive());
        m_registry->update({test::sampleReading(std::chrono::steady_clock::now())});
        QTest::qWait(300);
        QCOMPARE(changed.size(), 0);
        m_window->raiseWindow();
        QVERIFY(timer->isActive());
        QVERIFY(!changed.isEmpty());
        m_window->showMinimized();
        QTRY_VERIFY(!timer->isActive());
    }

    void minimisedWindowHidesToTheTray()
    {
        m_window->showMinimized();
        QTest::qWait(20);
        QVERIFY(m_window->isVisible()); // no tray: the task bar must keep it
        m_window->raiseWindow();
        QVERIFY(!m_window->isMinimized());
        m_window->setHidesToTray(true);
        m_window->showMinimized();
        QTRY_VERIFY(!m_window->isVisible());
        m_window->toggle();
        QVERIFY(m_window->isVisible() && !m_window->isMinimized());
        m_window->toggle();
        QVERIFY(!m_window->isVisible());
    }

    void startsHidden()
    {
        m_config.startsHidden = true;
        open({}, false);
        m_window->showAtStart();
        QVERIFY(m_window->isMinimized());
        open({}, false);
        m_window->setHidesToTray(true);
        m_window->showAtStart();
        QVERIFY(!m_window->isVisible());
    }

    void closingAsksWhenTold()
    {
        m_config.closesSilently = false;
        open({});
        QSignalSpy ended(m_window.get(), &MainWindow::exitRequested);
        QVERIFY(!m_window->close());
        QVERIFY(find<QMessageBox>("exitQuestion")->isVisible());
        QVERIFY(!m_window->close()); // a second attempt asks no second question
        QCOMPARE(m_window->findChildren<QMessageBox *>().size(), 1);
        find<QAbstractButton>("exitNo")->click();
        QTRY_VERIFY(!m_window->findChild<QMessageBox *>());
        QVERIFY(m_window->isVisible());
        QCOMPARE(ended.size(), 0);

        QVERIFY(!m_window->close());
        find<QAbstractButton>("exitYes")->click();
        QCOMPARE(ended.size(), 1);
        QVERIFY(!m_window->isVisible());
    }

    void theSystemIsNotAskedBack()
    {
        m_config.closesSilently = false;
        open({});
        QSignalSpy ended(m_window.get(), &MainWindow::exitRequested);
        QVERIFY(!m_window->close());
        QVERIFY(find<QMessageBox>("exitQuestion")->isVisible()); // not even while a question is open
        m_window->endWithoutQuestion();
        QCOMPARE(ended.size(), 1);
        QVERIFY(!m_window->isVisible());
    }

    void closingIsSilentOtherwise()
    {
        QSignalSpy ended(m_window.get(), &MainWindow::exitRequested);
        QVERIFY(m_window->close());
        QCOMPARE(ended.size(), 1);
    }

    void remembersItsLayout()
    {
        m_window->setGeometry(10, 10, 770, 700);
        auto *splitter = find<QSplitter>("columnsSplitter");
        splitter->setSizes({300, 470});
        const QList<int> sizes = splitter->sizes();
        m_window->close();
        open({});
        QCOMPARE(m_window->size(), QSize(770, 700));
        QTRY_COMPARE(find<QSplitter>("columnsSplitter")->sizes(), sizes);
    }

    /// The screen has become smaller, or its scale larger.
    void comesBackWhereItCanBeSeen()
    {
        const QRect available = m_window->screen()->availableGeometry();
        m_window->setGeometry(QRect(available.center(), available.size()));
        m_window->close();
        open({});
        QVERIFY(available.contains(m_window->geometry()));
    }
};

QTEST_MAIN(TestWindowLife)
#include "tst_windowlife.moc"
