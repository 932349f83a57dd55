#include "ui/attentionbanner.h"
#include "ui/attentiondialog.h"
#include "ui/models/attentionmodel.h"

#include "core/alarms/alarmtext.h"
#include "core/alarms/alarmwatch.h"
#include "core/values/statustext.h"
#include "tests/ui/modeltext.h"
#include "tests/ui/samplesite.h"
#include "translations/translation.h"

#include <QAbstractButton>
#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QTableView>
#include <QtTest>

using namespace gorizont;

namespace {

Alarm alarm(quint64 id, int number, StatusCode code = StatusCode::NoAnswer)
{
    Alarm alarm;
    alarm.id = id;
    alarm.port = 1;
    alarm.number = number;
    alarm.code = code;
    alarm.title = QStringLiteral("S%1").arg(number);
    return alarm;
}

QStringList titles(const QAbstractItemModel &model)
{
    QStringList list;
    for (int row = 0; row < model.rowCount(); ++row) {
        list += model.index(row, AttentionModel::Subject).data().toString();
    }
    return list;
}

} // namespace

/// Banner and list of the messages for the dispatcher, over the sample site.
class TestAttention : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_registry = std::make_unique<SensorRegistry>(test::sampleConfig().lines, StatusRules());
        m_alarms = std::make_unique<AlarmWatch>(*m_registry);
        for (const int port : {1, 2}) {
            m_registry->updateLine(test::openLine(port, std::chrono::steady_clock::now()));
        }
    }
    void cleanup()
    {
        m_alarms.reset();
        m_registry.reset();
    }

    void bannerSaysWhatIsWrong()
    {
        QWidget window;
        auto *banner = new AttentionBanner(*m_alarms, &window);
        window.show();
        QVERIFY(!banner->isVisible());
        fail(1, 0xA000);
        QTRY_VERIFY(banner->isVisible());
        const auto *text = banner->findChild<QLabel *>(QStringLiteral("attentionText"));
        QCOMPARE(
            text->text(),
            QStringLiteral("АН-Д3 No. 1 (COM4, address 12), Этаж 2: The fan does not work. Check the fan of the "
                           "thermostat: dirt, ice, its cable. The readings may drift."));
        fail(3, 0x4700);
        QTRY_COMPARE(
            text->text(),
            QStringLiteral(
                "2 sensor(s) need attention. The newest message: ИН-Д3 No. 3 (COM9, address 5): CRC errors"));
        lose(1);
        QTRY_COMPARE(
            text->text(),
            QStringLiteral("3 sensor(s) need attention. The newest message: COM4, Moxa UPort 1151: The connection to "
                           "the port is lost; sensors without data: 2"));
        mend(3);
        m_registry->updateLine(test::openLine(1, std::chrono::steady_clock::now()));
        QTRY_VERIFY(!banner->isVisible());
    }

    void bannerAcceptsOnlyWhatItShows()
    {
        AttentionBanner banner(*m_alarms);
        fail(1, 0x3700);
        QTRY_VERIFY(!banner.isHidden());
        fail(2, 0x3700); // the banner has not heard of it yet
        banner.findChild<QAbstractButton *>(QStringLiteral("attentionAccept"))->click();
        QCOMPARE(m_alarms->acknowledgedCount(), 1);
        QCOMPARE(m_alarms->unacknowledged().size(), 1);
        QVERIFY(!banner.isHidden());
        banner.findChild<QAbstractButton *>(QStringLiteral("attentionAccept"))->click();
        QVERIFY(banner.isHidden());
        fail(1, 0x4700); // another fault of a sensor that was accepted
        QTRY_VERIFY(!banner.isHidden());
    }

    void namesFromTheIniAreNoMarkup()
    {
        AttentionBanner banner(*m_alarms);
        QCOMPARE(banner.findChild<QLabel *>(QStringLiteral("attentionText"))->textFormat(), Qt::PlainText);
    }

    void listShowsEverythingAboutAMessage()
    {
        fail(1, 0x7400);
        lose(2);
        const AttentionDialog dialog(*m_registry, *m_alarms);
        const auto *table = dialog.findChild<QTableView *>(QStringLiteral("attentionTable"));
        const QStringList lines = test::modelText(*table->model(), true).split(u'\n');
        QCOMPARE(lines.size(), 3);
        QCOMPARE(lines.at(0), QStringLiteral("Since | Sensor or port | Place | What has happened | What to do"));
        const QRegularExpression clock(QStringLiteral("^\\d\\d:\\d\\d:\\d\\d \\d\\d\\.\\d\\d\\.\\d\\d \\| "));
        QVERIFY(lines.at(1).contains(clock));
        QCOMPARE(
            QString(lines.at(1)).remove(clock),
            QStringLiteral(
                "COM9 | Moxa UPort 1152 | The connection to the port is lost; sensors without data: 1 | Check "
                "the adapter, its cable and its power. The program opens the port again by itself."));
        QCOMPARE(
            QString(lines.at(2)).remove(clock),
            QStringLiteral("АН-Д3 No. 1 (COM4, address 12) | Этаж 2 | The transducer is out of range | Look at the "
                           "structure and at how the sensor is fixed: it is inclined or moves beyond what it can "
                           "measure."));
    }

    void acceptedOnesLeaveTheList()
    {
        fail(1, 0x3700);
        fail(2, 0x3700);
        fail(3, 0x3700);
        AttentionDialog dialog(*m_registry, *m_alarms);
        auto *table = dialog.findChild<QTableView *>(QStringLiteral("attentionTable"));
        auto *accept = dialog.findChild<QAbstractButton *>(QStringLiteral("acceptSelected"));
        const auto *summary = dialog.findChild<QLabel *>(QStringLiteral("attentionSummary"));
        QVERIFY(!accept->isEnabled()); // nothing is selected
        dialog.show();
        QVERIFY(accept->isEnabled());
        QCOMPARE(summary->text(), QStringLiteral("3 sensor(s) need attention"));
        table->sortByColumn(AttentionModel::Subject, Qt::AscendingOrder);
        table->selectRow(1);
        accept->click();
        QCOMPARE(table->model()->rowCount(), 2);
        QCOMPARE(m_alarms->acknowledgedCount(), 1);
        QCOMPARE(summary->text(), QStringLiteral("2 sensor(s) need attention, accepted, not mended yet: 1"));
        QVERIFY(table->model()->index(1, 1).data().toString().contains(QStringLiteral("No. 3")));
        mend(3); // gone without anybody's doing
        QTRY_COMPARE(table->model()->rowCount(), 1);
        dialog.findChild<QAbstractButton *>(QStringLiteral("acceptAll"))->click();
        QCOMPARE(table->model()->rowCount(), 0);
        QCOMPARE(summary->text(), QStringLiteral("There are no messages, accepted, not mended yet: 2"));
        QVERIFY(!dialog.findChild<QAbstractButton *>(QStringLiteral("acceptAll"))->isEnabled());
    }

    void keyboardIsEnough()
    {
        fail(1, 0x3700);
        fail(2, 0x3700);
        fail(3, 0x3700);
        lose(2);
        AttentionDialog dialog(*m_registry, *m_alarms);
        const QSignalSpy chosen(&dialog, &AttentionDialog::chosen);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        auto *table = dialog.findChild<QTableView *>(QStringLiteral("attentionTable"));
        QVERIFY(table->hasFocus());
        QTest::keyClick(table, Qt::Key_Return); // the newest stands first: the port
        QCOMPARE(m_alarms->unacknowledged().size(), 3); // and Enter accepts nothing
        QCOMPARE(chosen.size(), 1);
        QCOMPARE(chosen.at(0).first().value<SiteItem>(), SiteItem::line(1));
        QTest::keySequence(table, QKeySequence::Copy);
        QVERIFY(QGuiApplication::clipboard()->text().contains(QStringLiteral("\tCOM9\tMoxa UPort 1152\t")));
        QTest::keyClick(table, Qt::Key_Space);
        QCOMPARE(m_alarms->unacknowledged().size(), 2);
        QTest::keyClick(table, Qt::Key_Return); // the next row is ready
        QCOMPARE(chosen.at(1).first().value<SiteItem>(), SiteItem::sensor(1));
        QTest::keyClick(table, Qt::Key_Delete);
        QTest::keyClick(table, Qt::Key_Delete);
        QVERIFY(m_alarms->unacknowledged().isEmpty());
        QTest::keyClick(table, Qt::Key_Delete); // nothing is left
        QTest::keyClick(table, Qt::Key_Escape);
        QVERIFY(!dialog.isVisible());
    }

    /// What vanishes under the cursor must not make Delete hit its neighbour.
    void aMessageThatGoesTakesItsSelectionAlong()
    {
        fail(1, 0x3700);
        fail(2, 0x3700);
        AttentionDialog dialog(*m_registry, *m_alarms);
        dialog.show();
        auto *table = dialog.findChild<QTableView *>(QStringLiteral("attentionTable"));
        QVERIFY(table->selectionModel()->isRowSelected(0));
        mend(2);
        QTRY_COMPARE(table->model()->rowCount(), 1);
        QTest::keyClick(table, Qt::Key_Delete);
        QCOMPARE(m_alarms->acknowledgedCount(), 0);
    }

    void modelKeepsRowsThatStay()
    {
        AttentionModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.setAlarms({alarm(1, 1), alarm(2, 2), alarm(3, 3), alarm(5, 5), alarm(6, 6)});
        const QPersistentModelIndex third = model.index(2, AttentionModel::Subject);
        QSignalSpy removed(&model, &QAbstractItemModel::rowsRemoved);
        QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
        QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
        Alarm other = alarm(3, 3);
        other.line = LineState::OpenFailed;
        model.setAlarms({other, alarm(6, 6), alarm(8, 1)});
        QCOMPARE(titles(model), QStringList({QStringLiteral("S3"), QStringLiteral("S6"), QStringLiteral("S1")}));
        QCOMPARE(third.row(), 0);
        QCOMPARE(removed.size(), 2);
        QCOMPARE(changed.size(), 1);
        QCOMPARE(reset.size(), 0);
        model.setAlarms({});
        QCOMPARE(removed.size(), 3); // all at once
        QCOMPARE(model.rowCount(), 0);
    }

    /// N as a number, ports first; the time by what came first even within a second.
    void sorts()
    {
        QSortFilterProxyModel sorted;
        AttentionModel model;
        sorted.setSourceModel(&model);
        sorted.setSortRole(AttentionModel::SortRole);
        Alarm port = alarm(4, 0, StatusCode::PortError);
        port.title = QStringLiteral("COM10");
        model.setAlarms({alarm(1, 10), alarm(2, 2), alarm(3, 1), port});
        sorted.sort(AttentionModel::Subject);
        QCOMPARE(
            titles(sorted),
            QStringList({QStringLiteral("COM10"), QStringLiteral("S1"), QStringLiteral("S2"), QStringLiteral("S10")}));
        sorted.sort(AttentionModel::Began, Qt::DescendingOrder);
        QCOMPARE(
            titles(sorted),
            QStringList({QStringLiteral("COM10"), QStringLiteral("S1"), QStringLiteral("S2"), QStringLiteral("S10")}));
        sorted.sort(AttentionModel::Began);
        QCOMPARE(titles(sorted).first(), QStringLiteral("S10"));
    }

    /// A row has room for every message, however narrow the dialog is.
    void nothingIsCutOff_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("ru") << QStringLiteral("ru");
        QTest::newRow("en") << QStringLiteral("en");
    }
    void nothingIsCutOff()
    {
        QFETCH(QString, language);
        QVERIFY(installTranslation(language));
        AttentionDialog dialog(*m_registry, *m_alarms);
        auto *table = dialog.findChild<QTableView *>(QStringLiteral("attentionTable"));
        dialog.resize(400, 300);
        dialog.show();
        const auto cell = [table](int column) { return table->model()->index(0, column).data().toString(); };
        const auto check = [&] {
            for (int column = 0; column < AttentionModel::ColumnCount; ++column) {
                const int width = table->columnWidth(column) - 2 * 8;
                const QRect needed =
                    table->fontMetrics().boundingRect(QRect(0, 0, width, 1000), Qt::TextWordWrap, cell(column));
                QVERIFY2(needed.height() <= table->rowHeight(0) && needed.width() <= width, qPrintable(cell(column)));
            }
        };
        for (int code = 3; code <= 11; ++code) {
            fail(1, code << 12);
            QTRY_COMPARE(cell(AttentionModel::Meaning), statusText(static_cast<StatusCode>(code)));
            check();
        }
        for (const LineState state : {LineState::Lost, LineState::OpenFailed}) {
            lose(1, state);
            QTRY_COMPARE(cell(AttentionModel::Meaning), alarmtext::meaning(m_alarms->unacknowledged().first()));
            QCOMPARE(cell(AttentionModel::Subject), QStringLiteral("COM4"));
            check();
        }
    }

private:
    void fail(int number, int status)
    {
        Reading reading = test::tiltReading(number, 0, 0, std::chrono::steady_clock::now());
        reading.status = static_cast<quint16>(status);
        m_registry->update({reading});
    }
    void mend(int number) { m_registry->update({test::tiltReading(number, 0, 0, std::chrono::steady_clock::now())}); }
    void lose(int port, LineState state = LineState::Lost)
    {
        LineStatus lost;
        lost.port = port;
        lost.state = state;
        m_registry->updateLine(lost);
    }

    std::unique_ptr<SensorRegistry> m_registry;
    std::unique_ptr<AlarmWatch> m_alarms;
};

QTEST_MAIN(TestAttention)
#include "tst_attention.moc"
