#include "ui/plots/trendspage.h"

#include "tests/ui/plotsource.h"
#include "tests/ui/samplesite.h"
#include "ui/plots/plottime.h"
#include "ui/plots/trendplot.h"

#include <QComboBox>
#include <QLabel>
#include <QTemporaryDir>
#include <QTreeView>
#include <QtTest>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

const UtcTime present{1'800'000'000s};
const SeriesKey tiltX{2, Quantity::TiltX};
const SeriesKey temperature{1, Quantity::Temperature};

} // namespace

/// The page of trends as an operator uses it.
class TestTrendsPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_settings.isValid());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
    }
    void init()
    {
        m_now = present;
        m_source = std::make_unique<test::PlotSource>();
        m_registry = std::make_unique<SensorRegistry>(test::sampleConfig().lines, StatusRules());
        m_page = std::make_unique<TrendsPage>(*m_registry, m_source->source(), nullptr, [this] { return m_now; });
        m_page->resize(1000, 600);
        m_page->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    }
    void cleanup() { m_page.reset(); }

    void anEmptyPageTellsWhatToDo()
    {
        QVERIFY(hint()->isVisible());
        QVERIFY(hint()->text().contains(QStringLiteral("Tick values in the list")));
        QVERIFY(m_source->questions.empty());
        m_page->addSensor(2);
        QVERIFY(!hint()->isVisible()); // it is being read
        answer({});
        QTRY_VERIFY(hint()->isVisible());
        QVERIFY(hint()->text().contains(QStringLiteral("no values in this span")));
    }

    void aTickDrawsACurve()
    {
        auto *tree = m_page->findChild<QTreeView *>(QStringLiteral("curveTree"));
        const QModelIndex sensor = tree->model()->index(1, 0);
        QVERIFY(tree->model()->setData(tree->model()->index(0, 0, sensor), Qt::Checked, Qt::CheckStateRole));
        QCOMPARE(m_page->curves(), QList<SeriesKey>{tiltX});
        QCOMPARE(m_source->questions.size(), 1U);
        answer({{tiltX, 0s, {test::reading(present - 30min, 3600), test::reading(present - 20min, 7200)}, {}}});
        QTRY_VERIFY(plot()->graphsOf(tiltX)->line()->dataCount() == 2);
        QCOMPARE(plot()->graphsOf(tiltX)->line()->data()->at(1)->value, 2.0); // degrees
        QCOMPARE(plot()->legend->itemCount(), 1);
        QVERIFY(plot()->graphsOf(tiltX)->line()->name().startsWith(QStringLiteral("2 ИН-Д3 Mx")));
    }

    void unitsHaveAxesOfTheirOwn()
    {
        const SeriesKey direction{1, Quantity::AccelDirection};
        m_page->showCurves({tiltX, temperature, {2, Quantity::TiltY}, direction});
        QCOMPARE(plot()->axisOf(ValueAxis::Tilt)->axisType(), QCPAxis::atLeft);
        QCOMPARE(plot()->axisOf(ValueAxis::Temperature)->axisType(), QCPAxis::atRight);
        QCOMPARE(plot()->axisOf(ValueAxis::Direction)->axisType(), QCPAxis::atLeft);
        QCOMPARE(plot()->axisRect()->axisCount(QCPAxis::atLeft), 2);
        QCOMPARE(plot()->axisOf(ValueAxis::Temperature)->label(), QStringLiteral("Temperature, °C"));
        m_page->showCurves({temperature});
        QCOMPARE(plot()->axisOf(ValueAxis::Temperature)->axisType(), QCPAxis::atLeft);
        QCOMPARE(plot()->axisRect()->axisCount(QCPAxis::atLeft), 1);
        QVERIFY(!plot()->axisOf(ValueAxis::Tilt));
    }

    void scalesHoldWhatIsSeen()
    {
        m_page->showCurves({temperature});
        answer(
            {{temperature,
              0s,
              {test::reading(present - 90min, 900), test::reading(present - 30min, 20), test::reading(present, 30)},
              {}}});
        QTRY_VERIFY(plot()->hasValues());
        const QCPRange range = plot()->axisOf(ValueAxis::Temperature)->range();
        QVERIFY(range.lower < 20 && range.lower > 18);
        QVERIFY(range.upper > 30 && range.upper < 32);
    }

    void tiltInArcSeconds()
    {
        m_page->showCurves({tiltX});
        answer({{tiltX, 0s, {test::reading(present - 1min, 3600)}, {}}});
        QTRY_COMPARE(plot()->graphsOf(tiltX)->line()->dataCount(), 1);
        auto *units = m_page->findChild<QComboBox *>(QStringLiteral("tiltUnit"));
        units->setCurrentIndex(1);
        Q_EMIT units->activated(1);
        QCOMPARE(plot()->graphsOf(tiltX)->line()->data()->at(0)->value, 3600.0);
        QCOMPARE(plot()->axisOf(ValueAxis::Tilt)->label(), QStringLiteral("Tilt, ″"));
    }

    /// Readings move the edge, and the source is not asked for them.
    void theEdgeFollows()
    {
        m_page->showCurves({tiltX});
        answer({{tiltX, 0s, {test::reading(present - 10s, 0)}, {}}});
        QTRY_COMPARE(plot()->graphsOf(tiltX)->line()->dataCount(), 1);
        m_now += 30s;
        Reading reading = test::tiltReading(2, 7200, 0, SteadyTime());
        reading.time = m_now - 1s;
        m_registry->update({reading});
        QCOMPARE(plot()->graphsOf(tiltX)->line()->dataCount(), 2);
        QTRY_COMPARE(plot()->span().to, m_now);
        QCOMPARE(plot()->span().to - plot()->span().from, std::chrono::microseconds(1h));
        QCOMPARE(plot()->graphsOf(tiltX)->line()->data()->at(1)->value, 2.0);
        QCOMPARE(m_source->questions.size(), 1U);
    }

    void whoLooksAtThePastIsLeftThere()
    {
        QVERIFY(m_page->isFollowing());
        QTest::keyClick(plot(), Qt::Key_Left);
        QVERIFY(!m_page->isFollowing());
        const TimeSpan shown = plot()->span();
        QCOMPARE(shown.to, present - 6min);
        m_now += 5min;
        QTest::qWait(400);
        QCOMPARE(plot()->span(), shown);
        QTest::keyClick(plot(), Qt::Key_End);
        QVERIFY(m_page->isFollowing());
        QCOMPARE(plot()->span().to, m_now);
    }

    void keys()
    {
        QTest::keyClick(plot(), Qt::Key_PageUp);
        QCOMPARE(plot()->span(), (TimeSpan{present - 2h, present - 1h}));
        QTest::keyClick(plot(), Qt::Key_Plus);
        QCOMPARE(length(), std::chrono::microseconds(40min));
        QTest::keyClick(plot(), Qt::Key_Minus);
        QCOMPARE(plot()->span(), (TimeSpan{present - 2h, present - 1h}));
        QTest::keyClick(plot(), Qt::Key_Right);
        QCOMPARE(plot()->span().to, present - 54min);
    }

    /// Zooming at the edge keeps the edge; elsewhere it keeps what is under the mouse.
    void wheel()
    {
        turnWheel(0.25);
        QVERIFY(m_page->isFollowing());
        QCOMPARE(plot()->span().to, present);
        QCOMPARE(length(), std::chrono::microseconds(40min));
        m_page->showSpan({present - 10h, present - 9h});
        const double before = plot()->xAxis->pixelToCoord(xAt(0.25));
        turnWheel(0.25);
        QVERIFY(std::abs(plot()->xAxis->pixelToCoord(xAt(0.25)) - before) < 1e-3);
        QCOMPARE(length(), std::chrono::microseconds(40min));
    }

    void drag()
    {
        plot()->replot();
        const QPoint from(xAt(0.5), plot()->axisRect()->center().y());
        QTest::mousePress(plot(), Qt::LeftButton, {}, from);
        QTest::mouseMove(plot(), from + QPoint(plot()->plotWidth() / 4, 0));
        QTest::mouseRelease(plot(), Qt::LeftButton, {}, from + QPoint(plot()->plotWidth() / 4, 0));
        QVERIFY(!m_page->isFollowing());
        const double moved = std::chrono::duration<double>(present - plot()->span().to).count();
        QVERIFY(std::abs(moved - 900) < 10);
        QCOMPARE(length(), std::chrono::microseconds(1h));
    }

    void aScaleSetByHandStays()
    {
        m_page->showCurves({temperature});
        answer({{temperature, 0s, {test::reading(present - 2min, 20), test::reading(present - 1min, 30)}, {}}});
        QTRY_VERIFY(plot()->hasValues());
        QCPAxis *axis = plot()->axisOf(ValueAxis::Temperature);
        plot()->replot();
        const double before = axis->range().size();
        turnWheelAt(QPointF(plot()->axisRect()->left() - 12, plot()->axisRect()->center().y()));
        QVERIFY(axis->range().size() < 0.7 * before);
        QCOMPARE(length(), std::chrono::microseconds(1h));
        const QCPRange byHand = axis->range();
        QTest::keyClick(plot(), Qt::Key_Left);
        QTest::keyClick(plot(), Qt::Key_End);
        QCOMPARE(axis->range(), byHand);
        QTest::mouseDClick(plot(), Qt::LeftButton, {}, plot()->axisRect()->center());
        QCOMPARE(axis->range().size(), before);
    }

    void ranges()
    {
        for (const auto &[seconds, span] : QList<std::pair<int, std::chrono::microseconds>>{
                 {600, 10min}, {3600, 1h}, {86400, 24h}, {604800, 168h}, {2592000, 720h}, {31536000, 8760h}}) {
            auto *action = m_page->findChild<QAction *>(QStringLiteral("range%1").arg(seconds));
            QVERIFY(action);
            action->trigger();
            QCOMPARE(length(), span);
            QCOMPARE(plot()->span().to, present);
            QVERIFY(action->isChecked());
        }
    }

    void nobodyIsAskedWhileHidden()
    {
        m_page->showCurves({tiltX});
        answer({{tiltX, 0s, {}, {}}});
        m_page->hide();
        m_now += 1h;
        QTest::qWait(500);
        QCOMPARE(m_source->questions.size(), 1U);
        m_page->show();
        QTRY_COMPARE(m_source->questions.size(), 2U);
    }

    void anArchiveThatDoesNotAnswerIsSaid()
    {
        m_page->showCurves({tiltX});
        m_source->questions.clear();
        auto *state = m_page->findChild<QLabel *>(QStringLiteral("trendState"));
        QTRY_VERIFY(state->text().contains(QStringLiteral("does not answer")));
    }

private:
    QLabel *hint() const { return m_page->findChild<QLabel *>(QStringLiteral("trendHint")); }
    TrendPlot *plot() const { return m_page->findChild<TrendPlot *>(QStringLiteral("trendPlot")); }
    std::chrono::microseconds length() const { return plot()->span().to - plot()->span().from; }
    void answer(const QList<Series> &series) { m_source->answer(m_source->questions.size() - 1, series); }
    int xAt(double share) const
    {
        return plot()->axisRect()->left() + static_cast<int>(share * plot()->axisRect()->width());
    }
    void turnWheel(double share) { turnWheelAt(QPointF(xAt(share), plot()->axisRect()->center().y())); }
    void turnWheelAt(const QPointF &position)
    {
        QWheelEvent event(
            position, plot()->mapToGlobal(position), QPoint(), QPoint(0, 120), Qt::NoButton, Qt::NoModifier,
            Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(plot(), &event);
    }

    QTemporaryDir m_settings;
    UtcTime m_now;
    std::unique_ptr<test::PlotSource> m_source;
    std::unique_ptr<SensorRegistry> m_registry;
    std::unique_ptr<TrendsPage> m_page;
};

QTEST_MAIN(TestTrendsPage)
#include "tst_trendspage.moc"
