#include "core/station/service/periodrecords.h"
#include "core/station/service/stationclock.h"
#include "core/station/service/stationstorage.h"
#include "tests/core/history/failingwrite.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace gorizont;
using namespace gorizont::station;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

/// 2026-11-28 18:30:00, as a clock that is read as UTC: 20785 days and 18.5 hours.
constexpr qint64 evening = 20785LL * 86400 + 66600;

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(none)");
}

WeatherParameter parameter(QChar code, int number, std::optional<double> mean)
{
    WeatherParameter made;
    made.code = code;
    made.number = number;
    made.mean = mean;
    if (mean) {
        made.minimum = *mean - 0.25;
        made.maximum = *mean + 0.25;
    }
    return made;
}

StoredLine line(const QByteArray &record, const QByteArray &heading = ";time\n")
{
    return {QStringLiteral("2026_11_obj001.txt"), heading, record};
}

} // namespace

class TestStationRecords : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void formatsARecord();
    void namesFilesByMonthAndDay();
    void ticksWithThePeriods();
    void keepsTheClockApart();
    void writesAHeadingWhereColumnsChange();
    void goesOnAfterAKill();
    void losesNothingOfAFullDisk();
    void saysThatAFolderCannotBeWritten();
};

void TestStationRecords::formatsARecord()
{
    const QList<WeatherParameter> parameters{parameter(u'T', 1, -5.5), parameter(u'P', 12, {})};
    const QList<OutputFormat> formats{{6, 2}, {5, 1}};
    QCOMPARE(
        periodrecords::heading(parameters),
        QByteArray(";time\tT01\tT01 min\tT01 max\tP12\tP12 min\tP12 max\tdigital\n"));
    QCOMPARE(
        periodrecords::record(evening, parameters, formats, 0xA5),
        QByteArray("2026-11-28 18:30:00\t-5.50\t-5.75\t-5.25\t-\t-\t-\t000000a5\n"));
    QCOMPARE(
        periodrecords::safeRecord(evening, {1.5, std::nullopt, -0.001}),
        QByteArray("2026-11-28 18:30:00\t1.5\t-\t-0.001\n"));
}

void TestStationRecords::namesFilesByMonthAndDay()
{
    QCOMPARE(periodrecords::fileName(evening, 7), QStringLiteral("2026_11_obj007.txt"));
    QCOMPARE(periodrecords::safeFileName(evening), QStringLiteral("2026_11_28_raw.txt"));
}

/// Aligned to the clock, one for each period, none twice; a clock that is set back makes none.
void TestStationRecords::ticksWithThePeriods()
{
    PeriodTurn turn(600s);
    QVERIFY(!turn.due(evening - 3));
    QVERIFY(!turn.due(evening - 1));
    QCOMPARE(turn.due(evening), std::optional(evening));
    QVERIFY(!turn.due(evening));
    QVERIFY(!turn.due(evening + 599));
    QCOMPARE(turn.due(evening + 602), std::optional(evening + 600)); // the second itself was missed
    QVERIFY(!turn.due(evening - 5000));
    QCOMPARE(turn.due(evening - 4799), std::optional(evening - 4800));
    QCOMPARE(turn.due(evening + 86400), std::optional(evening + 86400));
}

void TestStationRecords::keepsTheClockApart()
{
    const QTimeZone moscow("Europe/Moscow");
    StationClock clock(moscow);
    const UtcTime now(1'700'000'000s); // 22:13:20 UTC, 01:13:20 in Moscow
    QCOMPARE(clock.seconds(now), 1'700'000'000 + 3 * 3600);
    QCOMPARE(clock.wallTime(clock.seconds(now)), now);
    clock.set(1'700'000'000, now);
    QCOMPARE(clock.offset(), -3 * 3600);
    QCOMPARE(clock.seconds(now + 5s), 1'700'000'005);
    QCOMPARE(readClockOffset(clockOffsetText(-10800)), std::optional<qint64>(-10800));
    QVERIFY(!readClockOffset("tomorrow"));
}

void TestStationRecords::writesAHeadingWhereColumnsChange()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("2026_11_obj001.txt"));
    {
        StationStorage storage(folder.path());
        storage.add(line("a\n"));
        storage.add(line("b\n"));
        storage.end();
    }
    {
        StationStorage storage(folder.path()); // the program was started again
        storage.add(line("c\n"));
        storage.add(line("d\n", ";time\tT01\n"));
        storage.add({QStringLiteral("SAFE/day.txt"), ";raw\n", "1\n"});
        storage.end();
    }
    QCOMPARE(contentOf(path), QByteArray(";time\na\nb\nc\n;time\tT01\nd\n"));
    QCOMPARE(contentOf(folder.filePath(QStringLiteral("SAFE/day.txt"))), QByteArray(";raw\n1\n"));
}

/// A record that a kill cut in half is removed, and that is said.
void TestStationRecords::goesOnAfterAKill()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("2026_11_obj001.txt"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(";time\na\n2026-11-28 18:3") == 23);
    file.close();
    StationStorage storage(folder.path());
    const QSignalSpy told(&storage, &StationStorage::told);
    storage.add(line("b\n"));
    storage.end();
    QCOMPARE(contentOf(path), QByteArray(";time\na\nb\n"));
    QCOMPARE(told.size(), 1);
}

void TestStationRecords::losesNothingOfAFullDisk()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("2026_11_obj001.txt"));
    StationStorage storage(folder.path());
    const QSignalSpy told(&storage, &StationStorage::told);
    storage.add(line("first\n"));
    storage.end();
    QCOMPARE(told.size(), 0);
    {
        const FailingWrite full(QStringLiteral("obj001.txt"), 3); // three bytes of the next record fit
        storage.add(line("second\n"));
        storage.add(line("third\n"));
        storage.end();
        QCOMPARE(contentOf(path), QByteArray(";time\nfirst\n"));
        storage.flush();
        QCOMPARE(told.size(), 1);
        QCOMPARE(told.at(0).at(0).toBool(), false);
    }
    storage.flush();
    QCOMPARE(contentOf(path), QByteArray(";time\nfirst\nsecond\nthird\n"));
    QCOMPARE(told.size(), 2);
    QCOMPARE(told.at(1).at(0).toBool(), true);
}

void TestStationRecords::saysThatAFolderCannotBeWritten()
{
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("file")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    StationStorage storage(folder.filePath(QStringLiteral("file/records")));
    const QSignalSpy told(&storage, &StationStorage::told);
    storage.add(line("a\n"));
    storage.keep(QStringLiteral("clock.txt"), "1\n");
    storage.end();
    QCOMPARE(told.size(), 2);
}

QTEST_GUILESS_MAIN(TestStationRecords)

#include "tst_stationrecords.moc"
