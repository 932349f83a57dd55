#include "core/archive/rollup.h"

#include <QTest>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

const UtcTime midnight{std::chrono::sys_days(std::chrono::year(2024) / 2 / 29)};

ValueColumn columnOf(const std::vector<std::optional<double>> &values)
{
    ValueColumn column;
    for (const auto &value : values) {
        column.values.push_back(value.value_or(0));
        column.isValid.push_back(value.has_value());
    }
    return column;
}

} // namespace

class TestRollup : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void countsAndMeasures();
    void begins1970AndBefore();
    void acceptsAClockThatGoesBack();
    void joinsMinutesToHoursAndDays();
    void joinsTwoHalvesOfABucket();
};

void TestRollup::countsAndMeasures()
{
    const std::vector<UtcTime> times{midnight + 1s, midnight + 59s, midnight + 60s, midnight + 61s, midnight + 200s};
    const Buckets buckets = bucketsOf(times, columnOf({-5, 8, {}, 2, {}}), 1min);
    const Buckets expected{
        {midnight, -5, 1.5, 8, 2, 2}, {midnight + 1min, 2, 2, 2, 2, 1}, {midnight + 3min, 0, 0, 0, 1, 0}};
    QCOMPARE(buckets, expected);
}

void TestRollup::begins1970AndBefore()
{
    const UtcTime epoch{};
    QVERIFY(floored(epoch, 1h) == epoch);
    QVERIFY(floored(epoch + 3599s, 1h) == epoch);
    QVERIFY(floored(epoch - 1us, 1h) == epoch - 1h);
    QVERIFY(floored(epoch - 1h, 1h) == epoch - 1h);
}

void TestRollup::acceptsAClockThatGoesBack()
{
    const std::vector<UtcTime> times{midnight + 61s, midnight + 62s, midnight + 3s, midnight + 63s};
    const Buckets buckets = bucketsOf(times, columnOf({1, 3, 7, 11}), 1min);
    QCOMPARE(buckets, (Buckets{{midnight, 7, 7, 7, 1, 1}, {midnight + 1min, 1, 5, 11, 3, 3}}));
}

/// Over the end of a leap February.
void TestRollup::joinsMinutesToHoursAndDays()
{
    std::vector<UtcTime> times;
    std::vector<std::optional<double>> values;
    for (int minute = 0; minute < 2 * 24 * 60; ++minute) {
        times.push_back(midnight + std::chrono::minutes(minute));
        values.emplace_back(minute);
    }
    const Buckets minutes = bucketsOf(times, columnOf(values), 1min);
    QCOMPARE(minutes.size(), 2880);
    const Buckets hours = coarsened(minutes, 1h);
    QCOMPARE(hours.size(), 48);
    QCOMPARE(hours.at(1), (SeriesBucket{midnight + 1h, 60, 89.5, 119, 60, 60}));
    const Buckets days = coarsened(hours, 24h);
    const UtcTime march{std::chrono::sys_days(std::chrono::year(2024) / 3 / 1)};
    QCOMPARE(days, (Buckets{{midnight, 0, 719.5, 1439, 1440, 1440}, {march, 1440, 2159.5, 2879, 1440, 1440}}));
}

void TestRollup::joinsTwoHalvesOfABucket()
{
    const Buckets early{{midnight, 1, 2, 3, 4, 3}, {midnight + 1min, 5, 5, 5, 1, 1}};
    const Buckets late{
        {midnight + 1min, 9, 10, 11, 3, 3}, {midnight + 2min, 0, 0, 0, 2, 0}, {midnight + 5min, 1, 1, 1, 1, 1}};
    const Buckets expected{
        {midnight, 1, 2, 3, 4, 3},
        {midnight + 1min, 5, 8.75, 11, 4, 4},
        {midnight + 2min, 0, 0, 0, 2, 0},
        {midnight + 5min, 1, 1, 1, 1, 1}};
    QCOMPARE(merged(early, late), expected);
    QCOMPARE(merged(late, early), expected);
    QCOMPARE(merged(early, {}), early);
    QCOMPARE(merged({}, early), early);
    const Buckets none{{midnight, 0, 0, 0, 2, 0}};
    QCOMPARE(merged(none, early).first(), (SeriesBucket{midnight, 1, 2, 3, 6, 3}));
}

QTEST_APPLESS_MAIN(TestRollup)

#include "tst_rollup.moc"
