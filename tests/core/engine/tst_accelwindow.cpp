#include "core/engine/accelwindow.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

constexpr UtcTime noon{std::chrono::seconds(1'700'000'000)};

/// Block \a number of a stream without gaps; its 32 samples are those of \a x and \a y at that place.
template <typename X, typename Y> SampleBlock block(int number, X x, Y y)
{
    SampleBlock made;
    made.start = noon + number * 3200ms;
    made.followsPrevious = number > 0;
    for (int i = 0; i < 32; ++i) {
        made.x.append(static_cast<qint16>(std::lround(x(number * 32 + i))));
        made.y.append(static_cast<qint16>(std::lround(y(number * 32 + i))));
    }
    return made;
}

SampleBlock constantBlock(int number, int x, int y)
{
    return block(
        number, [=](int) { return x; }, [=](int) { return y; });
}

AccelWindow windowOf(const QList<SampleBlock> &blocks, const SensorConfig &sensor = {})
{
    AccelWindow window{AxisTransform(sensor)};
    for (const SampleBlock &made : blocks) {
        window.add(made);
    }
    return window;
}

QList<SampleBlock> quietBlocks(int first, int count)
{
    QList<SampleBlock> made;
    for (int i = first; i < first + count; ++i) {
        made.append(constantBlock(i, 0, 0));
    }
    return made;
}

bool isNear(double a, double b, double allowed = 1e-9)
{
    return std::abs(a - b) <= allowed;
}

} // namespace

class TstAccelWindow : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readyWithTenBlocks();
    void sine();
    void maximumAndDirection_data();
    void maximumAndDirection();
    void scaleTurnsTheSign();
    void axesOfTheSite();
    void rmsOfKnownNumbers();
    void oldSamplesFallOut();
    void partOfABlockFallsOut();
    void gapClearsNothing();
    void clockSetBack();
    void clockSetForward();
    void clear();
    void strangeBlocksAreIgnored();
};

void TstAccelWindow::readyWithTenBlocks()
{
    AccelWindow window = windowOf(quietBlocks(0, 9));
    QVERIFY(!window.statistics());
    window.add(constantBlock(9, 0, 0));
    QVERIFY(window.statistics() == AccelStatistics());
}

/// A whole number of periods of a sine of amplitude A has an RMS of A/√2, two of them at right angles A.
void TstAccelWindow::sine()
{
    constexpr double amplitude = 20000;
    const auto phase = [](int i) { return 2 * std::numbers::pi * i / 32; };
    QList<SampleBlock> blocks;
    for (int i = 0; i < 12; ++i) {
        blocks.append(block(
            i, [&](int k) { return amplitude * std::sin(phase(k)); },
            [&](int k) { return amplitude * std::cos(phase(k)); }));
    }
    const auto statistics = windowOf(blocks).statistics();
    QVERIFY(statistics);
    QVERIFY(isNear(statistics->rmsX, amplitude / std::sqrt(2.0), 0.5));
    QVERIFY(isNear(statistics->rmsY, amplitude / std::sqrt(2.0), 0.5));
    QVERIFY(isNear(statistics->rms, amplitude, 0.5));
    QVERIFY(isNear(statistics->maximum, amplitude, 1));
}

void TstAccelWindow::maximumAndDirection_data()
{
    QTest::addColumn<int>("x");
    QTest::addColumn<int>("y");
    QTest::addColumn<double>("modulus");
    QTest::addColumn<double>("direction");
    QTest::newRow("first quadrant") << 3 << 4 << 5.0 << 53.130102354156;
    QTest::newRow("second quadrant") << -3 << 4 << 5.0 << 126.869897645844;
    QTest::newRow("third quadrant") << -3 << -4 << 5.0 << 233.130102354156;
    QTest::newRow("fourth quadrant") << 3 << -4 << 5.0 << 306.869897645844;
    QTest::newRow("+x") << 7 << 0 << 7.0 << 0.0;
    QTest::newRow("+y") << 0 << 7 << 7.0 << 90.0;
    QTest::newRow("-x") << -7 << 0 << 7.0 << 180.0;
    QTest::newRow("-y") << 0 << -7 << 7.0 << 270.0;
    QTest::newRow("largest raw values") << -32768 << -32768 << 46340.950011841578 << 225.0;
    QTest::newRow("nothing") << 0 << 0 << 0.0 << 0.0;
}

