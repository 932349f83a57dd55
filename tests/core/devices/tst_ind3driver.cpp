#include "core/devices/ind3/ind3driver.h"
#include "tests/support/fakeline.h"

#include <QElapsedTimer>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// Frames of spec/ind3.md; those of Modbus RTU were assembled by another program.
class TstInd3Driver : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void polls_data();
    void polls();
    void silence_data();
    void silence();
    void wrongChecksum_data();
    void wrongChecksum();
    void lateAnswersOfOthers();
    void vanishes_data();
    void vanishes();
    void modbusException();
    void modbusKeepsSilence();
    void othersDoNotWait();
    void asksItsOwnAddress();
    void impossibleAddress();
    void unknownProtocol();
    void noBacklog();
};

namespace {

void protocols()
{
    QTest::addColumn<QString>("protocol");
    QTest::addColumn<QByteArray>("request");
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("x");

    const QByteArray request = hex("7E 9B 01 01 9B 7E");
    const QByteArray answer = hex("7E 9B 01 01 6A 77 80 38 C2 00 FC 7E");
    QTest::newRow("default") << QString() << request << answer << -119.4140625 << 194.21875;
    QTest::newRow("2.11") << QStringLiteral("2.11") << request << answer << -119.4140625 << 194.21875;
    QTest::newRow("2.10") << QStringLiteral("2.10") << hex("7E 9A 01 01 FE 7E") << hex("E2 7C 00 72 32 81 7D")
                          << 124.8828125 << -306.4453125;
    QTest::newRow("modbus") << QStringLiteral(" Modbus") << hex("01 04 00 00 00 04 F1 C9")
                            << hex("01 04 08 FF FE 2D 8A 00 02 F6 AB 4C BB") << -119.414 << 194.219;
}

std::unique_ptr<Driver> driver(const QString &protocol, int address = 1)
{
    DriverSettings settings;
    settings.sensor.type = SensorType::InD;
    settings.sensor.address = address;
    settings.timing.readCommand = 200ms;
    if (!protocol.isNull()) {
        settings.sensor.options.insert(QStringLiteral("protocol"), protocol);
    }
    return ind3::makeDriver(settings);
}

} // namespace

void TstInd3Driver::polls_data()
{
    protocols();
}

/// In one piece, byte by byte, and after an echo.
void TstInd3Driver::polls()
{
    QFETCH(QString, protocol);
    QFETCH(QByteArray, request);
    QFETCH(QByteArray, answer);
    QFETCH(double, y);
    QFETCH(double, x);

    FakeLine line;
    line.expect(request, answer).expectInPieces(request, answer).expectInPieces(request, request + answer, 3);
    const auto sensor = driver(protocol);
    Measurement expected;
    expected.tilt = Tilt{x, y};
    for (int turn = 0; turn < 3; ++turn) {
        const auto got = sensor->poll(line);
        QVERIFY(got);
        QCOMPARE(*got, expected);
    }
    QVERIFY(line.isDone());
    QCOMPARE(line.complaints(), QByteArrayList());
    QVERIFY(sensor->takeNotes().isEmpty());
}

void TstInd3Driver::silence_data()
{
    protocols();
}

void TstInd3Driver::silence()
{
    QFETCH(QString, protocol);
    QFETCH(QByteArray, request);
    QFETCH(QByteArray, answer);

    QElapsedTimer real;
    real.start();
    FakeLine line;
    line.expect(request, {}).expect(request, answer.chopped(1)).expect(request, answer);
    const auto sensor = driver(protocol);
    const auto first = sensor->poll(line);
    QVERIFY(!first);
    QCOMPARE(first.fault(), Fault::Timeout);
    QVERIFY(line.elapsed() >= 200ms && line.elapsed() <= 210ms); // TORCom
    QCOMPARE(sensor->poll(line).fault(), Fault::Timeout);
    QVERIFY(sensor->poll(line));
    QVERIFY(real.elapsed() < 100);
}

void TstInd3Driver::wrongChecksum_data()
{
    protocols();
}

void TstInd3Driver::wrongChecksum()
{
    QFETCH(QString, protocol);
    QFETCH(QByteArray, request);
    QFETCH(QByteArray, answer);

    QByteArray damaged = answer;
    damaged[4] = static_cast<char>(damaged.at(4) ^ 0x10);
    FakeLine line;
    line.expect(request, damaged).expect(request, damaged + answer);
    const auto sensor = driver(protocol);
    QCOMPARE(sensor->poll(line).fault(), Fault::Checksum);
    QVERIFY(sensor->poll(line)); // the good one behind it is taken
}

