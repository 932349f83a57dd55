#include "tests/core/devices/and3frames.h"
#include "tests/core/engine/inisite.h"

#include <QTest>

#include <thread>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;
using std::chrono::milliseconds;

namespace {

QByteArray damaged(QByteArray answer)
{
    answer[5] = static_cast<char>(answer[5] ^ 1);
    return answer;
}

SteadyTime now()
{
    return std::chrono::steady_clock::now();
}

/// Takes turns until nothing is to be done at once: when there will be.
SteadyTime settle(LinePoller &poller, Line &line)
{
    SteadyTime next;
    do {
        next = poller.turn(line).nextAt;
    } while (next <= now());
    return next;
}

/// The next turn that asked a sensor.
TurnReport nextPoll(LinePoller &poller, Line &line)
{
    TurnReport report;
    do {
        std::this_thread::sleep_until(report.nextAt);
        report = poller.turn(line);
    } while (report.readings.isEmpty());
    return report;
}

} // namespace

/// [Timers], [Pauses], [Sleeps], [TimeOuts] and [Errors] of the ini: each key from the file to what it does to a line
/// (manual 000, section 5). Times on the line are those of its own clock.
class TestTimingKeys : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pauses_data();
    void pauses();
    void tmRunIsThePeriodOfACycle();
    void readTimeouts_data();
    void readTimeouts();
    void writeTimeouts();
    void sAdrChange_data();
    void sAdrChange();
    void pPauseTickIsTheLongestSlice_data();
    void pPauseTickIsTheLongestSlice();
    void pPauseTickIsTheRestOfParkedSensors();
    void errorLimits_data();
    void errorLimits();
};

void TestTimingKeys::pauses_data()
{
    QTest::addColumn<QByteArray>("ini");
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<int>("pause");
    const QByteArray bad = damaged(answerInD3);
    QTest::newRow("none") << QByteArray() << answerInD3 << 0;
    QTest::newRow("SIdle") << QByteArray("[Sleeps]\nSIdle=5000") << answerInD3 << 5000;
    QTest::newRow("SIdle, other") << QByteArray("[Sleeps]\nSIdle=9000") << answerInD3 << 9000;
    QTest::newRow("SRError") << QByteArray("[Sleeps]\nSRError=6000") << QByteArray() << 6000;
    QTest::newRow("SRError, other") << QByteArray("[Sleeps]\nSRError=8000") << QByteArray() << 8000;
    QTest::newRow("SRError after a CRC error") << QByteArray("[Sleeps]\nSRError=6000") << bad << 0;
    QTest::newRow("SRError after an answer") << QByteArray("[Sleeps]\nSRError=6000") << answerInD3 << 0;
    QTest::newRow("SCRCErr") << QByteArray("[Sleeps]\nSCRCErr=5000") << bad << 5000;
    QTest::newRow("SCRCErrors") << QByteArray("[Sleeps]\nSCRCErrors=7000") << bad << 7000;
    QTest::newRow("SCRCError after a silence") << QByteArray("[Sleeps]\nSCRCError=5000") << QByteArray() << 0;
}

/// The next turn comes after the pause and not before TmRun; the moments they count from lie between two looks at the
/// clock.
void TestTimingKeys::pauses()
{
    QFETCH(QByteArray, ini);
    QFETCH(QByteArray, answer);
    QFETCH(int, pause);
    constexpr auto period = 2000ms;
    const PollingSettings settings = settingsFrom(sensorsOf("IN-D3") + "[Timers]\nTmRun=2000\n" + ini);
    FakeLine line;
    line.expect(askInD3, answer);
    const SteadyTime before = now();
    const auto poller = startedPoller(settings);
    const SteadyTime started = now();
    const SteadyTime next = settle(*poller, line);
    QCOMPARE(line.complaints(), QByteArrayList());
    QVERIFY(next >= before + std::max(period, milliseconds(pause)));
    QVERIFY(next <= std::max(started + period, now() + milliseconds(pause)));
}

void TestTimingKeys::tmRunIsThePeriodOfACycle()
{
    for (const int period : {3000, 7000}) {
        const QByteArray ini = "[Timers]\nTmRun=" + QByteArray::number(period);
        const SteadyTime before = now();
        const auto poller = startedPoller(settingsFrom(sensorsOf("IN-D3") + ini));
        const SteadyTime after = now();
        FakeLine line;
        line.expect(askInD3, answerInD3);
        const SteadyTime next = settle(*poller, line);
        QVERIFY(next >= before + milliseconds(period));
        QVERIFY(next <= after + milliseconds(period));
    }
}

void TestTimingKeys::readTimeouts_data()
{
    QTest::addColumn<QByteArray>("ini");
    QTest::addColumn<int>("command"); // ms
    QTest::addColumn<int>("data");
    QTest::newRow("defaults") << QByteArray() << 200 << 4000;
    QTest::newRow("TORCom") << QByteArray("[TimeOuts]\nTORCom=1300") << 1300 << 4000;
    QTest::newRow("TORDat") << QByteArray("[TimeOuts]\nTORDat=6100") << 200 << 6100;
}

void TestTimingKeys::readTimeouts()
{
    QFETCH(QByteArray, ini);
    QFETCH(int, command);
    QFETCH(int, data);
    FakeLine line;
    line.expect(askAnD3, QByteArray());
    startedPoller(settingsFrom(sensorsOf("AN-D3") + ini))->turn(line);
    QCOMPARE(line.elapsed().count(), command);

    FakeLine bulk;
    bulk.expect(askAnD3, complexReadAnswer(32)).expect(sealed({1, 203, 0, 1}), QByteArray());
    const auto poller = startedPoller(settingsFrom(sensorsOf("AN-D3") + ini + "\n[Timers]\nTmRun=10000"));
    poller->turn(bulk);
    poller->turn(bulk); // in the free time of the cycle
    QCOMPARE(bulk.complaints(), QByteArrayList());
    QCOMPARE((bulk.elapsed() - bulk.requestTimes().last()).count(), data);
}