/// One sample among zeros; the axes' own maxima elsewhere must not be put together.
void TstAccelWindow::maximumAndDirection()
{
    QFETCH(int, x);
    QFETCH(int, y);
    QFETCH(double, modulus);
    QFETCH(double, direction);
    QList<SampleBlock> blocks = quietBlocks(0, 12);
    blocks[5].x[17] = static_cast<qint16>(x);
    blocks[5].y[17] = static_cast<qint16>(y);
    blocks[7].x[3] = static_cast<qint16>(x / 2);
    const auto statistics = windowOf(blocks).statistics();
    QVERIFY(statistics);
    QVERIFY(isNear(statistics->maximum, modulus));
    QVERIFY(isNear(statistics->direction, direction));
    QCOMPARE(statistics->maximumX, double(x));
    QCOMPARE(statistics->maximumY, double(y));
}

void TstAccelWindow::scaleTurnsTheSign()
{
    QList<SampleBlock> blocks = quietBlocks(0, 10);
    blocks[2].x[0] = 1000;
    blocks[2].y[0] = 1000;
    for (SampleBlock &made : blocks) {
        made.scale = -0.006;
    }
    const auto statistics = windowOf(blocks).statistics();
    QVERIFY(statistics);
    QVERIFY(isNear(statistics->maximumX, -6) && isNear(statistics->maximumY, -6));
    QVERIFY(isNear(statistics->direction, 225));
    // zeros times a negative scale have no direction either
    const auto quiet = windowOf([] {
                           QList<SampleBlock> made = quietBlocks(0, 10);
                           for (SampleBlock &each : made) {
                               each.scale = -0.006;
                           }
                           return made;
                       }())
                           .statistics();
    QCOMPARE(quiet->direction, 0.0);
}

/// InvY first, then turned by RotX = 90°: X′ = Y, Y′ = −X.
void TstAccelWindow::axesOfTheSite()
{
    SensorConfig sensor;
    sensor.isYInverted = true;
    sensor.rotationX = 90;
    sensor.offsetX = 1000; // of tilt, not of acceleration
    QList<SampleBlock> blocks;
    for (int i = 0; i < 10; ++i) {
        blocks.append(constantBlock(i, 3, 4));
    }
    const auto statistics = windowOf(blocks, sensor).statistics();
    QVERIFY(statistics);
    QVERIFY(isNear(statistics->maximumX, -4) && isNear(statistics->maximumY, -3));
    QVERIFY(isNear(statistics->rmsX, 4) && isNear(statistics->rmsY, 3) && isNear(statistics->rms, 5));
}

/// Half of the samples (6, 0), half (0, −8): rms about zero √18, √32 and √50, though the means are 3 and −4.
void TstAccelWindow::rmsOfKnownNumbers()
{
    QList<SampleBlock> blocks;
    for (int i = 0; i < 10; ++i) {
        blocks.append(i % 2 == 0 ? constantBlock(i, 6, 0) : constantBlock(i, 0, -8));
    }
    const auto statistics = windowOf(blocks).statistics();
    QVERIFY(statistics);
    QVERIFY(isNear(statistics->rmsX, std::sqrt(18.0)));
    QVERIFY(isNear(statistics->rmsY, std::sqrt(32.0)));
    QVERIFY(isNear(statistics->rms, std::sqrt(50.0)));
    QVERIFY(isNear(statistics->direction, 270));
}

