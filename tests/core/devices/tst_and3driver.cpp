#include "tests/core/devices/and3driverbench.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::and3;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

const QByteArray askFirmware = hex("01 24 04 00 B6 64");
const QByteArray startRecording = hex("01 32 06 00 17 F3");
const QByteArray complexRead1 = hex("01 C9 84 8F 04 55 E1 14 50 01 34 00 0F 24 05 CC 02 00 00 CC CF DE");
const QByteArray firmware1 = hex("01 24 0C 03 02 00 02 BA");
constexpr quint16 running = 0xCC00;
constexpr quint16 stopped = 0xCC40;

} // namespace

class TstAnd3Driver : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void scale();
    void reading();
    void whatIsNotReadyIsAbsent();
    void inPieces();
    void faults_data();
    void faults();
    void lineVanishes();
    void silenceBeforeEveryExchange_data();
    void silenceBeforeEveryExchange();
    void rebootIsAcknowledged();
    void rebootIsToldOnce();
    void lostAcknowledgementSpoilsNoReading();
    void stoppedRingIsStarted();
    void withoutAccelerationTheRingIsLeftAlone();
    void lateAnswerIsPassedOver();
    void lateAnswerAndThenNothingIsAskedAgain();
    void silenceIsNotAskedAgain();
    void echoingAdapter();
};

void TstAnd3Driver::scale()
{
    QVERIFY(qAbs(accelerationScale(9.81347) - -0.00594713) < 5e-9);
    QVERIFY(qAbs(accelerationScale(9.81347) / accelerationScale(1) - 9.81347) < 1e-12);
}

void TstAnd3Driver::reading()
{
    DriverBench bench;
    bench.line.expect(askComplex, complexRead1);
    const auto read = bench.driver.poll(bench.line);
    QVERIFY(read);
    Measurement expected;
    expected.tilt = Tilt{-3599.5, 2720.5};
    expected.temperature = 21.38;
    expected.fanFrequency = 42;
    expected.heaterPower = 5.2;
    expected.rawStatus = 0b0010'0100'0000'1111;
    expected.rawMode = 0b1100'1100'0000'0000;
    expected.ring = RingProgress{5728, 0};
    expected.conditions = Condition::FanError;
    QVERIFY(*read == expected);
    QVERIFY(bench.isClean());
    QVERIFY(bench.driver.takeNotes().isEmpty());
}

void TstAnd3Driver::whatIsNotReadyIsAbsent()
{
    DriverBench bench;
    const auto read = bench.pollAt(5, 0x2401);
    QVERIFY(read);
    QVERIFY(!read->tilt && !read->temperature && !read->fanFrequency);
    QCOMPARE(read->heaterPower, std::optional(5.2));
    QVERIFY(read->conditions.testFlag(Condition::TiltNotReady));
    QVERIFY(read->conditions.testFlag(Condition::TemperatureNotReady));
}

void TstAnd3Driver::inPieces()
{
    for (qsizetype size = 1; size < 22; ++size) {
        DriverBench bench;
        bench.line.expectInPieces(askComplex, complexRead1, size);
        const auto read = bench.driver.poll(bench.line);
        QVERIFY2(read && read->tilt == (Tilt{-3599.5, 2720.5}), qPrintable(QString::number(size)));
    }
}

void TstAnd3Driver::faults_data()
{
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<Fault>("fault");
    QByteArray damaged = complexRead1;
    damaged[5] = 0x54;
    QTest::newRow("silence") << QByteArray() << Fault::Timeout;
    QTest::newRow("half an answer") << complexRead1.left(21) << Fault::Timeout;
    QTest::newRow("wrong check sum") << damaged << Fault::Checksum;
    QTest::newRow("garbage") << hex("55 AA 00 FF 13") << Fault::Timeout;
    QTest::newRow("only its echo") << askComplex << Fault::Timeout;
}

void TstAnd3Driver::faults()
{
    QFETCH(QByteArray, answer);
    QFETCH(Fault, fault);
    DriverBench bench;
    bench.line.expect(askComplex, answer);
    const auto read = bench.driver.poll(bench.line);
    QVERIFY(!read);
    QCOMPARE(read.fault(), fault);
    QVERIFY(bench.isClean());
    QVERIFY(!bench.driver.hasBacklog());
    QVERIFY(bench.line.elapsed() <= 220ms);
}

void TstAnd3Driver::lineVanishes()
{
    DriverBench bench;
    bench.line.vanishAfter(askComplex);
    QCOMPARE(bench.driver.poll(bench.line).fault(), Fault::Closed);

    DriverBench rebooting;
    rebooting.line.expect(askComplex, complexReadAnswer(5, rebooted)).vanishAfter(acknowledge);
    QCOMPARE(rebooting.driver.poll(rebooting.line).fault(), Fault::Closed);
}

void TstAnd3Driver::silenceBeforeEveryExchange_data()
{
    QTest::addColumn<int>("addressChange");
    QTest::addColumn<int>("silence");
    QTest::newRow("as in the ini") << 16 << 16;
    QTest::newRow("never less than the device needs") << 0 << 10;
    QTest::newRow("more") << 40 << 40;
}

