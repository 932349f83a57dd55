#include "ui/complaintsdialog.h"
#include "ui/firstrundialog.h"
#include "ui/models/icons.h"
#include "ui/opctagsdialog.h"
#include "ui/registermapdialog.h"

#include "tests/ui/samplesite.h"

#include <QAbstractButton>
#include <QClipboard>
#include <QFileDialog>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QTableView>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QTextTable>
#include <QtTest>

using namespace gorizont;

class TestDialogs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void complaintsCanBeCopied()
    {
        const Complaint inKey{
            QStringLiteral("Port1"), QStringLiteral("adr2"), 34, QStringLiteral("300 is no address."),
            QStringLiteral("The sensor is off.")};
        const Complaint inFile{{}, {}, 0, QStringLiteral("The file is empty."), QStringLiteral("Defaults are used.")};
        ComplaintsDialog dialog({inKey, inFile});
        const QStringList lines{
            QStringLiteral("[Port1] adr2, line 34: 300 is no address. The sensor is off."),
            QStringLiteral("The file is empty. Defaults are used.")};
        const auto *text = dialog.findChild<QPlainTextEdit *>(QStringLiteral("complaintsText"));
        QCOMPARE(text->toPlainText(), lines.join(QStringLiteral("\n\n")));
        QVERIFY(!dialog.isModal());
        dialog.findChild<QAbstractButton *>(QStringLiteral("complaintsCopy"))->click();
        QCOMPARE(QGuiApplication::clipboard()->text(), lines.join(u'\n'));
    }

    void registerMapShowsASectionAtATime()
    {
        const QString markdown = QStringLiteral(
            "# Map\n\nBefore.\n\n## Unit 3\n\n| Register | Field |\n| --- | --- |\n| 2 | `tilt_x` |\n\n### Part\n\n"
            "#### Sensor \\| 1 <b>\n\nOf the sensor.\n");
        RegisterMapDialog dialog(markdown);
        dialog.show();
        auto *list = dialog.findChild<QListWidget *>(QStringLiteral("registerMapSections"));
        const auto *text = dialog.findChild<QTextBrowser *>(QStringLiteral("registerMapText"));
        QCOMPARE(list->count(), 3);
        QCOMPARE(list->item(2)->text(), QStringLiteral("    Sensor | 1 <b>"));
        QVERIFY(text->toPlainText().contains(QStringLiteral("Before.")));
        list->setCurrentRow(1);
        const auto tables = text->document()->rootFrame()->childFrames();
        QCOMPARE(tables.size(), 1);
        const auto *table = qobject_cast<QTextTable *>(tables.first());
        QVERIFY(table && table->rows() == 2 && table->columns() == 2);
        QVERIFY(!text->toPlainText().contains(QStringLiteral("Before.")));
        list->setCurrentRow(2);
        QCOMPARE(text->toPlainText().trimmed(), QStringLiteral("Sensor | 1 <b>\nOf the sensor."));
        dialog.findChild<QAbstractButton *>(QStringLiteral("registerMapCopy"))->click();
        QCOMPARE(QGuiApplication::clipboard()->text(), markdown);
    }

    void aLongSectionOfTheRegisterMapIsShownAsItIs()
    {
        const QString row = QStringLiteral("| 2 | `tilt_x` |\n");
        RegisterMapDialog dialog(QStringLiteral("# Map\n\n") + row.repeated(5000));
        const auto *text = dialog.findChild<QTextBrowser *>(QStringLiteral("registerMapText"));
        QVERIFY(text->toPlainText().contains(row));
    }

    void registerMapCanBeSaved()
    {
        const QTemporaryDir folder;
        const QString markdown = QStringLiteral("# Карта\n");
        RegisterMapDialog dialog(markdown);
        dialog.show();
        const auto chooses = [&dialog](const QString &path) {
            dialog.findChild<QAbstractButton *>(QStringLiteral("registerMapSave"))->click();
            auto *files = dialog.findChild<QFileDialog *>();
            QVERIFY(files && files->isVisible());
            Q_EMIT files->fileSelected(path);
            files->close();
            QTRY_VERIFY(!dialog.findChild<QFileDialog *>());
        };
        chooses(folder.filePath(QStringLiteral("map.md")));
        QFile file(folder.filePath(QStringLiteral("map.md")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), markdown.toUtf8());
        QVERIFY(!dialog.findChild<QWidget *>(QStringLiteral("registerMapProblem")));
        chooses(folder.filePath(QStringLiteral("nowhere/map.md")));
        QVERIFY(dialog.findChild<QWidget *>(QStringLiteral("registerMapProblem")));
    }

    void opcTagsCanBeFoundCopiedAndSaved()
    {
        const QTemporaryDir folder;
        const QString list = QStringLiteral("[COM5].Sensor_001[AND3][Addr:002].STATE.Restart\tbool\tперезагрузка\n"
                                            "[COM5].Sensor_001[AND3][Addr:002].DATA.Angl_X\tdouble\tугол X\n");
        OpcTagsDialog dialog(list, QStringLiteral("Done: <b>1</b>"));
        dialog.show();
        QCOMPARE(
            dialog.findChild<QLabel *>(QStringLiteral("opcTagsMessage"))->text(), QStringLiteral("Done: <b>1</b>"));
        const QAbstractItemModel *model = dialog.findChild<QTableView *>(QStringLiteral("opcTagsTable"))->model();
        QCOMPARE(model->rowCount(), 2);
        QCOMPARE(
            model->index(0, 0).data().toString(), QStringLiteral("[COM5].Sensor_001[AND3][Addr:002].STATE.Restart"));
        QCOMPARE(model->index(0, 1).data().toString(), QStringLiteral("bool"));
        dialog.findChild<QLineEdit *>(QStringLiteral("opcTagsSearch"))->setText(QStringLiteral("УГОЛ"));
        QCOMPARE(model->rowCount(), 1);
        QCOMPARE(model->index(0, 2).data().toString(), QStringLiteral("угол X"));
        dialog.findChild<QAbstractButton *>(QStringLiteral("opcTagsCopy"))->click();
        QCOMPARE(QGuiApplication::clipboard()->text(), list);
        const auto chooses = [&dialog](const QString &path) {
            dialog.findChild<QAbstractButton *>(QStringLiteral("opcTagsSave"))->click();
            auto *files = dialog.findChild<QFileDialog *>();
            QVERIFY(files && files->isVisible());
            Q_EMIT files->fileSelected(path);
            files->close();
            QTRY_VERIFY(!dialog.findChild<QFileDialog *>());
        };
        chooses(folder.filePath(QStringLiteral("tags.txt")));
        QFile file(folder.filePath(QStringLiteral("tags.txt")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), list.toUtf8());
        chooses(folder.filePath(QStringLiteral("nowhere/tags.txt")));
        QVERIFY(dialog.findChild<QWidget *>(QStringLiteral("opcTagsProblem")));
        OpcTagsDialog silent(list, {});
        QVERIFY(!silent.findChild<QLabel *>(QStringLiteral("opcTagsMessage")));
    }

    void firstRun_data()
    {
        QTest::addColumn<QString>("button");
        QTest::addColumn<int>("choice");
        using Choice = FirstRunDialog::Choice;
        QTest::newRow("demo") << QStringLiteral("startDemo") << static_cast<int>(Choice::StartDemo);
        QTest::newRow("file") << QStringLiteral("chooseFile") << static_cast<int>(Choice::ChooseFile);
        QTest::newRow("quit") << QStringLiteral("quit") << static_cast<int>(Choice::Quit);
    }
    void firstRun()
    {
        QFETCH(QString, button);
        QFETCH(int, choice);
        FirstRunDialog dialog({QStringLiteral("/opt/gorizont/GorizontServer.ini")});
        QCOMPARE(dialog.choice(), FirstRunDialog::Choice::Quit);
        dialog.findChild<QAbstractButton *>(button)->click();
        QCOMPARE(static_cast<int>(dialog.choice()), choice);
    }

    /// Every state has a shape of its own: the outlines differ, not only the colours.
    void statesDifferInShape()
    {
        QSet<QByteArray> outlines;
        for (std::size_t i = 0; i < healthKinds; ++i) {
            const QImage image = icons::state(static_cast<Health>(i)).pixmap(16, 16).toImage();
            QByteArray outline;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    outline += qAlpha(image.pixel(x, y)) > 127 ? '#' : ' ';
                }
            }
            QVERIFY(outline.contains('#'));
            outlines.insert(outline);
        }
        QCOMPARE(outlines.size(), static_cast<qsizetype>(healthKinds));
    }
};

QTEST_MAIN(TestDialogs)
#include "tst_dialogs.moc"
