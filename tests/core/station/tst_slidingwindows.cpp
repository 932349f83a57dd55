#include "core/station/secondaccumulator.h"
#include "core/station/slidingextremes.h"
#include "core/station/slidingmean.h"

#include <QRandomGenerator>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace gorizont::station;

namespace {

/// The same from the values themselves, without any cleverness.
struct Plain
{
    std::vector<double> values;

    Plain(const std::vector<std::optional<double>> &all, std::size_t length)
    {
        for (std::size_t i = all.size() > length ? all.size() - length : 0; i < all.size(); ++i) {
            if (all[i]) {
                values.push_back(*all[i]);
            }
        }
    }
    double mean() const
    {
        return static_cast<double>(std::accumulate(values.begin(), values.end(), 0.0L)) / double(values.size());
    }
    double deviation() const
    {
        long double sum = 0;
        for (const double value : values) {
            sum += (value - static_cast<long double>(mean())) * (value - static_cast<long double>(mean()));
        }
        return static_cast<double>(std::sqrt(sum / static_cast<long double>(values.size())));
    }
};

} // namespace

/// The windows against plain sums, and what the second adds up.
class TestSlidingWindows : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Python's statistics: fmean 3.4, pstdev 2.0591260281974.
    void meanAndDeviation()
    {
        SlidingMean window(5);
        QVERIFY(!window.mean());
        QVERIFY(!window.deviation());
        for (const double value : {100.0, 1.0, 2.0, 4.0, 3.0, 7.0}) {
            window.push(value);
        }
        QCOMPARE(window.count(), 5);
        QCOMPARE(*window.mean(), 3.4);
        QCOMPARE(*window.deviation(), 2.0591260281974);
    }

    void asPlainSums_data()
    {
        QTest::addColumn<int>("length");
        for (const int length : {1, 2, 7, 60, 600}) {
            QTest::addRow("%d", length) << length;
        }
    }

    void asPlainSums()
    {
        QFETCH(const int, length);
        QRandomGenerator random(static_cast<quint32>(length));
        SlidingMean means(length);
        SlidingExtremes extremes(length);
        std::vector<std::optional<double>> all;
        for (int i = 0; i < 5 * length + 20; ++i) {
            const bool isThere = random.bounded(4) != 0;
            all.push_back(isThere ? std::optional(1000 + random.bounded(5.0)) : std::nullopt);
            means.push(all.back());
            extremes.push(all.back());
            const Plain plain(all, static_cast<std::size_t>(length));
            QCOMPARE(means.count(), qint64(plain.values.size()));
            QCOMPARE(means.mean().has_value(), !plain.values.empty());
            QCOMPARE(extremes.minimum().has_value(), !plain.values.empty());
            if (!plain.values.empty()) {
                QVERIFY(std::abs(*means.mean() - plain.mean()) < 1e-10);
                QVERIFY(std::abs(*means.deviation() - plain.deviation()) < 1e-6);
                QCOMPARE(*extremes.minimum(), *std::min_element(plain.values.begin(), plain.values.end()));
                QCOMPARE(*extremes.maximum(), *std::max_element(plain.values.begin(), plain.values.end()));
            }
        }
    }

    void meanOfAConstantIsTheConstant_data()
    {
        QTest::addColumn<double>("constant");
        for (const double constant : {0.1, -273.15, 760.3, 1e-12, 1e12, 0.0}) {
            QTest::addRow("%g", constant) << constant;
        }
    }

    void meanOfAConstantIsTheConstant()
    {
        QFETCH(const double, constant);
        SlidingMean window(600);
        for (int i = 0; i < 2000; ++i) {
            window.push(i % 3 == 0 ? std::nullopt : std::optional(constant));
            if (window.count() > 0) {
                QVERIFY(*window.mean() == constant);
                QVERIFY(*window.deviation() == 0);
            }
        }
    }

    /// Far from 0, close to each other, for days: nothing drifts.
    void roundingNeverAddsUp()
    {
        constexpr int length = 3600;
        SlidingMean window(length);
        std::vector<std::optional<double>> all;
        QRandomGenerator random(1);
        for (int i = 0; i < 3 * 86400 + 17; ++i) {
            const double value = 1e6 + random.bounded(0.01);
            window.push(value);
            if (i >= 3 * 86400 + 17 - length) {
                all.push_back(value);
            }
        }
        const Plain plain(all, length);
        QVERIFY(std::abs(*window.mean() - plain.mean()) < 1e-9);
        QVERIFY(std::abs(*window.deviation() - plain.deviation()) < 1e-7);
    }

    /// What a value beyond all measure left in the sums is gone after two lengths at the latest.
    void aGiantIsForgotten()
    {
        SlidingMean window(10);
        window.push(1e300);
        for (int i = 0; i < 20; ++i) {
            window.push(0.5);
        }
        QCOMPARE(*window.mean(), 0.5);
        QCOMPARE(*window.deviation(), 0.0);
    }

    /// Rising, falling and equal values.
    void extremes()
    {
        SlidingExtremes window(3);
        QVERIFY(!window.minimum());
        for (const double value : {1.0, 2.0, 3.0, 4.0}) {
            window.push(value);
        }
        QCOMPARE(*window.minimum(), 2.0);
        QCOMPARE(*window.maximum(), 4.0);
        window.push(4.0);
        window.push({});
        QCOMPARE(*window.minimum(), 4.0);
        window.push({});
        window.push({});
        QVERIFY(!window.minimum());
        QVERIFY(!window.maximum());
    }

    void secondOfSamples()
    {
        SecondAccumulator second(3);
        second.add(0, 1);
        second.add(0, 2);
        second.add(0, qQNaN());
        second.add(7, 1);
        const std::vector<double> block{3, 4, 5};
        second.addBlock(1, block);
        const std::vector<std::optional<double>> expected{1.5, 4.0, std::nullopt};
        QCOMPARE(second.take(), expected);
        QCOMPARE(second.take(), (std::vector<std::optional<double>>(3)));
    }

    void secondOfScans()
    {
        SecondAccumulator second(2);
        const std::vector<double> scans{1, 10, 3, qInf(), 8, 20};
        second.addScans(scans);
        const std::vector<std::optional<double>> expected{4.0, 15.0};
        QCOMPARE(second.take(), expected);
    }
};

QTEST_GUILESS_MAIN(TestSlidingWindows)
#include "tst_slidingwindows.moc"
