#include "tests/ui/trendsbench.h"
#include "ui/models/sitetreemodel.h"
#include "ui/plots/cursorpair.h"
#include "ui/plots/curvestyle.h"
#include "ui/plots/plottime.h"

#include <QComboBox>
#include <QLabel>
#include <QMimeData>
#include <QTableView>
#include <QTreeView>
#include <QtTest>

using namespace gorizont;
using namespace std::chrono_literals;
using test::present;
using test::temperature;
using test::tiltX;

/// The page of trends as an operator uses it.
class TestTrendsPage : public QObject, protected test::TrendsBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { useOwnSettings(); }
    void init() { begin(); }
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

    /// The desktop turns dark while the program runs: the curves are still told from the background and each other.
    void coloursFollowTheDesktop()
    {
        m_page->showCurves({tiltX});
        answer({{tiltX, 0s, {test::reading(present - 10s, 0)}, {}}});
        QTRY_COMPARE(plot()->graphsOf(tiltX)->line()->dataCount(), 1);
        m_page->findChild<QAction *>(QStringLiteral("cursorsAction"))->trigger();
        QCOMPARE(plot()->graphsOf(tiltX)->line()->pen().color(), curveStyle(0, false).colour);
        QPalette dark(QColor(0x20, 0x22, 0x26));
        m_page->setPalette(dark);
        QCOMPARE(plot()->graphsOf(tiltX)->line()->pen().color(), curveStyle(0, true).colour);
        QCOMPARE(plot()->graphsOf(tiltX)->line()->dataCount(), 1);
        const auto *cursor = plot()->findChild<QCPItemStraightLine *>();
        QCOMPARE(cursor->pen().color(), dark.color(QPalette::Text));
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
        const QPointF to(from + QPoint(plot()->plotWidth() / 4, 0));
        QMouseEvent movement(
            QEvent::MouseMove, to, plot()->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(plot(), &movement);
        QTest::mouseRelease(plot(), Qt::LeftButton, {}, to.toPoint());
        QVERIFY(!m_page->isFollowing());
        const double moved = std::chrono::duration<double>(present - plot()->span().to).count();
        QVERIFY2(std::abs(moved - 900) < 10, qPrintable(QString::number(moved)));
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

    void nothingIsDrawnWhileHidden()
    {
        m_page->showCurves({tiltX});
        answer({{tiltX, 0s, {test::reading(present - 10s, 0)}, {}}});
        QTRY_COMPARE(plot()->graphsOf(tiltX)->line()->dataCount(), 1);
        m_page->hide();
        Reading reading = test::tiltReading(2, 7200, 0, SteadyTime());
        reading.time = present;
        m_registry->update({reading});
        QCOMPARE(plot()->graphsOf(tiltX)->line()->dataCount(), 1);
        m_page->show();
        QCOMPARE(plot()->graphsOf(tiltX)->line()->dataCount(), 2);
    }

    void anArchiveThatDoesNotAnswerIsSaid()
    {
        m_page->showCurves({tiltX});
        m_source->questions.clear();
        auto *state = m_page->findChild<QLabel *>(QStringLiteral("trendState"));
        QTRY_VERIFY(state->text().contains(QStringLiteral("does not answer")));
    }

    void cursorsReadTheCurves()
    {
        m_page->showCurves({temperature, tiltX});
        answer(
            {{temperature,
              0s,
              {test::reading(present - 40min, 20), test::reading(present - 20min, 26),
               test::reading(present - 1min, 3)},
              {}},
             {tiltX, 0s, {}, {}}});
        QTRY_VERIFY(plot()->hasValues());
        auto *table = m_page->findChild<QTableView *>(QStringLiteral("cursorTable"));
        QVERIFY(!table->isVisible());
        m_page->findChild<QAction *>(QStringLiteral("cursorsAction"))->trigger();
        QVERIFY(table->isVisible());
        QTest::qWait(50);
        auto *cursors = m_page->findChild<CursorPair *>();
        QCOMPARE(cursors->first(), present - 40min); // the thirds of an hour
        QCOMPARE(cursors->second(), present - 20min);
        const auto row = [table](int at) {
            QStringList cells;
            for (int column = 0; column < table->model()->columnCount(); ++column) {
                cells += table->model()->index(at, column).data().toString();
            }
            return cells.join(u'|');
        };
        QCOMPARE(
            row(0), QStringLiteral("1 АН-Д3 [Этаж 2] T, °C|20.00|26.00|+6.00|23.00|+18.00|+432.00|20.00|26.00|100.0"));
        QCOMPARE(row(1), QStringLiteral("2 ИН-Д3 Mx, °|—|—|—|—|—|—|—|—|—"));
        auto *moments = m_page->findChild<QLabel *>(QStringLiteral("cursorMoments"));
        QVERIFY(moments->text().endsWith(QStringLiteral("00:20:00")));
        QTest::keyClick(plot(), Qt::Key_Right, Qt::ControlModifier);
        QVERIFY(cursors->first() > present - 40min && cursors->first() < present - 39min);
        QVERIFY(m_page->isFollowing()); // the plot itself has not moved
    }

    void aCursorIsDragged()
    {
        m_page->findChild<QAction *>(QStringLiteral("cursorsAction"))->trigger();
        plot()->replot();
        auto *cursors = m_page->findChild<CursorPair *>();
        const QPoint from(
            qRound(plot()->xAxis->coordToPixel(toKey(cursors->first()))), plot()->axisRect()->center().y());
        QTest::mousePress(plot(), Qt::LeftButton, {}, from + QPoint(3, 0));
        const QPointF to(xAt(0.5), from.y());
        QMouseEvent movement(
            QEvent::MouseMove, to, plot()->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(plot(), &movement);
        QTest::mouseRelease(plot(), Qt::LeftButton, {}, to.toPoint());
        QVERIFY(std::chrono::abs(cursors->first() - (present - 30min)) < 20s);
        QVERIFY(m_page->isFollowing());
    }

    void aSensorIsDropped()
    {
        SiteTreeModel tree(*m_registry);
        const std::unique_ptr<QMimeData> sensor(tree.mimeData({tree.indexOf(SiteItem::sensor(1))}));
        drop(*sensor);
        QCOMPARE(m_page->curves(), (QList<SeriesKey>{tiltX, {2, Quantity::TiltY}}));
        const std::unique_ptr<QMimeData> port(tree.mimeData({tree.indexOf(SiteItem::line(1))}));
        drop(*port);
        QCOMPARE(m_page->curves().size(), 6);
        QMimeData text;
        text.setText(QStringLiteral("3"));
        QDragEnterEvent event({5, 5}, Qt::CopyAction, &text, Qt::LeftButton, Qt::NoModifier);
        event.ignore();
        QCoreApplication::sendEvent(m_page.get(), &event);
        QVERIFY(!event.isAccepted());
    }

private:
    void drop(QMimeData &data)
    {
        QDragEnterEvent enter({500, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        enter.ignore();
        QCoreApplication::sendEvent(m_page.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event({500, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_page.get(), &event);
    }
    QLabel *hint() const { return m_page->findChild<QLabel *>(QStringLiteral("trendHint")); }
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
};

QTEST_MAIN(TestTrendsPage)
#include "tst_trendspage.moc"
