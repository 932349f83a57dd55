#include "core/modbus/registerdocument.h"
#include "core/modbus/unitimages.h"
#include "core/modbus/vibrationmap.h"
#include "tests/core/modbus/modbussite.h"
#include "tests/support/fakeline.h"

#include <QRegularExpression>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;

namespace {

SensorConfig module(int number)
{
    SensorConfig sensor;
    sensor.port = 3;
    sensor.number = number;
    sensor.isOn = true;
    sensor.type = SensorType::LVims;
    sensor.model = QStringLiteral("L-VIMS");
    return sensor;
}

/// modbusSite(), 1, 2, 4, 6, and L-VIMS 5 and 7 on port 3: slots 3 and 5.
ModbusConfig vibrationSite(ModbusPacking packing = ModbusPacking::ByType)
{
    ModbusConfig config = modbusSite(packing);
    config.lines[2].sensors = {module(7), module(5)};
    return config;
}

Reading answerOf(int number)
{
    Reading reading;
    reading.number = number;
    reading.isAnswer = true;
    reading.status = 0x0700;
    const VibrationMeasurement first{0, 1, 70.71068, 45.2, false, true, {}, 40.0, false};
    const VibrationMeasurement last{7, 16, {}, {}, true, false, true, {}, true};
    const VibrationMeasurement speed{1, 5, 1500.0, {}, {}, {}, {}, {}, false};
    reading.vibration = Vibration{
        {{0, ChannelState::Good, true, {first, last}},
         {1, ChannelState::Break, true, {}},
         {2, ChannelState::Good, false, {speed}},
         {3, ChannelState::Good, true, {speed}}},
        {{0, true, true, false, true}, {3, false, false, true, true}, {7, true, false, false, false}}};
    return reading;
}

QByteArray read(const UnitImages &images, int address, int count)
{
    return images.inputRegisters(1)->registers(address, count).value_or(QByteArrayView()).toByteArray().toHex(' ');
}

QByteArray spaced(const char *text)
{
    return hex(text).toHex(' ');
}

QByteArray zeros(int registers)
{
    return QByteArray(2 * static_cast<qsizetype>(registers), '\0').toHex(' ');
}

const char *nothing = "0000 0000 7FC0 0000 7FC0 0000 7FC0 0000 0000 0000"; ///< a measurement that is not in use

} // namespace