void TstAnd3Driver::silenceBeforeEveryExchange()
{
    QFETCH(int, addressChange);
    QFETCH(int, silence);
    DriverSettings settings = settingsOfTest();
    settings.timing.addressChange = std::chrono::milliseconds(addressChange);
    settings.asksInformation = true;
    settings.sensor.number = 10; // the first question is due at once
    DriverBench bench(settings);
    bench.line.expect(askComplex, complexReadAnswer(6 * 32, rebooted, stopped));
    bench.line.expect(acknowledge, done50).expect(startRecording, done50).expect(askFirmware, firmware1);
    QVERIFY(bench.driver.poll(bench.line));
    QVERIFY(bench.driver.fetch(bench.line));
    QVERIFY(bench.fetch(0, 4));
    QVERIFY(bench.fetch(4, 2));
    QVERIFY(bench.isClean());
    const auto times = bench.line.requestTimes();
    QCOMPARE(times.size(), 6);
    for (qsizetype i = 1; i < times.size(); ++i) {
        QCOMPARE((times.at(i) - times.at(i - 1)).count(), silence); // FakeLine answers at once
    }
}

void TstAnd3Driver::rebootIsAcknowledged()
{
    DriverBench bench;
    const auto first = bench.pollAt(5, rebooted);
    QVERIFY(first && first->conditions.testFlag(Condition::Rebooted));
    QCOMPARE(texts(bench.driver), QStringList{QStringLiteral("The sensor has restarted.")});
    const auto second = bench.pollAt(15);
    QVERIFY(second && !second->conditions.testFlag(Condition::Rebooted));
    QVERIFY(bench.driver.takeNotes().isEmpty());
    QVERIFY(bench.isClean());
}

/// A sensor that does not take the acknowledgement is told again each turn, the journal only once.
void TstAnd3Driver::rebootIsToldOnce()
{
    DriverBench bench;
    QVERIFY(bench.pollAt(5, rebooted));
    QVERIFY(bench.pollAt(15, rebooted));
    QVERIFY(bench.pollAt(25, rebooted));
    QCOMPARE(bench.driver.takeNotes().size(), 1);
    QVERIFY(bench.pollAt(35));
    QVERIFY(bench.pollAt(2, rebooted));
    QCOMPARE(bench.driver.takeNotes().size(), 1);
    QVERIFY(bench.isClean());
}

void TstAnd3Driver::lostAcknowledgementSpoilsNoReading()
{
    DriverBench bench;
    bench.line.expect(askComplex, complexReadAnswer(5, rebooted)).expect(acknowledge, QByteArray());
    const auto read = bench.driver.poll(bench.line);
    QVERIFY(read && read->conditions.testFlag(Condition::Rebooted));
    QVERIFY(bench.isClean());
}

void TstAnd3Driver::stoppedRingIsStarted()
{
    DriverBench bench;
    for (int i = 0; i < 2; ++i) {
        bench.line.expect(askComplex, complexReadAnswer(5, healthy, stopped)).expect(startRecording, done50);
        QVERIFY(bench.driver.poll(bench.line));
    }
    QCOMPARE(
        texts(bench.driver),
        QStringList{QStringLiteral("The recording of accelerations was stopped; it is started again.")});
    QVERIFY(bench.pollAt(15));
    QVERIFY(bench.isClean());
}

void TstAnd3Driver::withoutAccelerationTheRingIsLeftAlone()
{
    DriverSettings settings = settingsOfTest();
    settings.sensor.measuresAcceleration = false;
    DriverBench bench(settings);
    bench.line.expect(askComplex, complexReadAnswer(320, healthy, stopped));
    const auto read = bench.driver.poll(bench.line);
    QVERIFY(read && !read->ring);
    QVERIFY(!bench.driver.hasBacklog());
    QVERIFY(bench.isClean());
}

void TstAnd3Driver::lateAnswerIsPassedOver()
{
    DriverBench bench;
    const QByteArray late = complexReadAnswer(99, healthy, running, 2);
    bench.line.expectPieces(askComplex, {{late, 5ms}, {done50, 5ms}, {complexRead1, 5ms}});
    const auto read = bench.driver.poll(bench.line);
    QVERIFY(read && read->tilt == (Tilt{-3599.5, 2720.5}));
    QVERIFY(bench.isClean());
}

void TstAnd3Driver::lateAnswerAndThenNothingIsAskedAgain()
{
    DriverBench bench;
    bench.line.expectPieces(askComplex, {{complexReadAnswer(99, healthy, running, 2), 150ms}});
    bench.line.expect(askComplex, complexRead1);
    QVERIFY(bench.driver.poll(bench.line));
    QVERIFY(bench.isClean());
    // once, not for ever
    bench.line.expect(askComplex, done50).expect(askComplex, done50);
    QCOMPARE(bench.driver.poll(bench.line).fault(), Fault::Timeout);
    QVERIFY(bench.isClean());
}

void TstAnd3Driver::silenceIsNotAskedAgain()
{
    DriverBench bench;
    bench.line.expect(askComplex, QByteArray());
    QCOMPARE(bench.driver.poll(bench.line).fault(), Fault::Timeout);
    QCOMPARE(bench.line.requestTimes().size(), 1);
    QVERIFY(bench.line.complaints().isEmpty());
}

void TstAnd3Driver::echoingAdapter()
{
    DriverBench bench;
    bench.line.expect(askComplex, askComplex + complexReadAnswer(32, rebooted));
    bench.line.expectInPieces(acknowledge, acknowledge + done50);
    const auto read = bench.driver.poll(bench.line);
    QVERIFY(read && read->tilt == (Tilt{10, -10}));
    bench.line.expect(askFirstPacket, askFirstPacket + packetsAnswer(0, 1));
    const auto blocks = bench.driver.fetch(bench.line);
    QVERIFY(blocks && blocks->size() == 1);
    QVERIFY(bench.isClean());
    QVERIFY(bench.line.elapsed() < 100ms); // nobody waited for a time-out
}

QTEST_GUILESS_MAIN(TstAnd3Driver)
#include "tst_and3driver.moc"
