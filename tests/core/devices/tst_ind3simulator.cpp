#include "core/devices/ind3/ind3driver.h"
#include "core/devices/ind3/ind3modbus.h"
#include "core/devices/ind3/ind3protocol.h"
#include "core/devices/ind3/ind3protocol210.h"
#include "core/devices/ind3/ind3simulator.h"
#include "core/protocol/modbusrtu.h"
#include "tests/support/fakeline.h"
#include "tests/support/scanning.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::ind3;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// The simulator against the vectors of spec/ind3.md, and against the codecs, with which it shares no line of code.
class TstInd3Simulator : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void factorySettings_data();
    void factorySettings();
    void selfTest();
    void tiltsLikeTheBuilding_data();
    void tiltsLikeTheBuilding();
    void anglesRoundTrip();
    void settings211();
    void settingsSurviveReboot();
    void refusesNonsense211_data();
    void refusesNonsense211();
    void changesAddress211();
    void escapes();
    void ping210();
    void settingsModbus();
    void exceptionsModbus_data();
    void exceptionsModbus();
    void changesAddressModbus();
    void changesProtocolModbus();
    void bootLoader();
    void forgetsHalfARequest();
    void inAnyPieces_data();
    void inAnyPieces();
    void survivesNoise_data();
    void survivesNoise();
    void ignoresOthers_data();
    void ignoresOthers();
};

namespace {

constexpr quint64 seed = 7;

SensorConfig config(const QString &protocol = QStringLiteral("2.11"), int address = 1)
{
    SensorConfig sensor;
    sensor.number = 3;
    sensor.address = address;
    sensor.serialNumber = QStringLiteral("1887");
    sensor.options.insert(QStringLiteral("protocol"), protocol);
    return sensor;
}

void questions()
{
    QTest::addColumn<QString>("protocol");
    QTest::addColumn<QByteArray>("request");
    QTest::newRow("2.11") << QStringLiteral("2.11") << hex("7E 9B 01 01 9B 7E");
    QTest::newRow("2.10") << QStringLiteral("2.10") << hex("7E 9A 01 01 FE 7E");
    QTest::newRow("modbus") << QStringLiteral("modbus") << hex("01 04 00 00 00 04 F1 C9");
}

/// Sends \a request and gives back the answer that its scan finds.
QByteArray talkTo(Simulator &device, const std::optional<Request> &request, SimulatedDevice::Time now = 1s)
{
    return request ? answerIn(request->scan, device.receive(request->bytes, now)).value_or(QByteArray()) : QByteArray();
}

} // namespace

void TstInd3Simulator::factorySettings_data()
{
    QTest::addColumn<QByteArray>("request");
    QTest::addColumn<QByteArray>("answer");

    QTest::newRow("version") << hex("7E 9B 0E 01 94 7E") << hex("7E 9B 0E 01 76 32 2E 31 31 FE 7E");
    QTest::newRow("get baud") << hex("7E 9C 01 01 9C 7E") << hex("7E 9C 01 01 04 98 7E");
    QTest::newRow("set 1200") << hex("7E 9C 02 01 01 9E 7E") << hex("7E 9C 02 01 9F 7E");
    QTest::newRow("get name") << hex("7E 9C 03 01 9E 7E") << hex("7E 9C 03 01 4E 4F 20 4E 41 4D 45 B8 7E");
    QTest::newRow("set address 2") << hex("7E 9C 09 01 02 96 7E") << hex("7E 9C 09 02 97 7E");
    QTest::newRow("serial number") << hex("7E 9C 0B 01 96 7E") << hex("7E 9C 0B 01 5F 07 00 00 CE 7E");
    QTest::newRow("get ticks") << hex("7E 9C 0C 01 91 7E") << hex("7E 9C 0C 01 05 94 7E");
    QTest::newRow("get period") << hex("7E 9C 0E 01 93 7E") << hex("7E 9C 0E 01 02 91 7E");
    QTest::newRow("revision 4144") << hex("7E 9C 0A 01 97 7E") << hex("7E 9C 0A 01 30 10 B7 7E");
}

