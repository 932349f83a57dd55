#include "core/devices/and3/and3simulator.h"
#include "core/devices/buildingmotion.h"
#include "tests/core/devices/and3frames.h"
#include "tests/support/fakeline.h"

#include <QTest>
#include <QtEndian>

using namespace gorizont;
using namespace gorizont::and3;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

using Time = SimulatedDevice::Time;

const QByteArray askComplex = hex("01 C9 00 00 12 4A");
const QByteArray acknowledge = hex("01 32 65 01 4F BD");
const QByteArray done50 = hex("01 32 2F 38");

SensorConfig sensorOfTest(int address = 1)
{
    SensorConfig sensor;
    sensor.number = 5;
    sensor.address = address;
    return sensor;
}

/// An answer must be good in itself before anything is read of it.
bool isSealed(const QByteArray &answer)
{
    return answer.size() >= 4 && sealed(answer.chopped(2)) == answer;
}

quint16 wordAt(const QByteArray &bytes, qsizetype at)
{
    return qFromLittleEndian<quint16>(bytes.constData() + at);
}

quint32 longAt(const QByteArray &bytes, qsizetype at)
{
    return qFromLittleEndian<quint32>(bytes.constData() + at);
}

qint16 shortAt(const QByteArray &bytes, qsizetype at)
{
    return qFromLittleEndian<qint16>(bytes.constData() + at);
}

/// A simulator and short words for talking to it.
struct Bench
{
    QByteArray ask(std::initializer_list<int> request, Time now) { return device.receive(sealed(request), now); }
    quint32 samples(Time now) { return longAt(ask({1, 201, 0, 0}, now), 14); }
    quint16 status(Time now) { return wordAt(ask({1, 201, 0, 0}, now), 12); }
    quint16 mode(Time now) { return wordAt(ask({1, 201, 0, 0}, now), 18); }

    And3Simulator device{sensorOfTest(), 42};
};

} // namespace

class TstAnd3Simulator : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void valuesAreThoseOfTheBuilding();
    void rebootFlag();
    void statusWords();
    void hearsInPieces();
    void hearsThroughNoise();
    void ignoresOthers();
    void refusesWhatItDoesNotKnow_data();
    void refusesWhatItDoesNotKnow();
    void information();
    void packetHoldsTheSamples();
    void packetsFollowEachOther();
    void ringKeepsTheLast128();
    void emptyCells();
    void stopAndRun();
    void clearRing();
    void overrun();
    void reset();
    void changeOfAddress();
};

void TstAnd3Simulator::valuesAreThoseOfTheBuilding()
{
    SensorConfig sensor = sensorOfTest();
    sensor.hasThermostat = true;
    And3Simulator device(sensor, 42);
    const BuildingMotion motion(42, 5);
    for (const Time at : {Time(0), Time(1234567), Time(1h)}) {
        const QByteArray answer = device.receive(askComplex, at);
        QVERIFY(isSealed(answer));
        QCOMPARE(answer.size(), 22);
        QVERIFY(qAbs(shortAt(answer, 2) / 8.0 - motion.tiltX(at)) <= 1 / 16.0);
        QVERIFY(qAbs(shortAt(answer, 4) / 8.0 - motion.tiltY(at)) <= 1 / 16.0);
        QVERIFY(qAbs(shortAt(answer, 6) / 250.0 - motion.temperature(at)) <= 1 / 500.0);
        QVERIFY(qAbs(wordAt(answer, 8) / 8.0 - motion.fanFrequency(at)) <= 1 / 16.0);
        QVERIFY(qAbs(wordAt(answer, 10) / 10.0 - motion.heaterPower(at)) <= 1 / 20.0);
    }
}

void TstAnd3Simulator::rebootFlag()
{
    Bench bench;
    QCOMPARE(bench.status(0s) & 1, 0);
    QCOMPARE(bench.device.receive(acknowledge, 1s), done50);
    QCOMPARE(bench.status(2s) & 1, 1);
    bench.device.reboot(3s);
    QCOMPARE(bench.status(3s) & 1, 0);
    QCOMPARE(bench.samples(4s), quint32(10));
}

