#include "ui/complaintsdialog.h"
#include "ui/firstrundialog.h"
#include "ui/models/icons.h"

#include <QAbstractButton>
#include <QClipboard>
#include <QGuiApplication>
#include <QPlainTextEdit>
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
