#include "core/devices/and3/and3driver.h"
#include "tests/core/devices/and3frames.h"
#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::and3;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

const QByteArray askComplex = hex("01 C9 00 00 12 4A");
const QByteArray askFirmware = hex("01 24 04 00 B6 64");
const QByteArray askFirstPacket = hex("01 CB 00 01 53 34");
const QByteArray acknowledge = hex("01 32 65 01 4F BD");
const QByteArray startRecording = hex("01 32 06 00 17 F3");
const QByteArray done50 = hex("01 32 2F 38");
const QByteArray complexRead1 = hex("01 C9 84 8F 04 55 E1 14 50 01 34 00 0F 24 05 CC 02 00 00 CC CF DE");
const QByteArray firmware1 = hex("01 24 0C 03 02 00 02 BA");

constexpr quint16 healthy = 0x240F;
constexpr quint16 rebooted = 0x240E;
constexpr quint16 running = 0xCC00;
constexpr quint16 stopped = 0xCC40;

DriverSettings settingsOfTest()
{
    DriverSettings settings;
    settings.sensor.number = 3;
    settings.sensor.address = 1;
    settings.sensor.isOn = true;
    settings.sensor.measuresTilt = true;
    settings.sensor.measuresTemperature = true;
    settings.sensor.measuresAcceleration = true;
    return settings;
}

QByteArray askPackets(int cell, int count)
{
    return sealed({1, 203, cell, count});
}

QStringList texts(Driver &driver)
{
    QStringList list;
    for (const DriverNote &note : driver.takeNotes()) {
        list.append(note.text);
    }
    return list;
}

/// A driver on a line that plays a script, and a clock of the test.
struct Bench
{
    explicit Bench(const DriverSettings &settings = settingsOfTest())
        : driver(settings, [this] { return now; })
    {
    }

    /// One poll that is answered with a count of \a samples.
    Result<Measurement> pollAt(quint32 samples, quint16 status = healthy)
    {
        line.expect(askComplex, complexReadAnswer(samples, status));
        if (!(status & 1)) {
            line.expect(acknowledge, done50);
        }
        return driver.poll(line);
    }

    Result<QList<SampleBlock>> fetch(quint64 first, int count)
    {
        line.expect(askPackets(static_cast<int>(first % 128), count), packetsAnswer(first, count));
        return driver.fetch(line);
    }

    bool isClean() const { return line.isDone() && line.complaints().isEmpty(); }