void TestTimingKeys::writeTimeouts()
{
    const QByteArray ini = "[TimeOuts]\nTOWCom=310\nTOWDat=2700\n[Timers]\nTmRun=10000";
    FakeLine line;
    line.expect(askAnD3, complexReadAnswer(32)).expect(sealed({1, 203, 0, 1}), QByteArray());
    const auto poller = startedPoller(settingsFrom(sensorsOf("AN-D3") + ini));
    poller->turn(line);
    poller->turn(line);
    QCOMPARE(line.writeTimeouts(), (QList<milliseconds>{310ms, 2700ms}));
}

void TestTimingKeys::sAdrChange_data()
{
    QTest::addColumn<int>("pause");
    QTest::newRow("none") << 0;
    QTest::newRow("usual") << 16;
    QTest::newRow("long") << 450;
}

/// Between two sensors, and not before the same one is asked again.
void TestTimingKeys::sAdrChange()
{
    QFETCH(int, pause);
    const QByteArray ini = "[Sleeps]\nSAdrChange=" + QByteArray::number(pause);
    const PollingSettings two = settingsFrom(sensorsOf("IN-D3", 2) + ini);
    const auto poller = startedPoller(two);
    FakeLine line;
    line.expect(askInD3, answerInD3);
    line.expect(hex("7E 9B 01 02 98 7E"), hex("7E 9B 01 02 6A 77 80 38 C2 00 FF 7E"));
    poller->turn(line);
    poller->turn(line);
    QCOMPARE(line.complaints(), QByteArrayList());
    QCOMPARE((line.requestTimes().at(1) - line.requestTimes().at(0)).count(), pause);

    const auto alone = startedPoller(settingsFrom(sensorsOf("IN-D3") + ini));
    FakeLine own;
    own.expect(askInD3, answerInD3).expect(askInD3, answerInD3);
    nextPoll(*alone, own);
    nextPoll(*alone, own);
    QCOMPARE(own.requestTimes(), (QList<milliseconds>{0ms, 0ms}));
}

void TestTimingKeys::pPauseTickIsTheLongestSlice_data()
{
    QTest::addColumn<int>("tick");
    QTest::newRow("5") << 5;
    QTest::newRow("250") << 250;
}

/// A wait is cut into slices so that the end of the program is heard.
void TestTimingKeys::pPauseTickIsTheLongestSlice()
{
    QFETCH(int, tick);
    FakeLine line{milliseconds(tick)};
    line.expect(askInD3, QByteArray()).expect(hex("7E 9B 01 02 98 7E"), QByteArray());
    const auto poller =
        startedPoller(settingsFrom(sensorsOf("IN-D3", 2) + "[TimeOuts]\nTORCom=1000\n[Sleeps]\nSAdrChange=2000"));
    poller->turn(line);
    QVERIFY(line.longestSlice() == milliseconds(tick));
    poller->turn(line); // and the silence before the next request
    QCOMPARE(line.requestTimes().size(), 2);
    QVERIFY(line.longestSlice() == milliseconds(tick));
}

void TestTimingKeys::pPauseTickIsTheRestOfParkedSensors()
{
    const QByteArray ini = "[Timers]\nTmRun=300\n[Pauses]\nPPauseTick=1650\n[Errors]\nNumRErrSrs=1";
    const auto poller = startedPoller(settingsFrom(sensorsOf("IN-D3") + ini));
    FakeLine line;
    line.expect(askInD3, QByteArray());
    std::this_thread::sleep_until(settle(*poller, line));
    const SteadyTime before = now();
    const SteadyTime next = settle(*poller, line);
    QCOMPARE(line.requestTimes().size(), 1); // parked: not asked
    QVERIFY(next >= before + 1650ms);
    QVERIFY(next <= now() + 1650ms);
}

void TestTimingKeys::errorLimits_data()
{
    QTest::addColumn<QByteArray>("ini");
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<int>("limit");
    QTest::addColumn<quint16>("word");
    const QByteArray bad = damaged(answerInD3);
    QTest::newRow("NumRErrSrs=1") << QByteArray("NumRErrSrs=1") << QByteArray() << 1 << quint16(0x3700);
    QTest::newRow("NumRErrSrs=4") << QByteArray("NumRErrSrs=4\nNumCErrSrs=1") << QByteArray() << 4 << quint16(0x3700);
    QTest::newRow("NumCErrSrs=1") << QByteArray("NumCErrSrs=1") << bad << 1 << quint16(0x4700);
    QTest::newRow("NumCErrSrs=4") << QByteArray("NumCErrSrs=4\nNumRErrSrs=1") << bad << 4 << quint16(0x4700);
}

void TestTimingKeys::errorLimits()
{
    QFETCH(QByteArray, ini);
    QFETCH(QByteArray, answer);
    QFETCH(int, limit);
    QFETCH(quint16, word);
    const auto poller = startedPoller(settingsFrom(sensorsOf("IN-D3") + "[Errors]\n" + ini));
    FakeLine line;
    for (int failures = 1; failures <= limit; ++failures) {
        line.expect(askInD3, answer);
        const TurnReport report = nextPoll(*poller, line);
        QCOMPARE(report.readings.first().status, failures < limit ? quint16(0x0700) : word);
    }
}

QTEST_APPLESS_MAIN(TestTimingKeys)
#include "tst_timingkeys.moc"
