#include "tests/core/devices/mk14station.h"
#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::mk14;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

const UtcTime someTime{std::chrono::seconds(1'700'000'000) + 400ms};

Service service(bool isClockUtc = true)
{
    Options options;
    options.parameters = usualParameters();
    options.outputs = 5;
    options.isClockUtc = isClockUtc;
    return Service(options, {}, [] { return someTime; });
}

// Packed by Python's struct module from manual 004, sections 3.6 and 4.1.
const QByteArray askMeans = hex("BB 03 01 00 A5 00 00 00 9C");
const QByteArray noData = hex("BB 03 00 00 A5 00 00 00 9D");
const QByteArray confirmation = hex("BB 03 00 00 00 00 00 00 42");
const QByteArray clockRequest = hex("BB 03 FF 00 00 F1 53 65 9A"); // 1700000000
const QByteArray file = hex("BB 03 FF 07 07 00 00 00 35  41 43 4B 2E 50 53 45 31 0D 0A BB 30 0D 0A D1");

} // namespace

/// The explicit actions: what is sent, and what counts as done.
class TstMk14Service : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void outputsStayOnceTheyAreSet()
    {
        FakeLine line;
        const Service station = service();
        QCOMPARE(station.outputs(line, 3), 5U);
        line.expect(askMeans, noData).expect(askMeans, noData);
        const auto set = station.setOutputs(line, 3, 0xA5);
        QVERIFY(set);
        QCOMPARE(set->digital, 0xA5U);
        QCOMPARE(station.outputs(line, 3), 0xA5U);
        QCOMPARE(station.outputs(line, 4), 5U);
        QVERIFY(station.read(line, 3, 1));
        QVERIFY(line.isDone() && line.complaints().isEmpty());
    }

    void outputsThatAreNotConfirmedDoNotStay()
    {
        FakeLine line;
        line.expect(askMeans, {}).expect(askMeans, {}).expect(askMeans, {});
        QCOMPARE(service().setOutputs(line, 3, 0xA5).fault(), Fault::Timeout);
        QVERIFY(!line.standingWord(3));
        QVERIFY(line.isDone() && line.complaints().isEmpty());
    }

    void timeIsConfirmedByABareHeader()
    {
        FakeLine line;
        line.expect(clockRequest, hex("00 BB") + confirmation);
        const auto sent = service().setTime(line, 3);
        QVERIFY(sent);
        QCOMPARE(*sent, 1'700'000'000);
    }

    void localTimeIsWhatTheClockOnTheWallShows()
    {
        qputenv("TZ", "UTC-3");
        tzset();
        FakeLine line;
        line.expect(hex("BB 03 FF 00 30 1B 54 65 3F"), confirmation); // 1700010800
        const auto sent = service(false).setTime(line, 3);
        QVERIFY(sent);
        QCOMPARE(*sent, 1'700'010'800);
        qunsetenv("TZ");
        tzset();
    }

    void anythingElseIsNotConfirmed_data()
    {
        QTest::addColumn<QByteArray>("answer");
        QTest::addColumn<Fault>("fault");
        QTest::newRow("silence") << QByteArray() << Fault::Timeout;
        QTest::newRow("another station") << hex("BB 04 00 00 00 00 00 00 41") << Fault::Timeout;
        QTest::newRow("data") << hex("BB 03 00 01 00 00 00 00 41 00 00 80 3F 41") << Fault::Timeout;
        QTest::newRow("the request itself") << file.first(9) << Fault::Timeout;
        QTest::newRow("a wrong check sum") << hex("BB 03 00 00 00 00 00 00 43") << Fault::Timeout;
    }

    void anythingElseIsNotConfirmed()
    {
        QFETCH(const QByteArray, answer);
        QFETCH(const Fault, fault);
        FakeLine line;
        line.expect(file, answer);
        QCOMPARE(
            service()
                .sendFile(
                    line, 3, "ACK.PSE",
                    "1\r\n\xBB"
                    "0\r\n")
                .fault(),
            fault);
        QVERIFY(line.isDone() && line.complaints().isEmpty()); // once
    }

    void aFileIsConfirmed()
    {
        FakeLine line;
        line.expect(file, confirmation);
        QVERIFY(service().sendFile(
            line, 3, "ACK.PSE",
            "1\r\n\xBB"
            "0\r\n"));
    }

    void aLongFileHasTimeToBeWritten()
    {
        StationLine line(weatherStation(3));
        const QByteArray text(64 * 1024, 'x');
        QVERIFY(service().sendFile(line, 3, "ACK.PAR", text));
        QCOMPARE(line.station().files().value("ACK.PAR"), text);
        FakeLine slow;
        slow.expect({}, {});
        QVERIFY(!service().sendFile(slow, 3, "ACK.PAR", text));
        QVERIFY(slow.writeTimeouts().first() > 600s);
    }

    void whatCannotBeIsNotSent()
    {
        FakeLine line;
        const Service station = service();
        QCOMPARE(station.read(line, 0, 1).fault(), Fault::Refused);
        QCOMPARE(station.read(line, 256, 1).fault(), Fault::Refused);
        QCOMPARE(station.read(line, 1, 0).fault(), Fault::Refused);
        QCOMPARE(station.read(line, 1, 9).fault(), Fault::Refused);
        QCOMPARE(station.setOutputs(line, 256, 0).fault(), Fault::Refused);
        QCOMPARE(station.setTime(line, 0).fault(), Fault::Refused);
        QCOMPARE(station.sendFile(line, 1, {}, "x").fault(), Fault::Refused);
        QCOMPARE(station.sendFile(line, 1, QByteArray(256, 'n'), "x").fault(), Fault::Refused);
        QCOMPARE(station.sendFile(line, 1, "n", QByteArray(64 * 1024 + 1, 'x')).fault(), Fault::Refused);
        QVERIFY(line.requestTimes().isEmpty());
    }
};

QTEST_GUILESS_MAIN(TstMk14Service)
#include "tst_mk14service.moc"
