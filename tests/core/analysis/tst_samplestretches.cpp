#include "core/analysis/samplestretches.h"

#include <QTest>

using namespace gorizont;
using namespace std::chrono_literals;

/// Samples of an accelerometer, cut where one is missing.
class TestSampleStretches : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneStretch()
    {
        const SampleStretches result = sampleStretches(samples({0, 1, 2, 3}));
        QCOMPARE(result.rate, 10.0);
        QCOMPARE(result.stretches, (QList<QList<double>>{{0, 1, 2, 3}}));
        QCOMPARE(result.samples(), 4);
    }

    void aMissingSampleCuts()
    {
        QCOMPARE(sampleStretches(samples({0, 1, 2, 4, 5})).stretches, (QList<QList<double>>{{0, 1, 2}, {4, 5}}));
    }

    /// The clock of the computer and that of the sensor differ a little.
    void unevenTimesDoNotCut()
    {
        Series series = samples({0, 1, 2, 3});
        series.buckets[2].from += 30ms;
        QCOMPARE(sampleStretches(series).stretches.size(), 1);
    }

    void aGapCuts()
    {
        Series series = samples({0, 1, 2, 3});
        series.gaps = {{at(1) + 1ms, at(2)}};
        QCOMPARE(sampleStretches(series).stretches, (QList<QList<double>>{{0, 1}, {2, 3}}));
    }

    void anInvalidOneCuts()
    {
        Series series = samples({0, 1, 2, 3, 4});
        series.buckets[2].valid = 0;
        QCOMPARE(sampleStretches(series).stretches, (QList<QList<double>>{{0, 1}, {3, 4}}));
    }

    void tooFew()
    {
        QCOMPARE(sampleStretches(Series()).rate, 0.0);
        QCOMPARE(sampleStretches(samples({5})).samples(), 0);
        QCOMPARE(sampleStretches(samples({5, 5})).rate, 0.0); // two at one moment
    }

private:
    static UtcTime at(int sample) { return UtcTime(1'500'000'000s) + sample * 100ms; }

    /// One sample at each of \a places, whose value is its place.
    static Series samples(const QList<int> &places)
    {
        Series series;
        for (const int place : places) {
            const auto value = static_cast<double>(place);
            series.buckets.append({at(place), value, value, value, 1, 1});
        }
        return series;
    }
};

QTEST_APPLESS_MAIN(TestSampleStretches)
#include "tst_samplestretches.moc"