/// 2.10 cannot know: its answers carry no address.
void TstInd3Driver::lateAnswersOfOthers()
{
    FakeLine line;
    line.expectPieces(
        hex("7E 9B 01 01 9B 7E"),
        {{hex("7E 9B 01 02 6A 77 80 38 C2 00 FF 7E"), 5ms},
         {hex("7E 9C 01 01 04 98 7E"), 5ms},
         {hex("7E 9B 01 01 6A 77 80 38 C2 00 FC 7E"), 5ms}});
    const auto main = driver(QStringLiteral("2.11"))->poll(line);
    QVERIFY(main);
    QCOMPARE(main->tilt->x, 194.21875);

    line.expectPieces(
        hex("01 04 00 00 00 04 F1 C9"),
        {{hex("02 04 08 00 00 00 00 00 00 00 00 2B 49"), 5ms},
         {hex("01 84 02"), 5ms},
         {hex("01 04 08 FF FE 2D 8A 00 02 F6 AB 4C BB"), 5ms}});
    const auto overModbus = driver(QStringLiteral("modbus"))->poll(line);
    QVERIFY(overModbus);
    QCOMPARE(overModbus->tilt->x, 194.219);

    line.expect(hex("7E 9B 01 01 9B 7E"), hex("7E 9B 01 02 6A 77 80 38 C2 00 FF 7E"));
    QCOMPARE(driver(QString())->poll(line).fault(), Fault::Timeout);
}

void TstInd3Driver::vanishes_data()
{
    protocols();
}

void TstInd3Driver::vanishes()
{
    QFETCH(QString, protocol);
    QFETCH(QByteArray, request);
    FakeLine line;
    line.vanishAfter(request);
    const auto sensor = driver(protocol);
    QCOMPARE(sensor->poll(line).fault(), Fault::Closed);
    QCOMPARE(sensor->poll(line).fault(), Fault::Closed);
}

void TstInd3Driver::modbusException()
{
    FakeLine line;
    line.expect(hex("01 04 00 00 00 04 F1 C9"), hex("01 84 02 C2 C1"));
    QCOMPARE(driver(QStringLiteral("modbus"))->poll(line).fault(), Fault::Refused);
}

/// 3.5 characters between the end of an answer and the next request.
void TstInd3Driver::modbusKeepsSilence()
{
    FakeLine line;
    const QByteArray request = hex("01 04 00 00 00 04 F1 C9");
    const QByteArray answer = hex("01 04 08 FF FE 2D 8A 00 02 F6 AB 4C BB");
    line.expectPieces(request, {{answer, 10ms}}).expectPieces(request, {{answer, 10ms}});
    const auto sensor = driver(QStringLiteral("modbus"));
    QVERIFY(sensor->poll(line));
    QVERIFY(sensor->poll(line));
    QCOMPARE(line.requestTimes().size(), 2);
    QVERIFY(line.requestTimes().at(1) - line.requestTimes().at(0) >= 14ms);
}

void TstInd3Driver::othersDoNotWait()
{
    FakeLine line;
    const QByteArray request = hex("7E 9B 01 01 9B 7E");
    const QByteArray answer = hex("7E 9B 01 01 6A 77 80 38 C2 00 FC 7E");
    line.expect(request, answer).expect(request, answer);
    const auto sensor = driver(QString());
    QVERIFY(sensor->poll(line));
    QVERIFY(sensor->poll(line));
    QVERIFY(line.elapsed() == 0ms);
}

void TstInd3Driver::asksItsOwnAddress()
{
    FakeLine line;
    line.expect(hex("7E 9B 01 7D 5E E4 7E"), hex("7E 9B 01 7D 5E 40 04 00 00 03 00 A3 7E"));
    const auto got = driver(QString(), 0x7E)->poll(line);
    QVERIFY(got);
    QCOMPARE(*got->tilt, (Tilt{3, 4.25}));
    QCOMPARE(line.complaints(), QByteArrayList());
}

void TstInd3Driver::impossibleAddress()
{
    FakeLine line;
    QCOMPARE(driver(QString(), 256)->poll(line).fault(), Fault::Refused);
    QCOMPARE(line.complaints(), QByteArrayList());
    QVERIFY(line.requestTimes().isEmpty());
}

void TstInd3Driver::unknownProtocol()
{
    FakeLine line;
    line.expect(hex("7E 9B 01 01 9B 7E"), hex("7E 9B 01 01 6A 77 80 38 C2 00 FC 7E"));
    const auto sensor = driver(QStringLiteral("3.0"));
    QVERIFY(sensor->poll(line));
    const auto notes = sensor->takeNotes();
    QCOMPARE(notes.size(), 1);
    QCOMPARE(notes.first().kind, JournalKind::Error);
    QVERIFY(notes.first().text.contains(QStringLiteral("3.0")));
    QVERIFY(sensor->takeNotes().isEmpty());
}

void TstInd3Driver::noBacklog()
{
    QVERIFY(!driver(QString())->hasBacklog());
}

QTEST_GUILESS_MAIN(TstInd3Driver)
#include "tst_ind3driver.moc"
