#include "core/values/readingjson.h"
#include "core/values/wind.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace gorizont;

namespace {

Weather twoParameters()
{
    WeatherParameter temperature;
    temperature.code = u'T';
    temperature.number = 2;
    temperature.name = QStringLiteral("Температура");
    temperature.unit = QStringLiteral("°C");
    temperature.mean = -3.5;
    temperature.instant = -3.25;
    temperature.minimum = -4.0;
    temperature.maximum = -3.0;
    temperature.voltage = 0.125;
    temperature.voltageInstant = 0.25;
    WeatherParameter speed;
    speed.code = u'M';
    speed.maxPeriod = 9.0;
    speed.deviation = 0.75;
    return {0x80000005, {temperature, speed}, {{true, 1700003600}, {false, 1700000000}}};
}

} // namespace

/// The weather of a station as JSON, and what of it is the wind.
class TstWeather : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void json()
    {
        Reading reading;
        reading.number = 7;
        reading.isAnswer = true;
        reading.status = 0x0500;
        reading.weather = twoParameters();
        SensorConfig sensor;
        sensor.name = QStringLiteral("Мачта (МК-14)");
        sensor.model = QStringLiteral("MK-14");
        sensor.address = 3;
        LineConfig line;
        line.com = 5;
        const QByteArray expected = R"json({
            "time": "1970-01-01T00:00:00.000Z", "number": 7, "name": "Мачта (МК-14)", "type": "MK-14", "port": "COM5",
            "address": 3, "status": 1280,
            "digital": 2147483653,
            "parameters": [
                {"code": "T", "number": 2, "name": "Температура", "unit": "°C", "mean": -3.5, "instant": -3.25,
                 "min": -4, "max": -3, "voltage": 0.125, "voltageInstant": 0.25},
                {"code": "M", "number": 1, "name": "", "unit": "", "maxPeriod": 9, "deviation": 0.75}],
            "events": [{"start": true, "time": 1700003600}, {"start": false, "time": 1700000000}]
        })json";
        QJsonParseError error{};
        const QJsonDocument wanted = QJsonDocument::fromJson(expected, &error);
        QCOMPARE(error.errorString(), QStringLiteral("no error occurred"));
        QCOMPARE(QJsonDocument::fromJson(readingToJson(reading, sensor, line)), wanted);
        reading.isAnswer = false;
        QVERIFY(!QJsonDocument::fromJson(readingToJson(reading, sensor, line))
                     .object()
                     .contains(QStringLiteral("parameters")));
    }

    void maximumIsTheLargerOne_data()
    {
        using Value = std::optional<double>;
        QTest::addColumn<Value>("maximum");
        QTest::addColumn<Value>("maxPeriod");
        QTest::addColumn<Value>("expected");
        QTest::newRow("of CMD 4") << Value(9.25) << Value(9.0) << Value(9.25);
        QTest::newRow("of CMD 8") << Value(2.5) << Value(9.0) << Value(9.0);
        QTest::newRow("only CMD 4") << Value(0.0) << Value() << Value(0.0);
        QTest::newRow("only CMD 8") << Value() << Value(0.0) << Value(0.0);
        QTest::newRow("none") << Value() << Value() << Value();
    }

    void maximumIsTheLargerOne()
    {
        QFETCH(const std::optional<double>, maximum);
        QFETCH(const std::optional<double>, maxPeriod);
        QFETCH(const std::optional<double>, expected);
        WeatherParameter speed;
        speed.code = u'M';
        speed.maximum = maximum;
        speed.maxPeriod = maxPeriod;
        QCOMPARE(windOf({0, {speed}, {}}).maximum, expected);
    }

    void windOfTheFirstSensors()
    {
        const auto parameter = [](QChar code, int number, double mean) {
            WeatherParameter made;
            made.code = code;
            made.number = number;
            made.mean = mean;
            made.deviation = mean / 10;
            return made;
        };
        const Weather weather{
            0, {parameter(u'M', 2, 7), parameter(u'A', 1, 180), parameter(u'M', 1, 5), parameter(u'A', 2, 90)}, {}};
        QCOMPARE(windOf(weather), (Wind{5.0, 180.0, {}, 0.5, 18.0}));
        QCOMPARE(windOf(Weather()), Wind());
        QCOMPARE(meanOf(weather, u'A'), 180.0);
        QVERIFY(!meanOf(weather, u'P'));
    }
};

QTEST_APPLESS_MAIN(TstWeather)
#include "tst_weather.moc"
