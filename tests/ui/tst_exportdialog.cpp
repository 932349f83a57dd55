#include "tests/ui/samplesite.h"
#include "tests/ui/slowhistory.h"
#include "ui/history/historypage.h"

#include <QComboBox>
#include <QDateTimeEdit>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>

using namespace gorizont;
using namespace Qt::Literals::StringLiterals;
using test::SlowSource;

/// The export as it is begun from the history page. In UTC.
class TestExportDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { qputenv("TZ", "UTC"); }
    void init()
    {
        QVERIFY((m_folder = std::make_unique<QTemporaryDir>())->isValid());
        m_source = std::make_unique<SlowSource>();
        m_registry = std::make_unique<SensorRegistry>(test::sampleConfig().lines, StatusRules());
        m_page = std::make_unique<HistoryPage>(*m_registry, u"Высотное здание"_s);
        m_page->setSource(m_source->source());
        m_page->resize(1100, 640);
        m_page->QWidget::show();
        QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    }
    void cleanup() { m_page.reset(); }

    void exportWritesAFile()
    {
        m_page->show(2, m_today.addDays(-1), m_today.addDays(-1));
        openExport("days.csv");
        dialogFind<QComboBox>("exportFormat")->setCurrentIndex(1);
        dialogFind<QComboBox>("exportEvery")->setCurrentIndex(2);
        dialogFind<QPushButton>("exportStart")->click();
        QTRY_VERIFY(dialogFind<QPushButton>("exportStart")->isEnabled());
        QVERIFY2(state().startsWith(u"Done, rows: 1. Written: "_s), qPrintable(state()));
        QFile file(m_folder->filePath(u"days.csv"_s));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(
            QString::fromUtf8(file.readAll()),
            u"time,2 IN-D3 tilt-x (arcsec) min,2 IN-D3 tilt-x (arcsec) mean,2 IN-D3 tilt-x (arcsec) max,"
            "2 IN-D3 tilt-y (arcsec) min,2 IN-D3 tilt-y (arcsec) mean,2 IN-D3 tilt-y (arcsec) max\n"
            "%1T00:00:00.000Z,1.000,2.000,3.000,1.000,2.000,3.000\n"_s.arg(m_today.addDays(-1).toString(Qt::ISODate)));
    }

    void exportIsCancelled()
    {
        m_source->isExportFast = false;
        openExport("never.csv");
        auto *cancel = dialogFind<QPushButton>("exportCancel");
        QVERIFY(!cancel->isEnabled());
        dialogFind<QPushButton>("exportStart")->click();
        QVERIFY(dialogFind<QProgressBar>("exportProgress")->isVisible());
        QVERIFY(cancel->isEnabled());
        cancel->click();
        QTRY_COMPARE(state(), u"Cancelled; nothing was written."_s);
        QVERIFY(QDir(m_folder->path()).isEmpty());
    }

    /// The dialog is closed while the archive is silent: nothing waits for it, nothing is left.
    void exportEndsWithItsDialog()
    {
        m_source->isExportFast = false;
        openExport("never.csv");
        dialogFind<QPushButton>("exportStart")->click();
        dialogFind<QPushButton>("exportClose")->click();
        QTRY_VERIFY(!m_page->findChild<QDialog *>(u"exportDialog"_s));
        QVERIFY(QDir(m_folder->path()).isEmpty());
    }

    void nothingIsReplacedUnasked()
    {
        QFile old(m_folder->filePath(u"old.csv"_s));
        QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
        old.close();
        openExport("old.csv");
        dialogFind<QPushButton>("exportStart")->click();
        dialogFind<QPushButton>("replaceNo")->click();
        QVERIFY(old.open(QIODevice::ReadOnly));
        QCOMPARE(old.readAll(), QByteArray("old"));
        QTRY_VERIFY(!m_page->findChild<QMessageBox *>());
        dialogFind<QPushButton>("exportStart")->click();
        dialogFind<QPushButton>("replaceYes")->click();
        QTRY_VERIFY(state().startsWith(u"Done"_s));
    }

    void exportSaysWhatIsWrong()
    {
        openExport("none/there.csv");
        dialogFind<QPushButton>("exportStart")->click();
        QTRY_VERIFY(state().contains(u"cannot be written ("_s));
        dialogFind<QDateTimeEdit>("exportTo")->setDateTime(dialogFind<QDateTimeEdit>("exportFrom")->dateTime());
        dialogFind<QPushButton>("exportStart")->click();
        QTRY_COMPARE(state(), u"The range ends before it begins: set another beginning or end."_s);
        dialogFind<QLineEdit>("exportPath")->clear();
        dialogFind<QPushButton>("exportStart")->click();
        QCOMPARE(state(), u"Name a file to write to."_s);
    }

    void seedHasCodesInsteadOfQuantities()
    {
        openExport("site.csv");
        QVERIFY(dialogFind<QListWidget>("exportQuantities")->isVisible());
        dialogFind<QComboBox>("exportFormat")->setCurrentIndex(2);
        QVERIFY(!dialogFind<QListWidget>("exportQuantities")->isVisible());
        QVERIFY(!dialogFind<QComboBox>("exportEvery")->isEnabled());
        QCOMPARE(dialogFind<QLineEdit>("exportStation")->text(), u"VYSOT"_s);
        QVERIFY(dialogFind<QLineEdit>("exportPath")->text().endsWith(u"site.mseed"_s));
    }

private:
    template <typename T> static T *found(const QWidget &in, const char *name)
    {
        T *found = in.findChild<T *>(QLatin1String(name));
        if (!found) {
            qFatal("no widget %s", name);
        }
        return found;
    }
    template <typename T> T *dialogFind(const char *name) const
    {
        return found<T>(*found<QDialog>(*m_page, "exportDialog"), name);
    }

    QString state() const { return dialogFind<QLabel>("exportState")->text(); }

    void openExport(const char *file) const
    {
        found<QPushButton>(*m_page, "exportButton")->click();
        dialogFind<QLineEdit>("exportPath")->setText(m_folder->filePath(QLatin1String(file)));
    }

    const QDate m_today = QDate::currentDate();
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<SlowSource> m_source;
    std::unique_ptr<SensorRegistry> m_registry;
    std::unique_ptr<HistoryPage> m_page;
};

QTEST_MAIN(TestExportDialog)
#include "tst_exportdialog.moc"