void TstInd3Simulator::factorySettings()
{
    QFETCH(QByteArray, request);
    QFETCH(QByteArray, answer);
    Simulator device(config(), seed);
    QCOMPARE(device.receive(request, 0s), answer);
}

void TstInd3Simulator::selfTest()
{
    Simulator device(config(), seed);
    device.setSelfTest(0x10);
    QCOMPARE(device.receive(hex("7E 9B 0E 01 94 7E"), 0s), hex("7E 9B FF 01 10 75 7E"));
    QCOMPARE(device.receive(hex("7E 9C 0B 01 96 7E"), 0s), hex("7E 9C 0B 01 5F 07 00 00 CE 7E"));
}

void TstInd3Simulator::tiltsLikeTheBuilding_data()
{
    questions();
}

/// Simulator, line and driver together, at several times.
void TstInd3Simulator::tiltsLikeTheBuilding()
{
    QFETCH(QString, protocol);
    QFETCH(QByteArray, request);
    const auto device = makeSimulator(config(protocol), seed);
    QCOMPARE(device->number(), 3);
    QCOMPARE(device->address(), 1);
    DriverSettings settings;
    settings.sensor = config(protocol);
    const auto driver = makeDriver(settings);
    const BuildingMotion motion(seed, 3);
    for (const SimulatedDevice::Time now :
         {SimulatedDevice::Time(0s), SimulatedDevice::Time(1h), SimulatedDevice::Time(30h)}) {
        FakeLine line;
        line.expect(request, device->receive(request, now));
        const auto got = driver->poll(line);
        QVERIFY(got);
        QVERIFY(std::abs(got->tilt->x - motion.tiltX(now)) <= 0.5 / 256);
        QVERIFY(std::abs(got->tilt->y - motion.tiltY(now)) <= 0.5 / 256);
    }
}

/// The simulator's own arithmetic of the angle block against the codec's, at the seams of its ranges.
void TstInd3Simulator::anglesRoundTrip()
{
    for (const double angle :
         {0.0, 0.00390625, -119.4140625, 255.998, -256.0, 16383.25, -16383.75, 16384.0, 983039.0}) {
        const QByteArray bytes = angleBytes(angle, -angle);
        const auto decoded = decodeAngleBlock(bytes);
        QVERIFY(decoded);
        const double tolerance = std::abs(angle) < 16383.5 ? 0.5 / 256 : 60;
        QVERIFY(std::abs(decoded->y - angle) <= tolerance);
        QVERIFY(std::abs(decoded->x + angle) <= tolerance);
        QCOMPARE(angleOfBytes(bytes.left(3)), decoded->y);
    }
    QCOMPARE(angleBytes(-119.414, 194.219), hex("6A 77 80 38 C2 00"));
}

void TstInd3Simulator::settings211()
{
    Simulator device(config(), seed);
    QVERIFY(!talkTo(device, setName(1, QStringLiteral("Дом }~ 1"))).isEmpty());
    QCOMPARE(*decodeNameAnswer(talkTo(device, ask(Packet::GetName, 1))), QStringLiteral("Дом }~ 1"));
    QVERIFY(!talkTo(device, setBaud(1, 115200)).isEmpty());
    QCOMPARE(*decodeBaud(talkTo(device, ask(Packet::GetBaud, 1))), 115200);
    QVERIFY(!talkTo(device, setTicks(1, 1)).isEmpty());
    QCOMPARE(*decodeTicks(talkTo(device, ask(Packet::GetTicks, 1))), 1);
    QVERIFY(!talkTo(device, setPeriod(1, 100ms)).isEmpty());
    QVERIFY(*decodePeriod(talkTo(device, ask(Packet::GetPeriod, 1))) == 100ms);
    QCOMPARE(*decodeRevision(talkTo(device, ask(Packet::Revision, 1))), Revision{4144});

    const Tilt before = *decodeAngles(talkTo(device, ask(Packet::ReadAngles, 1)));
    QVERIFY(!talkTo(device, setOffset(1, {200, -300})).isEmpty());
    QCOMPARE(*decodeOffset(talkTo(device, ask(Packet::GetOffset, 1))), (Tilt{200, -300}));
    const Tilt after = *decodeAngles(talkTo(device, ask(Packet::ReadAngles, 1)));
    QVERIFY(std::abs(before.x - after.x - 200) <= 1 / 256.0);
    QVERIFY(std::abs(before.y - after.y + 300) <= 1 / 256.0);
}

