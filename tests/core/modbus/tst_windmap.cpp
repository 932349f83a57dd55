#include "core/modbus/modbusanswer.h"
#include "core/modbus/registerdocument.h"
#include "tests/core/modbus/modbussite.h"
#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;

namespace {

/// modbusSite() with two stations on port 3: N=3 and, switched off, N=5.
ModbusConfig weatherSite(ModbusPacking packing = ModbusPacking::ByType)
{
    ModbusConfig config = modbusSite(packing);
    const auto station = [](int number, bool isOn) {
        SensorConfig sensor;
        sensor.port = 3;
        sensor.number = number;
        sensor.isOn = isOn;
        sensor.type = SensorType::Mk14;
        sensor.measuresWeather = true;
        sensor.measuresTemperature = true;
        return sensor;
    };
    config.lines[2].sensors = {station(5, false), station(3, true)};
    return config;
}

Reading weatherReading()
{
    WeatherParameter direction;
    direction.code = u'A';
    direction.mean = 187.54;
    direction.deviation = 12.5;
    WeatherParameter speed;
    speed.code = u'M';
    speed.mean = 4.75;
    speed.maximum = 9.25;
    speed.maxPeriod = 9.0;
    speed.deviation = 0.755;
    WeatherParameter pressure;
    pressure.code = u'P';
    pressure.mean = 745.25;
    Reading reading;
    reading.number = 3;
    reading.isAnswer = true;
    reading.status = 0x0500;
    reading.temperature = -3.5;
    reading.weather = Weather{0x80000005, {pressure, direction, speed}, {}};
    return reading;
}

UnitImages answered(const Reading &reading, ModbusPacking packing = ModbusPacking::ByType)
{
    UnitImages images(weatherSite(packing));
    images.update(weatherReading());
    images.update(reading);
    return images;
}

QByteArray unitFour(const UnitImages &images)
{
    const RegisterBlock *block = images.inputRegisters(4);
    return block->registers(block->base(), block->count()).value_or(QByteArrayView()).toByteArray().toHex();
}

QByteArray unitOne(const UnitImages &images, int address, int count)
{
    return images.inputRegisters(1)->registers(address, count).value_or(QByteArrayView()).toByteArray().toHex();
}

} // namespace

/// Unit 4 and the weather in unit 1, against bytes that Python's struct packed: "<I", "<H" × 7 and ">f".
///
/// 475 = 01DBh, 1875 = 0753h, 925 = 039Dh, 0, 0.755 → 76 = 004Ch, 1250 = 04E2h, 0500h; low byte first. Port 2 is off: 0Ch.
class TestWindMap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void blockOfUnitFour()
    {
        QCOMPARE(
            unitFour(answered(weatherReading())),
            "0c000000"
            "db0153079d0300004c00e2040005"
            "000000000000000000000000000f");
    }

    void slotsGoByNumberToo()
    {
        const QByteArray hole = "000000000000000000000000000f";
        QCOMPARE(
            unitFour(answered(weatherReading(), ModbusPacking::ByNumber)),
            "0c000000" + hole + hole + "db0153079d0300004c00e2040005" + hole + hole + hole);
    }

    void whatTheStationHasNotIsFFFF()
    {
        Reading reading = weatherReading();
        reading.weather->parameters[2].mean.reset();
        reading.weather->parameters[1].mean = 359.96;
        reading.weather->parameters[1].deviation.reset();
        QCOMPARE(unitFour(answered(reading)).mid(8, 28), "ffff00009d0300004c00ffff0005");
        reading.weather->parameters.clear();
        QCOMPARE(unitFour(answered(reading)).mid(8, 28), "ffffffffffff0000ffffffff0005");
    }

    void whoDoesNotAnswerKeepsTheLastValues()
    {
        Reading reading = weatherReading();
        reading.isAnswer = false;
        reading.status = 0x3700;
        QCOMPARE(unitFour(answered(reading)).mid(8, 28), "db0153079d0300004c00e2040037");
    }

    void unitOneHasTheWeather()
    {
        // Sensors in ascending N: 1, 2, 3, …: the block of N=3 starts at 3200.
        // 4.75, 187.54, 9.25, 0.755, 745.25, no humidity, 80000005h
        QCOMPARE(
            unitOne(answered(weatherReading()), 3280, 14), "40980000433b8a3d411400003f4147ae443a50007fc0000080000005");
        QCOMPARE(unitOne(answered(weatherReading()), 3224, 2), "c0600000");
        QCOMPARE(unitOne(answered(weatherReading()), 3204, 4), "0005042f05000012");
        QCOMPARE(
            unitOne(answered(weatherReading()), 3080, 14), "7fc000007fc000007fc000007fc000007fc000007fc0000000000000");
        Reading silent = weatherReading();
        silent.isAnswer = false;
        silent.status = 0x3700;
        QCOMPARE(unitOne(answered(silent), 3280, 14), "7fc000007fc000007fc000007fc000007fc000007fc0000000000000");
    }

    void noStationNoUnit()
    {
        QVERIFY(!UnitImages(modbusSite()).unit(4));
        QVERIFY(UnitImages(weatherSite()).unit(4));
    }

    void onlyFunctionFour()
    {
        const UnitImages images = answered(weatherReading());
        AnswerBuffer answers;
        answerRequests(hex("0001 0000 0006 04 04 0002 0002  0002 0000 0006 04 03 0002 0001"), images, answers);
        QCOMPARE(
            QByteArray(answers.constData(), answers.size()).toHex(),
            hex("0001 0000 0007 04 04 04 DB01 5307  0002 0000 0003 04 83 01").toHex());
    }

    void theDocumentCoversIt()
    {
        ServerConfig server;
        server.lines = weatherSite().lines;
        const QString document = registerDocument(server);
        // The example is of N=3: 4.75, 187.5, 9.00, σ 0.75 and 12.5.
        for (const char *part :
             {"## Unit 4. Wind", "`wind_max_direction`", "`00 01 00 00 00 06 04 04 00 02 00 07`",
              "`00 01 00 00 00 11 04 04 0E DB 01 53 07 84 03 00 00 4B 00 E2 04 00 05`"}) {
            QVERIFY2(document.contains(QString::fromUtf8(part)), part);
        }
    }
};

QTEST_APPLESS_MAIN(TestWindMap)
#include "tst_windmap.moc"
