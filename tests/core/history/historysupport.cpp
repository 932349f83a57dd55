#include "tests/core/history/historysupport.h"

#include <QDateTime>
#include <QFile>
#include <QTest>
#include <QTimeZone>

#include <csignal>

#include <sys/resource.h>

namespace gorizont::test {

FileSizeLimit::FileSizeLimit(qint64 bytes)
{
    std::signal(SIGXFSZ, SIG_IGN); // the write fails with EFBIG instead
    const rlimit limit{static_cast<rlim_t>(bytes), RLIM_INFINITY};
    QVERIFY(::setrlimit(RLIMIT_FSIZE, &limit) == 0);
}

FileSizeLimit::~FileSizeLimit()
{
    const rlimit limit{RLIM_INFINITY, RLIM_INFINITY};
    ::setrlimit(RLIMIT_FSIZE, &limit);
}

QByteArray readAll(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void writeAll(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

QByteArray expectedFile(const char *name)
{
    return readAll(QStringLiteral(GORIZONT_TEST_DATA "/history/") + QLatin1String(name));
}

QTimeZone moscowZone()
{
    return QTimeZone(3 * 3600);
}

UtcTime moscow(const char *text)
{
    QDateTime time = QDateTime::fromString(QLatin1String(text), Qt::ISODateWithMs);
    time.setTimeZone(moscowZone());
    return UtcTime(std::chrono::milliseconds(time.toMSecsSinceEpoch()));
}

SampleBlock samples(int number, UtcTime start, qint16 first, int count, bool followsPrevious)
{
    SampleBlock block;
    block.number = number;
    block.start = start;
    block.followsPrevious = followsPrevious;
    for (int i = 0; i < count; ++i) {
        block.x.append(static_cast<qint16>(first + i));
        block.y.append(static_cast<qint16>(-first - i));
    }
    return block;
}

SensorConfig tiltSensor(int number, bool hasThermometer)
{
    SensorConfig sensor;
    sensor.number = number;
    sensor.isOn = true;
    sensor.measuresTilt = true;
    sensor.measuresTemperature = hasThermometer;
    return sensor;
}

SensorConfig accelerometer(int number)
{
    SensorConfig sensor = tiltSensor(number, true);
    sensor.type = SensorType::AnD3;
    sensor.measuresAcceleration = true;
    return sensor;
}

SensorConfig vibrationModule(int number)
{
    SensorConfig sensor;
    sensor.number = number;
    sensor.index = 1;
    sensor.isOn = true;
    sensor.type = SensorType::LVims;
    sensor.model = QStringLiteral("L-VIMS");
    return sensor;
}

} // namespace gorizont::test