void TstAnd3Simulator::statusWords()
{
    Bench bench;
    bench.device.receive(acknowledge, 0s);
    QCOMPARE(bench.status(1s), quint16(0b0010'0100'0000'1111));
    QCOMPARE(bench.mode(1s), quint16(0b1100'1100'0000'0000));
    SensorConfig warm = sensorOfTest();
    warm.hasThermostat = true;
    And3Simulator device(warm, 42);
    device.receive(acknowledge, 0s);
    QCOMPARE(wordAt(device.receive(askComplex, 1s), 12), quint16(0b0010'0000'0000'1111));
}

void TstAnd3Simulator::hearsInPieces()
{
    Bench bench;
    for (const char c : askComplex.chopped(1)) {
        QVERIFY(bench.device.receive(QByteArray(1, c), 1s).isEmpty());
    }
    QCOMPARE(bench.device.receive(askComplex.right(1), 1s).size(), 22);
}

void TstAnd3Simulator::hearsThroughNoise()
{
    Bench bench;
    QCOMPARE(bench.device.receive(hex("01 C9 00 FF 00") + askComplex, 1s).size(), 22);
    QVERIFY(bench.device.receive(askComplex.left(4), 2s).isEmpty());
    QCOMPARE(bench.device.receive(askComplex, 3s).size(), 22);
    QByteArray damaged = askComplex;
    damaged[4] = 0x13;
    QVERIFY(bench.device.receive(damaged, 4s).isEmpty());
}

void TstAnd3Simulator::ignoresOthers()
{
    Bench bench;
    QVERIFY(bench.ask({2, 201, 0, 0}, 1s).isEmpty());
    QVERIFY(bench.ask({0, 201, 0, 0}, 1s).isEmpty());
    // broadcast is obeyed without an answer
    QVERIFY(bench.ask({0, 50, 101, 1}, 1s).isEmpty());
    QCOMPARE(bench.status(2s) & 1, 1);
}

void TstAnd3Simulator::refusesWhatItDoesNotKnow_data()
{
    QTest::addColumn<QByteArray>("request");
    QTest::newRow("unknown operation") << sealed({1, 200, 0, 0});
    QTest::newRow("unknown information") << sealed({1, 36, 1, 0});
    QTest::newRow("unknown mode") << sealed({1, 50, 7, 1});
    QTest::newRow("reset without its key") << sealed({1, 99, 0, 0});
    QTest::newRow("write without its key") << sealed({1, 220, 66, 98});
    QTest::newRow("unknown configuration") << sealed({1, 221, 3, 0});
    QTest::newRow("beyond the configuration") << sealed({1, 224, 32, 1});
    QTest::newRow("across the end of the ring") << sealed({1, 203, 127, 2});
    QTest::newRow("beyond the ring") << sealed({1, 203, 128, 1});
}

void TstAnd3Simulator::refusesWhatItDoesNotKnow()
{
    QFETCH(QByteArray, request);
    Bench bench;
    QVERIFY(bench.device.receive(request, 1s).isEmpty());
    QCOMPARE(bench.samples(5s), quint32(50)); // and goes on
}

void TstAnd3Simulator::information()
{
    Bench bench;
    QCOMPARE(bench.device.receive(hex("01 24 04 00 B6 64"), 1s), hex("01 24 0C 03 02 00 02 BA"));
    for (const int kind : {0, 2, 3, 5, 7}) {
        const QByteArray answer = bench.ask({1, 36, kind, 0}, 1s);
        QVERIFY(isSealed(answer) && answer.size() == 8);
    }
}

void TstAnd3Simulator::packetHoldsTheSamples()
{
    Bench bench;
    const QByteArray answer = bench.ask({1, 203, 2, 1}, 10s);
    QVERIFY(isSealed(answer) && answer.size() == 152);
    const BuildingMotion motion(42, 5);
    for (int i = 0; i < 32; ++i) {
        const Time at = (64 + i) * Time(100ms);
        // half a unit of rounding at 0.00594713 mm/s² a unit
        QVERIFY(qAbs(shortAt(answer, 2 + 2 * i) * -0.00594713 - motion.accelerationX(at)) < 0.003);
        QVERIFY(qAbs(shortAt(answer, 66 + 2 * i) * -0.00594713 - motion.accelerationY(at)) < 0.003);
    }
    QCOMPARE(wordAt(answer, 142), quint16(0)); // errors
    QVERIFY(wordAt(answer, 144) >= 324); // drz
    QVERIFY(wordAt(answer, 146) < 32767); // AX
    // what was recorded stays as it was
    QCOMPARE(bench.ask({1, 203, 2, 1}, 100s), answer);
}

/// Over the wrap of the low part of the ticks, which comes after 107 s.
void TstAnd3Simulator::packetsFollowEachOther()
{
    Bench bench;
    quint64 last = 0;
    for (int cell = 0; cell < 60; ++cell) {
        const QByteArray answer = bench.ask({1, 203, cell, 1}, 60 * Time(3200ms));
        const quint64 start = longAt(answer, 130);
        const quint64 stop = longAt(answer, 134);
        const quint64 high = longAt(answer, 138);
        QCOMPARE((start > stop ? high - 1 : high) << 32 | start, last);
        last = high << 32 | stop;
        QCOMPARE(last, static_cast<quint64>(cell + 1) * 128'000'000);
    }
}

void TstAnd3Simulator::ringKeepsTheLast128()
{
    Bench bench;
    const Time now = 200 * Time(3200ms); // packets 72…199
    const auto startOf = [&](int cell) {
        const QByteArray answer = bench.ask({1, 203, cell, 1}, now);
        const quint64 start = longAt(answer, 130);
        return (static_cast<quint64>(longAt(answer, 138)) - (start > longAt(answer, 134) ? 1 : 0)) << 32 | start;
    };
    QCOMPARE(startOf(199 % 128), 199 * ticksInPacket);
    QCOMPARE(startOf(200 % 128), 72 * ticksInPacket);
    QCOMPARE(startOf(127), 127 * ticksInPacket);
    QCOMPARE(startOf(0), 128 * ticksInPacket);
    const QByteArray several = bench.ask({1, 203, 10, 4}, now);
    QVERIFY(isSealed(several));
    QCOMPARE(several.size(), 4 + 4 * 148);
    QCOMPARE(several.mid(2 + 3 * 148, 148), bench.ask({1, 203, 13, 0}, now).mid(2, 148));
}

void TstAnd3Simulator::emptyCells()
{
    Bench bench;
    QCOMPARE(bench.ask({1, 203, 0, 1}, 3199ms), sealed(hex("01 CB") + QByteArray(148, '\0')));
    QVERIFY(longAt(bench.ask({1, 203, 0, 1}, 3200ms), 134) != 0);
    QCOMPARE(longAt(bench.ask({1, 203, 1, 1}, 3200ms), 134), quint32(0));
}

void TstAnd3Simulator::stopAndRun()
{
    Bench bench;
    QCOMPARE(bench.device.receive(hex("01 32 06 01 36 E3"), 10s), done50);
    QCOMPARE(bench.samples(20s), quint32(100));
    QCOMPARE(bench.mode(20s), quint16(0b1100'1100'0100'0000));
    QCOMPARE(bench.device.receive(hex("01 32 06 00 17 F3"), 30s), done50);
    QCOMPARE(bench.samples(31s), quint32(110));
    QCOMPARE(bench.mode(31s), quint16(0b1100'1100'0000'0000));
}

void TstAnd3Simulator::clearRing()
{
    Bench bench;
    QCOMPARE(bench.device.receive(hex("01 CE 00 00 82 CF"), 10s), hex("01 CE BC 16"));
    QCOMPARE(bench.samples(20s), quint32(0));
    QCOMPARE(bench.mode(20s), quint16(0b1100'1100'0100'0000));
    bench.ask({1, 50, 6, 0}, 20s);
    QCOMPARE(bench.samples(22s), quint32(20));
    QCOMPARE(bench.ask({1, 205, 16, 1}, 22s), hex("01 CD DF 26"));
}

void TstAnd3Simulator::overrun()
{
    Bench bench;
    bench.device.overrunRing(10s);
    QCOMPARE(bench.samples(10s), quint32(100 + 128 * 32));
    QCOMPARE(bench.samples(11s), quint32(110 + 128 * 32));
    QVERIFY(isSealed(bench.ask({1, 203, 2, 1}, 11s)));
}

void TstAnd3Simulator::reset()
{
    Bench bench;
    bench.device.receive(acknowledge, 1s);
    const QByteArray answer = bench.device.receive(hex("01 63 42 63 24 07"), 10s);
    QVERIFY(isSealed(answer));
    QVERIFY(answer.size() == 4 || answer.size() == 6);
    QVERIFY(bench.device.receive(askComplex, 10999ms).isEmpty());
    QCOMPARE(bench.status(11s) & 1, 0);
    QCOMPARE(bench.samples(12s), quint32(10));
}

/// The way of the description: 225, 201, 224, 221/1, 220, 99, and the new address after the restart.
void TstAnd3Simulator::changeOfAddress()
{
    Bench bench;
    QCOMPARE(bench.device.receive(hex("01 E1 00 00 75 65"), 1s), hex("01 E1 31 C3"));
    QCOMPARE(bench.device.receive(hex("01 E0 04 07 66 EE"), 1s), hex("01 E0 10 D3"));
    const QByteArray temporary = bench.device.receive(hex("01 DD 01 00 80 E6"), 1s);
    QVERIFY(isSealed(temporary) && temporary.size() == 36);
    QCOMPARE(static_cast<int>(temporary.at(2 + 4)), 7);
    QCOMPARE(static_cast<int>(bench.ask({1, 221, 0, 0}, 1s).at(2 + 4)), 1);
    QCOMPARE(static_cast<int>(bench.ask({1, 221, 2, 0}, 1s).at(2 + 4)), 1);
    const QByteArray written = bench.device.receive(hex("01 DC 42 63 EA D5"), 1s);
    QVERIFY(isSealed(written) && written.size() == 6);
    QCOMPARE(static_cast<int>(bench.ask({1, 221, 2, 0}, 1s).at(2 + 4)), 7);
    QCOMPARE(bench.device.address(), 1);
    bench.ask({1, 99, 66, 99}, 2s);
    QVERIFY(bench.ask({1, 201, 0, 0}, 4s).isEmpty());
    QVERIFY(isSealed(bench.ask({7, 201, 0, 0}, 4s)));
    QCOMPARE(bench.device.address(), 7);
}

QTEST_GUILESS_MAIN(TstAnd3Simulator)
#include "tst_and3simulator.moc"
