#include "ui/plots/trendspage.h"

#include "tests/ui/plotsource.h"
#include "tests/ui/samplesite.h"
#include "ui/models/sitetreemodel.h"
#include "ui/plots/cursorpair.h"
#include "ui/plots/plottime.h"
#include "ui/plots/trendplot.h"

#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QTableView>
#include <QTemporaryDir>
#include <QTreeView>
#include <QtTest>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

const UtcTime present{1'800'000'000s};
const SeriesKey tiltX{2, Quantity::TiltX};
const QString program = QStringLiteral("Gorizont Server");
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
        QSettings(QSettings::NativeFormat, QSettings::UserScope, program, program).clear();
        m_now = present;
        m_source = std::make_unique<test::PlotSource>();
        m_registry = std::make_unique<SensorRegistry>(test::sampleConfig().lines, StatusRules());
        open();
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

    void whatIsSeenIsSaved()
    {
        m_page->showCurves({temperature});
        answer({{temperature, 0s, {test::reading(present - 2h, 9), test::reading(present - 1min, 21.5)}, {}}});
        QTRY_VERIFY(plot()->hasValues());
        const QString csv = m_settings.filePath(QStringLiteral("a.csv"));
        QVERIFY(m_page->exportTo(csv, TrendsPage::Export::ExcelCsv));
        QFile file(csv);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArrayList lines = file.readAll().split('\n');
        QCOMPARE(lines.size(), 3);
        QVERIFY(lines.at(1).endsWith(";21,5\r"));
        const QString png = m_settings.filePath(QStringLiteral("a.png"));
        QVERIFY(m_page->exportTo(png, TrendsPage::Export::Png));
        QCOMPARE(QImage(png).size(), plot()->size() * plot()->devicePixelRatio());
        const QString pdf = m_settings.filePath(QStringLiteral("a.pdf"));
        QVERIFY(m_page->exportTo(pdf, TrendsPage::Export::Pdf));
        QFile document(pdf);
        QVERIFY(document.open(QIODevice::ReadOnly));
        QVERIFY(document.readAll().startsWith("%PDF-"));
        for (const auto form : {TrendsPage::Export::Png, TrendsPage::Export::Pdf, TrendsPage::Export::IsoCsv}) {
            QVERIFY(!m_page->exportTo(m_settings.filePath(QStringLiteral("none/a")), form));
        }
    }

    void layoutsAreKept()
    {
        m_page->showCurves({tiltX, temperature});
        m_page->follow(10min);
        m_page->keepLayout(QStringLiteral("Fundament & roof"));
        m_page->showCurves({temperature});
        m_page->follow(24h);
        m_page.reset(); // the last state is kept too
        open();
        QCOMPARE(m_page->curves(), QList<SeriesKey>{temperature});
        QCOMPARE(length(), std::chrono::microseconds(24h));
        QAction *kept = layoutAction(QStringLiteral("Fundament && roof"));
        QVERIFY(kept);
        kept->trigger();
        QCOMPARE(m_page->curves(), (QList<SeriesKey>{tiltX, temperature}));
        QCOMPARE(length(), std::chrono::microseconds(10min));
        m_page->keepLayout(QStringLiteral("Fundament & roof"));
        QAction *forget = layoutAction(QStringLiteral("&Delete"))->menu()->actions().constFirst();
        forget->trigger();
        QVERIFY(!layoutAction(QStringLiteral("Fundament && roof")));
    }

    void oldFilesAreShown()
    {
        QDir history(m_settings.path());
        QVERIFY(history.mkpath(QStringLiteral("History")) && history.cd(QStringLiteral("History")));
        QFile file(history.filePath(QStringLiteral("2018_02_data.txt")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        const QByteArray group = "\t  -264.0\t  7200.0\t   21.38\t     0.0\t 0 0000 0000 0000";
        file.write("18:33:03 07.02.18\t3300" + group + group + group + group + "\r\n");
        file.write("18:33:04 07.02.18\t3300" + group + group + group + group + "\r\n");
        file.close();
        m_page->showCurves({{2, Quantity::TiltY}});
        m_page->openOldFiles(history.path());
        auto *back = m_page->findChild<QAction *>(QStringLiteral("archiveAction"));
        QTRY_VERIFY(back->isVisible());
        QTRY_COMPARE(plot()->graphsOf({2, Quantity::TiltY})->line()->dataCount(), 2);
        QCOMPARE(plot()->graphsOf({2, Quantity::TiltY})->line()->data()->at(0)->value, 2.0);
        QVERIFY(!m_page->isFollowing());
        m_registry->update({test::tiltReading(2, 1, 1, SteadyTime())});
        QCOMPARE(plot()->graphsOf({2, Quantity::TiltY})->line()->dataCount(), 2); // the present is not among old files
        const TimeSpan shown = plot()->span();
        QTest::keyClick(plot(), Qt::Key_PageUp);
        QTest::keyClick(plot(), Qt::Key_Home);
        QCOMPARE(plot()->span(), shown);
        const std::size_t asked = m_source->questions.size();
        back->trigger();
        QVERIFY(m_page->isFollowing());
        QCOMPARE(m_source->questions.size(), asked + 1);
    }

    void foldersWithoutFilesAreExplained()
    {
        m_page->openOldFiles(m_settings.filePath(QStringLiteral("none")));
        QTRY_VERIFY(m_page->findChild<QMessageBox *>(QStringLiteral("trendMessage")));
        auto *box = m_page->findChild<QMessageBox *>(QStringLiteral("trendMessage"));
        QVERIFY(box->text().startsWith(QStringLiteral("There are no old records in")));
        box->close();
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
    void open()
    {
        m_page = std::make_unique<TrendsPage>(*m_registry, m_source->source(), nullptr, [this] { return m_now; });
        m_page->resize(1000, 600);
        m_page->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    }
    QAction *layoutAction(const QString &title) const
    {
        auto *menu = m_page->findChild<QMenu *>(QStringLiteral("layoutsMenu"));
        Q_EMIT menu->aboutToShow();
        for (QAction *action : menu->actions()) {
            if (action->text() == title) {
                return action;
            }
        }
        return nullptr;
    }
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
