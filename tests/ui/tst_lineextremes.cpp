#include "ui/plots/lineextremes.h"

#include <QRandomGenerator>
#include <QTest>

#include <limits>

using namespace gorizont;

/// The extremes of a line that grows, against a look at every value.
class TestLineExtremes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void areThoseOfEveryValue();
    void nothingIsThere();
};

void TestLineExtremes::areThoseOfEveryValue()
{
    QRandomGenerator random(7);
    QCPGraphDataContainer line;
    LineExtremes extremes;
    for (int i = 0; i < 2000; ++i) {
        const double value = i % 50 == 3 || (i > 700 && i < 1300) ? std::numeric_limits<double>::quiet_NaN()
                                                                  : random.bounded(1000.0) - 500;
        line.add(QCPGraphData(i, value));
        const double a = random.bounded(i + 1);
        const double b = random.bounded(i + 1);
        const QCPRange keys(std::min(a, b) - 0.5, std::max(a, b) + 0.5);
        bool isFound = false;
        const QCPRange expected = line.valueRange(isFound, QCP::sdBoth, keys);
        const auto found = extremes.within(line, keys);
        QCOMPARE(found.has_value(), isFound);
        if (isFound) {
            QCOMPARE(found->lower, expected.lower);
            QCOMPARE(found->upper, expected.upper);
        }
    }
    line.set({QCPGraphData(1, 5), QCPGraphData(2, 7)}, true);
    extremes.forget();
    QCOMPARE(extremes.within(line, QCPRange(0, 3))->upper, 7.0);
}

void TestLineExtremes::nothingIsThere()
{
    QCPGraphDataContainer line;
    LineExtremes extremes;
    QVERIFY(!extremes.within(line, QCPRange(0, 1)));
    line.add(QCPGraphData(5, 1));
    QVERIFY(!extremes.within(line, QCPRange(0, 1)));
    QVERIFY(!extremes.within(line, QCPRange(6, 7)));
    QVERIFY(extremes.within(line, QCPRange(5, 5)));
}

QTEST_MAIN(TestLineExtremes)

#include "tst_lineextremes.moc"
