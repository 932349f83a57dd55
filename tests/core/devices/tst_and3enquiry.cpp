#include "tests/core/devices/and3driverbench.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::and3;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

const QByteArray askFirmware = hex("01 24 04 00 B6 64");
const QByteArray firmware1 = hex("01 24 0C 03 02 00 02 BA");

QByteArray question(int kind)
{
    return sealed({1, 36, kind, 0});
}

QByteArray answer36(quint32 value)
{
    QByteArray frame("\x01\x24");
    addWord(frame, value, 4);
    return sealed(frame);
}

/// CanInfo=1, and the first question is due with the first poll.
DriverSettings asking()
{
    DriverSettings settings = settingsOfTest();
    settings.asksInformation = true;
    settings.sensor.number = 10;
    return settings;
}

/// What \a bench was told since the last look, or nothing.
DeviceInformation told(DriverBench &bench)
{
    return bench.driver.takeInformation().value_or(DeviceInformation());
}

} // namespace

/// CanInfo: what the sensor says of itself (36), once a minute (spec/gorizont.md, section 8).
class TstAnd3Enquiry : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void withoutCanInfoNothingIsAsked();
    void everyQuestionOnceAMinute();
    void aPollIsNotMadeLonger();
    void oneQuestionATurn();
    void neighboursAskInOtherSeconds();
    void answersBecomeInformation();
    void firmwareIsToldOnce();
    void silenceIsNoFault();
    void aLineThatIsGoneIs();
    void aChangedClockStopsNothing();
};

void TstAnd3Enquiry::withoutCanInfoNothingIsAsked()
{
    DriverSettings settings = asking();
    settings.asksInformation = false;
    DriverBench bench(settings);
    for (quint32 second = 0; second < 120; ++second) {
        QVERIFY(bench.pollAt(second % 32));
        QVERIFY(!bench.driver.hasBacklog());
        bench.now += 1s;
    }
    QVERIFY(bench.isClean());
}

void TstAnd3Enquiry::everyQuestionOnceAMinute()
{
    DriverBench bench(asking());
    constexpr int kinds[] = {4, 0, 2, 3, 5, 7};
    QList<int> asked;
    for (int second = 0; second < 180; ++second) {
        QVERIFY(bench.pollAt(5));
        if (bench.driver.hasBacklog()) {
            const int kind = kinds[asked.size() % 6];
            bench.line.expect(question(kind), kind == 4 ? firmware1 : answer36(1));
            QVERIFY(bench.driver.fetch(bench.line));
            asked.append(second);
        }
        bench.now += 1s;
    }
    QVERIFY(bench.isClean());
    QCOMPARE(asked, (QList<int>{0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120, 130, 140, 150, 160, 170}));
}

/// The question waits for the free time of the line, as bulk data do.
void TstAnd3Enquiry::aPollIsNotMadeLonger()
{
    DriverBench bench(asking());
    QVERIFY(bench.pollAt(5));
    QCOMPARE(bench.line.requestTimes().size(), 1);
    QVERIFY(bench.driver.hasBacklog());
}

void TstAnd3Enquiry::oneQuestionATurn()
{
    DriverBench bench(asking());
    bench.line.expect(askComplex, complexReadAnswer(6 * 32));
    QVERIFY(bench.driver.poll(bench.line));
    bench.line.expect(askFirmware, firmware1);
    const auto nothing = bench.driver.fetch(bench.line);
    QVERIFY(nothing && nothing->isEmpty());
    const auto blocks = bench.fetch(0, 4); // and now the packets
    QVERIFY(blocks && blocks->size() == 4);
    QVERIFY(bench.fetch(4, 2));
    QVERIFY(!bench.driver.hasBacklog());
    QVERIFY(bench.isClean());
}

