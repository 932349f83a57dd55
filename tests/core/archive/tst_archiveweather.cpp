#include "core/values/weather.h"
#include "tests/core/archive/archivesite.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// The weather of a station is kept beside the tilt of a building, to a hundredth.
class TestArchiveWeather : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isKeptToAHundredth()
    {
        const QTemporaryDir folder;
        ArchiveConfig config = archiveConfig(folder.filePath(QStringLiteral("archive.sqlite")));
        SensorConfig &station = config.lines.first().sensors.first();
        station.measuresTilt = false;
        station.measuresWeather = true;
        ArchiveBench bench(config);
        bench.open(noon);
        for (int second = 1; second <= 4000; ++second) {
            const Reading reading = weatherReading(noon + second * 1s, second);
            bench.writer->updateReadings({reading, tiltReading(2, reading.time, 0)});
            bench.now = reading.time;
            if (second % 100 == 0) {
                bench.writer->flush();
            }
        }
        bench.close();
        const Buckets speed = bench.fullRate({1, Quantity::WindSpeed}, noon, noon + 2h);
        QCOMPARE(speed.size(), 3999);
        QCOMPARE(speed.last().mean, 40.0); // 4000 / 100 + 0.0049
        QVERIFY(speed.at(5).from == noon + 6s && speed.at(6).from == noon + 8s); // the seventh was not valid
        const Buckets direction = bench.fullRate({1, Quantity::WindDirection}, noon, noon + 2h);
        QCOMPARE(direction.first().mean, 1.0);
        QCOMPARE(direction.at(359).mean, 0.0);
        QCOMPARE(bench.fullRate({1, Quantity::WindMaximum}, noon, noon + 2h).first().mean, 9.25);
        QCOMPARE(bench.fullRate({1, Quantity::Pressure}, noon, noon + 2h).last().mean, 745.25);
        QVERIFY(bench.fullRate({1, Quantity::Humidity}, noon, noon + 2h).isEmpty());
        // An hour of the direction went through the north eleven times: a bucket takes it as any number.
        const Series hour = bench.ask({1, Quantity::WindDirection}, noon, noon + 1h, 1);
        QCOMPARE(hour.buckets.first().minimum, 0.0);
        QCOMPARE(hour.buckets.first().maximum, 359.0);
        QVERIFY(bench.fullRate({2, Quantity::WindSpeed}, noon, noon + 2h).isEmpty());
        QCOMPARE(bench.sentences, QStringList());
    }

private:
    using Buckets = QList<SeriesBucket>;

    static Reading weatherReading(UtcTime time, int second)
    {
        const auto parameter = [](QChar code, double mean) {
            WeatherParameter made;
            made.code = code;
            made.mean = mean;
            return made;
        };
        WeatherParameter speed = parameter(u'M', second / 100.0 + 0.0049);
        speed.maxPeriod = 9.2517;
        if (second == 7) {
            speed.mean.reset();
        }
        Reading reading;
        reading.number = 1;
        reading.time = time;
        reading.isAnswer = true;
        reading.status = 0x0500;
        reading.weather = Weather{0, {parameter(u'A', second % 360), speed, parameter(u'P', 745.25)}, {}};
        return reading;
    }
};

QTEST_GUILESS_MAIN(TestArchiveWeather)
#include "tst_archiveweather.moc"
