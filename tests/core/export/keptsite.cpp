#include "tests/core/export/keptsite.h"

#include <QDateTime>
#include <QFile>

namespace gorizont::test {

namespace {

SensorConfig tiltSensor(int number, const QString &place)
{
    SensorConfig sensor;
    sensor.number = number;
    sensor.place = place;
    sensor.isOn = true;
    sensor.measuresTilt = true;
    return sensor;
}

} // namespace

ArchiveSource KeptSite::source() const
{
    ArchiveSource source;
    source.series = [kept = *this](const SeriesQuery &query) {
        if (kept.asked) {
            *kept.asked << query;
        }
        QList<Series> answer;
        for (const SeriesKey &key : query.keys) {
            Series found{key, {}, {}, {}};
            for (const Series &one : kept.series) {
                if (one.key != key) {
                    continue;
                }
                std::copy_if(one.buckets.begin(), one.buckets.end(), std::back_inserter(found.buckets), [&](auto &b) {
                    return b.from >= query.from && b.from < query.to;
                });
            }
            answer << found;
        }
        return QtFuture::makeReadyFuture(answer);
    };
    source.blocks = [kept = *this](int number, UtcTime from, UtcTime to) {
        QList<SampleBlock> answer;
        std::copy_if(kept.blocks.begin(), kept.blocks.end(), std::back_inserter(answer), [&](const SampleBlock &block) {
            const std::chrono::duration<double> length(static_cast<double>(block.x.size()) / block.rate);
            return block.number == number && block.start < to && block.start + length > from;
        });
        return QtFuture::makeReadyFuture(answer);
    };
    return source;
}

SensorConfig accelerometer(int number, const QString &place)
{
    SensorConfig sensor = tiltSensor(number, place);
    sensor.type = SensorType::AnD3;
    sensor.model = QStringLiteral("AN-D3");
    sensor.measuresTemperature = true;
    sensor.measuresAcceleration = true;
    return sensor;
}

SensorConfig inclinometer(int number, const QString &place)
{
    SensorConfig sensor = tiltSensor(number, place);
    sensor.type = SensorType::InD;
    sensor.model = QStringLiteral("IN-D3");
    return sensor;
}

SeriesBucket reading(UtcTime time, double value)
{
    return {time, value, value, value, 1, 1};
}

SeriesBucket noReading(UtcTime time)
{
    return {time, 0, 0, 0, 1, 0};
}

UtcTime utc(const char *iso)
{
    const QDateTime time = QDateTime::fromString(QString::fromLatin1(iso), Qt::ISODateWithMs);
    return UtcTime(std::chrono::milliseconds(time.toMSecsSinceEpoch()));
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        qFatal("no file %s", qPrintable(path));
    }
    return file.readAll();
}

} // namespace gorizont::test
