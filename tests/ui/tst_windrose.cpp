#include "tests/ui/contrast.h"
#include "tests/ui/weathersite.h"
#include "translations/translation.h"
#include "ui/models/weathertext.h"
#include "ui/models/windrose.h"
#include "ui/weather/windroseview.h"

#include <QtTest>

#include <cmath>
#include <limits>

using namespace gorizont;
using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

/// The arithmetic of the wind: rumbs, classes, calm, time, components.
class TestWindRose : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(installTranslation(u"ru"_s)); }

    void rumbs_data();
    void rumbs();
    void classes_data();
    void classes();
    void calmHasNoDirection();
    void withoutDirectionIsNotCalm();
    void sharesAreOfAllReadings();
    void theFirstOfEqualsPrevails();
    void aTurnTurnsTheRose();
    void samplesComeFromTheMeans();
    void samplesThatAreNone_data();
    void samplesThatAreNone();
    void forgetsWhatIsOld();
    void keepsADay();
    void aClockThatStepsBackLosesNothing();
    void components_data();
    void components();
    void vectorGoesBeforeModulus();
    void componentsNeedBoth();
    void rimIsRound_data();
    void rimIsRound();
    void classNames();
    void strongerWindsStandOutMore_data();
    void strongerWindsStandOutMore();
};

void TestWindRose::rumbs_data()
{
    QTest::addColumn<double>("degrees");
    QTest::addColumn<int>("sector");
    QTest::addColumn<QString>("text");
    QTest::newRow("north") << 0.0 << 0 << u"0° С"_s;
    QTest::newRow("the last before NNE") << 11.24 << 0 << u"11° С"_s;
    QTest::newRow("the first of NNE") << 11.25 << 1 << u"11° ССВ"_s;
    QTest::newRow("east") << 90.0 << 4 << u"90° В"_s;
    QTest::newRow("SSE") << 157.5 << 7 << u"158° ЮЮВ"_s;
    QTest::newRow("south") << 180.0 << 8 << u"180° Ю"_s;
    QTest::newRow("SW") << 225.0 << 10 << u"225° ЮЗ"_s;
    QTest::newRow("west") << 270.0 << 12 << u"270° З"_s;
    QTest::newRow("the last of NNW") << 348.74 << 15 << u"349° ССЗ"_s;
    QTest::newRow("north again") << 348.75 << 0 << u"349° С"_s;
    QTest::newRow("rounded to a whole turn") << 359.7 << 0 << u"0° С"_s;
    QTest::newRow("a whole turn") << 360.0 << 0 << u"0° С"_s;
    QTest::newRow("more than a turn") << 450.0 << 4 << u"90° В"_s;
    QTest::newRow("backwards") << -90.0 << 12 << u"270° З"_s;
    QTest::newRow("a trifle backwards") << -1e-20 << 0 << u"0° С"_s;
}

void TestWindRose::rumbs()
{
    QFETCH(const double, degrees);
    QFETCH(const QString, text);
    QTEST(windrose::sectorOf(degrees), "sector");
    QCOMPARE(weathertext::direction(degrees), text);
    QVERIFY(windrose::normalized(degrees) >= 0 && windrose::normalized(degrees) < 360);
}

void TestWindRose::classes_data()
{
    QTest::addColumn<double>("speed");
    QTest::addColumn<int>("number");
    QTest::newRow("nothing") << 0.0 << -1;
    QTest::newRow("calm") << 0.499 << -1;
    QTest::newRow("no calm") << 0.5 << 0;
    QTest::newRow("below 2") << 1.999 << 0;
    QTest::newRow("2") << 2.0 << 1;
    QTest::newRow("4") << 4.0 << 2;
    QTest::newRow("7") << 7.0 << 3;
    QTest::newRow("11") << 11.0 << 4;
    QTest::newRow("15") << 15.0 << 5;
    QTest::newRow("a hurricane") << 60.0 << 5;
}

void TestWindRose::classes()
{
    QFETCH(const double, speed);
    QTEST(windrose::classOf(speed), "number");
}

