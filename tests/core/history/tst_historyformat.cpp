#include "core/history/cadence.h"
#include "core/history/historyformat.h"
#include "core/history/writehealth.h"
#include "core/values/clockwatch.h"
#include "tests/core/history/historysupport.h"

#include <QTest>

#include <limits>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

SensorColumns columns(const SensorConfig &sensor, quint16 status, std::optional<Tilt> tilt = {})
{
    SensorColumns result{sensor, {}};
    result.reading.number = sensor.number;
    result.reading.status = status;
    result.reading.tilt = tilt;
    return result;
}

LineStatus line(int port, LineState state)
{
    LineStatus status;
    status.port = port;
    status.state = state;
    return status;
}

const QList<LineStatus> twoLines{line(1, LineState::Open), line(2, LineState::Open)};

} // namespace

class TestHistoryFormat : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void dataLineOfTheSpecification();
    void accelerationLineHasBothMaximaFirst();
    void valueNeverKnownLeavesItsFieldEmpty();
    void lastValueStaysWhenTheStatusSaysInvalid();
    void bigNumbersWidenAndZeroHasNoSign();
    void whatIsNotANumberIsAbsent();
    void localeDoesNotMatter();
    void channelDigits_data();
    void channelDigits();
    void statusDigits_data();
    void statusDigits();
    void logLineHasItsDigit_data();
    void logLineHasItsDigit();
    void logTextStaysOnOneLine();
    void fileNames();
    void summerTimeIsLocal();
    void cadenceDropsLateTicks();
    void clockWatchNoticesSteps();
    void healthSpeaksOnceForAllStreams();
};

void TestHistoryFormat::dataLineOfTheSpecification()
{
    SensorColumns second = columns(tiltSensor(2, true), 0x0018, Tilt{-3599.5, -3599.5});
    second.reading.temperature = 21.38;
    const QList<SensorColumns> sensors{columns(tiltSensor(1), 0x0338, Tilt{-264.0, -6644.6}), second};
    const QDateTime local = localTime(moscow("2018-02-07T18:33:03.999"), moscowZone());
    QCOMPARE(dataRecord(local, gorizont::channelDigits(twoLines), sensors), expectedFile("spec_data.txt"));
}

void TestHistoryFormat::accelerationLineHasBothMaximaFirst()
{
    SensorColumns sensor = columns(accelerometer(1), 0x0018);
    sensor.reading.acceleration = AccelStatistics{179.4, -175.91, 35.24, 168.6, 2.2, 2.19, 0.001};
    const QDateTime local = localTime(moscow("2018-02-07T19:41:43"), moscowZone());
    const QList<SensorColumns> sensors{columns(tiltSensor(7), 0x0338, Tilt{1, 2}), sensor};
    QCOMPARE(accelerationRecord(local, gorizont::channelDigits(twoLines), sensors), expectedFile("spec_adata.txt"));
}

void TestHistoryFormat::valueNeverKnownLeavesItsFieldEmpty()
{
    SensorConfig heated = tiltSensor(2, true);
    heated.hasThermostat = true;
    const QDateTime local = localTime(moscow("2018-02-07T18:33:03"), moscowZone());
    const QList<SensorColumns> tilts{columns(tiltSensor(1, true), 0x0700), columns(heated, 0x0F00)};
    QCOMPARE(dataRecord(local, gorizont::channelDigits(twoLines), tilts), expectedFile("never_known_data.txt"));
    QCOMPARE(
        accelerationRecord(local, gorizont::channelDigits(twoLines), {columns(accelerometer(1), 0x0700)}),
        expectedFile("never_known_adata.txt"));
}

void TestHistoryFormat::lastValueStaysWhenTheStatusSaysInvalid()
{
    const QList<SensorColumns> sensors{columns(tiltSensor(1), 0x3700, Tilt{1.5, -2.5})};
    const QByteArray record = dataRecord(localTime(moscow("2018-02-07T18:33:03"), moscowZone()), "3330", sensors);
    QCOMPARE(record, "18:33:03 07.02.18\t3330\t     1.5\t    -2.5\t\t     0.0\t 3 0111 0000 0000\r\n");
}

