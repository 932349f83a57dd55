#include "core/devices/usmisn/usmisndriver.h"
#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// What the recordings of tests/data/usmisn do not show: time, words for the journal, the watchdog.
class TstUsmIsnDriver : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void measuresBothAxes();
    void waitsForTheMeasurement();
    void transactionsGoOn();
    void asksForTheTypeAfterARestart();
    void tellsTroubleOnce();
    void anotherDevice();
    void impossibleAddress();
    void silencesTheLine();
    void leavesTheLineAlone();
    void watchdog();
};

namespace {

const QByteArray askType = "%/Q/7/001/GetType//%";
const QByteArray type = "\n%/R/7/001/GetType/028/%\r\n";

QByteArray question(const char *transaction, int channel)
{
    return QByteArray("%/Q/7/") + transaction + "/GetValue/0," + QByteArray::number(channel) + "/%";
}

QByteArray answer(const char *transaction, int channel, const char *value = "-0000.50000")
{
    return QByteArray("\n%/R/007/") + transaction + "/GetValue/0,0028000280" + QByteArray::number(channel) + ",0,"
        + value + ",0000.00020,-05.25,A,Grad,Angle,001,5/%\r\n";
}

std::unique_ptr<Driver> driver(const QHash<QString, QString> &options = {}, int address = 7)
{
    DriverSettings settings;
    settings.sensor.type = SensorType::UsmIsn;
    settings.sensor.address = address;
    settings.sensor.options = options;
    settings.timing.readCommand = 200ms;
    settings.timing.readErrorLimit = 3;
    return usmisn::makeDriver(settings);
}

} // namespace

void TstUsmIsnDriver::measuresBothAxes()
{
    FakeLine line;
    line.expectInPieces(askType, type);
    line.expectInPieces(question("002", 1), answer("002", 1))
        .expectInPieces(question("003", 2), answer("003", 2, "0001.25000"), 3);
    const auto measured = driver()->poll(line);
    QVERIFY(measured);
    Measurement expected;
    expected.tilt = Tilt{-1800, 4500};
    expected.variation = TiltVariation{0.0002, 0.0002};
    expected.temperature = -5.25;
    QCOMPARE(*measured, expected);
    QVERIFY(line.isDone());
    QCOMPARE(line.complaints(), QByteArrayList());
}

/// 1.5 s an axis at most, and twice that before it is given up; none of it is real time.
void TstUsmIsnDriver::waitsForTheMeasurement()
{
    FakeLine line;
    line.expect(askType, type);
    line.expectPieces(question("002", 1), {{answer("002", 1), 1500ms}});
    line.expectPieces(question("003", 2), {{answer("003", 2), 2900ms}});
    const auto sensor = driver();
    QVERIFY(sensor->poll(line));
    const auto before = line.elapsed();
    line.expect(question("004", 1), {});
    QCOMPARE(sensor->poll(line).fault(), Fault::Timeout);
    QCOMPARE(line.elapsed() - before, 3000ms); // the other axis is not asked
    QVERIFY(line.isDone());
}

/// The late answer of the last turn is not taken for that of this one.
void TstUsmIsnDriver::transactionsGoOn()
{
    FakeLine line;
    line.expect(askType, type).expect(question("002", 1), {});
    line.expectPieces(question("003", 1), {{answer("002", 1, "0009.00000"), 5ms}, {answer("003", 1), 5ms}});
    line.expect(question("004", 2), answer("004", 2));
    const auto sensor = driver();
    QVERIFY(!sensor->poll(line));
    const auto measured = sensor->poll(line);
    QVERIFY(measured);
    QCOMPARE(measured->tilt->x, -1800.0);
    QCOMPARE(line.complaints(), QByteArrayList());
}

void TstUsmIsnDriver::asksForTheTypeAfterARestart()
{
    FakeLine line;
    line.expect(askType, type)
        .expect(question("002", 1), answer("002", 1))
        .expect(question("003", 2), answer("003", 2));
    line.expect("%/Q/7/004/GetType//%", "\n%/R/7/004/GetType/028/%\r\n");
    line.expect(question("005", 1), answer("005", 1)).expect(question("006", 2), answer("006", 2));
    const auto sensor = driver();
    QVERIFY(sensor->poll(line));
    sensor->restart();
    QVERIFY(sensor->poll(line));
    QVERIFY(line.isDone());
    QCOMPARE(line.complaints(), QByteArrayList());
}