/// The channels of L-VIMS in unit 1. The bytes of measurements were made with Python's struct.pack('>HHfffHH', …).
class TestVibrationMap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fieldsAreApart()
    {
        const AreaPart &areas = vibrationAreas();
        QVERIFY(areApart(areas.fields, areas.step));
        QCOMPARE(areas.start(0) + areas.step, 65500);
        QCOMPARE(areas.start(areas.most - 1), 35500);
        QCOMPARE(areas.fields.size(), std::size_t(4 * (3 + 8 * 5) + 5));
    }

    /// Blocks stay where they are; the areas lie at the end, the first module highest.
    void whereTheAreasAre()
    {
        const UnitImages images(vibrationSite());
        QCOMPARE(images.inputRegisters(1)->count(), 65500);
        QCOMPARE(read(images, 6, 2), spaced("0BB8 0064"));
        QCOMPARE(read(images, 3300, 2), spaced("0000 0005"));
        QCOMPARE(read(images, 3300 + 94, 6), spaced("FDE8 0004 0064 FF78 0000 0000")); // 65000, 4, 100, 65400
        QCOMPARE(read(images, 3500, 2), spaced("0000 0007"));
        QCOMPARE(read(images, 3500 + 94, 6), spaced("FBF4 0004 0064 FD84 0000 0000")); // 64500, 4, 100, 64900
        QCOMPARE(read(images, 3300 + 4, 2), spaced("0004 0807")); // L-VIMS; a sensor, on, its port on, channels_at
        QCOMPARE(read(images, 3300 + 7, 1), spaced("0020"));
        QCOMPARE(read(images, 3400 + 94, 6), zeros(6)); // N=6 has no channels
        QVERIFY(!images.inputRegisters(1)->registers(65499, 2));
    }

    void nothingMovesWhereThereIsNoModule()
    {
        const UnitImages images(modbusSite());
        QCOMPARE(images.inputRegisters(1)->count(), 3400);
        QVERIFY(images.unreachable().isEmpty());
    }

    void aChannelIsReadWithOneRequest()
    {
        UnitImages images(vibrationSite());
        images.update(answerOf(7));
        // state, flags: known, in use; two measurements
        QCOMPARE(read(images, 64500, 20), spaced("0000 0003 0002") + ' ' + zeros(17));
        QCOMPARE(
            read(images, 64520, 10),
            // in use, value, percent, baseline, warning, fault and warning are known = 34Fh; 70.71068, 45.2, 40
            spaced("0001 034F 428D 6BDE 4234 CCCD 4220 0000 0000 0000"));
        QCOMPARE(read(images, 64530, 10), spaced(nothing));
        // in use, far from the baseline, fault, stop, all three known = 7B1h; no value
        QCOMPARE(read(images, 64590, 10), spaced("0010 07B1 7FC0 0000 7FC0 0000 7FC0 0000 0000 0000"));
        QCOMPARE(read(images, 64600, 3), spaced("0002 0007 0000")); // broken
        QCOMPARE(read(images, 64700, 3), spaced("FFFF 0001 0000")); // known, not in use
        QCOMPARE(read(images, 64730, 10), spaced(nothing));
        QCOMPARE(read(images, 64800, 3), spaced("0000 0003 0001"));
        QCOMPARE(read(images, 64830, 10), spaced("0005 0003 44BB 8000 7FC0 0000 7FC0 0000 0000 0000"));
        // known, logical 0 and 7, physical 0, error 3, enabled 0 and 3
        QCOMPARE(read(images, 64900, 6), spaced("00FF 0081 0001 0008 0009 0000"));
        QCOMPARE(read(images, 65000, 3), spaced("FFFF 0000 0000")); // the other one said nothing
        QCOMPARE(read(images, 65020, 10), spaced(nothing));
        QCOMPARE(read(images, 65400, 5), zeros(5));
    }

    void nothingIsKnownOfAModuleThatIsSilent()
    {
        UnitImages images(vibrationSite());
        Reading reading = answerOf(7);
        images.update(reading);
        reading.isAnswer = false;
        images.update(reading); // one lost answer changes nothing
        QCOMPARE(read(images, 64500, 3), spaced("0000 0003 0002"));
        reading.status = 0x3700;
        images.update(reading);
        QCOMPARE(read(images, 64500, 3), spaced("FFFF 0000 0000"));
        QCOMPARE(read(images, 64520, 10), spaced(nothing));
        QCOMPARE(read(images, 64900, 5), zeros(5));
    }

    void byNumber()
    {
        const UnitImages images(vibrationSite(ModbusPacking::ByNumber));
        QCOMPARE(read(images, 3400 + 94, 1), spaced("FDE8")); // slot 4 is N=5
        QCOMPARE(read(images, 3600 + 94, 1), spaced("FBF4"));
        QCOMPARE(read(images, 3500 + 94, 1), spaced("0000"));
    }

    /// 70 modules: 60 have areas down to 35500, below which there is room for 325 slots.
    void aSiteOfModules()
    {
        ModbusConfig config = modbusSite();
        for (int number = 1001; number <= 1330; ++number) {
            config.lines[2].sensors.append(module(number));
            if (number > 1070) {
                config.lines[2].sensors.last().type = SensorType::InD;
            }
        }
        const UnitImages images(config);
        QCOMPARE(read(images, 3000 + 100 * (4 + 59) + 94, 1), spaced("8AAC")); // 35500
        QCOMPARE(read(images, 3000 + 100 * (4 + 60) + 94, 1), spaced("0000"));
        QCOMPARE(images.unreachable().numbers.size(), 334 - 325);
        QCOMPARE(images.unreachable().numbers.first(), 1322);
        QCOMPARE(read(images, 3000 + 100 * 324, 2), spaced("0000 0529")); // 1321
    }

    /// The document has every field of every area where the image has it.
    void theDocument()
    {
        ServerConfig server;
        server.lines = vibrationSite().lines;
        const QString document = registerDocument(server);
        static const QRegularExpression row(
            QStringLiteral("\\| (\\d+) \\| 3\\d+ \\| 4\\d+ \\| (\\d) \\| `channel0_m0_value` \\|"));
        QList<int> found;
        for (auto match = row.globalMatch(document); match.hasNext();) {
            found.append(match.next().captured(1).toInt());
        }
        QCOMPARE(found, (QList<int>{65022, 64522}));
        QCOMPARE(document.count(QStringLiteral("`relays_enabled`")), 2);
        QVERIFY(document.contains(QStringLiteral("| 14 | RMS of a harmonic of velocity | mm/s |")));
        server.lines = modbusSite().lines;
        QVERIFY(!registerDocument(server).contains(QStringLiteral("channel0")));
    }
};

QTEST_APPLESS_MAIN(TestVibrationMap)
#include "tst_vibrationmap.moc"
