#include "core/simulation/simulatedbus.h"

#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

/// Two ИН-Д3 at 9600 8N1: a byte takes 1041 µs.
LineConfig line()
{
    LineConfig line;
    line.index = 1;
    line.baudRate = 9600;
    for (int i = 1; i <= 2; ++i) {
        SensorConfig sensor;
        sensor.number = 10 + i;
        sensor.address = i;
        sensor.type = SensorType::InD;
        line.sensors.append(sensor);
    }
    return line;
}

SimulatedBus bus(const char *fault = nullptr)
{
    SimulatedBus::Options options;
    if (fault) {
        options.faults = {*parseSimulatedFault(QString::fromLatin1(fault))};
    }
    return SimulatedBus(line(), options);
}

const QByteArray askFirst = hex("7E 9B 01 01 9B 7E"); // spec/ind3.md
const QByteArray askSecond = hex("7E 9B 01 02 98 7E");

QByteArray joined(const QList<SimulatedBus::Piece> &pieces)
{
    QByteArray bytes;
    for (const auto &piece : pieces) {
        bytes += piece.bytes;
    }
    return bytes;
}

} // namespace

class TestSimulatedBus : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theRightSensorAnswersAfterTheTimeOfTheBytes()
    {
        SimulatedBus site = bus();
        const auto pieces = site.receive(askSecond, 5s);
        QCOMPARE(pieces.size(), 1);
        QVERIFY(pieces.first().bytes.startsWith(hex("7E 9B 01 02")));
        QCOMPARE(site.wireTime(6), 6246us);
        QCOMPARE(pieces.first().at, 5s + site.wireTime(6) + 1ms + site.wireTime(pieces.first().bytes.size()));
    }

    void nobodyAnswersForeignRequests() { QVERIFY(bus().receive(hex("7E 9B 01 07 9D 7E"), 0s).isEmpty()); }

    void aSilentSensorIsSilentInItsTime()
    {
        SimulatedBus site = bus("silent=11@10-20");
        QVERIFY(!site.receive(askFirst, 5s).isEmpty());
        QVERIFY(site.receive(askFirst, 15s).isEmpty());
        QVERIFY(!site.receive(askSecond, 16s).isEmpty());
        QVERIFY(!site.receive(askFirst, 25s).isEmpty());
    }

    void faultsChangeTheAnswer()
    {
        const QByteArray good = joined(bus().receive(askFirst, 1s));
        const QByteArray damaged = joined(bus("crc=100").receive(askFirst, 1s));
        QCOMPARE(damaged.size(), good.size());
        QVERIFY(damaged != good);
        const QByteArray noisy = joined(bus("garbage=100").receive(askFirst, 1s));
        QVERIFY(noisy.size() > good.size() && noisy.endsWith(good));
        const auto pieces = bus("pieces=100").receive(askFirst, 1s);
        QVERIFY(pieces.size() > 1);
        QCOMPARE(joined(pieces), good);
        QVERIFY(bus("late=100").receive(askFirst, 1s).first().at > 2500ms);
    }
};

QTEST_APPLESS_MAIN(TestSimulatedBus)
#include "tst_simulatedbus.moc"