void TestWindRose::calmHasNoDirection()
{
    WindCounts counts;
    counts.add(WindSample{90, 0.3, 0.3});
    counts.add(WindSample{{}, 0.1, 0.1});
    QCOMPARE(counts.calm, 2U);
    QCOMPARE(counts.undirected, 0U);
    QCOMPARE(counts.inSector(4), 0U);
    QCOMPARE(counts.prevailing(), std::optional<int>());
}

void TestWindRose::withoutDirectionIsNotCalm()
{
    WindCounts counts;
    counts.add(WindSample{{}, 9, 9});
    QCOMPARE(counts.calm, 0U);
    QCOMPARE(counts.undirected, 1U);
    QCOMPARE(counts.total(), 1U);
}

void TestWindRose::sharesAreOfAllReadings()
{
    WindCounts counts;
    QCOMPARE(counts.share(0), 0.0);
    QCOMPARE(counts.meanSpeed(), std::optional<double>());
    counts.add(WindSample{0, 1, 2});
    counts.add(WindSample{10, 5, 8});
    counts.add(WindSample{180, 6, 6});
    counts.add(WindSample{{}, 0, 0});
    QCOMPARE(counts.total(), 4U);
    QCOMPARE(counts.inSector(0), 2U);
    QCOMPARE(counts.cells[0][0], 1U);
    QCOMPARE(counts.cells[0][2], 1U);
    QCOMPARE(counts.share(counts.inSector(0)), 0.5);
    QCOMPARE(counts.share(counts.calm), 0.25);
    QCOMPARE(counts.prevailing(), std::optional(0));
    QCOMPARE(counts.meanSpeed(), std::optional(3.0));
    QCOMPARE(counts.fastest, 8.0);
}

void TestWindRose::theFirstOfEqualsPrevails()
{
    WindCounts counts;
    counts.add(WindSample{270, 3, 3});
    counts.add(WindSample{90, 3, 3});
    QCOMPARE(counts.prevailing(), std::optional(4));
}

/// Sectors are alike: a wind that is turned by one of them is counted in the next.
void TestWindRose::aTurnTurnsTheRose()
{
    for (int degree = 0; degree < 360; ++degree) {
        const double turned = degree + windrose::sectorWidth;
        QCOMPARE(windrose::sectorOf(turned), (windrose::sectorOf(degree) + 1) % windrose::sectorCount);
    }
}

void TestWindRose::samplesComeFromTheMeans()
{
    const auto sample = WindSample::of(test::sampleWeather());
    QCOMPARE(sample, std::optional(WindSample{225.4, 4.14, 7.35}));
    Weather means = test::sampleWeather();
    means.parameters[5].instant.reset();
    means.parameters[5].maximum.reset();
    means.parameters[5].maxPeriod.reset();
    means.parameters[4].mean.reset();
    QCOMPARE(WindSample::of(means), std::optional(WindSample{{}, 4.14, 4.14}));
}

void TestWindRose::samplesThatAreNone_data()
{
    QTest::addColumn<double>("speed");
    QTest::newRow("negative") << -0.1;
    QTest::newRow("not a number") << std::nan("");
    QTest::newRow("infinite") << std::numeric_limits<double>::infinity();
}

void TestWindRose::samplesThatAreNone()
{
    QFETCH(const double, speed);
    Weather weather = test::sampleWeather();
    weather.parameters[5].mean = speed;
    QVERIFY(!WindSample::of(weather));
    weather.parameters[5].mean.reset();
    QVERIFY(!WindSample::of(weather));
    weather.parameters.removeAt(5);
    QVERIFY(!WindSample::of(weather));
}

void TestWindRose::forgetsWhatIsOld()
{
    const SteadyTime start(100h);
    WindRecord record;
    record.add(start, {0, 3, 3});
    record.add(start + 9min, {90, 3, 3});
    QCOMPARE(record.over(10min, start + 9min).total(), 2U);
    QCOMPARE(record.over(10min, start + 10min).total(), 1U);
    record.add(start + 30min, {180, 3, 3});
    QCOMPARE(record.over(10min, start + 30min).inSector(8), 1U);
    QCOMPARE(record.over(60min, start + 30min).total(), 3U);
    QCOMPARE(record.over(60min, start + 5h).total(), 0U);
}