    UtcTime now{std::chrono::seconds(1'700'000'000)};
    And3Driver driver;
    FakeLine line;
};

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
    void firmware();
    void firmwareUnanswered();
    void lateAnswerIsPassedOver();
    void lateAnswerAndThenNothingIsAskedAgain();
    void silenceIsNotAskedAgain();
    void echoingAdapter();
    void fetchBringsBlocks();
    void fetchInSteps();
    void fetchPatience();
    void afterAFailedFetchThePollComesFirst();
    void overrunStandsForOnePoll();
    void syncErrorStandsForOnePoll();
    void rejectedPacketIsAGap();
    void reopenedLineLosesNothing();
    void rebootBetweenPolls();
};

void TstAnd3Driver::scale()
{
    QVERIFY(qAbs(accelerationScale(9.81347) - -0.00594713) < 5e-9);
    QVERIFY(qAbs(accelerationScale(9.81347) / accelerationScale(1) - 9.81347) < 1e-12);
}

void TstAnd3Driver::reading()
{
    Bench bench;
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
    Bench bench;
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
        Bench bench;
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
    Bench bench;
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
    Bench bench;
    bench.line.vanishAfter(askComplex);
    QCOMPARE(bench.driver.poll(bench.line).fault(), Fault::Closed);

    Bench rebooting;
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
    Bench bench(settings);
    bench.line.expect(askComplex, complexReadAnswer(6 * 32, rebooted, stopped));
    bench.line.expect(acknowledge, done50).expect(startRecording, done50).expect(askFirmware, firmware1);
    QVERIFY(bench.driver.poll(bench.line));
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
    Bench bench;
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
    Bench bench;
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
    Bench bench;
    bench.line.expect(askComplex, complexReadAnswer(5, rebooted)).expect(acknowledge, QByteArray());
    const auto read = bench.driver.poll(bench.line);
    QVERIFY(read && read->conditions.testFlag(Condition::Rebooted));
    QVERIFY(bench.isClean());
}

void TstAnd3Driver::stoppedRingIsStarted()
{
    Bench bench;
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
    Bench bench(settings);
    bench.line.expect(askComplex, complexReadAnswer(320, healthy, stopped));
    const auto read = bench.driver.poll(bench.line);
    QVERIFY(read && !read->ring);
    QVERIFY(!bench.driver.hasBacklog());
    QVERIFY(bench.isClean());
}

void TstAnd3Driver::firmware()
{
    DriverSettings settings = settingsOfTest();
    settings.asksInformation = true;
    Bench bench(settings);
    bench.line.expect(askComplex, complexReadAnswer(5)).expect(askFirmware, firmware1);
    QVERIFY(bench.driver.poll(bench.line));
    QCOMPARE(texts(bench.driver), QStringList{QStringLiteral("Firmware 2.3, build 12.")});
    bench.now += 59s;
    QVERIFY(bench.pollAt(15)); // not asked
    bench.now += 1s;
    bench.line.expect(askComplex, complexReadAnswer(25)).expect(askFirmware, firmware1);
    QVERIFY(bench.driver.poll(bench.line));
    QVERIFY(bench.driver.takeNotes().isEmpty());
    QVERIFY(bench.isClean());
}

void TstAnd3Driver::firmwareUnanswered()
{
    DriverSettings settings = settingsOfTest();
    settings.asksInformation = true;
    Bench bench(settings);
    bench.line.expect(askComplex, complexReadAnswer(5)).expect(askFirmware, QByteArray());
    QVERIFY(bench.driver.poll(bench.line));
    QVERIFY(bench.pollAt(15));
    QVERIFY(bench.driver.takeNotes().isEmpty());
    QVERIFY(bench.isClean());
}

void TstAnd3Driver::lateAnswerIsPassedOver()
{
    Bench bench;
    const QByteArray late = complexReadAnswer(99, healthy, running, 2);
    bench.line.expectPieces(askComplex, {{late, 5ms}, {done50, 5ms}, {complexRead1, 5ms}});
    const auto read = bench.driver.poll(bench.line);
    QVERIFY(read && read->tilt == (Tilt{-3599.5, 2720.5}));
    QVERIFY(bench.isClean());
}

void TstAnd3Driver::lateAnswerAndThenNothingIsAskedAgain()
{
    Bench bench;
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
    Bench bench;
    bench.line.expect(askComplex, QByteArray());
    QCOMPARE(bench.driver.poll(bench.line).fault(), Fault::Timeout);
    QCOMPARE(bench.line.requestTimes().size(), 1);
    QVERIFY(bench.line.complaints().isEmpty());
}

void TstAnd3Driver::echoingAdapter()
{
    Bench bench;
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

void TstAnd3Driver::fetchBringsBlocks()
{
    Bench bench;
    QVERIFY(!bench.driver.hasBacklog());
    QVERIFY(bench.pollAt(31));
    QVERIFY(!bench.driver.hasBacklog());
    QVERIFY(bench.pollAt(32 + 4));
    QVERIFY(bench.driver.hasBacklog());
    const auto blocks = bench.fetch(0, 1);
    QVERIFY(blocks && blocks->size() == 1);
    const SampleBlock &block = blocks->first();
    QCOMPARE(block.number, 3);
    QCOMPARE(block.rate, 10.0);
    QCOMPARE(block.scale, accelerationScale(9.81347));
    QVERIFY(block.start == bench.now - 3600ms);
    QVERIFY(!block.followsPrevious);
    QCOMPARE(block.x.size(), 32);
    QCOMPARE(block.y.size(), 32);
    QCOMPARE(block.x.at(31), qint16(31));
    QCOMPARE(block.y.at(31), qint16(-31));
    QVERIFY(!bench.driver.hasBacklog());
    const auto read = bench.pollAt(40);
    QVERIFY(read && read->ring == (RingProgress{1, 1}));
    QVERIFY(bench.isClean());
}

/// The whole ring at the first start, four packets a step, cut at the last cell.
void TstAnd3Driver::fetchInSteps()
{
    Bench bench;
    QVERIFY(bench.pollAt(242 * 32)); // 123…241
    QList<SampleBlock> blocks;
    quint64 next = 123;
    for (const int count : {4, 1, 4, 4}) {
        QVERIFY(bench.driver.hasBacklog());
        const auto fetched = bench.fetch(next, count);
        QVERIFY(fetched);
        blocks += *fetched;
        next += static_cast<quint64>(count);
    }
    QCOMPARE(blocks.size(), 13);
    for (qsizetype i = 0; i < blocks.size(); ++i) {
        QCOMPARE(blocks.at(i).x.first(), static_cast<qint16>((123 + i) * 32));
        QCOMPARE(blocks.at(i).followsPrevious, i > 0);
    }
    QVERIFY(bench.isClean());
}

/// TORDat, not TORCom: the answer may take seconds.
void TstAnd3Driver::fetchPatience()
{
    Bench bench;
    QVERIFY(bench.pollAt(32));
    bench.line.expectPieces(askFirstPacket, {{packetsAnswer(0, 1), 3900ms}});
    QVERIFY(bench.driver.fetch(bench.line));
}

void TstAnd3Driver::afterAFailedFetchThePollComesFirst()
{
    Bench bench;
    QVERIFY(bench.pollAt(32));
    bench.line.expect(askFirstPacket, QByteArray());
    QCOMPARE(bench.driver.fetch(bench.line).fault(), Fault::Timeout);
    QVERIFY(!bench.driver.hasBacklog());
    QVERIFY(bench.pollAt(42));
    QVERIFY(bench.driver.hasBacklog());
    const auto blocks = bench.fetch(0, 1); // the same packet
    QVERIFY(blocks && blocks->size() == 1);
}

void TstAnd3Driver::overrunStandsForOnePoll()
{
    Bench bench;
    QVERIFY(bench.pollAt(32));
    QVERIFY(bench.fetch(0, 1));
    const auto overrun = bench.pollAt(200 * 32);
    QVERIFY(overrun && overrun->conditions.testFlag(Condition::RingOverrun));
    const QList<DriverNote> notes = bench.driver.takeNotes();
    QCOMPARE(notes.size(), 1);
    QCOMPARE(notes.first().kind, JournalKind::Error);
    QCOMPARE(notes.first().text, QStringLiteral("The buffer of accelerations overran, packets lost: 198."));
    const auto blocks = bench.fetch(199, 1);
    QVERIFY(blocks && !blocks->first().followsPrevious);
    const auto after = bench.pollAt(200 * 32 + 9);
    QVERIFY(after && !after->conditions.testFlag(Condition::RingOverrun));
    QVERIFY(!after->conditions.testFlag(Condition::SyncError));
    QVERIFY(bench.isClean());
}

void TstAnd3Driver::syncErrorStandsForOnePoll()
{
    Bench bench;
    QVERIFY(bench.pollAt(2 * 32));
    PacketText shifted = PacketText::numbered(1);
    shifted.start += 40;
    bench.line.expect(askPackets(0, 2), packetsAnswer(PacketText::numbered(0).toBytes() + shifted.toBytes()));
    const auto blocks = bench.driver.fetch(bench.line);
    QVERIFY(blocks && blocks->size() == 2 && !blocks->at(1).followsPrevious);
    QCOMPARE(texts(bench.driver), QStringList{QStringLiteral("Packets of accelerations do not follow each other.")});
    bench.line.expect(askComplex, QByteArray());
    QVERIFY(!bench.driver.poll(bench.line)); // a failed poll does not use it up
    const auto first = bench.pollAt(74);
    QVERIFY(first && first->conditions.testFlag(Condition::SyncError));
    const auto second = bench.pollAt(84);
    QVERIFY(second && !second->conditions.testFlag(Condition::SyncError));
    QVERIFY(bench.isClean());
}

void TstAnd3Driver::rejectedPacketIsAGap()
{
    Bench bench;
    QVERIFY(bench.pollAt(3 * 32));
    PacketText bad = PacketText::numbered(1);
    bad.drz = 323;
    bench.line.expect(
        askPackets(0, 3),
        packetsAnswer(PacketText::numbered(0).toBytes() + bad.toBytes() + PacketText::numbered(2).toBytes()));
    const auto blocks = bench.driver.fetch(bench.line);
    QVERIFY(blocks && blocks->size() == 2);
    QCOMPARE(blocks->at(1).x.first(), qint16(64));
    QVERIFY(!blocks->at(1).followsPrevious);
    const auto after = bench.pollAt(3 * 32 + 10);
    QVERIFY(after && !after->conditions.testFlag(Condition::SyncError));
    QVERIFY(after->ring == (RingProgress{3, 3}));
}

void TstAnd3Driver::reopenedLineLosesNothing()
{
    Bench bench;
    QVERIFY(bench.pollAt(2 * 32));
    QVERIFY(bench.fetch(0, 2));
    bench.driver.restart();
    QVERIFY(!bench.driver.hasBacklog());
    const auto read = bench.pollAt(110 * 32);
    QVERIFY(read && !read->conditions.testFlag(Condition::RingOverrun));
    const auto blocks = bench.fetch(2, 4);
    QVERIFY(blocks && blocks->first().followsPrevious);
    QVERIFY(bench.driver.takeNotes().isEmpty());
    QVERIFY(bench.isClean());
}

void TstAnd3Driver::rebootBetweenPolls()
{
    Bench bench;
    QVERIFY(bench.pollAt(2 * 32));
    QVERIFY(bench.fetch(0, 2));
    const auto read = bench.pollAt(5 * 32, rebooted); // longer than the old run
    QVERIFY(read && read->conditions.testFlag(Condition::Rebooted));
    const auto blocks = bench.fetch(0, 4);
    QVERIFY(blocks && !blocks->first().followsPrevious);
    QVERIFY(!bench.pollAt(5 * 32 + 9)->conditions.testFlag(Condition::SyncError));
    QCOMPARE(texts(bench.driver), QStringList{QStringLiteral("The sensor has restarted.")});
    // without the flag the count itself tells
    QVERIFY(bench.pollAt(7));
    QCOMPARE(texts(bench.driver), QStringList{QStringLiteral("The sensor counts its measurements anew.")});
}

QTEST_GUILESS_MAIN(TstAnd3Driver)
#include "tst_and3driver.moc"
