#include "tests/ui/ind3dialogbench.h"

#include <QProgressBar>
#include <QSemaphore>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

bool isSetName(const QByteArray &request)
{
    return request.startsWith("\x7E\x9C\x04");
}

} // namespace

/// The service window of ИН-Д3 and its port: taken, given back, unplugged, held up, garbled.
class TestInd3DialogPort : public Ind3DialogBench
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { close(); }

    void everyWayOutResumesPolling_data()
    {
        QTest::addColumn<QString>("way");
        for (const char *way : {"exit", "escape", "close", "delete", "scanning"}) {
            QTest::newRow(way) << QString::fromLatin1(way);
        }
    }
    void everyWayOutResumesPolling()
    {
        QFETCH(QString, way);
        if (way == QStringLiteral("scanning")) {
            start(two, two, {.pace = 20ms});
            QTRY_VERIFY_WITH_TIMEOUT(addresses().contains(11), patience);
        } else {
            open(two, two);
        }
        m_bench->forgetAnswers();
        if (way == QStringLiteral("escape")) {
            QTest::keyClick(m_dialog, Qt::Key_Escape);
        } else if (way == QStringLiteral("close")) {
            QVERIFY(m_dialog->close());
        } else if (way == QStringLiteral("delete")) {
            delete m_dialog.data();
        } else {
            button("serviceExit")->click();
        }
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog, patience);
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->isPolled(), patience);
    }

    void thePortIsGivenBackAndTaken()
    {
        open(two, two);
        m_bench->forgetAnswers();
        button("portButton")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->isPolled(), patience);
        QVERIFY(m_dialog->isVisible());
        QVERIFY(!find<QLineEdit>("nameEdit")->isEnabled());
        QVERIFY(!button("scanButton")->isEnabled());
        button("portButton")->click();
        QTRY_COMPARE_WITH_TIMEOUT(text("factoryNumber"), QStringLiteral("3591"), patience);
        QCOMPARE(m_bench->state(), LineState::Service);
    }

    void aPortInServiceIsRefused()
    {
        open(two, two);
        Ind3Dialog second(m_bench->port());
        second.setAttribute(Qt::WA_DeleteOnClose, false);
        second.show();
        second.enter();
        QTRY_VERIFY_WITH_TIMEOUT(
            second.findChild<QLabel *>(QStringLiteral("serviceMessage"))
                ->text()
                .contains(QStringLiteral("in service already")),
            patience);
        second.close();
        QTest::qWait(50);
        QCOMPARE(m_bench->state(), LineState::Service); // the first one still has it
    }

    void unpluggedWhileScanning()
    {
        start(two, two, {.pace = 20ms});
        QTRY_VERIFY_WITH_TIMEOUT(addresses().contains(11), patience);
        m_bench->isPlugged = false;
        QTRY_VERIFY_WITH_TIMEOUT(
            text("serviceMessage").contains(QStringLiteral("COM16 is gone (no such port)")), patience);
        QVERIFY(!find<QLineEdit>("nameEdit")->isEnabled());
        QVERIFY(!button("scanButton")->isEnabled());
        QVERIFY(button("serviceExit")->isEnabled());
        m_bench->isPlugged = true;
        m_bench->forgetAnswers();
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->isPolled(), patience);
        button("serviceExit")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog, patience);
        m_bench->forgetAnswers();
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->isPolled(), patience);
    }

    void unpluggedWhileWriting()
    {
        BenchOptions options;
        options.onRequest = [this](const QByteArray &request) {
            if (isSetName(request)) {
                m_bench->isPlugged = false;
            }
        };
        open(two, two, options);
        type("nameEdit", QStringLiteral("Roof"));
        choose("ticksCombo", 0);
        button("applySettings")->click();
        QTRY_VERIFY_WITH_TIMEOUT(text("serviceMessage").contains(QStringLiteral("COM16 is gone")), patience);
        const QString name =
            QStringLiteral("name “Roof”, the port is gone: whether it was written is not known, check it");
        const QString ticks = QStringLiteral("averaging ticks 1, not written");
        QVERIFY(text("serviceMessage").contains(name));
        QVERIFY(text("serviceMessage").contains(ticks));
        const QString errors = m_bench->journalTexts(JournalKind::Error).join(u'\n');
        QVERIFY(errors.contains(QStringLiteral("COM16, ИН-Д3 address 11: ") + name));
        QVERIFY(errors.contains(ticks));
        m_bench->isPlugged = true;
        m_bench->forgetAnswers();
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->isPolled(), patience);
    }

    void closingWaitsForTheAnswer()
    {
        QSemaphore reached;
        QSemaphore released;
        open(two, two, holdingNames(reached, released));
        type("nameEdit", QStringLiteral("Roof"));
        button("applySettings")->click();
        QVERIFY(reached.tryAcquire(1, patience));
        m_dialog->close();
        QVERIFY(m_dialog->isVisible());
        QVERIFY(text("serviceMessage").contains(QStringLiteral("closes as soon as")));
        m_bench->forgetAnswers();
        released.release();
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog, patience);
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->isPolled(), patience);
        QVERIFY(m_bench->journalTexts(JournalKind::Info)
                    .contains(QStringLiteral("COM16, ИН-Д3 address 11: name “Roof”, written")));
        QCOMPARE(nameOf(0), QByteArray("Roof"));
    }

    void leavingKeepsTheRestUnwritten()
    {
        QSemaphore reached;
        QSemaphore released;
        open(two, two, holdingNames(reached, released));
        type("nameEdit", QStringLiteral("Roof"));
        choose("ticksCombo", 0);
        button("applySettings")->click();
        QVERIFY(reached.tryAcquire(1, patience));
        QTest::keyClick(m_dialog, Qt::Key_Escape);
        m_bench->forgetAnswers();
        released.release();
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->isPolled(), patience);
        QVERIFY(m_dialog->isVisible()); // with something to read
        QVERIFY(text("serviceMessage").contains(QStringLiteral("averaging ticks 1, not written")));
        QTest::keyClick(m_dialog, Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog, patience);
    }

    /// The end of the program does not wait; the journal says what nobody knows.
    void destroyedWhileWriting()
    {
        QSemaphore reached;
        QSemaphore released;
        open(two, two, holdingNames(reached, released));
        type("nameEdit", QStringLiteral("Roof"));
        button("applySettings")->click();
        QVERIFY(reached.tryAcquire(1, patience));
        delete m_dialog.data();
        QVERIFY(m_bench->journalTexts(JournalKind::Error)
                    .join(u'\n')
                    .contains(QStringLiteral("name “Roof”, the program ended")));
        m_bench->forgetAnswers();
        released.release();
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->isPolled(), patience);
    }

    void theThreadMayEndFirst()
    {
        start(two, two, {.pace = 20ms});
        QTRY_VERIFY_WITH_TIMEOUT(addresses().contains(11), patience);
        m_bench->endThread();
        QTest::qWait(50);
        button("serviceExit")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog, patience);
    }

    /// Whatever the line does: what the window calls written is in the sensor.
    void faultsAreSurvived_data()
    {
        QTest::addColumn<QStringList>("faults");
        QTest::addColumn<bool>("isHarmless");
        QTest::newRow("pieces") << QStringList{QStringLiteral("pieces=100")} << true;
        QTest::newRow("garbage") << QStringList{QStringLiteral("garbage=100")} << false;
        QTest::newRow("crc") << QStringList{QStringLiteral("crc=30")} << false;
        QTest::newRow("late") << QStringList{QStringLiteral("late=30")} << false;
        QTest::newRow("all") << QStringList{
            QStringLiteral("crc=15"), QStringLiteral("garbage=30"), QStringLiteral("pieces=50"),
            QStringLiteral(
                "late=15")} << false;
    }
    void faultsAreSurvived()
    {
        QFETCH(QStringList, faults);
        QFETCH(bool, isHarmless);
        FaultPlan plan;
        for (const QString &fault : faults) {
            plan.append(*parseSimulatedFault(fault));
        }
        start(two, two, {.faults = plan});
        QTRY_COMPARE_WITH_TIMEOUT(find<QProgressBar>("scanProgress")->value(), 255, patience);
        QTRY_VERIFY_WITH_TIMEOUT(
            text("serviceMessage").isEmpty() || !text("serviceMessage").startsWith(QStringLiteral("Reading")),
            patience);
        if (isHarmless) {
            QCOMPARE(addresses(), QList<int>({11, 24}));
            QVERIFY(find<QLineEdit>("nameEdit")->isEnabled());
        }
        for (int i = 0; i < 10 && find<QLineEdit>("nameEdit")->isEnabled(); ++i) {
            const QString name = QStringLiteral("Name %1").arg(i);
            type("nameEdit", name);
            button("applySettings")->click();
            QTRY_VERIFY_WITH_TIMEOUT(text("serviceMessage").startsWith(QStringLiteral("Sensor ")), patience);
            const bool isWritten = text("serviceMessage").contains(name + QStringLiteral("”, written."));
            QVERIFY(isWritten || !isHarmless);
            if (isWritten) {
                QCOMPARE(
                    nameOf(find<QComboBox>("addressCombo")->currentText() == QStringLiteral("11") ? 0 : 1),
                    name.toLatin1());
            }
            m_bench->skip(2s); // late answers are over
        }
    }

private:
    /// Holds the line while a name is on its way, until the test lets it go.
    static BenchOptions holdingNames(QSemaphore &reached, QSemaphore &released)
    {
        BenchOptions options;
        options.onRequest = [&](const QByteArray &request) {
            if (isSetName(request)) {
                reached.release();
                released.tryAcquire(1, patience);
            }
        };
        return options;
    }
};

QTEST_MAIN(TestInd3DialogPort)
#include "tst_ind3dialogport.moc"
