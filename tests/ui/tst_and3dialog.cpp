#include "core/devices/and3/and3simulator.h"
#include "tests/ui/dialogtester.h"
#include "tests/ui/servicebench.h"
#include "ui/service/and3dialog.h"

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QtTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

SensorConfig accelerometer(int index, int number, int address)
{
    return serviceSensor(SensorType::AnD3, index, number, address);
}

const QList<SensorConfig> two{accelerometer(1, 1, 2), accelerometer(2, 2, 5)};

/// Op of a request: its second byte (spec/and3.md).
bool hasOp(const QByteArray &request, int op)
{
    return request.size() == 6 && static_cast<unsigned char>(request.at(1)) == op;
}

FaultPlan faults(const QStringList &texts)
{
    FaultPlan plan;
    for (const QString &text : texts) {
        plan.append(*parseSimulatedFault(text));
    }
    return plan;
}

} // namespace

/// The service window of АН-Д3 with a real worker on a simulated line, its widgets found by their names.
class TestAnd3Dialog : public QObject, public DialogTester
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup()
    {
        delete m_dialog.data();
        m_bench.reset();
    }

    /// Manual 000, sections 9.5 – 9.10.
    void scanFindsTheSensors()
    {
        open(two, two);
        QCOMPARE(m_dialog->windowTitle(), QStringLiteral("Settings of АН-Д3 sensors on COM16"));
        QCOMPARE(addresses(), QList<int>({2, 5}));
        QCOMPARE(text("foundCount"), QStringLiteral("2"));
        QCOMPARE(text("portNumber"), QStringLiteral("16"));
        QCOMPARE(text("currentAddress"), QStringLiteral("2"));
        QCOMPARE(text("firmware"), QStringLiteral("2.3.12"));
        QVERIFY(text("liveTemperature").contains(QRegularExpression(QStringLiteral("^-?\\d+\\.\\d\\d$"))));
        QVERIFY(text("liveTilt").contains(QRegularExpression(QStringLiteral("^[+-]\\d+\\.\\d [+-]\\d+\\.\\d$"))));
        QVERIFY(!button("changeAddress")->isEnabled()); // 9.8
        QVERIFY(button("changeAddress")->toolTip().contains(QStringLiteral("<System>")));
        const auto *offered = find<QComboBox>("newAddressCombo");
        QCOMPARE(offered->count(), 253);
        QVERIFY(offered->findData(2) < 0 && offered->findData(5) < 0 && offered->findData(3) >= 0);
        QVERIFY(!button("writeAddress")->isEnabled()); // nothing is chosen
        QVERIFY(button("systemReset")->isEnabled());
    }

    void anotherAddressIsRead()
    {
        open(two, two);
        choose("addressCombo", 1);
        QTRY_COMPARE_WITH_TIMEOUT(text("currentAddress"), QStringLiteral("5"), patience);
    }

    void valuesAreReadEverySecond()
    {
        open(two, two);
        m_bench->forgetSent();
        const auto reads = [this] {
            const QList<QByteArray> sent = m_bench->sent();
            return std::count_if(sent.begin(), sent.end(), [](const auto &request) { return hasOp(request, 201); });
        };
        QTRY_VERIFY_WITH_TIMEOUT(reads() >= 2, patience);
        QCOMPARE(find<QTimer>("liveTimer")->interval(), 1000);
        const auto all = reads();
        QVERIFY(m_bench->sent().size() <= all + 1); // nothing but that, and perhaps one more meanwhile
    }

    void aStoppedScanGivesNoAddressAway()
    {
        start(two, two, {.pace = 20ms});
        QTRY_VERIFY_WITH_TIMEOUT(addresses().contains(2), patience);
        button("scanButton")->click();
        QTRY_COMPARE_WITH_TIMEOUT(text("currentAddress"), QStringLiteral("2"), patience);
        QVERIFY(!find<QComboBox>("newAddressCombo")->isEnabled());
        QVERIFY(!button("writeAddress")->isEnabled());
        QCOMPARE(find<QComboBox>("newAddressCombo")->count(), 0);
    }

    /// Manual 000, section 9.11.
    void addressIsWrittenResetAndFound()
    {
        open(two, two, withRestart(), 3s);
        m_bench->forgetSent();
        chooseNew(7);
        QVERIFY(button("writeAddress")->isEnabled());
        button("writeAddress")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m_dialog->findChild<QDialog *>(QStringLiteral("resetMessage")), patience);
        const QList<QByteArray> sent = m_bench->sent();
        const auto isSetByte = [](const auto &request) { return hasOp(request, 224); };
        QCOMPARE(std::count_if(sent.begin(), sent.end(), isSetByte), 1);
        QVERIFY(std::find_if(sent.begin(), sent.end(), isSetByte)->startsWith(QByteArray("\x02\xE0\x04\x07")));
        button("resetMessageOk")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog->findChild<QDialog *>(QStringLiteral("resetMessage")), patience);
        QCOMPARE(addresses(), QList<int>({2, 5})); // it still answers where it was

        button("systemReset")->click(); // no question: it was announced
        QTRY_VERIFY_WITH_TIMEOUT(find<QProgressBar>("restartProgress")->isVisible(), patience);
        QVERIFY(!button("scanButton")->isEnabled());
        QTRY_COMPARE_WITH_TIMEOUT(addresses(), QList<int>({5, 7}), patience);
        QTRY_COMPARE_WITH_TIMEOUT(text("currentAddress"), QStringLiteral("7"), patience);
        QVERIFY(text("serviceMessage").contains(QStringLiteral("answers at its new address 7")));
        QVERIFY(text("serviceMessage").contains(QStringLiteral("adr1=7 into [Port4]")));
        const QString lines = m_bench->journalTexts(JournalKind::Info).join(u'\n');
        QVERIFY(lines.contains(
            QStringLiteral("COM16, АН-Д3 address 2: new address 7 stored, it holds after a system reset")));
        QVERIFY(lines.contains(QStringLiteral("COM16, АН-Д3 address 2: system reset sent")));
        m_bench->forgetAnswers();
        button("serviceExit")->click(); // nothing is left to ask about
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog, patience);
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->isPolled(), patience);
    }

    void leavingWithoutAResetIsAskedAbout()
    {
        open(two, two);
        chooseNew(7);
        button("writeAddress")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m_dialog->findChild<QDialog *>(QStringLiteral("resetMessage")), patience);
        button("resetMessageOk")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog->findChild<QDialog *>(QStringLiteral("resetMessage")), patience);
        QTest::keyClick(m_dialog, Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(m_dialog->findChild<QDialog *>(QStringLiteral("serviceQuestion")), patience);
        button("questionStay")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog->findChild<QDialog *>(QStringLiteral("serviceQuestion")), patience);
        QVERIFY(m_dialog->isVisible());
        QTest::keyClick(m_dialog, Qt::Key_Escape);
        button("questionGo")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog, patience);
    }

    void aResetThatNobodyAnnouncedIsAskedAbout()
    {
        open(two, two, withRestart(), 3s);
        m_bench->forgetSent();
        button("systemReset")->click();
        button("questionStay")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog->findChild<QDialog *>(QStringLiteral("serviceQuestion")), patience);
        const auto resets = [this] {
            const QList<QByteArray> sent = m_bench->sent();
            return std::count_if(sent.begin(), sent.end(), [](const auto &request) { return hasOp(request, 99); });
        };
        QCOMPARE(resets(), 0);
        button("systemReset")->click();
        button("questionGo")->click();
        QTRY_VERIFY_WITH_TIMEOUT(resets() > 0, patience);
        QTRY_COMPARE_WITH_TIMEOUT(text("currentAddress"), QStringLiteral("2"), patience);
    }

    /// The sensor N 2 was silent while the line was scanned, so its address looks free.
    void aTakenAddressIsRefused()
    {
        open(two, two, {.faults = faults({QStringLiteral("silent=2@0-3600")})});
        QCOMPARE(addresses(), QList<int>({2}));
        m_bench->skip(3600s);
        m_bench->forgetSent();
        chooseNew(5);
        button("writeAddress")->click();
        QTRY_VERIFY_WITH_TIMEOUT(
            text("serviceMessage").contains(QStringLiteral("the new address 5 is taken; nothing was stored")),
            patience);
        QVERIFY(m_bench->journalTexts(JournalKind::Error).join(u'\n').contains(QStringLiteral("nothing was stored")));
        const QList<QByteArray> sent = m_bench->sent();
        QVERIFY(std::none_of(sent.begin(), sent.end(), [](const auto &request) { return hasOp(request, 224); }));
    }

    void unpluggedWhileWriting_data()
    {
        QTest::addColumn<int>("op");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("225") << 225
                             << QStringLiteral(
                                    "copying the configuration failed (the port is gone); nothing was stored");
        QTest::newRow("224") << 224
                             << QStringLiteral(
                                    "setting the new address 7 failed (the port is gone); nothing was stored");
        QTest::newRow("220") << 220 << QStringLiteral("whether it was stored is not known");
    }
    void unpluggedWhileWriting()
    {
        QFETCH(int, op);
        QFETCH(QString, sentence);
        BenchOptions options;
        options.onRequest = [this, op](const QByteArray &request) {
            if (hasOp(request, op)) {
                m_bench->isPlugged = false;
            }
        };
        open(two, two, options);
        chooseNew(7);
        button("writeAddress")->click();
        QTRY_VERIFY_WITH_TIMEOUT(text("serviceMessage").contains(QStringLiteral("COM16 is gone")), patience);
        QVERIFY(text("serviceMessage").contains(sentence));
        QVERIFY(m_bench->journalTexts(JournalKind::Error).join(u'\n').contains(sentence));
        QVERIFY(!button("systemReset")->isEnabled());
        m_bench->isPlugged = true;
        m_bench->forgetAnswers();
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->isPolled(), patience);
        button("serviceExit")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog, patience);
    }

    void unpluggedWhileRestarting()
    {
        open(two, two, {}, 1h);
        chooseNew(7);
        button("writeAddress")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m_dialog->findChild<QDialog *>(QStringLiteral("resetMessage")), patience);
        button("resetMessageOk")->click();
        button("systemReset")->click();
        QTRY_VERIFY_WITH_TIMEOUT(find<QProgressBar>("restartProgress")->isVisible(), patience);
        m_bench->isPlugged = false;
        QTRY_VERIFY_WITH_TIMEOUT(text("serviceMessage").contains(QStringLiteral("COM16 is gone")), patience);
        m_bench->isPlugged = true;
        m_bench->forgetAnswers();
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->isPolled(), patience);
        button("serviceExit")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog, patience);
    }

    void everyWayOutResumesPolling_data()
    {
        QTest::addColumn<QString>("way");
        for (const char *way : {"exit", "escape", "close", "delete"}) {
            QTest::newRow(way) << QString::fromLatin1(way);
        }
    }
    void everyWayOutResumesPolling()
    {
        QFETCH(QString, way);
        open(two, two);
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

    /// Whatever the line does: an address that the window calls stored is what the sensor has after a reset.
    void faultsAreSurvived_data()
    {
        QTest::addColumn<QStringList>("texts");
        QTest::newRow("pieces") << QStringList{QStringLiteral("pieces=100")};
        QTest::newRow("garbage") << QStringList{QStringLiteral("garbage=50")};
        QTest::newRow("crc") << QStringList{QStringLiteral("crc=20")};
        QTest::newRow("late") << QStringList{QStringLiteral("late=20")};
    }
    void faultsAreSurvived()
    {
        QFETCH(QStringList, texts);
        open(two, two, {.faults = faults(texts)});
        int stored = 0;
        for (int i = 0; i < 5; ++i) {
            if (!find<QComboBox>("newAddressCombo")->isEnabled()) {
                break; // the sensor could not be read
            }
            chooseNew(100 + i);
            button("writeAddress")->click();
            QTRY_VERIFY_WITH_TIMEOUT(button("systemReset")->isEnabled(), patience);
            if (text("serviceMessage").contains(QStringLiteral("stored, it holds"))) {
                ++stored;
                QTRY_VERIFY_WITH_TIMEOUT(m_dialog->findChild<QDialog *>(QStringLiteral("resetMessage")), patience);
                button("resetMessageOk")->click();
                QTRY_VERIFY_WITH_TIMEOUT(!m_dialog->findChild<QDialog *>(QStringLiteral("resetMessage")), patience);
            } else {
                QVERIFY2(text("serviceMessage").contains(QStringLiteral("failed")), qPrintable(text("serviceMessage")));
            }
            m_bench->skip(2s);
        }
        QVERIFY2(stored > 0, qPrintable(text("serviceMessage")));
    }

private:
    QWidget *window() const override { return m_dialog; }
    /// A second passes on the line while the sensor restarts.
    BenchOptions withRestart()
    {
        BenchOptions options;
        options.onRequest = [this, isReset = false](const QByteArray &request) mutable {
            if (std::exchange(isReset, hasOp(request, 99))) {
                m_bench->skip(2s);
            }
        };
        return options;
    }

    void start(
        const QList<SensorConfig> &ini, const QList<SensorConfig> &connected, const BenchOptions &options = {},
        std::chrono::milliseconds restartTime = 1s)
    {
        m_bench = std::make_unique<ServiceBench>(serviceLine(ini), connected, options);
        QTRY_COMPARE_WITH_TIMEOUT(m_bench->state(), LineState::Open, patience);
        m_dialog = new And3Dialog(m_bench->port(), nullptr, restartTime);
        m_dialog->show();
        m_dialog->enter();
    }

    /// Until the first sensor is shown.
    void open(
        const QList<SensorConfig> &ini, const QList<SensorConfig> &connected, const BenchOptions &options = {},
        std::chrono::milliseconds restartTime = 1s)
    {
        start(ini, connected, options, restartTime);
        QTRY_VERIFY_WITH_TIMEOUT(button("systemReset")->isEnabled(), patience);
    }

    void chooseNew(int address) const
    {
        choose("newAddressCombo", find<QComboBox>("newAddressCombo")->findData(address));
    }

    std::unique_ptr<ServiceBench> m_bench;
    QPointer<And3Dialog> m_dialog;
};

QTEST_MAIN(TestAnd3Dialog)
#include "tst_and3dialog.moc"