void TestWindRose::keepsADay()
{
    const SteadyTime start(100h);
    WindRecord record;
    for (auto at = 0min; at < 30h; at += 1min) {
        record.add(start + at, {45, 3, 3});
    }
    QCOMPARE(record.over(WindRecord::longest, start + 30h - 1min).total(), 24U * 60);
    QCOMPARE(record.over(100h, start + 30h - 1min).total(), 24U * 60); // the rest is gone
}

void TestWindRose::aClockThatStepsBackLosesNothing()
{
    const SteadyTime start(100h);
    WindRecord record;
    record.add(start, {0, 3, 3});
    record.add(start - 5min, {0, 3, 3});
    QCOMPARE(record.over(1min, start).total(), 2U);
}

void TestWindRose::components_data()
{
    QTest::addColumn<double>("from");
    QTest::addColumn<QString>("text");
    // The air of a west wind goes east.
    QTest::newRow("north wind") << 0.0 << u"+0.0 -4.0"_s;
    QTest::newRow("east wind") << 90.0 << u"-4.0 +0.0"_s;
    QTest::newRow("south wind") << 180.0 << u"+0.0 +4.0"_s;
    QTest::newRow("west wind") << 270.0 << u"+4.0 +0.0"_s;
    QTest::newRow("from the south west") << 225.0 << u"+2.8 +2.8"_s;
}

void TestWindRose::components()
{
    QFETCH(const double, from);
    Weather weather = test::sampleWeather();
    weather.parameters[4].mean = from;
    weather.parameters[5].mean = 4;
    QTEST(weathertext::components(WindComponents::of(weather)), "text");
}

void TestWindRose::vectorGoesBeforeModulus()
{
    Weather weather = test::sampleWeather();
    weather.parameters[4].mean = 270;
    WeatherParameter vector;
    vector.code = weathercode::windVector;
    vector.mean = 3.5;
    weather.parameters += vector;
    QCOMPARE(WindComponents::of(weather)->u, 3.5);
    weather.parameters.last().mean.reset();
    QCOMPARE(WindComponents::of(weather)->u, 4.14);
}

void TestWindRose::componentsNeedBoth()
{
    Weather weather = test::sampleWeather();
    weather.parameters[4].mean.reset();
    QVERIFY(!WindComponents::of(weather));
    weather = test::sampleWeather();
    weather.parameters[5].mean.reset();
    QVERIFY(!WindComponents::of(weather));
    QCOMPARE(weathertext::components({}), u"—"_s);
}

void TestWindRose::rimIsRound_data()
{
    QTest::addColumn<double>("largest");
    QTest::addColumn<double>("rim");
    QTest::newRow("nothing") << 0.0 << 0.1;
    QTest::newRow("fits") << 0.1 << 0.1;
    QTest::newRow("does not fit") << 0.101 << 0.2;
    QTest::newRow("a half") << 0.5 << 0.6;
    QTest::newRow("always the same") << 1.0 << 1.0;
}

void TestWindRose::rimIsRound()
{
    QFETCH(const double, largest);
    QTEST(WindRoseView::rimShare(largest), "rim");
}

void TestWindRose::classNames()
{
    QCOMPARE(WindRoseView::className(0), u"0.5 – 2 м/с"_s);
    QCOMPARE(WindRoseView::className(5), u"от 15 м/с"_s);
}

void TestWindRose::strongerWindsStandOutMore_data()
{
    QTest::addColumn<QColor>("background");
    QTest::addColumn<bool>("isDark");
    QTest::newRow("light") << QColor(255, 255, 255) << false;
    QTest::newRow("dark") << QColor(30, 30, 34) << true;
}

void TestWindRose::strongerWindsStandOutMore()
{
    QFETCH(const QColor, background);
    QFETCH(const bool, isDark);
    double before = 1.3;
    for (int speedClass = 0; speedClass < windrose::classCount; ++speedClass) {
        const double now = test::contrast(WindRoseView::classColour(speedClass, isDark), background);
        QVERIFY2(now > before, qPrintable(u"%1: %2 after %3"_s.arg(speedClass).arg(now).arg(before)));
        before = 1.1 * now;
    }
    QVERIFY(before > 4.5);
}

QTEST_MAIN(TestWindRose)

#include "tst_windrose.moc"
