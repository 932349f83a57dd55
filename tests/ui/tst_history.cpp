#include "ui/history/historypage.h"

#include "tests/ui/modeltext.h"
#include "tests/ui/samplesite.h"
#include "tests/ui/slowhistory.h"
#include "ui/history/daycalendar.h"
#include "ui/history/gapmodel.h"
#include "ui/pages/tableview.h"

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QHelpEvent>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QToolTip>
#include <QtTest>

using namespace gorizont;
using test::SlowSource;
using test::utcOf;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

DayCompleteness completeness(int number, QDate day, std::chrono::microseconds valid)
{
    return {number, day, valid, 24h};
}

} // namespace

/// The history page over a source that takes its time. In UTC.
class TestHistory : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { qputenv("TZ", "UTC"); }
    void init()
    {
        m_source = std::make_unique<SlowSource>();
        m_registry = std::make_unique<SensorRegistry>(test::sampleConfig().lines, StatusRules());
        m_page = std::make_unique<HistoryPage>(*m_registry, u"Высотное здание"_s);
        m_page->setSource(m_source->source());
        m_page->resize(1100, 640);
        m_page->QWidget::show();
        QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
        m_calendar = find<DayCalendar>("dayCalendar");
    }
    void cleanup() { m_page.reset(); }

    void withoutArchive()
    {
        HistoryPage page(*m_registry, {});
        page.setSource({});
        page.QWidget::show();
        QVERIFY(QTest::qWaitForWindowExposed(&page));
        const auto *label = page.findChild<QLabel *>(u"noArchive"_s);
        QVERIFY(label->isVisible());
        QVERIFY(label->text().startsWith(u"There is no archive."_s));
        QVERIFY(!page.findChild<DayCalendar *>()->isVisible());
    }

    void asksForWhatItShows()
    {
        const SlowSource::Months &asked = m_source->months.last();
        QCOMPARE(asked.numbers, QList<int>({1, 2, 3, 4}));
        QCOMPARE(asked.first, m_calendar->firstShown());
        QCOMPARE(asked.last, m_calendar->lastShown());
        QVERIFY(asked.first <= m_today && asked.last >= m_today);
        QCOMPARE(m_source->gaps.last().from, utcOf(m_today));
        QCOMPARE(m_source->gaps.last().to, utcOf(m_today.addDays(1)));
        QCOMPARE(find<TableView>("gapTable")->emptyText(), u"Looking for gaps…"_s);
    }

    void otherMonths()
    {
        const QDate first = m_calendar->firstShown();
        find<QWidget>("earlierButton")->setFocus();
        QTest::mouseClick(find<QWidget>("earlierButton"), Qt::LeftButton);
        QCOMPARE(m_source->months.last().first, first.addMonths(-1));
        QTest::mouseClick(find<QWidget>("laterButton"), Qt::LeftButton);
        QCOMPARE(m_source->months.last().first, first);
        const qsizetype asked = m_source->months.size();
        QTest::mouseClick(find<QWidget>("laterButton"), Qt::LeftButton); // there is nothing after today
        QCOMPARE(m_source->months.size(), asked);
    }

    void marksAreShown()
    {
        const QDate yesterday = m_today.addDays(-1);
        m_calendar->choose(yesterday, yesterday);
        m_source->months.last().answer(
            {completeness(1, yesterday, 24h), completeness(2, yesterday, 18h), completeness(3, yesterday, 24h)});
        QTRY_COMPARE(toolTipOf(yesterday).section(u'\n', 1), u"91 % are there\n2 ИН-Д3 [24]: 6:00:00 missing"_s);
        QCOMPARE(colourOf(yesterday), dayColour({22h, 24h, {}}, false));
        QCOMPARE(colourOf(m_today), QColor(m_calendar->palette().color(QPalette::Base)));
        QVERIFY(toolTipOf(m_today).endsWith(u"nothing is known of this day"_s));
    }

    void marks_data()
    {
        QTest::addColumn<std::chrono::microseconds>("valid");
        QTest::addColumn<QString>("percent");
        QTest::newRow("nothing") << std::chrono::microseconds(0) << "0";
        QTest::newRow("hardly anything") << std::chrono::microseconds(1s) << "<1";
        QTest::newRow("most") << std::chrono::microseconds(24h - 1s) << "99";
        QTest::newRow("all") << std::chrono::microseconds(24h) << "100";
    }
    void marks()
    {
        QFETCH(std::chrono::microseconds, valid);
        QFETCH(QString, percent);
        QCOMPARE(percentText({valid, 24h, {}}), percent);
    }

    void gapsInWords()
    {
        const UtcTime midnight = utcOf(m_today);
        GapModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.setSensors({m_registry->sensors()[0].config});
        model.setGaps(
            {{1, midnight, midnight + 90s, GapReason::NoAnswer, {}},
             {1, midnight + 2h, midnight + 3h, GapReason::PortError, u"АН-Д3"_s},
             {9, midnight + 4h, {}, GapReason::ProgramStopped, {}}},
            midnight + 5h);
        const QString date = m_today.toString(u"dd.MM.yy"_s);
        QCOMPARE(
            test::modelText(model, true),
            u"Sensor | From | To | Length | Reason | Filled from\n"
            "1 АН-Д3 [Этаж 2] [12] | 00:00:00 %1 | 00:01:30 %1 | 0:01:30 | no answer | —\n"
            "1 АН-Д3 [Этаж 2] [12] | 02:00:00 %1 | 03:00:00 %1 | 1:00:00 | the port was not available | АН-Д3\n"
            "9 | 04:00:00 %1 | goes on | 1:00:00 | the program was not running | —"_s.arg(date));
        for (int reason = 1; reason <= int(GapReason::Disk); ++reason) {
            QVERIFY(!gapReasonText(static_cast<GapReason>(reason)).isEmpty());
        }
    }

    /// The second question was asked before the first was answered: only its answer is shown.
    void lateAnswersAreForgotten()
    {
        const auto first = m_source->gaps.last();
        QTest::keyClick(m_calendar, Qt::Key_Left);
        const auto second = m_source->gaps.last();
        QCOMPARE(second.from, utcOf(m_today.addDays(-1)));
        QVERIFY(first.promise->isCanceled());
        second.answer({gap(2)});
        QTRY_COMPARE(tabs(), QStringList({u"Gaps (1)"_s, u"Events"_s}));
        first.answer({gap(1), gap(1)});
        QTest::qWait(50);
        QCOMPARE(tabs(), QStringList({u"Gaps (1)"_s, u"Events"_s}));
        QVERIFY(test::modelText(*find<TableView>("gapTable")->model()).startsWith(u"2 ИН-Д3"_s));
    }

    void nothingIsMissing()
    {
        m_source->gaps.last().answer({});
        m_source->events.last().answer({});
        QTRY_COMPARE(find<TableView>("gapTable")->emptyText(), u"Nothing is missing in these days."_s);
        QTRY_COMPARE(find<TableView>("dayEventTable")->emptyText(), u"No events in these days."_s);
        QCOMPARE(tabs(), QStringList({u"Gaps"_s, u"Events"_s}));
    }

    void archiveDoesNotAnswer()
    {
        m_source->months.last().promise->finish();
        m_source->gaps.last().promise->finish();
        m_source->events.last().promise->finish();
        const QString sentence = u"The archive does not answer; F5 asks again."_s;
        QTRY_COMPARE(find<QLabel>("historyTrouble")->text(), sentence);
        QTRY_COMPARE(find<TableView>("gapTable")->emptyText(), sentence);
        QTRY_COMPARE(find<TableView>("dayEventTable")->emptyText(), sentence);
        const qsizetype asked = m_source->months.size();
        m_page->refresh(); // what F5 does in the window
        QCOMPARE(m_source->months.size(), asked + 1);
        m_source->months.last().answer({});
        QTRY_COMPARE(find<QLabel>("historyTrouble")->text(), QString());
    }

    void eventsOfTheDay()
    {
        m_source->events.last().answer(
            {{JournalKind::Error, utcOf(m_today) + 1h, u"Порт COM4 потерян."_s, 1, 0},
             {JournalKind::On, utcOf(m_today) + 2h, u"Порт COM4 открыт."_s, 1, 0}});
        QTRY_COMPARE(tabs().last(), u"Events (2)"_s);
        const QString date = m_today.toString(u"dd.MM.yy"_s);
        QCOMPARE(
            test::modelText(*find<TableView>("dayEventTable")->model()),
            u"01:00:00 %1   Порт COM4 потерян.\n02:00:00 %1   Порт COM4 открыт."_s.arg(date));
        QTest::keyClick(m_calendar, Qt::Key_Left); // and then there is nothing
        m_source->events.last().answer({});
        QTRY_COMPARE(find<TableView>("dayEventTable")->model()->rowCount(), 0);
    }

    void keysOfTheCalendar()
    {
        const QDate day(m_today.year() - 1, 3, 31);
        m_calendar->choose(day, day);
        QVERIFY(m_calendar->firstShown() <= day && m_calendar->lastShown() >= day);
        const auto press = [this](int key, Qt::KeyboardModifiers with = {}) {
            QTest::keyClick(m_calendar, Qt::Key(key), with);
            return std::pair(m_calendar->firstChosen(), m_calendar->lastChosen());
        };
        const auto one = [](QDate date) { return std::pair(date, date); };
        QCOMPARE(press(Qt::Key_Right), one(day.addDays(1)));
        QCOMPARE(press(Qt::Key_Up), one(day.addDays(-6)));
        QCOMPARE(press(Qt::Key_Down), one(day.addDays(1)));
        QCOMPARE(press(Qt::Key_Left), one(day));
        QCOMPARE(press(Qt::Key_PageUp), one(QDate(day.year(), 2, day.addDays(-31).day())));
        QCOMPARE(press(Qt::Key_Home), one(QDate(day.year(), 2, 1)));
        QCOMPARE(press(Qt::Key_End, Qt::ShiftModifier).first, QDate(day.year(), 2, 1));
        QCOMPARE(m_calendar->lastChosen(), QDate(day.year(), 3, 1).addDays(-1));
        QCOMPARE(m_source->gaps.last().to, utcOf(QDate(day.year(), 3, 1)));
        m_calendar->choose(m_today, m_today);
        QCOMPARE(press(Qt::Key_Right), one(m_today)); // the future cannot be chosen
        QVERIFY(find<QLabel>("historyRange")->text().contains(QString::number(m_today.year())));
    }

    void daysAreChosenWithTheMouse()
    {
        const QDate first(m_today.addMonths(-1).year(), m_today.addMonths(-1).month(), 10);
        QTest::mouseClick(m_calendar, Qt::LeftButton, {}, placeOf(first));
        QCOMPARE(m_calendar->firstChosen(), first);
        QTest::mouseClick(m_calendar, Qt::LeftButton, Qt::ShiftModifier, placeOf(first.addDays(3)));
        QCOMPARE(m_calendar->firstChosen(), first);
        QCOMPARE(m_calendar->lastChosen(), first.addDays(3));
    }

    /// The window stays open for weeks: it shows the day it is, not the one it was started on.
    void theDayGoesOn()
    {
        DayCalendar calendar;
        calendar.resize(calendar.minimumSizeHint());
        const QDate later = m_today.addDays(40);
        calendar.setToday(later);
        QCOMPARE(calendar.firstChosen(), later);
        QCOMPARE(calendar.lastChosen(), later);
        QVERIFY(calendar.firstShown() <= later && calendar.lastShown() >= later);
        const QDate chosen = later.addDays(-200);
        calendar.choose(chosen, chosen);
        const QDate shown = calendar.firstShown();
        calendar.setToday(later.addDays(40));
        QCOMPARE(calendar.firstChosen(), chosen); // somebody is busy with that day
        QCOMPARE(calendar.firstShown(), shown);
    }

    void theWheelTurnsMonths()
    {
        const QDate first = m_calendar->firstShown();
        for (int i = 0; i < 7; ++i) {
            turnWheel({0, 15});
        }
        turnWheel({120, 0});
        QCOMPARE(m_calendar->firstShown(), first);
        turnWheel({0, 15});
        QCOMPARE(m_calendar->firstShown(), first.addMonths(-1));
        turnWheel({0, 240});
        QCOMPARE(m_calendar->firstShown(), first.addMonths(-3));
        turnWheel({0, 60});
        turnWheel({0, -120}); // another direction begins anew
        QCOMPARE(m_calendar->firstShown(), first.addMonths(-2));
    }

    /// A part of the window at 200 %: the keys reach every day all the same, and it is in sight.
    void lowWindow()
    {
        QVERIFY(m_page->minimumSizeHint().height() < 260);
        m_page->resize(500, 260);
        m_calendar->setFocus();
        const QDate last = QDate(m_today.year(), m_today.month(), 1).addDays(-1);
        m_calendar->choose(last, last);
        QTRY_VERIFY(m_calendar->visibleRegion().contains(placeOf(last)));
        QTest::keyClick(m_calendar, Qt::Key_Home);
        const QDate first(last.year(), last.month(), 1);
        QCOMPARE(m_calendar->firstChosen(), first);
        QTRY_VERIFY(m_calendar->visibleRegion().contains(placeOf(first)));
    }

    void sensorsAreChosen()
    {
        auto *all = find<QCheckBox>("historySensorsAll");
        auto *list = find<QListWidget>("historySensors");
        list->item(1)->setCheckState(Qt::Unchecked);
        QCOMPARE(m_source->months.last().numbers, QList<int>({1, 3, 4}));
        QCOMPARE(all->checkState(), Qt::PartiallyChecked);
        all->click();
        QCOMPARE(m_source->gaps.last().numbers, QList<int>({1, 2, 3, 4}));
        all->click();
        QCOMPARE(m_source->gaps.last().numbers, QList<int>());
        m_source->gaps.last().answer({});
        QTRY_COMPARE(find<TableView>("gapTable")->emptyText(), u"Choose a sensor on the left."_s);
        QVERIFY(!find<QPushButton>("exportButton")->isEnabled());
        m_page->show(2, m_today.addDays(-3), m_today.addDays(-2));
        QCOMPARE(m_source->gaps.last().numbers, QList<int>({2}));
        QCOMPARE(m_source->gaps.last().from, utcOf(m_today.addDays(-3)));
        QCOMPARE(m_source->gaps.last().to, utcOf(m_today.addDays(-1)));
    }