void TstAnd3Enquiry::neighboursAskInOtherSeconds()
{
    const UtcTime start(1'700'000'000s);
    QMap<int, int> askingIn; // second → how many
    for (int number = 1; number <= 30; ++number) {
        Enquiry enquiry(number);
        for (int second = 0; second < 10; ++second) {
            if (enquiry.isDue(start + second * 1s)) {
                ++askingIn[second];
                enquiry.next(start + second * 1s);
            }
        }
    }
    QCOMPARE(askingIn.values(), QList<int>(10, 3));
}

void TstAnd3Enquiry::answersBecomeInformation()
{
    DriverBench bench(asking());
    const QList<QPair<int, quint32>> answers{{0, 40'000'000}, {2, 452}, {3, 1000}, {5, 0x0201}, {7, 250}};
    QVERIFY(bench.pollAt(5));
    bench.line.expect(askFirmware, firmware1);
    QVERIFY(bench.driver.fetch(bench.line));
    DeviceInformation expected;
    expected.number = 10;
    expected.firmware = QStringLiteral("2.3.12");
    QVERIFY(told(bench) == expected);
    for (const auto &[kind, value] : answers) {
        bench.now += 10s;
        QVERIFY(bench.pollAt(5));
        bench.line.expect(question(kind), answer36(value));
        QVERIFY(bench.driver.fetch(bench.line));
    }
    expected.systemClock = 40'000'000;
    expected.heaterPower = 452;
    expected.fanPower = 1000;
    expected.innerTransducer = 0x0201;
    expected.responseTime = 250;
    QVERIFY(told(bench) == expected);
    QVERIFY(!bench.driver.takeInformation()); // taken
    QVERIFY(bench.isClean());
}

void TstAnd3Enquiry::firmwareIsToldOnce()
{
    Enquiry enquiry(1);
    QVERIFY(enquiry.take(InformationKind::Firmware, firmware1));
    QVERIFY(!enquiry.take(InformationKind::Firmware, firmware1));
    QVERIFY(!enquiry.take(InformationKind::Firmware, hex("01 24 0C 03 02 00"))); // no answer 36

    DriverBench bench(asking());
    QVERIFY(bench.pollAt(5));
    bench.line.expect(askFirmware, firmware1);
    QVERIFY(bench.driver.fetch(bench.line));
    QCOMPARE(texts(bench.driver), QStringList{QStringLiteral("Firmware 2.3.12.")});
}

void TstAnd3Enquiry::silenceIsNoFault()
{
    DriverBench bench(asking());
    QVERIFY(bench.pollAt(5));
    bench.line.expect(askFirmware, QByteArray());
    QVERIFY(bench.driver.fetch(bench.line));
    QVERIFY(!bench.driver.takeInformation());
    QVERIFY(!bench.driver.hasBacklog()); // not again at once
    QVERIFY(bench.pollAt(5));
    QVERIFY(!bench.driver.hasBacklog());
    bench.now += 10s;
    QVERIFY(bench.pollAt(5));
    bench.line.expect(question(0), answer36(1)); // the next one, not the same again
    QVERIFY(bench.driver.fetch(bench.line));
    QVERIFY(bench.driver.takeNotes().isEmpty());
    QVERIFY(bench.isClean());
}

void TstAnd3Enquiry::aLineThatIsGoneIs()
{
    DriverBench bench(asking());
    QVERIFY(bench.pollAt(5));
    bench.line.vanishAfter(askFirmware);
    QCOMPARE(bench.driver.fetch(bench.line).fault(), Fault::Closed);
}

void TstAnd3Enquiry::aChangedClockStopsNothing()
{
    const UtcTime start(1'700'000'000s);
    Enquiry enquiry(10);
    QVERIFY(enquiry.isDue(start));
    enquiry.next(start);
    QVERIFY(!enquiry.isDue(start + 9s));
    QVERIFY(enquiry.isDue(start - 1h));
    enquiry.next(start - 1h);
    QVERIFY(!enquiry.isDue(start - 1h + 9s));
    QVERIFY(enquiry.isDue(start));
}

QTEST_GUILESS_MAIN(TstAnd3Enquiry)
#include "tst_and3enquiry.moc"
