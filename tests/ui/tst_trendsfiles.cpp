#include "tests/ui/trendsbench.h"

#include <QLabel>
#include <QMenu>
#include <QMessageBox>

using namespace gorizont;
using namespace std::chrono_literals;
using test::present;
using test::temperature;
using test::tiltX;

/// What the page of trends writes, keeps and reads: pictures, tables, layouts, old files.
class TestTrendsFiles : public QObject, protected test::TrendsBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { useOwnSettings(); }
    void init() { begin(); }
    void cleanup() { m_page.reset(); }

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
        QVERIFY(lines.at(1).endsWith(";21,500\r"));
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

private:
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
};

QTEST_MAIN(TestTrendsFiles)
#include "tst_trendsfiles.moc"
