#include "core/analysis/seriesstatistics.h"

#include <QTest>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

const UtcTime start{1'500'000'000s};

SeriesBucket value(std::chrono::microseconds after, double number)
{
    return {start + after, number, number, number, 1, 1};
}

Series sample()
{
    Series series;
    series.buckets = {value(0s, 1), value(600s, 2), value(1200s, 4), value(2400s, 3), value(3600s, 7)};
    return series;
}

} // namespace

/// What stands in the readout of two cursors.
class TestSeriesStatistics : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// numpy.polyfit(t, v, 1) of the sample: 122.896551724 a day.
    void ofReadings()
    {
        const std::optional<SeriesStatistics> result = statistics(sample(), start, start + 3601s);
        QVERIFY(result);
        QCOMPARE(result->first, 1.0);
        QCOMPARE(result->last, 7.0);
        QCOMPARE(result->difference(), 6.0);
        QCOMPARE(result->mean, 3.4);
        QCOMPARE(result->minimum, 1.0);
        QCOMPARE(result->maximum, 7.0);
        QCOMPARE(result->slope, 122.89655172413792);
        QCOMPARE(result->slopeAnHour(), 122.89655172413792 / 24);
        QCOMPARE(result->completeness, 1.0);
        QCOMPARE(result->valid, 5U);
    }

    /// numpy.polyfit with w = √count, numpy.average with weights.
    void bucketsWeighAsManyReadingsAsTheyHold()
    {
        Series series;
        series.step = 3600s;
        series.buckets = {
            {start, -5, 1, 2, 12, 10},
            {start + 3600s, 3, 4, 9, 20, 20},
            {start + 7200s, 1, 2, 3, 5, 5},
            {start + 10800s, 0, 0, 0, 7, 0}};
        const std::optional<SeriesStatistics> result = statistics(series, start, start + 14400s);
        QVERIFY(result);
        QCOMPARE(result->mean, 2.857142857142857);
        QCOMPARE(result->slope, 24.0);
        QCOMPARE(result->minimum, -5.0);
        QCOMPARE(result->maximum, 9.0);
        QCOMPARE(result->last, 2.0);
        QCOMPARE(result->readings, 44U);
        QCOMPARE(result->valid, 35U);
    }

    void onlyWhatLiesBetween()
    {
        const std::optional<SeriesStatistics> result = statistics(sample(), start + 600s, start + 2400s);
        QVERIFY(result);
        QCOMPARE(result->first, 2.0);
        QCOMPARE(result->last, 4.0);
        QCOMPARE(result->valid, 2U);
    }

    /// Small changes of a large value, far from the epoch.
    void slopeOfALargeValue()
    {
        Series series;
        for (int i = 0; i < 1000; ++i) {
            series.buckets.append(value(i * 60s, 1e6 + i * 1e-6));
        }
        const std::optional<SeriesStatistics> result = statistics(series, start, start + 60000s);
        QVERIFY(std::abs(result->slope - 1440e-6) < 1e-9);
    }

    void nothingToSay()
    {
        QVERIFY(!statistics(Series(), start, start + 1h));
        QVERIFY(!statistics(sample(), start + 1s, start + 2s));
        QVERIFY(!statistics(sample(), start + 1h, start));
        Series invalid;
        invalid.buckets = {{start, 0, 0, 0, 5, 0}};
        QVERIFY(!statistics(invalid, start, start + 1h));
        QCOMPARE(statistics(sample(), start, start + 1s)->slope, 0.0);
    }

    void completenessIsTimeWithoutGaps()
    {
        const QList<TimeSpan> gaps{
            {start - 1h, start + 6min}, {start + 3min, start + 12min}, {start + 54min, start + 2h}};
        QCOMPARE(completeness(gaps, start, start + 1h), 0.7);
        QCOMPARE(completeness({}, start, start + 1h), 1.0);
        QCOMPARE(completeness({{start - 1h, start + 2h}}, start, start + 1h), 0.0);
        QCOMPARE(completeness(gaps, start, start), 0.0);
    }

    void valueAtAMoment()
    {
        Series series = sample();
        series.gaps = {{start + 1300s, start + 2300s}};
        QCOMPARE(valueAt(series, start), 1.0);
        QCOMPARE(valueAt(series, start + 299s), 1.0);
        QCOMPARE(valueAt(series, start + 301s), 2.0);
        QCOMPARE(valueAt(series, start + 3600s), 7.0);
        QVERIFY(!valueAt(series, start - 1us));
        QVERIFY(!valueAt(series, start + 3601s));
        QVERIFY(!valueAt(series, start + 1300s));
        QCOMPARE(valueAt(series, start + 2300s), 3.0);
        QVERIFY(!valueAt(Series(), start));
        series.step = 600s; // a bucket holds all of its stretch
        QCOMPARE(valueAt(series, start + 599s), 1.0);
        QCOMPARE(valueAt(series, start + 4199s), 7.0);
    }
};

QTEST_APPLESS_MAIN(TestSeriesStatistics)
#include "tst_seriesstatistics.moc"
