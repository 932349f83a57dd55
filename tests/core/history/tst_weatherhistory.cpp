#include "core/history/historywriter.h"
#include "core/history/weatherformat.h"
#include "tests/core/history/historysupport.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

SensorConfig station(int number)
{
    SensorConfig sensor;
    sensor.number = number;
    sensor.isOn = true;
    sensor.type = SensorType::Mk14;
    sensor.measuresWeather = true;
    sensor.measuresTemperature = true;
    return sensor;
}

Reading weatherReading(int number)
{
    WeatherParameter temperature;
    temperature.code = u'T';
    temperature.mean = -3.504;
    temperature.instant = -3.25;
    temperature.minimum = -4.0;
    temperature.maximum = -0.001;
    WeatherParameter speed;
    speed.code = u'M';
    speed.number = 2;
    speed.mean = 4.75;
    speed.maxPeriod = 9.0;
    speed.deviation = 0.75;
    Reading reading;
    reading.number = number;
    reading.status = 0x0500;
    reading.isAnswer = true;
    reading.weather = Weather{0xA5, {temperature, speed}, {{false, 1700003600}, {true, 1700000000}}};
    return reading;
}

const QByteArray beginning = "18:33:03 07.02.18\t3330\t";
const QByteArray values = " 0 0101 0000 0000\t000000A5\t-1700003600"
                          "\tT1\t   -3.50\t   -3.25\t   -4.00\t    0.00\t\t"
                          "\tM2\t    4.75\t\t\t\t    9.00\t    0.75\r\n";

} // namespace

/// `_wdata`: what a line says, and when there is such a file.
class TestWeatherHistory : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_config = {};
        m_config.folder = m_folder->filePath(QStringLiteral("History"));
        m_config.saveInterval = 20ms;
        m_config.zone = moscowZone();
        LineConfig line;
        line.index = 1;
        line.isOn = true;
        line.sensors = {station(12), tiltSensor(1), station(7)};
        m_config.lines = {line};
    }

    void recordOfAStation()
    {
        const QDateTime local = localTime(moscow("2018-02-07T18:33:03"), moscowZone());
        QCOMPARE(weatherRecord(local, "3330", {station(7), weatherReading(7)}), beginning + "7\t" + values);
    }

    void everyStationHasALineInAscendingN()
    {
        run([](HistoryWriter &writer) { writer.updateReadings({weatherReading(12)}); });
        QVERIFY(file().startsWith(
            beginning + "7\t 0 0111 0000 0000\t\t\r\n" + beginning + "12\t" + values + beginning + "7\t"));
    }

    void noFileWithoutAStation()
    {
        m_config.lines.first().sensors = {tiltSensor(1)};
        run();
        QCOMPARE(
            QDir(m_config.folder).entryList({QStringLiteral("*.txt")}),
            QStringList{QStringLiteral("2018_02_data.txt")});
    }

    void noFileWithoutCanSave()
    {
        m_config.savesFiles = false;
        run();
        QVERIFY(!QDir(m_config.folder).exists());
    }

    void anUnfinishedRecordIsCutOff()
    {
        QVERIFY(QDir().mkpath(m_config.folder));
        const QByteArray whole = beginning + "7\t" + values;
        writeAll(path(), whole + whole.first(40));
        run();
        QVERIFY(file().startsWith(whole + beginning + "7\t 0 0111"));
        for (const QByteArray &line : file().chopped(2).split('\n')) {
            QVERIFY2(line.startsWith("18:33:03 07.02.18\t3330\t"), line.constData());
        }
    }

private:
    QString path() const { return m_config.folder + QStringLiteral("/2018_02_wdata.txt"); }
    QByteArray file() const { return readAll(path()); }

    /// Until some records are due.
    void run(const std::function<void(HistoryWriter &)> &prepare = {})
    {
        HistoryWriter writer(m_config, [] { return moscow("2018-02-07T18:33:03"); });
        QSignalSpy records(&writer, &HistoryWriter::dataLineWritten);
        if (prepare) {
            prepare(writer);
        }
        writer.start();
        QTRY_VERIFY(records.size() >= 3);
        writer.stop();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    HistoryConfig m_config;
};

QTEST_GUILESS_MAIN(TestWeatherHistory)
#include "tst_weatherhistory.moc"
