#pragma once

#include "core/archive/archivequery.h"
#include "core/archive/archivewriter.h"

#include <QTemporaryDir>

/// A small site and its archive, on a clock that the test holds.
namespace gorizont::test {

inline const UtcTime noon{std::chrono::sys_days(std::chrono::year(2024) / 12 / 31) + std::chrono::hours(12)};

/// N 1 and 2 measure tilt, 2 temperature too; N 3 is an accelerometer.
inline QList<LineConfig> archiveLines()
{
    LineConfig line;
    line.index = 1;
    line.isOn = true;
    for (int number = 1; number <= 3; ++number) {
        SensorConfig sensor;
        sensor.port = 1;
        sensor.index = number;
        sensor.number = number;
        sensor.isOn = true;
        sensor.measuresTilt = number < 3;
        sensor.measuresTemperature = number == 2;
        sensor.measuresAcceleration = number == 3;
        line.sensors.append(sensor);
    }
    return {line};
}

inline ArchiveConfig archiveConfig(const QString &file)
{
    ArchiveConfig config;
    config.file = file;
    config.lines = archiveLines();
    config.retryInterval = std::chrono::milliseconds(0);
    return config;
}

/// An answer whose tilt in X is \a value, in Y its negative, in 1/256 of an arc-second.
inline Reading tiltReading(int number, UtcTime time, int value)
{
    Reading reading;
    reading.number = number;
    reading.time = time;
    reading.isAnswer = true;
    reading.tilt = Tilt{value / 256.0, -value / 256.0};
    reading.temperature = 20 + value % 7 / 16.0;
    reading.period = std::chrono::seconds(1);
    return reading;
}

inline SampleBlock sampleBlock(UtcTime start, int first, int count, bool followsPrevious = true)
{
    SampleBlock block{3, start, 10, 0.5, followsPrevious, {}, {}};
    for (int i = 0; i < count; ++i) {
        block.x.append(static_cast<qint16>(first + i));
        block.y.append(static_cast<qint16>(-first - i));
    }
    return block;
}

/// A writer that is driven by hand, and what it tells.
struct ArchiveBench
{
    explicit ArchiveBench(const ArchiveConfig &archiveConfig)
        : config(archiveConfig)
    {
    }

    void open(UtcTime at)
    {
        now = at;
        writer = std::make_unique<ArchiveWriter>(config, [this] { return now; });
        QObject::connect(writer.get(), &ArchiveWriter::journal, [this](const JournalEntry &entry) {
            sentences.append(entry.text);
        });
        writer->flush();
    }
    void read(int number, UtcTime at, int value)
    {
        writer->updateReadings({tiltReading(number, at, value)});
        now = at;
    }
    void close()
    {
        writer->stop();
        writer.reset();
    }

    QList<SeriesBucket> fullRate(SeriesKey key, UtcTime from, UtcTime to) const
    {
        return ask(key, from, to, 0).buckets;
    }
    Series ask(SeriesKey key, UtcTime from, UtcTime to, int width) const
    {
        ArchiveQuery query(config);
        return query.series({{key}, from, to, width}).value(0);
    }

    ArchiveConfig config;
    UtcTime now;
    QStringList sentences;
    std::unique_ptr<ArchiveWriter> writer;
};

} // namespace gorizont::test
