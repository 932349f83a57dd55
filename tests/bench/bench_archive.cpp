// What the archive costs: bytes a value, values a second against plain rows, and how long a window of curves takes.
//   bench_archive [--days N]
#include "core/archive/archivequery.h"
#include "core/archive/archivewriter.h"
#include "core/devices/buildingmotion.h"
#include "core/values/geometry.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QSqlQuery>
#include <QTemporaryDir>

#include <cmath>
#include <cstdio>
#include <ctime>

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

/// What something took, in seconds.
struct Cost
{
    double time = 1e9; ///< waits for the disk included
    double processor = 1e9;
    void keepBest(const Cost &other)
    {
        time = std::min(time, other.time);
        processor = std::min(processor, other.processor);
    }
};

class CostTimer
{
public:
    CostTimer() { m_timer.start(); }
    Cost cost() const
    {
        return {
            static_cast<double>(m_timer.nsecsElapsed()) / 1e9,
            static_cast<double>(std::clock() - m_processor) / CLOCKS_PER_SEC};
    }

private:
    QElapsedTimer m_timer;
    std::clock_t m_processor = std::clock();
};

/// \a turns of all sensors; returns what the writer took.
Cost write(ArchiveConfig config, const QList<Readings> &turns, int turnsPerCommit)
{
    config.retentionInterval = 24h;
    UtcTime now = turns.first().first().time;
    ArchiveWriter writer(config, [&now] { return now; });
    writer.flush();
    const CostTimer timer;
    for (qsizetype i = 0; i < turns.size(); ++i) {
        writer.updateReadings(turns.at(i));
        now = turns.at(i).last().time;
        if ((i + 1) % turnsPerCommit == 0) {
            writer.flush();
        }
    }
    writer.stop();
    return timer.cost();
}

/// The same as rows (sensor, quantity, time, value) with an index, in the same commits.
Cost writeRows(const ArchiveConfig &config, const QList<Readings> &turns, int turnsPerCommit)
{
    ArchiveDatabase database(config, ArchiveDatabase::Access::Write);
    if (!database.open()) {
        return {};
    }
    database.execute(QStringLiteral("CREATE TABLE value (number INTEGER, quantity INTEGER, time BIGINT, value REAL)"));
    database.execute(QStringLiteral("CREATE INDEX by_time ON value (number, quantity, time)"));
    const QString insert = QStringLiteral("INSERT INTO value VALUES (?, ?, ?, ?)");
    const CostTimer timer;
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
    return timer.cost();
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
    Cost best;
    Cost bestRows;
    for (int round = 0; round < 3; ++round) {
        const QByteArray suffix = QByteArray::number(turnsPerCommit * 10 + round);
        const ArchiveConfig ours = archive(folder, "a" + suffix);
        const ArchiveConfig rows = archive(folder, "r" + suffix);
        best.keepBest(write(ours, turns, turnsPerCommit));
        bestRows.keepBest(writeRows(rows, turns, turnsPerCommit));
        if (round == 0) {
            std::printf(
                "two hours at 1 Hz        %6.2f bytes a value, as rows %.1f\n",
                static_cast<double>(bytesOf(ours.file)) / values, static_cast<double>(bytesOf(rows.file)) / values);
            printShares(ours, values);
        }
    }
    const auto print = [values](const char *of, double ours, double rows) {
        std::printf(
            "  %-22s %6.0f thousand values a second, as rows %.0f: ratio %.2f\n", of, values / ours / 1000,
            values / rows / 1000, rows / ours);
    };
    std::printf("%d readings a commit\n", turnsPerCommit * sensors);
    print("of time", best.time, bestRows.time);
    print("of processor time", best.processor, bestRows.processor);
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

/// \a some turns again and again for \a times: the building takes longer to simulate than the archive to keep it.
void writeAgain(const ArchiveConfig &config, QList<Readings> some, std::chrono::microseconds period, int times)
{
    UtcTime now = start;
    ArchiveWriter writer(config, [&now] { return now; });
    const auto length = some.size() * period;
    for (qsizetype i = 0; i < times * some.size(); ++i) {
        Readings &batch = some[i % some.size()];
        now = start + i * period;
        writer.updateReadings(batch);
        for (Reading &reading : batch) {
            reading.time += length;
        }
        if (i % 360 == 0) {
            writer.flush();
        }
    }
    writer.stop();
    // The clock here jumps from one commit to the next, and the archive tells of each jump; a real one does not.
    ArchiveDatabase database(config, ArchiveDatabase::Access::Write);
    if (database.open()) {
        database.execute(QStringLiteral("BEGIN"));
        database.execute(QStringLiteral("DELETE FROM gap"));
        for (int free = database.single(QStringLiteral("PRAGMA freelist_count")).toInt(); free > 0; --free) {
            database.execute(QStringLiteral("PRAGMA incremental_vacuum(1)"));
        }
        database.execute(QStringLiteral("COMMIT"));
    }
}

void printBytes(const char *what, const ArchiveConfig &config, double values)
{
    const auto bytes = static_cast<double>(bytesOf(config.file));
    std::printf("%-24s %6.2f bytes a value, %.0f MB\n", what, bytes / values, bytes / 1e6);
    printShares(config, values);
}

/// A sensor whose axes are turned, and one whose are not.
void benchBytes(const QTemporaryDir &folder)
{
    constexpr double values = double{sensors} * quantities * 86'400;
    const QList<Readings> plain = turnsOf(7200, 1s);
    const ArchiveConfig day = archive(folder, "day");
    writeAgain(day, plain, 1s, 12);
    printBytes("a day at 1 Hz", day, values);
    ArchiveConfig turnedDay = archive(folder, "turned");
    for (SensorConfig &sensor : turnedDay.lines[0].sensors) {
        sensor.rotationX = 30;
        sensor.offsetX = 12.3;
    }
    QList<Readings> turned = plain;
    for (Readings &batch : turned) {
        for (Reading &reading : batch) {
            const SensorConfig &sensor = turnedDay.lines.first().sensors.at(reading.number - 1);
            reading.tilt = correctedTilt(*reading.tilt, AxisTransform(sensor), sensor);
        }
    }
    writeAgain(turnedDay, turned, 1s, 12);
    printBytes("the same, RotX = 30", turnedDay, values);
}

void benchReading(const QTemporaryDir &folder, int days)
{
    const ArchiveConfig config = archive(folder, "year");
    writeAgain(config, turnsOf(8640, 10s), 10s, days);
    const double values = double{sensors} * quantities * days * 8640;
    printBytes(qPrintable(QStringLiteral("%1 days at 0.1 Hz").arg(days)), config, values);
    ask(config, "all of it", start, start + days * 24h);
    ask(config, "a month", start + (days - 31) * 24h, start + (days - 1) * 24h);
    ask(config, "a day", start + (days - 2) * 24h, start + (days - 1) * 24h);
}

void benchLive(const QTemporaryDir &folder)
{
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
    benchBytes(folder);
    for (const int turnsPerCommit : {1, 100}) {
        benchWriting(folder, turnsPerCommit);
    }
    benchLive(folder);
    benchReading(folder, at > 0 ? arguments.value(at + 1).toInt() : 365);
    return 0;
}
