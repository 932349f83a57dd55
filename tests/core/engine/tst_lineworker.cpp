#include "core/engine/lineworker.h"

#include "tests/support/pluggedline.h"

#include <QSignalSpy>
#include <QTest>
#include <QThread>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

SensorConfig inclinometer(int number, int address)
{
    SensorConfig sensor;
    sensor.port = 1;
    sensor.index = number;
    sensor.number = number;
    sensor.address = address;
    sensor.isOn = true;
    sensor.type = SensorType::InD;
    sensor.model = QStringLiteral("IN-D3");
    sensor.measuresTilt = true;
    return sensor;
}

PollingSettings settings(int sensors)
{
    PollingSettings settings;
    settings.line.index = 1;
    settings.line.com = 7;
    settings.line.isOn = true;
    settings.line.baudRate = 115200;
    for (int i = 1; i <= sensors; ++i) {
        settings.line.sensors.append(inclinometer(i, i));
    }
    settings.timing.run = 50ms;
    settings.timing.addressChange = 1ms;
    settings.timing.readCommand = 30ms;
    settings.timing.closePause = 200ms;
    settings.timing.reopenPause = 100ms;
    settings.timing.crcErrorPause = 0ms;
    settings.timing.updateInterval = 10ms;
    settings.rules = {3, 3, false};
    return settings;
}

/// A worker in its thread and everything it says, collected in the test's thread.
class Bench : public QObject
{
public:
    explicit Bench(const PollingSettings &settings, const FaultPlan &faults = {})
        : worker(settings, [this, line = settings.line, faults] {
            SimulatedBus::Options options;
            options.faults = faults;
            return std::make_unique<test::PluggedLine>(line, options, isPlugged);
        })
    {
        worker.moveToThread(&thread);
        connect(&thread, &QThread::started, &worker, &LineWorker::start);
        connect(&thread, &QThread::finished, &worker, &LineWorker::stop, Qt::DirectConnection);
        connect(&worker, &LineWorker::readingsReady, this, [this](const Readings &batch) {
            for (const Reading &reading : batch) {
                last[reading.number] = reading;
                answers[reading.number] += reading.isAnswer ? 1 : 0;
            }
        });
        connect(&worker, &LineWorker::lineChanged, this, [this](const LineStatus &status) { line = status; });
        connect(&worker, &LineWorker::journal, this, [this](const JournalEntry &entry) { journal.append(entry); });
        thread.start();
    }

    ~Bench() override
    {
        worker.interrupt();
        thread.quit();
        thread.wait();
    }

    template <typename Answer> static Answer answerOf(const QFuture<Answer> &future)
    {
        return QTest::qWaitFor([&] { return future.isFinished(); }, 5000) && future.resultCount() == 1
            ? future.result()
            : Answer(Fault::Cancelled);
    }

    int journalLines(JournalKind kind) const
    {
        return static_cast<int>(
            std::count_if(journal.begin(), journal.end(), [kind](const auto &entry) { return entry.kind == kind; }));
    }

    std::atomic_bool isPlugged{true};
    QThread thread;
    LineWorker worker;
    QHash<int, Reading> last;
    QHash<int, int> answers;
    LineStatus line;
    QList<JournalEntry> journal;
};

Result<int> count(Line &line)
{
    return line.isOpen() ? 1 : 0;
}

FaultPlan faults(const char *text)
{
    return {*parseSimulatedFault(QString::fromLatin1(text))};
}

} // namespace

