#include "app/server/singleinstance.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <thread>

using namespace gorizont;

/// CanCopy=0: one copy of the program for one folder (manual 000, section 5).
class TestSingleInstance : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theSecondCopyRaisesTheFirst()
    {
        const QTemporaryDir folder;
        SingleInstance first(folder.path());
        QVERIFY(first.acquire());
        QSignalSpy raised(&first, &SingleInstance::raiseRequested);
        std::atomic_bool isSecond{true};
        std::atomic_bool hasAnswered{false};
        std::atomic_bool hasEnded{false};
        std::thread other([&] {
            SingleInstance second(folder.path());
            isSecond = !second.acquire();
            hasAnswered = second.raiseOther();
            hasEnded = true;
        });
        [[maybe_unused]] const bool ended = QTest::qWaitFor([&] { return hasEnded.load(); }, 20000);
        other.join();
        QVERIFY(isSecond);
        QVERIFY(hasAnswered);
        QTRY_COMPARE(raised.size(), 1);
    }

    void anotherFolderIsAnotherSite()
    {
        const QTemporaryDir here;
        const QTemporaryDir there;
        SingleInstance first(here.path());
        SingleInstance second(there.path());
        QVERIFY(first.acquire());
        QVERIFY(second.acquire());
    }

    /// Manual 000, 11.3: whatever the folders, one copy serves OPC DA.
    void opcAllowsOneCopy()
    {
        const QTemporaryDir here;
        const QTemporaryDir there;
        constexpr int port = 61234;
        {
            SingleInstance first(here.path());
            SingleInstance second(there.path());
            QVERIFY(first.acquireOpc(port));
            QVERIFY(!second.acquireOpc(port));
            QVERIFY(second.acquireOpc(port + 1));
        }
        SingleInstance next(there.path());
        QVERIFY(next.acquireOpc(port));
    }

    void theFolderIsFreeAfterTheEnd()
    {
        const QTemporaryDir folder;
        {
            SingleInstance first(folder.path());
            QVERIFY(first.acquire());
        }
        SingleInstance next(folder.path());
        QVERIFY(!next.raiseOther()); // nobody there
        QVERIFY(next.acquire());
    }
};

QTEST_GUILESS_MAIN(TestSingleInstance)
#include "tst_singleinstance.moc"
