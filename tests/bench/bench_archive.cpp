// What the archive costs: bytes a value, values a second against plain rows, and how long a window of curves takes.
//   bench_archive [--days N]
#include "core/archive/archivequery.h"
#include "core/archive/archivewriter.h"
#include "core/devices/buildingmotion.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QSqlQuery>
#include <QTemporaryDir>

#include <cmath>
#include <cstdio>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

const UtcTime start{std::chrono::sys_days(std::chrono::year(2024) / 1 / 1)};
constexpr int sensors = 30;
constexpr int quantities = 3;

QList<LineConfig> lines()
{
    LineConfig line;
    line.index = 1;
    line.isOn = true;
    for (int number = 1; number <= sensors; ++number) {
        SensorConfig sensor;
        sensor.number = number;
        sensor.isOn = true;
        sensor.measuresTilt = true;
        sensor.measuresTemperature = true;
        line.sensors.append(sensor);
    }
    return {line};
}

ArchiveConfig archive(const QTemporaryDir &folder, const char *name)
{
    ArchiveConfig config;
    config.file = folder.filePath(QString::fromLatin1(name));
    config.lines = lines();
    return config;
}

/// What the simulated building moves, in the steps of the devices: 1/256 of an arc-second, 1/16 °C; asked with some
/// milliseconds of disorder.
Reading readingOf(int number, UtcTime time)
{
    static const QList<BuildingMotion> motions = [] {
        QList<BuildingMotion> all;
        for (int i = 0; i <= sensors; ++i) {
            all.append(BuildingMotion(1, i));
        }
        return all;
    }();
    const BuildingMotion &motion = motions.at(number);
    const auto since = time - start;
    const auto rounded = [](double value, double parts) { return std::round(value * parts) / parts; };
    Reading reading;
    reading.number = number;
    reading.time = time + std::chrono::microseconds((since.count() / 1000 * 7919 + number * 104729) % 1500);
    reading.isAnswer = true;
    reading.tilt = Tilt{rounded(motion.tiltX(since), 256), rounded(motion.tiltY(since), 256)};
    reading.temperature = rounded(motion.temperature(since), 16);
    return reading;
}

Readings turn(UtcTime time)
{
    Readings batch;
    for (int number = 1; number <= sensors; ++number) {
        batch.append(readingOf(number, time));
    }
    return batch;
}

qint64 bytesOf(const QString &file)
{
    return QFileInfo(file).size();
}

/// \a turns of all sensors; returns seconds spent in the writer.
double write(ArchiveConfig config, const QList<Readings> &turns, int turnsPerCommit)
{
    config.retentionInterval = 24h;
    UtcTime now = turns.first().first().time;
    ArchiveWriter writer(config, [&now] { return now; });
    writer.flush();
    QElapsedTimer timer;
    timer.start();
    for (qsizetype i = 0; i < turns.size(); ++i) {
        writer.updateReadings(turns.at(i));
        now = turns.at(i).last().time;
        if ((i + 1) % turnsPerCommit == 0) {
            writer.flush();
        }
    }
    writer.stop();
    return static_cast<double>(timer.nsecsElapsed()) / 1e9;
}

/// The same as rows (sensor, quantity, time, value) with an index, in the same commits.
double writeRows(const ArchiveConfig &config, const QList<Readings> &turns, int turnsPerCommit)
{
    ArchiveDatabase database(config, ArchiveDatabase::Access::Write);
    if (!database.open()) {
        return 0;
    }
    database.execute(QStringLiteral("CREATE TABLE value (number INTEGER, quantity INTEGER, time BIGINT, value REAL)"));
    database.execute(QStringLiteral("CREATE INDEX by_time ON value (number, quantity, time)"));
    const QString insert = QStringLiteral("INSERT INTO value VALUES (?, ?, ?, ?)");
    QElapsedTimer timer;
    timer.start();
    database.begin();
    for (qsizetype i = 0; i < turns.size(); ++i) {
        for (const Reading &reading : turns.at(i)) {
            for (const Quantity quantity : {Quantity::TiltX, Quantity::TiltY, Quantity::Temperature}) {
                database.run(
                    insert,
                    {reading.number, static_cast<int>(quantity), storedTime(reading.time),
                     *valueOf(reading, quantity)});
            }
        }
        if ((i + 1) % turnsPerCommit == 0) {
            database.commit();
            database.begin();
        }
    }
    database.commit();
    return static_cast<double>(timer.nsecsElapsed()) / 1e9;
}

QList<Readings> turnsOf(int count, std::chrono::microseconds period)
{
    QList<Readings> turns;
    for (int i = 0; i < count; ++i) {
        turns.append(turn(start + i * period));
    }
    return turns;
}

