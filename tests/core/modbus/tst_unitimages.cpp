#include "core/modbus/registervalue.h"
#include "core/modbus/unitimages.h"
#include "tests/core/modbus/modbussite.h"

#include <QTest>

#include <limits>

using namespace gorizont;
using namespace gorizont::test;

namespace {

UnitImages sampleImages(ModbusPacking packing, int base)
{
    UnitImages images(modbusSite(packing, base));
    images.update(sampleTilt());
    images.update(sampleAcceleration());
    images.updateLine(lineStatus(3, LineState::OpenFailed));
    images.updateLine(lineStatus(5, LineState::Lost));
    return images;
}

QByteArray all(const UnitImages &images, int unit)
{
    const RegisterBlock *block = images.inputRegisters(unit);
    return block->registers(block->base(), block->count()).value_or(QByteArrayView()).toByteArray();
}

} // namespace

/// The register blocks of units 3 and 6 against bytes worked out by hand (modbussite.h).
class TestUnitImages : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void packsByType()
    {
        const UnitImages images = sampleImages(ModbusPacking::ByType, 0);
        QCOMPARE(all(images, 3).toHex(), tiltBlock().toHex());
        QCOMPARE(all(images, 6).toHex(), accelerationBlock().toHex());
    }

    void packsByNumber()
    {
        const UnitImages images = sampleImages(ModbusPacking::ByNumber, 0);
        const QByteArray hole = "000000000000000f";
        const QByteArray tilt = tiltBlock().toHex();
        // Slots 1, 2, hole 3, 4, hole 5, 6.
        QCOMPARE(
            all(images, 3).toHex(),
            tilt.first(8) + tilt.mid(8, 32) + hole + tilt.mid(40, 16) + hole + tilt.mid(56, 16));
        const QByteArray none = "0000000000000000000f";
        const QByteArray acceleration = accelerationBlock().toHex();
        QCOMPARE(
            all(images, 6).toHex(),
            acceleration.first(8) + none + acceleration.mid(8, 20) + none + none + none + acceleration.mid(28, 20));
    }

    void baseOneStartsAtRegisterOne()
    {
        const UnitImages images = sampleImages(ModbusPacking::ByType, 1);
        const RegisterBlock *block = images.inputRegisters(3);
        QCOMPARE(all(images, 3).toHex(), tiltBlock().toHex());
        QVERIFY(!block->registers(0, 1));
        QVERIFY(!block->registers(0, 18));
        QCOMPARE(block->registers(1, 1)->toByteArray().toHex(), "1c02");
        QCOMPARE(block->registers(18, 1)->toByteArray().toHex(), "0017");
        QVERIFY(!block->registers(19, 1));
        QVERIFY(!block->registers(18, 2));
    }

    void everySubRangeIsAPieceOfTheWhole()
    {
        const UnitImages images = sampleImages(ModbusPacking::ByType, 0);
        const QByteArray whole = tiltBlock();
        for (int address = 0; address < 18; ++address) {
            for (int count = 1; address + count <= 18; ++count) {
                const QByteArray piece = images.inputRegisters(3)->registers(address, count)->toByteArray();
                QCOMPARE(piece, whole.mid(qsizetype(2) * address, qsizetype(2) * count));
            }
            QVERIFY(!images.inputRegisters(3)->registers(address, 19 - address));
        }
    }

    void startsWithWhatIsKnownBeforeThePolling()
    {
        const UnitImages images(modbusSite());
        // Port 2 is off: 3 << 2. Nobody answered yet: 0700; switched off: 0F00; port off: 1700.
        QCOMPARE(
            all(images, 3).toHex(),
            "0c000000"
            "0000000000000007"
            "0000000000000007"
            "000000000000000f"
            "0000000000000017");
    }

    void keepsTheLastValuesWithTheirFlags()
    {
        UnitImages images = sampleImages(ModbusPacking::ByType, 0);
        Reading lost;
        lost.number = 2;
        lost.status = 0x3700;
        images.update(lost);
        QCOMPARE(images.inputRegisters(3)->registers(6, 4)->toByteArray().toHex(), "18fc18fc5a080037");
        QCOMPARE(images.inputRegisters(6)->registers(2, 5)->toByteArray().toHex(), "ff028c0a0000db000037");
    }

    void ignoresStrangers()
    {
        UnitImages images = sampleImages(ModbusPacking::ByType, 0);
        Reading stranger = sampleAcceleration();
        for (const int number : {-1, 0, 3, 7, 100000}) {
            stranger.number = number;
            images.update(stranger);
        }
        images.updateLine(lineStatus(4, LineState::Lost));
        QCOMPARE(all(images, 3).toHex(), tiltBlock().toHex());
        QCOMPARE(all(images, 6).toHex(), accelerationBlock().toHex());
    }

    void knowsThreeUnits()
    {
        const UnitImages images(modbusSite());
        for (int unit = 0; unit < 256; ++unit) {
            QCOMPARE(images.inputRegisters(unit) != nullptr, unit == 1 || unit == 3 || unit == 6);
        }
    }

    void ofTwoSensorsWithOneNumberTheFirstIsServed()
    {
        ModbusConfig config = modbusSite();
        config.lines[2].sensors = {config.lines[0].sensors[2]}; // N=1 again, on port 3
        config.lines[2].sensors[0].isOn = false;
        UnitImages images(config);
        images.update(sampleTilt());
        QCOMPARE(images.inputRegisters(3)->registers(2, 8)->toByteArray().toHex(), "b7ffcaf800003803000000000000000f");
    }

    void namesTheSensorsThatFindNoRoom()
    {
        ModbusConfig config = modbusSite(ModbusPacking::ByNumber);
        // Unit 3: 2 + 4 × 16383 = 65534 registers fit; unit 6: 2 + 5 × 13106 = 65532; unit 1: 3000 + 100 × 625 = 65500.
        config.lines[0].sensors[0].number = 16383;
        config.lines[0].sensors[1].number = 13107;
        config.lines[1].sensors[0].number = 2000000000;
        const UnitImages images(config);
        QCOMPARE(images.unreachable().numbers, (QList<int>{13107, 16383, 2000000000}));
        QCOMPARE(images.unreachable().units, (QList<int>{1, 3, 6}));
        const QString sentence = images.unreachable().sentence();
        QVERIFY2(
            sentence.contains(QStringLiteral("3 sensors")) && sentence.contains(QStringLiteral("N=13107")),
            qPrintable(sentence));
        QVERIFY2(sentence.contains(QStringLiteral("unit 1, 3, 6")), qPrintable(sentence));
        QCOMPARE(images.inputRegisters(1)->count(), 65500);
        QCOMPARE(images.inputRegisters(3)->count(), 65534);
        QCOMPARE(images.inputRegisters(6)->count(), 65532);
        QCOMPARE(images.inputRegisters(3)->registers(65533, 1)->toByteArray().toHex(), "000f");
    }

    void roundsAndSaturates_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("scale");
        QTest::addColumn<int>("asShort");
        QTest::addColumn<int>("asWord");
        QTest::newRow("half up") << 0.5 << 1.0 << 1 << 1;
        QTest::newRow("half down") << -0.5 << 1.0 << -1 << 0;
        QTest::newRow("one and a half") << 1.5 << 1.0 << 2 << 2;
        QTest::newRow("two and a half, not to even") << 2.5 << 1.0 << 3 << 3;
        QTest::newRow("below half") << 0.4999 << 1.0 << 0 << 0;
        QTest::newRow("minus below half") << -0.4999 << 1.0 << 0 << 0;
        QTest::newRow("decimal half") << 1.005 << 100.0 << 101 << 101;
        QTest::newRow("minus decimal half") << -1.005 << 100.0 << -101 << 0;
        QTest::newRow("1.8 arc-seconds are 0.0005 degrees") << 1.8 << 1 / 3.6 << 1 << 1;
        QTest::newRow("largest short") << 327.67 << 100.0 << 32767 << 32767;
        QTest::newRow("above short") << 327.68 << 100.0 << 32767 << 32768;
        QTest::newRow("smallest short") << -327.68 << 100.0 << -32768 << 0;
        QTest::newRow("below short") << -327.69 << 100.0 << -32768 << 0;
        QTest::newRow("largest word") << 655.35 << 100.0 << 32767 << 65535;
        QTest::newRow("above word") << 655.36 << 100.0 << 32767 << 65535;
        QTest::newRow("huge") << 1e300 << 100.0 << 32767 << 65535;
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity() << 100.0 << 32767 << 65535;
        QTest::newRow("minus infinite") << -std::numeric_limits<double>::infinity() << 100.0 << -32768 << 0;
        QTest::newRow("not a number") << std::numeric_limits<double>::quiet_NaN() << 100.0 << 0 << 0;
    }

    void roundsAndSaturates()
    {
        QFETCH(const double, value);
        QFETCH(const double, scale);
        QTEST(static_cast<int>(registerValue<qint16>(value, scale)), "asShort");
        QTEST(static_cast<int>(registerValue<quint16>(value, scale)), "asWord");
    }

    void aDirectionStaysBelowAFullTurn()
    {
        UnitImages images(modbusSite());
        Reading reading = sampleAcceleration();
        reading.acceleration->direction = 359.96;
        images.update(reading);
        QCOMPARE(images.inputRegisters(6)->registers(3, 1)->toByteArray().toHex(), "0000");
        reading.acceleration->direction = 359.94; // 3599 = 0E0Fh
        images.update(reading);
        QCOMPARE(images.inputRegisters(6)->registers(3, 1)->toByteArray().toHex(), "0f0e");
    }

    void takesItsOrdersFromTheServerConfig()
    {
        ServerConfig server;
        server.modbusPort = 1502;
        server.modbusPacking = ModbusPacking::ByNumber;
        server.modbusBase = 1;
        server.modbusClients = 7;
        server.modbusIdle = std::chrono::seconds(30);
        server.modbusBind = QStringLiteral("::1");
        server.modbusAllow = QStringList{QStringLiteral("10.0.0.0/8")};
        server.lines = modbusSite().lines;
        server.timing.readErrorLimit = 3;
        server.timing.crcErrorLimit = 4;
        server.hasLegacyStatusBits = true;
        ModbusConfig expected;
        expected.port = 1502;
        expected.packing = ModbusPacking::ByNumber;
        expected.base = 1;
        expected.desk.clients = 7;
        expected.desk.idle = std::chrono::milliseconds(30000);
        expected.desk.bind = QStringLiteral("::1");
        expected.desk.allow = QStringList{QStringLiteral("10.0.0.0/8")};
        expected.lines = modbusSite().lines;
        expected.rules = {3, 4, true};
        QVERIFY(modbusConfig(server) == expected);
    }
};

QTEST_APPLESS_MAIN(TestUnitImages)
#include "tst_unitimages.moc"