private:
    static Gap gap(int number)
    {
        return {number, utcOf(QDate::currentDate()), utcOf(QDate::currentDate()) + 60s, GapReason::Crc, {}};
    }

    template <typename T> T *find(const char *name) const
    {
        T *found = m_page->findChild<T *>(QLatin1String(name));
        if (!found) {
            qFatal("no widget %s", name);
        }
        return found;
    }
    QStringList tabs() const
    {
        const auto *lists = find<QTabWidget>("historyLists");
        return {lists->tabText(0), lists->tabText(1)};
    }

    void turnWheel(QPoint delta) const
    {
        const QPointF place = m_calendar->rect().center();
        QWheelEvent event(
            place, m_calendar->mapToGlobal(place), {}, delta, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(m_calendar, &event);
    }

    /// Where the tool tip and the mouse find a day.
    QPoint placeOf(QDate day) const { return m_calendar->dayRect(day).center(); }

    /// Between the frame of a day and its texts.
    QColor colourOf(QDate day) const
    {
        const QPoint place = m_calendar->dayRect(day).topLeft() + QPoint(5, 5);
        return m_calendar->grab().toImage().pixelColor(place);
    }

    QString toolTipOf(QDate day) const
    {
        QToolTip::hideText();
        const QPoint place = placeOf(day);
        QHelpEvent help(QEvent::ToolTip, place, m_calendar->mapToGlobal(place));
        QCoreApplication::sendEvent(m_calendar, &help);
        return QToolTip::text();
    }

    const QDate m_today = QDate::currentDate();
    std::unique_ptr<SlowSource> m_source;
    std::unique_ptr<SensorRegistry> m_registry;
    std::unique_ptr<HistoryPage> m_page;
    DayCalendar *m_calendar = nullptr;
};

QTEST_MAIN(TestHistory)
#include "tst_history.moc"
