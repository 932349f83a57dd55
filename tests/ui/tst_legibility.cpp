#include "core/alarms/alarmwatch.h"
#include "ui/mainwindow.h"

#include "tests/ui/samplesite.h"
#include "translations/translation.h"
#include "ui/pages/tablecolumns.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QtTest>

using namespace gorizont;

/// Nothing of the window is cut off, in either language. ctest runs it at every scale (QT_SCALE_FACTOR).
class TestLegibility : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_settings.isValid());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
        qInfo("scale %.2f", qGuiApp->devicePixelRatio());
    }

    void windows_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QSize>("size");
        for (const char *language : {"ru", "en"}) {
            QTest::addRow("%s on a desktop", language) << QString::fromLatin1(language) << QSize(1340, 800);
            QTest::addRow("%s on Full HD at 200 %%", language) << QString::fromLatin1(language) << QSize(960, 500);
        }
    }
    void windows()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        QVERIFY(installTranslation(language));
        ServerConfig config = test::sampleConfig();
        config.showsAdvanced = true;
        SensorRegistry registry(config.lines, StatusRules());
        Journal journal;
        const SteadyTime now = std::chrono::steady_clock::now();
        registry.updateLine(test::openLine(1, now));
        registry.update({test::sampleReading(now)});
        AlarmWatch alarms(registry);
        MainWindow window(registry, journal, alarms, config, {});
        window.appendMeasurement(QStringLiteral(
            "18:33:03 07.02.18\t3300\t  -264.0\t -6644.6\t\t     0.0\t 0 0011 0011 1000\t -3599.5\t -3599.5\t   21.38"
            "\t     0.0\t10 0000 0001 0100"));
        window.setServerStatus(QStringLiteral("Modbus TCP: 502"));
        window.resize(size);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QCOMPARE(window.size(), size); // the least the panels need is less than this
        for (const SiteItem item : {SiteItem::server(), SiteItem::line(0), SiteItem::sensor(0), SiteItem::sensor(1)}) {
            window.select(item);
            for (const char *action : {"goAction5", "goAction6", "goAction7"}) {
                window.findChild<QAction *>(QLatin1String(action))->trigger();
                QCoreApplication::processEvents();
                QCOMPARE(cutOff(window), QString());
            }
            if (item == SiteItem::server()) {
                for (const char *action : {"goAction2", "goAction9"}) {
                    window.findChild<QAction *>(QLatin1String(action))->trigger();
                    QCoreApplication::processEvents();
                    QCOMPARE(cutOff(window), QString());
                }
            }
        }
    }

    /// The test itself sees what is cut off.
    void findsWhatIsCutOff()
    {
        QWidget window;
        QLabel label(QStringLiteral("a sentence"), &window);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        label.resize(label.sizeHint());
        QCOMPARE(cutOff(window), QString());
        label.resize(20, 20);
        QCOMPARE(cutOff(window), QStringLiteral("a sentence"));
    }

private:
    /// The texts, divided by `; `.
    static QString cutOff(const QWidget &window)
    {
        QStringList list;
        for (const QWidget *widget : window.findChildren<QWidget *>()) {
            if (!widget->isVisible()) {
                continue;
            }
            if (const auto *label = qobject_cast<const QLabel *>(widget)) {
                addIf(list, !label->wordWrap() && label->width() < label->sizeHint().width(), label->text());
            } else if (const auto *box = qobject_cast<const QCheckBox *>(widget)) {
                addIf(list, box->width() < box->sizeHint().width(), box->text());
            } else if (const auto *tabs = qobject_cast<const QTabBar *>(widget)) {
                addIf(list, tabs->width() < tabs->sizeHint().width(), tabs->tabText(0));
            } else if (const auto *edit = qobject_cast<const QLineEdit *>(widget)) {
                constexpr int frame = 12;
                const int wanted = edit->fontMetrics().horizontalAdvance(edit->placeholderText()) + frame;
                addIf(list, edit->width() < wanted, edit->placeholderText());
            } else if (const auto *table = qobject_cast<const QTableView *>(widget)) {
                addTable(list, *table);
            }
        }
        return list.join(QStringLiteral("; "));
    }

    static void addIf(QStringList &list, bool isCutOff, const QString &text)
    {
        if (isCutOff && !text.isEmpty()) {
            list += text;
        }
    }

    /// Headings with room for the sort mark; names of parameters, which nobody should have to guess.
    static void addTable(QStringList &list, const QTableView &table)
    {
        const QHeaderView *header = table.horizontalHeader();
        constexpr int margins = 2 * TableColumns::sideMargin;
        const int mark = table.isSortingEnabled() ? header->style()->pixelMetric(QStyle::PM_HeaderMarkSize) : 0;
        for (int column = 0; column < header->count() && !header->isHidden(); ++column) {
            const QString text = table.model()->headerData(column, Qt::Horizontal).toString();
            const int wanted = header->fontMetrics().horizontalAdvance(text) + mark + margins;
            addIf(list, header->sectionSize(column) < wanted, text);
        }
        if (table.objectName() == QStringLiteral("measurementsTable")) {
            for (int column = 0; column < header->count(); ++column) {
                const QModelIndex cell = table.model()->index(0, column);
                const QFontMetrics metrics(cell.data(Qt::FontRole).value<QFont>());
                const int wanted = metrics.horizontalAdvance(cell.data().toString()) + margins;
                addIf(list, table.columnWidth(column) < wanted, cell.data().toString());
            }
        } else if (table.objectName() != QStringLiteral("journalTable")) {
            for (int row = 0; row < table.model()->rowCount(); ++row) {
                const QModelIndex cell = table.model()->index(row, 0);
                const int icon = cell.data(Qt::DecorationRole).isNull() ? 0 : table.iconSize().width();
                const int wanted = table.fontMetrics().horizontalAdvance(cell.data().toString()) + icon + margins;
                const bool mayElide = table.textElideMode() == Qt::ElideMiddle; // its ends tell rows apart
                addIf(
                    list, !mayElide && table.columnSpan(row, 0) == 1 && table.columnWidth(0) < wanted,
                    cell.data().toString());
            }
        }
    }

    QTemporaryDir m_settings;
};

QTEST_MAIN(TestLegibility)
#include "tst_legibility.moc"
