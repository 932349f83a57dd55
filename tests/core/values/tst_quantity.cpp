#include "core/values/quantity.h"

#include <QTest>

using namespace gorizont;

/// A quantity of a reading is what the status word lets it be: a value that is not valid is absent, never old.
class TestQuantity : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void allOfAGoodAnswer();
    void whatTheStatusWordDenies_data();
    void whatTheStatusWordDenies();
    void absentIsEmpty();
    void numbersAreFixed();
    void ofAConfiguration();

private:
    static Reading goodReading();
};

Reading TestQuantity::goodReading()
{
    Reading reading;
    reading.tilt = Tilt{-3599.5, 2720.5};
    reading.temperature = 21.38;
    reading.heaterPower = 12.5;
    reading.fanFrequency = 33.0;
    reading.acceleration = AccelStatistics{7.67, -0.4, -7.66, 270.0, 2.19, 0.01, 2.18};
    reading.displacement = LinkDisplacement{{17.4, -0.1}, Displacement{50.0, -0.25}};
    WeatherParameter direction;
    direction.code = u'A';
    direction.mean = 187.5;
    WeatherParameter speed;
    speed.code = u'M';
    speed.mean = 4.75;
    speed.maximum = 9.25;
    speed.maxPeriod = 9.0;
    WeatherParameter pressure;
    pressure.code = u'P';
    pressure.mean = 745.25;
    WeatherParameter humidity;
    humidity.code = u'H';
    humidity.mean = 68.0;
    reading.weather = Weather{0, {pressure, humidity, direction, speed}, {}};
    return reading;
}

void TestQuantity::allOfAGoodAnswer()
{
    const QList<double> expected{-3599.5, 2720.5, 21.38, 12.5,  33.0, 7.67,  -0.4, -7.66,  2.19, 0.01,
                                 2.18,    270.0,  50.0,  -0.25, 4.75, 187.5, 9.25, 745.25, 68.0};
    QList<double> found;
    for (const Quantity quantity : readingQuantities()) {
        found << valueOf(goodReading(), quantity).value();
    }
    QCOMPARE(found, expected);
}

void TestQuantity::whatTheStatusWordDenies_data()
{
    QTest::addColumn<quint16>("status");
    QTest::addColumn<QList<int>>("denied");
    QTest::newRow("tilt") << quint16{0x0400} << QList<int>{1, 2};
    QTest::newRow("temperature") << quint16{0x0200} << QList<int>{3};
    QTest::newRow("acceleration") << quint16{0x0100} << QList<int>{6, 7, 8, 9, 10, 11, 12};
    QTest::newRow("no answer") << quint16{0x3700} << QList<int>{1, 2, 3, 6, 7, 8, 9, 10, 11, 12};
}

void TestQuantity::whatTheStatusWordDenies()
{
    QFETCH(quint16, status);
    QFETCH(QList<int>, denied);
    Reading reading = goodReading();
    reading.status = status;
    for (const Quantity quantity : readingQuantities()) {
        QCOMPARE(valueOf(reading, quantity).has_value(), !denied.contains(int(quantity)));
    }
}

void TestQuantity::absentIsEmpty()
{
    for (const Quantity quantity : readingQuantities()) {
        QVERIFY(!valueOf(Reading(), quantity));
    }
    QVERIFY(!valueOf(goodReading(), Quantity::SampleX));
}

void TestQuantity::numbersAreFixed()
{
    // They stand in archives that outlive the program.
    QCOMPARE(int(Quantity::TiltX), 1);
    QCOMPARE(int(Quantity::AccelMaximum), 6);
    QCOMPARE(int(Quantity::SampleY), 14);
    QCOMPARE(int(Quantity::WindSpeed), 17);
    QCOMPARE(int(Quantity::Humidity), 21);
}

void TestQuantity::ofAConfiguration()
{
    SensorConfig sensor;
    QVERIFY(quantitiesOf(sensor).isEmpty());
    sensor.measuresTilt = true;
    sensor.measuresTemperature = true;
    QCOMPARE(quantitiesOf(sensor), (QList{Quantity::TiltX, Quantity::TiltY, Quantity::Temperature}));
    sensor.hasThermostat = true;
    QVERIFY(quantitiesOf(sensor).contains(Quantity::FanFrequency));
    sensor.measuresAcceleration = true;
    QVERIFY(quantitiesOf(sensor).contains(Quantity::SampleY));
    QVERIFY(!quantitiesOf(sensor).contains(Quantity::DisplacementX));
    SensorConfig station;
    station.measuresWeather = true;
    QCOMPARE(
        quantitiesOf(station),
        (QList{
            Quantity::WindSpeed, Quantity::WindDirection, Quantity::WindMaximum, Quantity::Pressure,
            Quantity::Humidity}));
    sensor.isInChain = true;
    QVERIFY(
        quantitiesOf(sensor).contains(Quantity::DisplacementX)
        && quantitiesOf(sensor).contains(Quantity::DisplacementY));
}

QTEST_APPLESS_MAIN(TestQuantity)

#include "tst_quantity.moc"