void TstInd3Simulator::settingsSurviveReboot()
{
    Simulator device(config(), seed);
    QVERIFY(!talkTo(device, setTicks(1, 64)).isEmpty());
    device.receive(hex("7E 9B 01"), 1s); // forgotten by the restart
    device.reboot(2s);
    QCOMPARE(*decodeTicks(talkTo(device, ask(Packet::GetTicks, 1))), 64);
}

void TstInd3Simulator::refusesNonsense211_data()
{
    QTest::addColumn<QByteArray>("request");
    QTest::newRow("speed 9") << hex("7E 9C 02 01 09 96 7E");
    QTest::newRow("speed without a code") << hex("7E 9C 02 01 9F 7E");
    QTest::newRow("address 0") << hex("7E 9C 09 01 00 94 7E");
    QTest::newRow("ticks 7") << hex("7E 9C 0D 01 07 97 7E");
    QTest::newRow("period 4") << hex("7E 9C 0F 01 04 96 7E");
    QTest::newRow("seventeen characters")
        << hex("7E 9C 04 01 31 31 31 31 31 31 31 31 31 31 31 31 31 31 31 31 31 A8 7E");
    QTest::newRow("short offset") << hex("7E 9C 06 01 80 1B 7E");
    QTest::newRow("question with data") << hex("7E 9B 01 01 00 9B 7E");
    QTest::newRow("unknown packet") << hex("7E 9C 10 01 8D 7E");
    QTest::newRow("unknown protocol") << hex("7E 9D 01 01 9D 7E");
    QTest::newRow("wrong check sum") << hex("7E 9B 01 01 9A 7E");
}

void TstInd3Simulator::refusesNonsense211()
{
    QFETCH(QByteArray, request);
    Simulator device(config(), seed);
    QCOMPARE(device.receive(request, 0s), QByteArray());
    QCOMPARE(device.address(), 1);
    QCOMPARE(device.receive(hex("7E 9C 01 01 9C 7E"), 0s), hex("7E 9C 01 01 04 98 7E"));
}

void TstInd3Simulator::changesAddress211()
{
    Simulator device(config(), seed);
    QCOMPARE(talkTo(device, setAddress(1, 2)), hex("7E 9C 09 02 97 7E"));
    QCOMPARE(device.address(), 2);
    QVERIFY(device.receive(hex("7E 9B 01 01 9B 7E"), 0s).isEmpty());
    QVERIFY(decodeAngles(talkTo(device, ask(Packet::ReadAngles, 2))));
}

void TstInd3Simulator::escapes()
{
    Simulator device(config(QStringLiteral("2.11"), 0x7E), seed);
    QCOMPARE(device.receive(hex("7E 9C 0C 7D 5E EE 7E"), 0s), hex("7E 9C 0C 7D 5E 05 EB 7E"));
    QVERIFY(decodeAngles(talkTo(device, ask(Packet::ReadAngles, 0x7E))));
}

void TstInd3Simulator::ping210()
{
    Simulator device(config(QStringLiteral("2.10")), seed);
    QCOMPARE(device.receive(hex("7E 9A 03 01 FC 7E"), 0s), hex("35"));
    QVERIFY(device.receive(hex("7E 9A 02 01 FD 7E"), 0s).isEmpty());
    QVERIFY(device.receive(hex("7E 9A 03 01 FD 7E"), 0s).isEmpty());
    QVERIFY(device.receive(hex("7E 9B 01 01 9B 7E"), 0s).isEmpty());
}