void TestHistoryFormat::bigNumbersWidenAndZeroHasNoSign()
{
    SensorColumns hot = columns(tiltSensor(1, true), 0xA014, Tilt{-1234567.89, 123456789012.5});
    hot.reading.temperature = -40;
    hot.reading.heaterPower = 99.96;
    SensorColumns still = columns(tiltSensor(2, true), 0, Tilt{-0.04, 0.06});
    still.reading.temperature = -0.0;
    still.reading.heaterPower = -0.049;
    const QDateTime local = localTime(moscow("2018-02-07T18:33:03"), moscowZone());
    QCOMPARE(dataRecord(local, "3300", {hot, still}), expectedFile("big_data.txt"));
}

void TestHistoryFormat::whatIsNotANumberIsAbsent()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    const QDateTime local = localTime(moscow("2018-02-07T18:33:03"), moscowZone());
    QCOMPARE(
        dataRecord(local, "3330", {columns(tiltSensor(1), 0, Tilt{nan, -infinite})}),
        "18:33:03 07.02.18\t3330\t\t\t\t     0.0\t 0 0000 0000 0000\r\n");
    const QByteArray huge = dataRecord(local, "3330", {columns(tiltSensor(1), 0, Tilt{1e308, 0})});
    QCOMPARE(huge.split('\t').at(2).size(), 309 + 2);
}

void TestHistoryFormat::localeDoesNotMatter()
{
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::Arabic, QLocale::Egypt));
    dataLineOfTheSpecification();
    accelerationLineHasBothMaximaFirst();
    QCOMPARE(monthFileName(QDate(2018, 2, 7), MonthFile::Data), u"2018_02_data.txt");
    QLocale::setDefault(before);
}

void TestHistoryFormat::channelDigits_data()
{
    QTest::addColumn<QList<LineStatus>>("lines");
    QTest::addColumn<QByteArray>("digits");
    QTest::newRow("no port") << QList<LineStatus>() << QByteArray("3333");
    QTest::newRow("two good ports") << twoLines << QByteArray("3300");
    QTest::newRow("three ports, every code")
        << QList{line(1, LineState::OpenFailed), line(2, LineState::Lost), line(3, LineState::Off)}
        << QByteArray("3321");
    QTest::newRow("waiting and service are no errors")
        << QList{line(1, LineState::Opening), line(2, LineState::Service)} << QByteArray("3300");
    QTest::newRow("a hole") << QList{line(3, LineState::Open), line(1, LineState::Lost)} << QByteArray("3032");
    QTest::newRow("five ports widen the word") << QList{line(5, LineState::Open)} << QByteArray("03333");
    QList<LineStatus> sixteen;
    for (int port = 1; port <= 16; ++port) {
        sixteen.append(line(port, port == 16 ? LineState::OpenFailed : LineState::Open));
    }
    QTest::newRow("sixteen ports") << sixteen << QByteArray("1000000000000000");
    QTest::newRow("impossible ports") << QList{line(0, LineState::Open), line(17, LineState::Open)}
                                      << QByteArray("3333");
}

void TestHistoryFormat::channelDigits()
{
    QFETCH(QList<LineStatus>, lines);
    QTEST(gorizont::channelDigits(lines), "digits");
}

void TestHistoryFormat::statusDigits_data()
{
    QTest::addColumn<quint16>("word");
    QTest::addColumn<QByteArray>("digits");
    QTest::newRow("fan") << quint16(0xA014) << QByteArray("10 0000 0001 0100");
    QTest::newRow("polling off") << quint16(0x0F00) << QByteArray(" 0 1111 0000 0000");
    QTest::newRow("port off") << quint16(0x1700) << QByteArray(" 1 0111 0000 0000");
    QTest::newRow("sample of section 3") << quint16(0x0338) << QByteArray(" 0 0011 0011 1000");
    QTest::newRow("every bit") << quint16(0xFFFF) << QByteArray("15 1111 1111 1111");
}

void TestHistoryFormat::statusDigits()
{
    QFETCH(quint16, word);
    QTEST(gorizont::statusDigits(word), "digits");
}

void TestHistoryFormat::logLineHasItsDigit_data()
{
    QTest::addColumn<JournalKind>("kind");
    QTest::addColumn<QString>("record");
    QTest::newRow("info") << JournalKind::Info << QStringLiteral("0 18:33:03 07.02.18   текст\r\n");
    QTest::newRow("on") << JournalKind::On << QStringLiteral("1 18:33:03 07.02.18   текст\r\n");
    QTest::newRow("off") << JournalKind::Off << QStringLiteral("2 18:33:03 07.02.18   текст\r\n");
    QTest::newRow("error") << JournalKind::Error << QStringLiteral("3 18:33:03 07.02.18   текст\r\n");
}

