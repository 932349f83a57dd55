#include "ui/plots/seriesfeed.h"

#include "tests/ui/plotsource.h"
#include "tests/ui/samplesite.h"

#include <QSignalSpy>
#include <QtTest>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

const UtcTime present{1'800'000'000s};
const SeriesKey tiltX{3, Quantity::TiltX};
const SeriesKey tiltY{3, Quantity::TiltY};

Reading tilt(UtcTime time, double x)
{
    Reading reading = test::tiltReading(3, x, -x, SteadyTime());
    reading.time = time;
    return reading;
}

} // namespace

/// What is asked of a source, when, and what becomes of the answers.
class TestPlotFeed : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_now = present;
        m_source = std::make_unique<test::PlotSource>();
        m_feed = std::make_unique<SeriesFeed>([this] { return m_now; });
        m_feed->setSource(m_source->source(), true);
    }

    void asksAtOnceWithMargins()
    {
        m_feed->want(hour(present));
        QCOMPARE(m_source->questions.size(), 1U);
        const SeriesQuery query = m_source->questions.front().query;
        QCOMPARE(query.keys, QList<SeriesKey>{tiltX});
        QVERIFY(query.from < present - 1h && query.to > present);
        const double wanted = 600.0 / std::chrono::duration<double>(1h).count();
        QVERIFY(query.width / std::chrono::duration<double>(query.to - query.from).count() >= 0.99 * wanted);
        QVERIFY(m_feed->isWaiting());
        QVERIFY(m_feed->history(tiltX).buckets.isEmpty());
    }

    void takesTheAnswer()
    {
        const QSignalSpy changed(m_feed.get(), &SeriesFeed::historyChanged);
        m_feed->want(hour(present));
        const Series series{tiltX, 1min, {test::reading(present - 1min, 5)}, {}};
        m_source->answer(0, {series});
        QTRY_COMPARE(changed.size(), 1);
        QCOMPARE(m_feed->history(tiltX), series);
        QVERIFY(!m_feed->isWaiting());
    }

    /// A hundred movements are one question, and only its answer counts.
    void panningAsksOnce()
    {
        m_feed->want(hour(present));
        m_source->answer(0, {{tiltX, 0s, {test::reading(present, 1)}, {}}});
        QTRY_VERIFY(!m_feed->isWaiting());
        for (int i = 1; i <= 100; ++i) {
            m_feed->want(hour(present - i * 1h));
        }
        QCOMPARE(m_source->questions.size(), 1U);
        QTRY_COMPARE(m_source->questions.size(), 2U);
        QVERIFY(m_source->questions.back().query.from < present - 101h);
        QTest::qWait(200);
        QCOMPARE(m_source->questions.size(), 2U);
    }

    void anOldAnswerIsIgnored()
    {
        m_feed->want(hour(present));
        m_feed->want({{tiltX, tiltY}, present - 1h, present, 600});
        QCOMPARE(m_source->questions.size(), 2U);
        QVERIFY(m_source->questions.front().isCancelled());
        m_source->answer(0, {{tiltX, 0s, {test::reading(present, 1)}, {}}});
        m_source->answer(1, {{tiltX, 0s, {test::reading(present, 2)}, {}}, {tiltY, 0s, {}, {}}});
        QTRY_VERIFY(!m_feed->isWaiting());
        QCOMPARE(m_feed->history(tiltX).buckets.first().mean, 2.0);
    }

    void aSmallMovementAsksNothing()
    {
        m_feed->want(hour(present - 2h));
        m_source->answer(0, {{tiltX, 0s, {}, {}}});
        QTRY_VERIFY(!m_feed->isWaiting());
        m_feed->want(hour(present - 2h - 10min));
        QTest::qWait(200);
        QCOMPARE(m_source->questions.size(), 1U);
        m_feed->want({{tiltX}, present - 150min, present - 149min, 600}); // finer than what is known
        QTRY_COMPARE(m_source->questions.size(), 2U);
    }

    /// The edge lives on the readings; the source is asked again now and then only.
    void theEdgeMovesWithoutTheSource()
    {
        m_feed->want(hour(present));
        m_source->answer(0, {{tiltX, 1min, {test::reading(present - 90s, 5)}, {}}});
        QTRY_VERIFY(!m_feed->isWaiting());
        const QSignalSpy changed(m_feed.get(), &SeriesFeed::liveChanged);
        for (int i = 1; i <= 20; ++i) {
            m_now += 1s;
            m_feed->append({tilt(m_now, i)});
            m_feed->want(hour(m_now));
        }
        QTest::qWait(200);
        QCOMPARE(m_source->questions.size(), 1U);
        QCOMPARE(changed.size(), 20);
        QCOMPARE(m_feed->live(tiltX).size(), 20);
        QCOMPARE(m_feed->live(tiltX).last(), test::reading(m_now, 20));
        m_now += 30s;
        m_feed->want(hour(m_now));
        QTRY_COMPARE(m_source->questions.size(), 2U);
        m_source->answer(1, {{tiltX, 10s, {test::reading(present, 9)}, {}}});
        QTRY_COMPARE(m_feed->live(tiltX).size(), 10); // the first ten seconds are history by now
    }

    /// An archive that needs longer than the edge takes to move on still comes to an end.
    void aSlowAnswerIsWaitedFor()
    {
        m_feed->want(hour(present));
        for (int i = 0; i < 20; ++i) {
            m_now += 1min;
            m_feed->want(hour(m_now));
        }
        QTest::qWait(200);
        QCOMPARE(m_source->questions.size(), 1U);
        QVERIFY(!m_source->questions.front().isCancelled());
        m_source->answer(0, {{tiltX, 0s, {test::reading(present, 5)}, {}}});
        QTRY_VERIFY(!m_feed->isWaiting());
        QCOMPARE(m_feed->history(tiltX).buckets.size(), 1);
        m_feed->want(hour(m_now)); // by now it is old
        QTRY_COMPARE(m_source->questions.size(), 2U);
    }

    /// What was asked of the past says nothing of the present, however little time has gone by.
    void fromThePastToTheEdge()
    {
        m_feed->want(hour(present - 100h));
        m_now += 1ms;
        m_feed->want(hour(m_now));
        QTRY_COMPARE(m_source->questions.size(), 2U);
        QVERIFY(m_source->questions.front().isCancelled());
    }

    void theClockIsSetBack()
    {
        m_feed->want(hour(present));
        m_source->answer(0, {{tiltX, 0s, {}, {}}});
        QTRY_VERIFY(!m_feed->isWaiting());
        m_feed->append({tilt(present, 1)});
        m_now = present - 10min;
        const QSignalSpy redrawn(m_feed.get(), &SeriesFeed::historyChanged);
        m_feed->append({tilt(m_now, 2)});
        QCOMPARE(m_feed->live(tiltX), QList<SeriesBucket>{test::reading(m_now, 2)});
        QCOMPARE(redrawn.size(), 1);
        m_feed->want(hour(m_now)); // what was asked before holds other moments under the same times
        QTRY_COMPARE(m_source->questions.size(), 2U);
    }

    /// Whoever reads for it may stop.
    void itsEndCancelsTheQuestion()
    {
        m_feed->want(hour(present));
        m_feed.reset();
        QVERIFY(m_source->questions.front().isCancelled());
    }

    void whatEndsTheLiveCurve()
    {
        m_feed->want(hour(present));
        Reading silent = tilt(present + 1s, 7);
        silent.isAnswer = false;
        silent.status = 0x3700;
        Reading other = tilt(present + 2s, 8);
        other.number = 2;
        Reading noted = tilt(present + 3s, 7);
        noted.isAnswer = false;
        m_feed->append({tilt(present, 7), silent, other, noted, tilt(present, 7)});
        const QList<SeriesBucket> live = m_feed->live(tiltX);
        QCOMPARE(live.size(), 2);
        QCOMPARE(live.at(0).valid, 1U);
        QCOMPARE(live.at(1), (SeriesBucket{present + 1s, 0, 0, 0, 1, 0}));
    }

    /// Between an old span and the present nobody knows anything: the two are not joined.
    void theEdgeIsNotJoinedToThePast()
    {
        m_feed->want(hour(present - 100h));
        m_source->answer(0, {{tiltX, 0s, {test::reading(present - 100h, 5)}, {}}});
        QTRY_VERIFY(!m_feed->isWaiting());
        m_feed->append({tilt(present, 7)});
        QVERIFY(m_feed->live(tiltX).isEmpty());
    }

    void aSourceThatIsGone()
    {
        m_feed->want(hour(present));
        m_source->questions.clear(); // its promise goes, and with it the future is cancelled
        QTRY_VERIFY(m_feed->hasFailed());
        QVERIFY(!m_feed->isWaiting());
        m_feed->want(hour(present + 1s));
        QTRY_COMPARE(m_source->questions.size(), 1U); // it is asked again
        m_source->answer(0, {{tiltX, 0s, {}, {}}});
        QTRY_VERIFY(!m_feed->hasFailed());
    }

    void withoutASource()
    {
        m_feed->setSource({}, true);
        m_feed->want(hour(present));
        m_feed->append({tilt(present, 7)});
        QCOMPARE(m_feed->live(tiltX).size(), 1);
        QVERIFY(!m_feed->isWaiting());
    }

    void filesHaveNoEdge()
    {
        m_feed->setSource(m_source->source(), false);
        m_feed->want(hour(present));
        m_feed->append({tilt(present, 7)});
        QVERIFY(m_feed->live(tiltX).isEmpty());
    }

    void anotherSourceIsAskedForTheSame()
    {
        m_feed->want(hour(present));
        m_source->answer(0, {{tiltX, 0s, {test::reading(present, 5)}, {}}});
        QTRY_VERIFY(!m_feed->isWaiting());
        test::PlotSource other;
        m_feed->setSource(other.source(), false);
        QVERIFY(m_feed->history(tiltX).buckets.isEmpty());
        QCOMPARE(other.questions.size(), 1U);
        m_feed->setSource({}, true);
    }

private:
    static SeriesFeed::Wish hour(UtcTime to) { return {{tiltX}, to - 1h, to, 600}; }

    UtcTime m_now;
    std::unique_ptr<test::PlotSource> m_source;
    std::unique_ptr<SeriesFeed> m_feed;
};

QTEST_GUILESS_MAIN(TestPlotFeed)
#include "tst_plotfeed.moc"
