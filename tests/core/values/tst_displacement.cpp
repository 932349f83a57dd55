#include "core/values/displacement.h"

#include <QTest>

using namespace gorizont;

/// Expected figures: bc -l, l·1000·s(a/3600·π/180), and right angles that need no table.
class TestDisplacement : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void ofOneLink_data();
    void ofOneLink();
    void sumsGoUpwards();
    void whatIsMissingBelowIsMissingAbove();
    void lengthsScaleAndSignsTurn();
};

void TestDisplacement::ofOneLink_data()
{
    QTest::addColumn<double>("arcSeconds");
    QTest::addColumn<double>("length");
    QTest::addColumn<double>("millimetres");
    QTest::newRow("upright") << 0.0 << 3.0 << 0.0;
    QTest::newRow("thirty degrees are a half") << 108000.0 << 2.0 << 1000.0;
    QTest::newRow("lying") << -324000.0 << 1.5 << -1500.0;
    QTest::newRow("one degree") << 3600.0 << 1.0 << 17.452406437283512;
    QTest::newRow("an arc-second over ten metres") << 1.0 << 10.0 << 0.048481368092;
}

void TestDisplacement::ofOneLink()
{
    QFETCH(double, arcSeconds);
    QFETCH(double, length);
    QFETCH(double, millimetres);
    const Displacement shift = linkDisplacement({arcSeconds, -arcSeconds}, length);
    QVERIFY(std::abs(shift.x - millimetres) < 1e-9);
    QVERIFY(std::abs(shift.y + millimetres) < 1e-9);
}

void TestDisplacement::sumsGoUpwards()
{
    const ChainConfig chain{1, {}, {{7, 2.0}, {3, 1.0}, {5, 0.5}}};
    const QHash<int, Tilt> tilts{{7, {108000, 0}}, {3, {-108000, 324000}}, {5, {0, 0}}};
    const auto nodes = chainNodes(chain, [&](int number) { return std::optional(tilts.value(number)); });
    QCOMPARE(nodes.size(), std::size_t{3});
    const QList<int> numbers{nodes[0].number, nodes[1].number, nodes[2].number};
    QCOMPARE(numbers, QList<int>({7, 3, 5}));
    QCOMPARE(nodes[0].height, 2.0);
    QCOMPARE(nodes[1].height, 3.0);
    QCOMPARE(nodes[2].height, 3.5);
    QCOMPARE(nodes[1].own->x, -500.0);
    QCOMPARE(nodes[1].sum->x, 500.0);
    QCOMPARE(nodes[1].sum->y, 1000.0);
    QCOMPARE(nodes[2].sum, nodes[1].sum);
}

void TestDisplacement::whatIsMissingBelowIsMissingAbove()
{
    const ChainConfig chain{1, {}, {{1, 1.0}, {2, 1.0}, {3, 1.0}}};
    const auto nodes = chainNodes(chain, [](int number) {
        return number == 2 ? std::nullopt : std::optional(Tilt{3600, 0});
    });
    QVERIFY(nodes[0].sum);
    QVERIFY(!nodes[1].own);
    QVERIFY(!nodes[1].sum);
    QVERIFY(nodes[2].own);
    QVERIFY(!nodes[2].sum);
}

void TestDisplacement::lengthsScaleAndSignsTurn()
{
    for (double angle = -20000; angle <= 20000; angle += 1234.5) {
        const Displacement one = linkDisplacement({angle, 0}, 1);
        QVERIFY(std::abs(linkDisplacement({angle, 0}, 4).x - 4 * one.x) < 1e-9);
        QVERIFY(std::abs(linkDisplacement({-angle, 0}, 1).x + one.x) < 1e-12);
        QVERIFY(std::abs(one.x) <= 1000);
    }
}

QTEST_APPLESS_MAIN(TestDisplacement)

#include "tst_displacement.moc"