void TstUsmIsnDriver::tellsTroubleOnce()
{
    FakeLine line;
    line.expect(askType, type);
    const auto sensor = driver();
    const auto turn = [&](const char *first, const char *second, const char *keyword) {
        const QByteArray bad = QByteArray("\n%/R/7/") + first + "/GetValue/" + keyword + "/% \r\n";
        line.expect(question(first, 1), *keyword ? bad : answer(first, 1))
            .expect(question(second, 2), answer(second, 2));
        return sensor->poll(line) ? sensor->takeNotes() : QList<DriverNote>();
    };
    const auto first = turn("002", "003", "ErrorCH");
    QCOMPARE(first.size(), 1);
    QCOMPARE(first.first().kind, JournalKind::Error);
    QVERIFY(first.first().text.contains(QStringLiteral("ErrorCH")));
    QVERIFY(turn("004", "005", "ErrorCH").isEmpty());
    const auto other = turn("006", "007", "ErrorData");
    QCOMPARE(other.size(), 1);
    QVERIFY(other.first().text.contains(QStringLiteral("ErrorData")));
    QVERIFY(turn("008", "009", "").isEmpty());
    QCOMPARE(turn("010", "011", "ErrorData").size(), 1); // it was well meanwhile
    QVERIFY(turn("012", "013", "ErrorSensor").isEmpty()); // that is a status
    QCOMPARE(line.complaints(), QByteArrayList());
}

void TstUsmIsnDriver::anotherDevice()
{
    FakeLine line;
    line.expect(askType, "\n%/R/7/001/GetType/017/%\r\n")
        .expect("%/Q/7/002/GetType//%", "\n%/R/7/002/GetType/017/%\r\n");
    const auto sensor = driver();
    QCOMPARE(sensor->poll(line).fault(), Fault::Refused);
    const auto notes = sensor->takeNotes();
    QCOMPARE(notes.size(), 1);
    QVERIFY(notes.first().text.contains(QStringLiteral("17")));
    QCOMPARE(sensor->poll(line).fault(), Fault::Refused);
    QVERIFY(sensor->takeNotes().isEmpty());
    QVERIFY(line.isDone());
}

void TstUsmIsnDriver::impossibleAddress()
{
    FakeLine line;
    QCOMPARE(driver({}, 0)->poll(line).fault(), Fault::Refused);
    QCOMPARE(driver({}, 256)->poll(line).fault(), Fault::Refused);
    QVERIFY(line.requestTimes().isEmpty());
}

/// After NumRErrSrs failures in a row the line is to be silent for 30 s, and only then again after as many more.
void TstUsmIsnDriver::silencesTheLine()
{
    FakeLine line;
    const auto sensor = driver();
    for (int round = 0; round < 2; ++round) {
        for (int i = 1; i <= 3; ++i) {
            QCOMPARE(sensor->takeSilence(), 0s);
            QVERIFY(!sensor->poll(line));
        }
        QCOMPARE(sensor->takeSilence(), 30s);
    }
    QCOMPARE(sensor->takeSilence(), 0s);
}

void TstUsmIsnDriver::leavesTheLineAlone()
{
    FakeLine line;
    const auto sensor = driver({{QStringLiteral("usmrevive"), QStringLiteral("0")}});
    for (int i = 0; i < 10; ++i) {
        QVERIFY(!sensor->poll(line));
        QCOMPARE(sensor->takeSilence(), 0s);
    }
    FakeLine lost;
    lost.close();
    const auto other = driver();
    for (int i = 0; i < 10; ++i) { // no fault of the device
        QCOMPARE(other->poll(lost).fault(), Fault::Closed);
        QCOMPARE(other->takeSilence(), 0s);
    }
    FakeLine foreign;
    const auto third = driver();
    for (int i = 1; i < 10; ++i) { // whoever answers does not hang
        const QByteArray number = QByteArray::number(i).rightJustified(3, '0');
        foreign.expect("%/Q/7/" + number + "/GetType//%", "\n%/R/7/" + number + "/GetType/017/%\r\n");
        QCOMPARE(third->poll(foreign).fault(), Fault::Refused);
        QCOMPARE(third->takeSilence(), 0s);
    }
}

void TstUsmIsnDriver::watchdog()
{
    const auto food = driver()->keepAlive();
    QVERIFY(food);
    QCOMPARE(food->message, QByteArray("%/Q/0/000/GetSerial//%"));
    QVERIFY(food->after <= 13s); // twice in 26 s
}

QTEST_GUILESS_MAIN(TstUsmIsnDriver)
#include "tst_usmisndriver.moc"