void TestHistoryFormat::logLineHasItsDigit()
{
    QFETCH(JournalKind, kind);
    QTEST(logRecord({kind, moscow("2018-02-07T18:33:03"), QStringLiteral("текст")}, moscowZone()), "record");
}

void TestHistoryFormat::logTextStaysOnOneLine()
{
    const JournalEntry entry{JournalKind::Info, moscow("2018-02-07T18:33:03"), QStringLiteral("a\r\nb\tc")};
    QCOMPARE(logRecord(entry, moscowZone()), u"0 18:33:03 07.02.18   a  b c\r\n");
}

void TestHistoryFormat::fileNames()
{
    QCOMPARE(monthFileName(QDate(2018, 2, 28), MonthFile::Data), u"2018_02_data.txt");
    QCOMPARE(monthFileName(QDate(2018, 12, 1), MonthFile::Acceleration), u"2018_12_adata.txt");
    QCOMPARE(monthFileName(QDate(2026, 11, 1), MonthFile::Log), u"2026_11_log.txt");
    const QDateTime start = localTime(moscow("2016-03-29T22:46:09.700"), moscowZone());
    QCOMPARE(sampleFileName(start, 1, u'X'), u"16_03_29_22_46_09_1X.wrd");
    QCOMPARE(sampleFileName(start, 12, u'Y'), u"16_03_29_22_46_09_12Y.wrd");
}

void TestHistoryFormat::summerTimeIsLocal()
{
    const QTimeZone berlin("Europe/Berlin");
    QVERIFY(berlin.isValid());
    const UtcTime winter(std::chrono::seconds(1'711'846'799)); // 2024-03-31 00:59:59 UTC, the last second before
    QCOMPARE(localTime(winter, berlin).toString(u"hh:mm:ss"), u"01:59:59");
    QCOMPARE(localTime(winter + 1s, berlin).toString(u"hh:mm:ss"), u"03:00:00");
}

void TestHistoryFormat::cadenceDropsLateTicks()
{
    const SteadyTime start(1h);
    const Cadence cadence(start, 1000ms);
    QVERIFY(cadence.next(start) == start + 1s);
    QVERIFY(cadence.next(start + 999ms) == start + 1s);
    QVERIFY(cadence.next(start + 1003ms) == start + 2s);
    QVERIFY(cadence.next(start + 3700ms) == start + 4s);
}

void TestHistoryFormat::clockWatchNoticesSteps()
{
    ClockWatch watch;
    const UtcTime wall = moscow("2018-02-07T18:33:03");
    const SteadyTime steady(1h);
    QVERIFY(!watch.step(wall, steady));
    QVERIFY(!watch.step(wall + 10s, steady + 10s));
    QVERIFY(!watch.step(wall + 21s, steady + 20s)); // exactly the tolerance
    QCOMPARE(watch.step(wall - 3579s, steady + 20s).value_or(0s).count(), -3'600'000'000);
    QVERIFY(!watch.step(wall - 3578s, steady + 21s));
    QCOMPARE(watch.step(wall - 3576s + 500ms, steady + 21s).value_or(0s).count(), 2'500'000);
}

void TestHistoryFormat::healthSpeaksOnceForAllStreams()
{
    WriteHealth health(3000ms);
    const SteadyTime now(1h);
    QVERIFY(!health.succeeded(HistoryStream::Data));
    QVERIFY(health.failed(HistoryStream::Data, now));
    QVERIFY(!health.failed(HistoryStream::Samples, now + 1s));
    QVERIFY(!health.mayTry(HistoryStream::Data, now + 2999ms));
    QVERIFY(health.mayTry(HistoryStream::Data, now + 3s));
    QVERIFY(health.mayTry(HistoryStream::Log, now));
    QVERIFY(!health.failed(HistoryStream::Data, now + 3s));
    QVERIFY(!health.succeeded(HistoryStream::Data));
    QVERIFY(!health.succeeded(HistoryStream::Log));
    QVERIFY(health.succeeded(HistoryStream::Samples));
    QVERIFY(health.isGood());
}

QTEST_GUILESS_MAIN(TestHistoryFormat)
#include "tst_historyformat.moc"