void TstInd3Simulator::settingsModbus()
{
    Simulator device(config(QStringLiteral("modbus")), seed);
    QCOMPARE(
        device.receive(hex("01 03 00 14 00 08 04 08"), 0s),
        hex("01 03 10 00 04 00 01 00 02 00 05 10 30 00 01 00 00 07 5F 98 F4"));
    QCOMPARE(device.receive(hex("01 10 00 14 00 01 02 00 08 A4 82"), 0s), hex("01 10 00 14 00 01 41 CD"));
    QVERIFY(modbusrtu::confirmation(talkTo(device, modbus::setTicks(1, 1))));
    QVERIFY(modbusrtu::confirmation(talkTo(device, modbus::setPeriod(1, 100ms))));
    const modbus::Settings expected{115200, true, 100ms, 1, {4144}, 1, 1887};
    QVERIFY(*modbus::decodeSettings(talkTo(device, modbus::readSettings(1))) == expected);

    const Tilt before = *modbus::decodeAngles(talkTo(device, modbus::readAngles(1)));
    QVERIFY(modbusrtu::confirmation(talkTo(device, modbus::setOffset(1, {200, -300.5}))));
    const modbus::Offsets offsets{{200, -300.5}, {0, 0}};
    QVERIFY(*modbus::decodeOffsets(talkTo(device, modbus::readOffsets(1))) == offsets);
    const Tilt after = *modbus::decodeAngles(talkTo(device, modbus::readAngles(1)));
    QVERIFY(std::abs(before.x - after.x - 200) <= 0.0011);
    QVERIFY(std::abs(before.y - after.y + 300.5) <= 0.0011);
}

void TstInd3Simulator::exceptionsModbus_data()
{
    QTest::addColumn<QByteArray>("request");
    QTest::addColumn<QByteArray>("answer");

    QTest::newRow("function 05") << hex("01 05 00 00 FF 00 8C 3A") << hex("01 85 01 83 50");
    QTest::newRow("03 of the angles") << hex("01 03 00 00 00 04 44 09") << hex("01 83 02 C0 F1");
    QTest::newRow("03 past the end") << hex("01 03 00 64 00 01 C5 D5") << hex("01 83 02 C0 F1");
    QTest::newRow("03 of no register") << hex("01 03 00 14 00 00 05 CE") << hex("01 83 03 01 31");
    QTest::newRow("16 of the revision") << hex("01 10 00 18 00 01 02 00 01 64 48") << hex("01 90 02 CD C1");
    QTest::newRow("16, speed 9") << hex("01 10 00 14 00 01 02 00 09 65 42") << hex("01 90 03 0C 01");
}

void TstInd3Simulator::exceptionsModbus()
{
    QFETCH(QByteArray, request);
    QFETCH(QByteArray, answer);
    Simulator device(config(QStringLiteral("modbus")), seed);
    QCOMPARE(device.receive(request, 0s), answer);
    QCOMPARE(device.receive(hex("01 03 00 14 00 01 C4 0E"), 0s), hex("01 03 02 00 04 B9 87"));
}

void TstInd3Simulator::changesAddressModbus()
{
    Simulator device(config(QStringLiteral("modbus")), seed);
    QCOMPARE(talkTo(device, modbus::setAddress(1, 2)), hex("01 10 00 19 00 01 D0 0E"));
    QCOMPARE(device.address(), 2);
    QVERIFY(talkTo(device, modbus::readAngles(1)).isEmpty());
    QVERIFY(modbus::decodeAngles(talkTo(device, modbus::readAngles(2))));
}

void TstInd3Simulator::changesProtocolModbus()
{
    Simulator device(config(QStringLiteral("modbus")), seed);
    QVERIFY(talkTo(device, ask(Packet::ReadAngles, 1)).isEmpty());
    device.reboot(0s);
    QVERIFY(modbusrtu::confirmation(talkTo(device, modbus::setProtocol(1, false))));
    QVERIFY(talkTo(device, modbus::readAngles(1)).isEmpty());
    QVERIFY(decodeAngles(talkTo(device, ask(Packet::ReadAngles, 1))));
}