/// Where the bytes are.
void printShares(const ArchiveConfig &config, double values)
{
    ArchiveDatabase database(config, ArchiveDatabase::Access::Read);
    if (!database.open()) {
        return;
    }
    const auto share = [&](const char *rows) {
        return database.single(QStringLiteral("SELECT sum(length(data)) FROM ") + QString::fromLatin1(rows)).toDouble()
            / values;
    };
    std::printf(
        "  of these readings %.2f, minutes %.2f, hours and days %.2f; in use %.2f\n", share("chunk"),
        share("rollup WHERE kind = 3"), share("rollup WHERE kind > 3"),
        static_cast<double>(usedBytes(database)) / values);
}

void benchWriting(const QTemporaryDir &folder, int turnsPerCommit)
{
    const QList<Readings> turns = turnsOf(7200, 1s);
    const double values = double{sensors} * quantities * static_cast<double>(turns.size());
    double best = 1e9;
    double bestRows = 1e9;
    for (int round = 0; round < 3; ++round) {
        const QByteArray suffix = QByteArray::number(turnsPerCommit * 10 + round);
        const ArchiveConfig ours = archive(folder, "a" + suffix);
        const ArchiveConfig rows = archive(folder, "r" + suffix);
        best = std::min(best, write(ours, turns, turnsPerCommit));
        bestRows = std::min(bestRows, writeRows(rows, turns, turnsPerCommit));
        if (round == 0) {
            std::printf(
                "two hours at 1 Hz        %6.2f bytes a value, as rows %.1f\n",
                static_cast<double>(bytesOf(ours.file)) / values, static_cast<double>(bytesOf(rows.file)) / values);
            printShares(ours, values);
        }
    }
    std::printf(
        "%5d readings a commit  %6.0f thousand values a second, as rows %.0f: ratio %.2f\n", turnsPerCommit * sensors,
        values / best / 1000, values / bestRows / 1000, bestRows / best);
}

void ask(const ArchiveConfig &config, const char *what, UtcTime from, UtcTime to)
{
    ArchiveQuery query(config);
    SeriesQuery window{{}, from, to, 1500};
    for (int number = 1; number <= 3; ++number) {
        window.keys << SeriesKey{number, Quantity::TiltX} << SeriesKey{number, Quantity::TiltY};
    }
    double best = 1e9;
    double first = 0;
    qsizetype buckets = 0;
    for (int round = 0; round < 15; ++round) {
        QElapsedTimer timer;
        timer.start();
        const QList<Series> all = query.series(window);
        const double ms = static_cast<double>(timer.nsecsElapsed()) / 1e6;
        first = round == 0 ? ms : first;
        best = std::min(best, ms);
        buckets = all.first().buckets.size();
    }
    std::printf(
        "%-24s %6.2f ms, the first time %.2f; %lld buckets a curve\n", what, best, first,
        static_cast<long long>(buckets));
}

void benchReading(const QTemporaryDir &folder, int days)
{
    const ArchiveConfig config = archive(folder, "year");
    {
        UtcTime now = start;
        ArchiveWriter writer(config, [&now] { return now; });
        for (int i = 0; i < days * 8640; ++i) {
            now = start + i * 10s;
            writer.updateReadings(turn(now));
            if (i % 360 == 0) {
                writer.flush();
            }
        }
        writer.stop();
    }
    const double values = double{sensors} * quantities * days * 8640;
    std::printf(
        "%4d days at 0.1 Hz      %6.2f bytes a value, %.0f MB\n", days,
        static_cast<double>(bytesOf(config.file)) / values, static_cast<double>(bytesOf(config.file)) / 1e6);
    printShares(config, values);
    ask(config, "all of it", start, start + days * 24h);
    ask(config, "a month", start + (days - 31) * 24h, start + (days - 1) * 24h);
    ask(config, "a day", start + (days - 2) * 24h, start + (days - 1) * 24h);
    const ArchiveConfig live = archive(folder, "live");
    UtcTime now = start;
    ArchiveWriter writer(live, [&now] { return now; });
    for (int i = 0; i < 2 * 3600; ++i) {
        now = start + i * 1s;
        writer.updateReadings(turn(now));
        writer.flush();
    }
    ask(live, "the last hour at 1 Hz", now - 1h, now);
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication app(argc, argv);
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    const QStringList arguments = QCoreApplication::arguments();
    const qsizetype at = arguments.indexOf(QStringLiteral("--days"));
    const QTemporaryDir folder;
    for (const int turnsPerCommit : {1, 100}) {
        benchWriting(folder, turnsPerCommit);
    }
    benchReading(folder, at > 0 ? arguments.value(at + 1).toInt() : 365);
    return 0;
}
