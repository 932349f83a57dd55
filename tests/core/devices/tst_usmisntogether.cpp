#include "core/devices/addressscan.h"
#include "core/devices/usmisn/usmisnrecords.h"
#include "core/devices/usmisn/usmisnservice.h"
#include "core/devices/usmisn/usmisnsimulator.h"
#include "tests/support/simulatedtime.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::usmisn;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// The service against the simulator, on lines where things go wrong.
class TstUsmisnTogether : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void scansALine();
    void movesThePort();
    void wakesARecorder();
    void resumesWithoutLossOrDuplicates();
    void threeAnswersOnADisturbedLine_data();
    void threeAnswersOnADisturbedLine();
};

namespace {

Timing timing()
{
    Timing timing;
    timing.readCommand = 200ms;
    timing.readData = 4000ms;
    return timing;
}

LineConfig lineWith(int sensors, int baud = 9600)
{
    LineConfig line;
    line.index = 1;
    line.baudRate = baud;
    for (int i = 1; i <= sensors; ++i) {
        SensorConfig sensor;
        sensor.type = SensorType::UsmIsn;
        sensor.number = i;
        sensor.address = 10 * i;
        sensor.serialNumber = QString::number(1234567 + i);
        line.sensors.append(sensor);
    }
    return line;
}

/// That has been on for two seconds.
std::unique_ptr<SimulatedTimeLine> siteWith(int sensors, int baud = 9600, const QStringList &faults = {})
{
    SimulatedBus::Options options;
    for (const QString &fault : faults) {
        options.faults.append(*parseSimulatedFault(fault));
    }
    auto line = std::make_unique<SimulatedTimeLine>(lineWith(sensors, baud), options);
    line->wait(2000ms);
    return line;
}

Simulator &deviceOf(const SimulatedTimeLine &line)
{
    return dynamic_cast<Simulator &>(*line.bus().devices().front());
}

} // namespace

void TstUsmisnTogether::scansALine()
{
    const auto line = siteWith(3);
    const Service service(timing());
    AddressScan scan;
    while (scan.next() != 0) {
        const auto type = service.probe(*line, scan.next());
        scan.record(type ? Result<void>() : type.fault());
    }
    QCOMPARE(scan.found(), (QList<int>{10, 20, 30}));
    QVERIFY(scan.unclear().isEmpty());
    QVERIFY(line->elapsed() < 70s);
    QCOMPARE(*service.find(*line, 1234569), 20);
    QVERIFY(service.find(*line, 7654321).fault() == Fault::Timeout);
    QCOMPARE(service.read(*line, 30)->serial, 1234570U);
}

void TstUsmisnTogether::movesThePort()
{
    const auto line = siteWith(1);
    const Service service(timing());
    const PortSettings fast{57600, Parity::Even, StopBits::Two};
    const PortChange changed = service.changePort(*line, 10, fast);
    QVERIFY(changed.result && changed.isProbed);
    QCOMPARE(deviceOf(*line).ownPort(), fast);
    QCOMPARE(*line->port(), factoryPort); // the line is as it was
    QVERIFY(service.probe(*line, 10).fault() == Fault::Timeout);
    QVERIFY(service.changePort(*line, 10, fast).result); // it hears nothing at the old settings, and is at the new ones

    QVERIFY(line->setPort(fast));
    const PortChange reset = service.resetPort(*line, 10);
    QVERIFY(reset.result && reset.isProbed);
    QVERIFY(line->setPort(factoryPort));
    QVERIFY(service.probe(*line, 10));
    QVERIFY(service.changePort(*line, 11, fast).result.fault() == Fault::Timeout);
    QVERIFY(service.changePort(*line, 10, {50, Parity::None, StopBits::One}).result.fault() == Fault::Refused);
}

void TstUsmisnTogether::wakesARecorder()
{
    const auto line = siteWith(1);
    const Service service(timing());
    QVERIFY(service.startCycle(*line, 10, {1483267255, 1483267265, 900s, 0s}));
    const auto start = line->elapsed();
    bool isAwake = false;
    while (!isAwake && line->elapsed() - start < Service::stopLimit) {
        const auto stopped = service.tryStopCycle(*line, 10);
        isAwake = static_cast<bool>(stopped);
        QVERIFY(isAwake || stopped.fault() == Fault::Timeout);
    }
    QVERIFY(isAwake);
    QVERIFY(line->elapsed() - start < 30s);
    QVERIFY(service.probe(*line, 10));
}

/// A month of a recorder over a line that loses answers: new ones first, then all of them until nothing is missing.
void TstUsmisnTogether::resumesWithoutLossOrDuplicates()
{
    const auto line = siteWith(1, 115200, {QStringLiteral("crc=40@600-4000000")});
    const Service service(timing());
    QVERIFY(service.startCycle(*line, 10, {1483267255, 1483267256, 3600s, 0s}));
    line->wait(std::chrono::hours(24 * 30));
    for (int i = 0; i < 1000 && deviceOf(*line).isRecording(); ++i) {
        (void)service.tryStopCycle(*line, 10);
    }
    QVERIFY(!deviceOf(*line).isRecording());
    RecordBook book;
    int seen = 0;
    bool isWhole = false;
    for (int pass = 0; pass < 20 && !isWhole; ++pass) {
        isWhole = true;
        for (const int channel : {channelX, channelY}) {
            int taken = 0;
            const RecordMask mask = pass == 0 ? RecordMask::New : RecordMask::All;
            const auto done = service.records(*line, 10, 0, mask, channel, [&](const Value &record) {
                book.add(record);
                ++seen;
                return pass > 0 || ++taken < 100; // the first transfers are stopped
            });
            isWhole = isWhole && done;
            line->wait(8s); // a device that was not heard to the end goes on sending
        }
        isWhole = isWhole && book.missing() == 0;
    }
    QVERIFY(isWhole);
    QVERIFY(seen > book.size()); // some came twice
    QCOMPARE(book.size(), deviceOf(*line).memory().size());
    QCOMPARE(book.missing(), 0);
}

void TstUsmisnTogether::threeAnswersOnADisturbedLine_data()
{
    QTest::addColumn<QStringList>("faults");
    QTest::newRow("garbage") << QStringList{QStringLiteral("garbage=100")};
    QTest::newRow("pieces") << QStringList{QStringLiteral("pieces=100")};
    QTest::newRow("late") << QStringList{QStringLiteral("late=30")};
    QTest::newRow("all") << QStringList{
        QStringLiteral("garbage=50"), QStringLiteral("pieces=50"), QStringLiteral("late=10"), QStringLiteral("crc=10")};
}

/// What is read is right or a fault, never something else.
void TstUsmisnTogether::threeAnswersOnADisturbedLine()
{
    QFETCH(QStringList, faults);
    const auto line = siteWith(2, 9600, faults);
    const Service service(timing());
    int good = 0;
    for (int i = 0; i < 30; ++i) {
        const auto identity = service.read(*line, 20);
        if (identity) {
            ++good;
            QCOMPARE(identity->address, 20);
            QCOMPARE(identity->channels.size(), 2);
            QCOMPARE(identity->calibratedOn, QDate(2017, 4, 14));
        }
    }
    QVERIFY2(good >= 10, qPrintable(QString::number(good)));
}

QTEST_GUILESS_MAIN(TstUsmisnTogether)
#include "tst_usmisntogether.moc"