class TestLineWorker : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pollsEverySensor()
    {
        Bench bench(settings(3));
        QTRY_VERIFY(bench.answers[1] > 3 && bench.answers[2] > 3 && bench.answers[3] > 3);
        QCOMPARE(bench.last[2].status, quint16(0x0300)); // tilt is valid, the others are not measured
        QVERIFY(bench.last[2].tilt.has_value());
        QVERIFY(bench.last[2].period > 30ms);
        QCOMPARE(bench.line.state, LineState::Open);
        QVERIFY(bench.line.bytesSent > 0 && bench.line.bytesReceived > 0);
        QCOMPARE(bench.journal.size(), 1); // one line for opening, none for each sensor
    }

    void parksASilentSensorAndKeepsItsNeighbours()
    {
        Bench bench(settings(2), faults("silent=1"));
        QTRY_COMPARE(bench.last[1].status, quint16(0x3700));
        QCOMPARE(bench.last[1].counters.readErrors, 3u);
        const int before = bench.answers[2];
        QTest::qWait(1000);
        QVERIFY2(bench.answers[2] - before >= 8, qPrintable(QString::number(bench.answers[2] - before)));
        QCOMPARE(bench.last[1].counters.readErrors, 3u); // not probed before two seconds are over
        QCOMPARE(bench.journalLines(JournalKind::Error), 1);
    }

    void wrongCheckSumsHaveTheirOwnCode()
    {
        Bench bench(settings(1), faults("crc=100"));
        QTRY_COMPARE(bench.last[1].status, quint16(0x4700));
        QCOMPARE(bench.last[1].counters.crcErrors, 3u);
        QCOMPARE(bench.last[1].counters.readErrors, 0u);
    }

    void survivesGarbageAndPieces()
    {
        FaultPlan plan = faults("garbage=100") + faults("pieces=100");
        PollingSettings patient = settings(1);
        patient.timing.readCommand = 500ms;
        Bench bench(patient, plan);
        QTRY_VERIFY(bench.answers[1] > 10);
        QVERIFY(bench.last[1].counters.readErrors + bench.last[1].counters.crcErrors <= 2);
    }

    void closesAndReopensALostPort()
    {
        Bench bench(settings(2));
        QTRY_VERIFY(bench.answers[1] > 2);
        bench.isPlugged = false;
        QTRY_COMPARE(bench.line.state, LineState::Lost);
        QTRY_COMPARE(bench.last[1].status, quint16(0x2700));
        QTRY_VERIFY(bench.line.failedOpens >= 3);
        QCOMPARE(bench.line.state, LineState::OpenFailed);
        QVERIFY(bench.last[1].tilt.has_value()); // the last value stays
        bench.isPlugged = true;
        const int before = bench.answers[1];
        QTRY_VERIFY_WITH_TIMEOUT(bench.answers[1] > before, 1000);
        QCOMPARE(bench.journalLines(JournalKind::Error), 1);
        QCOMPARE(bench.journalLines(JournalKind::On), 2);
    }

    void aPortThatCannotBeOpenedIsToldOnce()
    {
        PollingSettings impatient = settings(1);
        impatient.timing.reopenPause = 20ms;
        Bench bench(impatient);
        bench.isPlugged = false;
        QTRY_VERIFY(bench.line.failedOpens > 5);
        QCOMPARE(bench.journalLines(JournalKind::Error), 1);
        QVERIFY(!bench.line.lastError.isEmpty());
    }

    void serviceSuspendsPollingAndRunsTasks()
    {
        Bench bench(settings(1));
        QTRY_VERIFY(bench.answers[1] > 1);
        QVERIFY(bench.answerOf(bench.worker.enterService()));
        QTRY_COMPARE(bench.line.state, LineState::Service);
        QTRY_COMPARE(bench.last[1].status, quint16(0x0700));
        const int before = bench.answers[1];
        QCOMPARE(*bench.answerOf(bench.worker.serve(count)), 1);
        QTest::qWait(200);
        QCOMPARE(bench.answers[1], before);
        bench.worker.leaveService();
        QTRY_VERIFY(bench.answers[1] > before);
        QCOMPARE(bench.last[1].status, quint16(0x0300));
        QCOMPARE(bench.journalLines(JournalKind::Off), 1);
    }

    void serviceNeedsAnOpenPortOfItsOwn()
    {
        Bench bench(settings(1));
        QTRY_COMPARE(bench.line.state, LineState::Open);
        QCOMPARE(bench.answerOf(bench.worker.serve(count)).fault(), Fault::Closed); // nobody is in service
        QVERIFY(bench.answerOf(bench.worker.enterService()));
        QCOMPARE(bench.answerOf(bench.worker.enterService()).fault(), Fault::Refused);
        bench.worker.leaveService();
        QTRY_COMPARE(bench.line.state, LineState::Open);
        bench.isPlugged = false;
        QTRY_COMPARE(bench.line.state, LineState::OpenFailed);
        QCOMPARE(bench.answerOf(bench.worker.enterService()).fault(), Fault::Closed);
        bench.worker.leaveService();
        QCOMPARE(bench.journalLines(JournalKind::Off), 1);
    }

    void aPortThatGoesAwayEndsItsService()
    {
        Bench bench(settings(1));
        QTRY_COMPARE(bench.line.state, LineState::Open);
        QVERIFY(bench.answerOf(bench.worker.enterService()));
        bench.isPlugged = false;
        const auto asked = bench.answerOf(bench.worker.serve([](Line &line) -> Result<int> {
            const auto sent = line.send(QByteArray("x"), 100ms, 0us);
            return sent ? Result<int>(1) : sent.fault();
        }));
        QCOMPARE(asked.fault(), Fault::Closed);
        QTRY_VERIFY(bench.line.state == LineState::Lost || bench.line.state == LineState::OpenFailed);
        QCOMPARE(bench.answerOf(bench.worker.serve(count)).fault(), Fault::Closed);
        bench.isPlugged = true;
        const int before = bench.answers[1];
        QTRY_VERIFY(bench.answers[1] > before); // polling goes on by itself
        bench.worker.leaveService(); // the dialog closes later than the port: nothing happens
        QTest::qWait(100);
        QCOMPARE(bench.line.state, LineState::Open);
    }

    void anUnusedPortInServiceIsWatched()
    {
        Bench bench(settings(1));
        QTRY_COMPARE(bench.line.state, LineState::Open);
        QVERIFY(bench.answerOf(bench.worker.enterService()));
        bench.isPlugged = false;
        QTRY_VERIFY(bench.line.state == LineState::Lost || bench.line.state == LineState::OpenFailed);
    }

    void aStepThatComesTooLateIsCancelled()
    {
        Bench bench(settings(1));
        QTRY_COMPARE(bench.line.state, LineState::Open);
        bench.thread.quit();
        QVERIFY(bench.thread.wait(5000));
        const auto future = bench.worker.serve(count);
        QCoreApplication::removePostedEvents(&bench.worker); // what the end of the worker does
        QVERIFY(future.isCanceled() && future.isFinished());
    }

    void retryDoesNotWaitForThePause()
    {
        PollingSettings patient = settings(1);
        patient.timing.closePause = 1h;
        patient.timing.reopenPause = 1h;
        Bench bench(patient);
        QTRY_VERIFY(bench.answers[1] > 0);
        bench.isPlugged = false;
        QTRY_COMPARE(bench.line.state, LineState::Lost);
        bench.worker.retry();
        QTRY_COMPARE(bench.line.state, LineState::OpenFailed);
        bench.isPlugged = true;
        bench.worker.retry();
        QTRY_COMPARE(bench.line.state, LineState::Open);
    }

    void retryAsksAParkedSensor()
    {
        Bench bench(settings(2), faults("silent=1"));
        QTRY_COMPARE(bench.last[1].counters.readErrors, 3u);
        bench.worker.retry();
        QTRY_COMPARE_WITH_TIMEOUT(bench.last[1].counters.readErrors, 4u, 1500); // its own probe comes after two seconds
    }

    void stopsInTheMiddleOfAWait()
    {
        PollingSettings slow = settings(1);
        slow.timing.readCommand = 60s;
        Bench bench(slow, faults("silent=1"));
        QTRY_COMPARE(bench.line.state, LineState::Open);
        QTest::qWait(50);
        QElapsedTimer timer;
        timer.start();
        bench.worker.interrupt();
        bench.thread.quit();
        QVERIFY(bench.thread.wait(5000));
        QVERIFY(timer.elapsed() < 2000);
    }
};

QTEST_GUILESS_MAIN(TestLineWorker)
#include "tst_lineworker.moc"
