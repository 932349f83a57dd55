#include "tests/core/modbus/answeredsite.h"

#include <QTest>

#include <algorithm>
#include <limits>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

// Where things are, as extendedmap.h draws it. The sensors of modbusSite() in ascending N: 1, 2, 4, 6.
constexpr int directory = 100;
constexpr int blockOf1 = 3000;
constexpr int blockOf2 = 3100;
constexpr int blockOf4 = 3200;
constexpr int blockOf6 = 3300;

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

} // namespace

/// Unit 1 against bytes worked out by hand. Floats: sign, exponent + 127, fraction without its leading 1 (IEEE 754):
/// −3600 = −1.7578125 × 2^11 → sign 1, exponent 138 = 8Ah, fraction .7578125 = 610000h of 800000h → C5610000h.
class TestExtendedMap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyFieldIsAValueOrAClock()
    {
        const auto isOneOfThem = [](const auto &field) { return (field.value == nullptr) != (field.clock == nullptr); };
        const UnitImages images(modbusSite());
        QCOMPARE(images.units().size(), std::size_t{3});
        for (const UnitImage &unit : images.units()) {
            QVERIFY(std::ranges::all_of(unit.layout().head, isOneOfThem));
            for (const SlotPart &part : unit.layout().parts) {
                QVERIFY(std::ranges::all_of(part.fields, isOneOfThem));
            }
        }
    }

    void theHeadTellsWhereEverythingIs()
    {
        const UnitImages images(modbusSite());
        // "GORZ", version 1, 4 slots, directory 100 of 4 registers each, blocks 3000 of 100 registers each.
        QCOMPARE(read(images, 0, 8), spaced("474F 525A 0001 0004 0064 0004 0BB8 0064"));
        QCOMPARE(images.inputRegisters(1)->count(), 3400);
        QVERIFY(images.unreachable().isEmpty());
    }

    void theHeadCountsByState()
    {
        UnitImages images(modbusSite());
        // Port 2 off: 3 << 2. Four sensors, none answers, N=4 off. Code 0: 1, 2 and 4; code 1, port off: 6.
        QCOMPARE(read(images, 14, 2), spaced("0000 000C"));
        QCOMPARE(read(images, 16, 3), spaced("0004 0000 0001"));
        QCOMPARE(read(images, 20, 12), spaced("0003 0001 0000 0000 0000 0000 0000 0000 0000 0000 0000 0000"));
        Reading reading = answer();
        images.update(reading);
        QCOMPARE(read(images, 16, 3), spaced("0004 0001 0001"));
        QCOMPARE(read(images, 20, 4), spaced("0003 0001 0000 0000"));
        reading.isAnswer = false;
        reading.status = 0x3700;
        images.update(reading);
        images.updateLine(lineStatus(5, LineState::Lost));
        QCOMPARE(read(images, 14, 2), spaced("0000 020C"));
        QCOMPARE(read(images, 16, 3), spaced("0004 0000 0001"));
        QCOMPARE(read(images, 20, 4), spaced("0002 0001 0000 0001"));
        reading.number = 6;
        reading.status = 0xB700;
        images.update(reading);
        QCOMPARE(read(images, 20, 12), spaced("0002 0000 0000 0001 0000 0000 0000 0000 0000 0000 0000 0001"));
    }

    void theDirectoryNamesEverySlot()
    {
        // N (two registers), status, flags: 1 a sensor, 2 on, 4 its port on.
        const UnitImages images(modbusSite());
        QCOMPARE(
            read(images, directory, 16),
            spaced("0000 0001 0700 0007  0000 0002 0700 0007  0000 0004 0F00 0005  0000 0006 1700 0003"));
        QCOMPARE(read(images, directory + 16, 4), spaced("0000 0000 0000 0000"));
    }

    void aBlockHoldsAllOfASensor()
    {
        const UnitImages images = answered();
        // N=2, port 1, address 1, type 2 (АН-Д3), flags: sensor, on, port on, answers, tilt, temperature, accelerations,
        // raw status, raw mode, ring = 3FFh; status; quantities: tilt, temperature, acceleration; raw words.
        QCOMPARE(read(images, blockOf2, 10), spaced("0000 0002 0001 0001 0002 03FF 0018 0007 240F CC00"));
        // 1517999583456 ms, the rest of the microseconds cut off: 353 × 2^32 = 1516123455488, 353 = 161h;
        // the rest 1876127968 = 6FD370E0h.
        QCOMPARE(read(images, blockOf2 + 12, 4), spaced("0000 0161 6FD3 70E0"));
        QCOMPARE(
            read(images, blockOf2 + 16, 16),
            spaced("C561 0000" // −3600″ = −1.7578125 × 2^11
                   "44E1 1000" // 1800.5″ = 1.75830078125 × 2^10
                   "BF80 0000" // −1°
                   "3F00 091A" // 0.5001388…° = 1.0002777… × 2^−1; .0002777… × 2^23 = 2330.17 = 91Ah
                   "41AB 0000" // 21.375 = 1.3359375 × 2^4
                   "42C7 0000" // 99.5 = 1.5546875 × 2^6
                   "4144 0000" // 12.25 = 1.53125 × 2^3
                   "0000 0000")); // reserved
        QCOMPARE(
            read(images, blockOf2 + 32, 16),
            spaced("40F8 0000" // 7.75 = 1.9375 × 2^2
                   "4387 0000" // 270 = 1.0546875 × 2^8
                   "8000 0000" // −0
                   "C0F8 0000" // −7.75
                   "4020 0000" // 2.5
                   "3F00 0000" // 0.5
                   "3DCC CCCD" // 0.1, rounded to the nearest
                   "0000 0000"));
        // 70000 = 1 1170h; 3; 4294967301 goes on after 2^32 with 5; 5728 = 1660h; 179 = B3h.
        QCOMPARE(
            read(images, blockOf2 + 48, 16),
            spaced("0001 1170 0000 0003 0000 0005 0000 1660 0000 00B3 0000 0000"
                   "3F80 0000" // 1 s
                   "3D00 0000")); // 0.03125 s = 2^−5
        QCOMPARE(read(images, blockOf2 + 64, 8), spaced("7FC0 0000 7FC0 0000 7FC0 0000 7FC0 0000")); // in no chain
        QCOMPARE(read(images, blockOf2 + 72, 8), zeros(8));
        // No wind, no weather: floats that are not there.
        QCOMPARE(read(images, blockOf2 + 80, 12), spaced("7FC00000 7FC00000 7FC00000 7FC00000 7FC00000 7FC00000"));
        QCOMPARE(read(images, blockOf2 + 92, 8), zeros(8));
    }

    void aSensorInAChainHasDisplacements()
    {
        UnitImages images(modbusSite());
        Reading reading = answer();
        reading.displacement = LinkDisplacement{{0.5, -7.75}, Displacement{270, 2.5}};
        images.update(reading);
        QCOMPARE(read(images, blockOf2 + 64, 8), spaced("3F00 0000 C0F8 0000 4387 0000 4020 0000"));
        reading.displacement->sum.reset(); // a sensor below it is not valid
        images.update(reading);
        QCOMPARE(read(images, blockOf2 + 64, 8), spaced("3F00 0000 C0F8 0000 7FC0 0000 7FC0 0000"));
        reading.status |= 0x0400; // tilt not valid
        images.update(reading);
        QCOMPARE(read(images, blockOf2 + 64, 4), spaced("7FC0 0000 7FC0 0000"));
    }

    void whatIsAbsentIsNaN()
    {
        const UnitImages images(modbusSite());
        const QByteArray nan = spaced("7FC0 0000");
        for (const int block : {blockOf1, blockOf2, blockOf4, blockOf6}) {
            for (const int offset : {16, 18, 20, 22, 24, 26, 28, 32, 34, 36, 38, 40, 42, 44, 60, 62, 64, 66, 68, 70}) {
                QCOMPARE(read(images, block + offset, 2), nan);
            }
            QCOMPARE(read(images, block + 12, 4), zeros(4)); // never answered
            QCOMPARE(read(images, block + 48, 10), zeros(10));
        }
        QCOMPARE(read(images, blockOf4, 10), spaced("0000 0004 0001 0001 0001 0005 0F00 0001 0000 0000"));
    }

    void whatIsNotValidNowIsNaN()
    {
        UnitImages images = answered();
        Reading reading = answer();
        reading.status = 0x0700 | 0x0018; // it answers, and nothing is valid
        images.update(reading);
        QCOMPARE(read(images, blockOf2 + 5, 2), spaced("038F 0718"));
        for (const int offset : {16, 18, 20, 22, 24, 32, 34, 36, 38, 40, 42, 44}) {
            QCOMPARE(read(images, blockOf2 + offset, 2), spaced("7FC0 0000"));
        }
        QCOMPARE(read(images, blockOf2 + 26, 4), spaced("42C7 0000 4144 0000"));
        reading.status = 0x0018 | 0x0200; // only the temperature is not
        images.update(reading);
        QCOMPARE(read(images, blockOf2 + 16, 2), spaced("C561 0000"));
        QCOMPARE(read(images, blockOf2 + 24, 2), spaced("7FC0 0000"));
        QCOMPARE(read(images, blockOf2 + 32, 2), spaced("40F8 0000"));
    }

    void aFailedTurnChangesNothingUntilTheStatusDoes()
    {
        UnitImages images = answered();
        Reading reading = answer();
        reading.isAnswer = false;
        reading.time += 1s;
        reading.counters.readErrors = 4;
        images.update(reading);
        QCOMPARE(read(images, blockOf2 + 5, 1), spaced("03FF"));
        QCOMPARE(read(images, blockOf2 + 12, 4), spaced("0000 0161 6FD3 70E0")); // of the answer, not of the failure
        QCOMPARE(read(images, blockOf2 + 26, 2), spaced("42C7 0000"));
        QCOMPARE(read(images, blockOf2 + 50, 2), spaced("0000 0004"));
        reading.status = 0x3700;
        images.update(reading);
        QCOMPARE(read(images, blockOf2 + 5, 2), spaced("0387 3700"));
        QCOMPARE(read(images, blockOf2 + 16, 2), spaced("7FC0 0000"));
        QCOMPARE(read(images, blockOf2 + 26, 4), spaced("7FC0 0000 7FC0 0000"));
        QCOMPARE(read(images, blockOf2 + 8, 2), spaced("240F CC00")); // the words of the last answer, dated by its time
        QCOMPARE(read(images, blockOf2 + 12, 4), spaced("0000 0161 6FD3 70E0"));
        reading.status = 0x0700; // the line was opened again, the sensor has not answered yet
        images.update(reading);
        QCOMPARE(read(images, blockOf2 + 5, 2), spaced("0387 0700"));
        QCOMPARE(read(images, blockOf2 + 26, 2), spaced("7FC0 0000"));
    }

    void floatsHoldWhatTheyCan()
    {
        UnitImages images(modbusSite());
        Reading reading = answer();
        reading.temperature = std::numeric_limits<double>::infinity();
        reading.tilt = Tilt{1e39, std::numeric_limits<double>::quiet_NaN()};
        images.update(reading);
        QCOMPARE(read(images, blockOf2 + 16, 4), spaced("7FC0 0000 7FC0 0000"));
        QCOMPARE(read(images, blockOf2 + 24, 2), spaced("7FC0 0000"));
        reading.tilt = Tilt{16777217.0, 1e-50}; // 2^24 + 1 has no float: 2^24, to even; and less than the smallest
        images.update(reading);
        QCOMPARE(read(images, blockOf2 + 16, 4), spaced("4B80 0000 0000 0000"));
    }

    void baseMovesOnlyTheManualsUnits()
    {
        const UnitImages images(modbusSite(ModbusPacking::ByType, 1));
        QCOMPARE(read(images, 0, 2), spaced("474F 525A"));
        QCOMPARE(images.inputRegisters(3)->base(), 1);
    }

    void byNumberLeavesHoles()
    {
        UnitImages images(modbusSite(ModbusPacking::ByNumber));
        QCOMPARE(read(images, 3, 1), spaced("0006"));
        QCOMPARE(read(images, 16, 3), spaced("0004 0000 0001")); // a hole is no sensor
        QCOMPARE(read(images, directory + 8, 8), spaced("0000 0000 0F00 0000  0000 0004 0F00 0005"));
        QCOMPARE(read(images, 3200, 10), spaced("0000 0000 0000 0000 0000 0000 0F00 0000 0000 0000"));
        images.update(answer()); // N=2 in slot 1
        QCOMPARE(read(images, 3116, 2), spaced("C561 0000"));
        QCOMPARE(read(images, 3300, 2), spaced("0000 0004"));
    }

    void sensorsOfEveryTypeHaveABlock()
    {
        ModbusConfig config = modbusSite();
        config.lines[2].sensors = {SensorConfig(), SensorConfig(), SensorConfig(), SensorConfig()};
        const SensorType types[] = {SensorType::UsmIsn, SensorType::LVims, SensorType::Mk14, SensorType::None};
        for (int i = 0; i < 4; ++i) {
            config.lines[2].sensors[i].number = 21 + i;
            config.lines[2].sensors[i].port = 3;
            config.lines[2].sensors[i].address = 255 - i;
            config.lines[2].sensors[i].type = types[i];
        }
        const UnitImages images(config);
        QCOMPARE(read(images, 3400, 5), spaced("0000 0015 0003 00FF 0003"));
        QCOMPARE(read(images, 3500, 5), spaced("0000 0016 0003 00FE 0004"));
        QCOMPARE(read(images, 3600, 5), spaced("0000 0017 0003 00FD 0005"));
        QCOMPARE(read(images, 3700, 5), spaced("0000 0018 0003 00FC 0000"));
        QCOMPARE(images.inputRegisters(1)->count(), 3800);
    }

    void whoFindsNoRoomIsNamed()
    {
        ModbusConfig config = modbusSite();
        const SensorConfig model = config.lines[0].sensors[0];
        config.lines[0].sensors.clear();
        for (int number = 1; number <= 700; ++number) {
            config.lines[0].sensors.append(model);
            config.lines[0].sensors.last().number = number;
        }
        config.lines[1].sensors.clear();
        const UnitImages images(config);
        // (65536 − 3000) / 100 = 625 blocks; unit 3 has room for all.
        QCOMPARE(images.inputRegisters(1)->count(), 65500);
        QCOMPARE(read(images, 65400, 2), spaced("0000 0271"));
        QCOMPARE(images.unreachable().numbers.size(), 75);
        QCOMPARE(images.unreachable().numbers.first(), 626);
        QCOMPARE(images.unreachable().units, QList<int>{1});
    }
};

QTEST_APPLESS_MAIN(TestExtendedMap)
#include "tst_extendedmap.moc"
