#include "ui/models/journalmodel.h"

#include "tests/ui/contrast.h"
#include "tests/ui/modeltext.h"

#include <QAbstractItemModelTester>
#include <QColor>
#include <QtTest>

using namespace gorizont;
using namespace std::chrono_literals;

class TestJournalModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { qputenv("TZ", "UTC"); }

    void entries()
    {
        Journal journal;
        journal.append({JournalKind::On, UtcTime(1518028383s), QStringLiteral("first")});
        JournalModel model(journal);
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        journal.append({JournalKind::Error, UtcTime(1518028384s), QStringLiteral("second")});
        QCOMPARE(
            test::modelText(model),
            QStringLiteral("18:33:03 07.02.18   first\n"
                           "18:33:04 07.02.18   second"));
    }

    /// Green on, blue off, red error; information in the colour of all text, on light and on dark.
    void colours()
    {
        for (const bool isDark : {false, true}) {
            const QColor on = journalColour(JournalKind::On, isDark);
            const QColor off = journalColour(JournalKind::Off, isDark);
            const QColor error = journalColour(JournalKind::Error, isDark);
            QVERIFY(on.green() > on.red() && on.green() > on.blue());
            QVERIFY(off.blue() > off.red() && off.blue() > off.green());
            QVERIFY(error.red() > error.green() && error.red() > error.blue());
            QVERIFY(!journalColour(JournalKind::Info, isDark).isValid());
        }
    }

    void filter()
    {
        Journal journal;
        JournalModel model(journal);
        JournalFilter filter;
        filter.setSourceModel(&model);
        const QAbstractItemModelTester tester(&filter, QAbstractItemModelTester::FailureReportingMode::QtTest);
        for (const JournalKind kind : {JournalKind::Info, JournalKind::On, JournalKind::Off, JournalKind::Error}) {
            journal.append({kind, UtcTime(1518028383s), QString::number(static_cast<int>(kind))});
        }
        QCOMPARE(filter.rowCount(), 4);
        filter.setShown(JournalKind::Info, false);
        filter.setShown(JournalKind::On, false);
        QCOMPARE(
            test::modelText(filter),
            QStringLiteral("18:33:03 07.02.18   2\n"
                           "18:33:03 07.02.18   3"));
        journal.append({JournalKind::Info, UtcTime(), {}});
        QCOMPARE(filter.rowCount(), 2);
        filter.setShown(JournalKind::Info, true);
        QCOMPARE(filter.rowCount(), 4);
    }

    void findsText()
    {
        Journal journal;
        JournalModel model(journal);
        JournalFilter filter;
        filter.setSourceModel(&model);
        QVERIFY(!filter.isFiltering());
        journal.append({JournalKind::Error, UtcTime(1518028383s), QStringLiteral("COM4 не открывается")});
        journal.append({JournalKind::On, UtcTime(1518028384s), QStringLiteral("COM9 открыт")});
        filter.setText(QStringLiteral("  com4 "));
        QCOMPARE(test::modelText(filter), QStringLiteral("18:33:03 07.02.18   COM4 не открывается"));
        filter.setText(QStringLiteral("18:33:04"));
        QCOMPARE(test::modelText(filter), QStringLiteral("18:33:04 07.02.18   COM9 открыт"));
        filter.setShown(JournalKind::On, false);
        QCOMPARE(filter.rowCount(), 0);
        QVERIFY(filter.isFiltering());
        filter.setText({});
        QCOMPARE(filter.rowCount(), 1);
    }

    void coloursStandOut()
    {
        for (const JournalKind kind : {JournalKind::On, JournalKind::Off, JournalKind::Error}) {
            QVERIFY(test::contrast(journalColour(kind, false), Qt::white) >= 4.5);
            QVERIFY(test::contrast(journalColour(kind, true), QColor(0x2d, 0x2d, 0x2d)) >= 4.5);
        }
    }

    void dropsWhatTheJournalDrops()
    {
        Journal journal;
        JournalModel model(journal);
        JournalFilter filter;
        filter.setSourceModel(&model);
        for (std::size_t i = 0; i < Journal::capacity + 3; ++i) {
            journal.append({JournalKind::Info, UtcTime(1518028383s), QString::number(i)});
        }
        QCOMPARE(model.rowCount(), static_cast<int>(Journal::capacity));
        QCOMPARE(filter.rowCount(), static_cast<int>(Journal::capacity));
        QCOMPARE(model.index(0, 0).data().toString(), QStringLiteral("18:33:03 07.02.18   3"));
        QCOMPARE(filter.index(filter.rowCount() - 1, 0).data().toString(), QStringLiteral("18:33:03 07.02.18   10002"));
    }
};

QTEST_MAIN(TestJournalModel)
#include "tst_journalmodel.moc"