/// Whoever writes register 38 hears no more of the device.
void TstInd3Simulator::bootLoader()
{
    Simulator device(config(QStringLiteral("modbus")), seed);
    QCOMPARE(device.receive(hex("01 10 00 26 00 01 02 00 01 60 96"), 0s), hex("01 10 00 26 00 01 E0 02"));
    QVERIFY(talkTo(device, modbus::readAngles(1)).isEmpty());
    device.reboot(1s);
    QVERIFY(modbus::decodeAngles(talkTo(device, modbus::readAngles(1))));
}

/// Half a request of function 16 could wait for 200 more bytes; silence ends it.
void TstInd3Simulator::forgetsHalfARequest()
{
    Simulator device(config(QStringLiteral("modbus")), seed);
    QVERIFY(device.receive(hex("01 10 00 1E 00 78 F0 FF"), 1s).isEmpty());
    QVERIFY(device.receive(modbus::readAngles(1)->bytes, 1s + 10ms).isEmpty());
    QVERIFY(modbus::decodeAngles(talkTo(device, modbus::readAngles(1), 1s + 200ms)));
}

void TstInd3Simulator::inAnyPieces_data()
{
    questions();
}

void TstInd3Simulator::inAnyPieces()
{
    QFETCH(QString, protocol);
    QFETCH(QByteArray, request);
    Simulator whole(config(protocol), seed);
    const QByteArray expected = whole.receive(request, 1s);
    QVERIFY(!expected.isEmpty());
    for (qsizetype size = 1; size <= request.size(); ++size) {
        Simulator device(config(protocol), seed);
        QByteArray answer;
        for (qsizetype at = 0; at < request.size(); at += size) {
            QVERIFY(answer.isEmpty());
            answer = device.receive(request.mid(at, size), 1s);
        }
        QCOMPARE(answer, expected);
    }
    QCOMPARE(whole.receive(request + request, 1s), expected + expected);
}

void TstInd3Simulator::survivesNoise_data()
{
    questions();
}

void TstInd3Simulator::survivesNoise()
{
    QFETCH(QString, protocol);
    QFETCH(QByteArray, request);
    Simulator device(config(protocol), seed);
    const QByteArray expected = device.receive(request, 2s);
    QVERIFY(!expected.isEmpty());
    for (const QByteArray &noise :
         {hex("00"), hex("FF FF FF"), hex("7E"), hex("7E 7E 7D"), hex("01 04 00"), hex("7E 9A 01"),
          QByteArray(5000, '\x55'), request.chopped(1)}) {
        device.receive(noise, 1s);
        device.receive(hex("7E 7E"), 1s); // ends what 2.11 has in its buffer
        QCOMPARE(device.receive(request, 2s), expected);
    }
}

void TstInd3Simulator::ignoresOthers_data()
{
    QTest::addColumn<QString>("protocol");
    QTest::addColumn<QByteArray>("others");
    QTest::addColumn<QByteArray>("request");

    QTest::newRow("2.11") << QStringLiteral("2.11")
                          << hex("7E 9B 01 02 98 7E 7E 9B 01 02 6A 77 80 38 C2 00 FF 7E 01 C9 00 00 12 4A")
                          << hex("7E 7E 9B 01 01 9B 7E");
    QTest::newRow("2.10") << QStringLiteral("2.10") << hex("7E 9A 01 02 FD 7E E2 7C 00 72 32 81 7D 01 C9 00 00 12 4A")
                          << hex("7E 9A 01 01 FE 7E");
    QTest::newRow("modbus") << QStringLiteral("modbus") << hex("02 04 00 00 00 04 F1 FA 01 C9 00 00 12 4A")
                            << hex("01 04 00 00 00 04 F1 C9");
}

void TstInd3Simulator::ignoresOthers()
{
    QFETCH(QString, protocol);
    QFETCH(QByteArray, others);
    QFETCH(QByteArray, request);
    Simulator device(config(protocol), seed);
    QVERIFY(device.receive(others, 1s).isEmpty());
    QVERIFY(!device.receive(request, 2s).isEmpty());
}

QTEST_GUILESS_MAIN(TstInd3Simulator)
#include "tst_ind3simulator.moc"