/// The peak is sample 10: it is in the window up to sample 609, the end of 600 samples.
void TstAccelWindow::oldSamplesFallOut()
{
    AccelWindow window = windowOf(quietBlocks(0, 0));
    SampleBlock peak = constantBlock(0, 0, 0);
    peak.x[10] = 100;
    window.add(peak);
    for (int i = 1; i <= 18; ++i) { // up to sample 607
        window.add(constantBlock(i, 0, 0));
    }
    QCOMPARE(window.statistics()->maximum, 100.0);
    window.add(constantBlock(19, 0, 0)); // up to sample 639
    QCOMPARE(window.statistics()->maximum, 0.0);
}

/// 600 samples, not whole blocks: of the first block (all 10) the 8 last are left after block 18, then nothing.
void TstAccelWindow::partOfABlockFallsOut()
{
    AccelWindow window = windowOf({constantBlock(0, 10, 0)});
    for (int i = 1; i < 18; ++i) {
        window.add(constantBlock(i, 0, 0));
    }
    QVERIFY(isNear(window.statistics()->rmsX, std::sqrt(32 * 100.0 / 576)));
    window.add(constantBlock(18, 0, 0)); // 608 samples came
    QVERIFY(isNear(window.statistics()->rmsX, std::sqrt(24 * 100.0 / 600)));
    window.add(constantBlock(19, 0, 0));
    QCOMPARE(window.statistics()->rmsX, 0.0);
}

void TstAccelWindow::gapClearsNothing()
{
    QList<SampleBlock> blocks = quietBlocks(0, 8);
    blocks[7].x[0] = 50;
    AccelWindow window = windowOf(blocks);
    SampleBlock after = constantBlock(10, 0, 0);
    after.followsPrevious = false;
    window.add(after);
    QVERIFY(!window.statistics()); // nine
    window.add(constantBlock(11, 0, 0));
    QCOMPARE(window.statistics()->maximum, 50.0);
    // a minute without samples leaves nothing of them
    SampleBlock late = constantBlock(40, 0, 0);
    late.followsPrevious = false;
    window.add(late);
    QVERIFY(!window.statistics());
}

/// The samples of before do not stay until the clock has come that far again.
void TstAccelWindow::clockSetBack()
{
    for (const bool follows : {true, false}) {
        QList<SampleBlock> blocks = quietBlocks(0, 15);
        blocks[14].x[31] = 70;
        AccelWindow window = windowOf(blocks);
        for (int i = 15; i < 34; ++i) {
            SampleBlock made = constantBlock(i, 0, 0);
            made.start -= 1h;
            made.followsPrevious = i > 15 || follows;
            window.add(made);
            const double expected = i < 33 ? 70 : 0; // 18 blocks of 32 after it, 600 samples in all
            QCOMPARE(window.statistics()->maximum, expected);
        }
    }
}

void TstAccelWindow::clockSetForward()
{
    AccelWindow window = windowOf(quietBlocks(0, 15));
    SampleBlock next = constantBlock(15, 0, 0);
    next.start += 1h;
    window.add(next);
    QVERIFY(window.statistics());
}

void TstAccelWindow::clear()
{
    AccelWindow window = windowOf(quietBlocks(0, 15));
    QVERIFY(window.statistics());
    window.clear();
    QVERIFY(!window.statistics());
    window.add(constantBlock(0, 0, 0));
    QVERIFY(!window.statistics());
}

void TstAccelWindow::strangeBlocksAreIgnored()
{
    AccelWindow window = windowOf(quietBlocks(0, 10));
    SampleBlock empty;
    empty.start = noon + 1h;
    window.add(empty);
    SampleBlock still = constantBlock(10, 500, 0);
    still.rate = 0;
    window.add(still);
    still.rate = std::nan("");
    window.add(still);
    QVERIFY(window.statistics() == AccelStatistics());
}

QTEST_GUILESS_MAIN(TstAccelWindow)
#include "tst_accelwindow.moc"
