#include "core/alarms/alarmwatch.h"
#include "ui/mainwindow.h"

#include "tests/ui/contrast.h"
#include "tests/ui/samplesite.h"
#include "translations/translation.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTreeView>
#include <QtTest>

using namespace gorizont;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

/// The upper and the lower panel of the real window, in Russian.
class TestPanels : public QObject
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
        QVERIFY(installTranslation(QStringLiteral("ru")));
        QFile::remove(QSettings(QSettings::NativeFormat, QSettings::UserScope, program, program).fileName());
        m_config = test::sampleConfig();
        open();
    }
    void cleanup() { m_window.reset(); }

    void clicksSortPortsByNumbers()
    {
        const SteadyTime now = std::chrono::steady_clock::now();
        LineStatus first = test::openLine(1, now - 3600s);
        first.bytesSent = 9;
        LineStatus second = test::openLine(2, now - 60s);
        second.bytesSent = 10;
        m_registry->updateLine(first);
        m_registry->updateLine(second);
        press(Qt::Key_1);
        clickHeading("portsTable", 3); // Отправлено
        QCOMPARE(column("portsTable", 3), QStringList({u"0"_s, u"9"_s, u"10"_s}));
        clickHeading("portsTable", 3);
        QCOMPARE(column("portsTable", 3), QStringList({u"10"_s, u"9"_s, u"0"_s}));
        // a port that is not open has no time: last in both directions
        clickHeading("portsTable", 2);
        QCOMPARE(column("portsTable", 0), QStringList({u"COM9"_s, u"COM4"_s, u"COM2"_s}));
        clickHeading("portsTable", 2);
        QCOMPARE(column("portsTable", 0), QStringList({u"COM4"_s, u"COM9"_s, u"COM2"_s}));
    }

    void clicksSortSensors()
    {
        const SteadyTime now = std::chrono::steady_clock::now();
        m_registry->update({test::tiltReading(2, 36000, 0, now), test::tiltReading(3, 3600, 0, now)});
        press(Qt::Key_2);
        clickHeading("sensorsTable", 1); // Mx
        QCOMPARE(column("sensorsTable", 1), QStringList({u"+1.000"_s, u"+10.000"_s, u"—"_s, u"—"_s}));
        clickHeading("sensorsTable", 1);
        QCOMPARE(column("sensorsTable", 1), QStringList({u"+10.000"_s, u"+1.000"_s, u"—"_s, u"—"_s}));
    }

    /// Widths, places, the order of rows and the selected tabs survive a restart; one action undoes what was done to
    /// columns.
    void columnsAndTabsAreKept()
    {
        press(Qt::Key_2);
        press(Qt::Key_7);
        QHeaderView *header = find<QTableView>("sensorsTable")->horizontalHeader();
        header->moveSection(header->visualIndex(8), 1);
        header->resizeSection(1, 111);
        clickHeading("sensorsTable", 2);
        m_window->select(SiteItem::sensor(0));
        m_window->close();
        open();
        header = find<QTableView>("sensorsTable")->horizontalHeader();
        QCOMPARE(find<QTabWidget>("stateTabs")->tabText(find<QTabWidget>("stateTabs")->currentIndex()), u"Датчики"_s);
        QCOMPARE(find<QTabWidget>("infoTabs")->tabText(find<QTabWidget>("infoTabs")->currentIndex()), u"Журнал"_s);
        QCOMPARE(header->visualIndex(8), 1);
        QCOMPARE(header->sectionSize(1), 111);
        QCOMPARE(header->sortIndicatorSection(), 2);
        find<QAction>("restoreAllColumnsAction")->trigger();
        QCOMPARE(header->visualIndex(8), 8);
        QVERIFY(header->sectionSize(1) != 111);
        QCOMPARE(header->sortIndicatorSection(), 0);
    }

    /// Whoever looks at a sensor and comes back finds the tab of the server where he left it.
    void serverTabIsRemembered()
    {
        press(Qt::Key_2);
        m_window->select(SiteItem::sensor(0));
        m_window->select(SiteItem::line(0));
        m_window->select(SiteItem::server());
        QCOMPARE(find<QTabWidget>("stateTabs")->currentIndex(), 1);
        press(Qt::Key_1);
        m_window->select(SiteItem::sensor(0));
        m_window->select(SiteItem::server());
        QCOMPARE(find<QTabWidget>("stateTabs")->currentIndex(), 0);
    }

    void enterOnARowSelectsInTheTree()
    {
        press(Qt::Key_1);
        auto *table = find<QTableView>("portsTable");
        table->setCurrentIndex(table->model()->index(1, 0));
        QTest::keyClick(table, Qt::Key_Return);
        QCOMPARE(find<QTreeView>("siteTree")->currentIndex().data().toString(), u"COM9"_s);
    }

    void keysGoEverywhere()
    {
        const QList<std::pair<Qt::Key, QString>> upper{
            {Qt::Key_1, u"Порты"_s}, {Qt::Key_2, u"Датчики"_s}, {Qt::Key_3, u"Порт"_s}, {Qt::Key_4, u"Датчик"_s}};
        const auto *state = find<QTabWidget>("stateTabs");
        for (const auto &[key, title] : upper) {
            press(key);
            QCOMPARE(state->tabText(state->currentIndex()), title);
        }
        const QList<std::pair<Qt::Key, QString>> lower{
            {Qt::Key_6, u"Измерения"_s}, {Qt::Key_7, u"Журнал"_s}, {Qt::Key_5, u"Настройки"_s}};
        const auto *info = find<QTabWidget>("infoTabs");
        for (const auto &[key, title] : lower) {
            press(key);
            QCOMPARE(info->tabText(info->currentIndex()), title);
        }
    }

    void searchIsLeftByEscape()
    {
        auto *search = find<QLineEdit>("treeSearch");
        QTest::keyClick(m_window.get(), Qt::Key_F, Qt::ControlModifier);
        QCOMPARE(QApplication::focusWidget(), search);
        QTest::keyClicks(search, QStringLiteral("nowhere"));
        QVERIFY(find<QAction>("nothingFound")->isVisible());
        QTest::keyClick(search, Qt::Key_Escape);
        QCOMPARE(QApplication::focusWidget(), find<QTreeView>("siteTree"));
        QTest::keyClick(m_window.get(), Qt::Key_F, Qt::ControlModifier);
        QTest::keyClicks(search, QStringLiteral("[5]")); // all of the old text is selected and replaced
        QVERIFY(!find<QAction>("nothingFound")->isVisible());
        QCOMPARE(find<QTreeView>("siteTree")->currentIndex().data().toString(), u"3 ИН-Д3 [5]"_s);
        QTest::keyClick(search, Qt::Key_Down);
        QCOMPARE(QApplication::focusWidget(), find<QTreeView>("siteTree"));
    }

    /// F5: whoever can try again is told, and what is known is drawn at once.
    void refreshTriesAgain()
    {
        press(Qt::Key_2);
        QSignalSpy retry(m_window.get(), &MainWindow::retryRequested);
        QSignalSpy drawn(find<QTableView>("sensorsTable")->model(), &QAbstractItemModel::dataChanged);
        QTest::keyClick(m_window.get(), Qt::Key_F5);
        QCOMPARE(retry.size(), 1);
        QVERIFY(!drawn.isEmpty());
    }

    void tabOrder()
    {
        QStringList order;
        find<QLineEdit>("treeSearch")->setFocus();
        for (int i = 0; i < 5; ++i) {
            const QWidget *widget = QApplication::focusWidget();
            QVERIFY(widget);
            const bool isNamed = widget->objectName() != QStringLiteral("qt_tabwidget_tabbar");
            order += isNamed ? widget->objectName() : widget->parentWidget()->objectName();
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        }
        QCOMPARE(order, QStringList({u"treeSearch"_s, u"siteTree"_s, u"stateTabs"_s, u"portsTable"_s, u"infoTabs"_s}));
    }

    void mnemonicsDoNotCollide_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("ru") << QStringLiteral("ru");
        QTest::newRow("en") << QStringLiteral("en");
    }
    void mnemonicsDoNotCollide()
    {
        QFETCH(QString, language);
        QVERIFY(installTranslation(language));
        m_config.showsAdvanced = true;
        open();
        QList<QList<QAction *>> groups{
            m_window->menuBar()->actions(), find<QTableView>("portsTable")->actions(),
            find<QTableView>("clientsTable")->actions()};
        for (const QAction *menu : m_window->menuBar()->actions()) {
            groups += menu->menu()->actions();
        }
        for (const QList<QAction *> &group : groups) {
            QStringList taken;
            for (const QAction *action : group) {
                if (!action->isSeparator()) {
                    const QString letter = QKeySequence::mnemonic(action->text()).toString();
                    QVERIFY2(!letter.isEmpty(), qPrintable(action->text()));
                    QVERIFY2(!taken.contains(letter), qPrintable(action->text()));
                    taken += letter;
                }
            }
        }
    }

    /// Desktops switch between light and dark while the program runs; some dark ones leave hints black.
    void everythingIsReadableInLightAndDark()
    {
        const QPalette before = QApplication::palette();
        const QList<std::pair<QColor, QColor>> pairs{
            {Qt::black, Qt::white}, {QColor(252, 252, 252), QColor(27, 30, 32)}};
        for (const auto &[text, base] : pairs) {
            QPalette palette = before;
            palette.setColor(QPalette::Text, text);
            palette.setColor(QPalette::Base, base);
            palette.setColor(QPalette::PlaceholderText, Qt::black);
            QApplication::setPalette(palette);
            for (const char *name : {"treeSearch", "journalSearch"}) {
                const QPalette own = find<QLineEdit>(name)->palette();
                QVERIFY(test::contrast(own.color(QPalette::PlaceholderText), own.color(QPalette::Base)) >= 4.5);
            }
            // a sensor that is off, an explanation, a sentence of the journal
            m_journal->add(JournalKind::Error, u"error"_s);
            const QModelIndex off = find<QTableView>("sensorsTable")->model()->index(3, 0);
            const QModelIndex note = find<QTableView>("settingsTable")->model()->index(1, 2);
            const QModelIndex event = find<QTableView>("journalTable")->model()->index(0, 0);
            for (const QModelIndex &index : {off, note, event}) {
                QVERIFY(test::contrast(index.data(Qt::ForegroundRole).value<QColor>(), base) >= 4.5);
            }
        }
        QApplication::setPalette(before);
    }

    void journalIsFilteredByText()
    {
        press(Qt::Key_7);
        m_journal->add(JournalKind::On, QStringLiteral("COM4 открыт"));
        m_journal->add(JournalKind::Error, QStringLiteral("COM9 не открывается"));
        auto *search = find<QLineEdit>("journalSearch");
        search->setFocus();
        QTest::keyClicks(search, QStringLiteral("com9"));
        QCOMPARE(column("journalTable", 0).size(), 1);
        QVERIFY(column("journalTable", 0).first().endsWith(QStringLiteral("   COM9 не открывается")));
        find<QCheckBox>("showErrors")->click();
        QCOMPARE(column("journalTable", 0).size(), 0);
        QCOMPARE(emptyText("journalTable"), u"Нет событий, подходящих под этот фильтр."_s);
        search->clear();
        QCOMPARE(column("journalTable", 0).size(), 1);
    }

    void emptyPanelsSayWhy()
    {
        m_config.lines.clear();
        m_config.timing.save = 2500ms;
        open();
        QCOMPARE(emptyText("portsTable"), u"В файле настроек нет портов."_s);
        QCOMPARE(emptyText("sensorsTable"), u"В файле настроек нет датчиков."_s);
        QCOMPARE(emptyText("measurementsTable"), u"Измерений пока нет: строка добавляется каждые 2.5 с."_s);
        QCOMPARE(emptyText("journalTable"), u"Событий пока нет."_s);
        for (const Qt::Key key : {Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_4, Qt::Key_5, Qt::Key_6, Qt::Key_7}) {
            press(key);
        }
        QCOMPARE(find<QTreeView>("siteTree")->currentIndex().data().toString(), u"Сервер"_s);
    }

private:
    void open()
    {
        m_window.reset();
        m_alarms.reset();
        m_registry = std::make_unique<SensorRegistry>(m_config.lines, StatusRules());
        m_journal = std::make_unique<Journal>();
        m_alarms = std::make_unique<AlarmWatch>(*m_registry);
        m_window = std::make_unique<MainWindow>(*m_registry, *m_journal, *m_alarms, m_config, QList<Complaint>());
        m_window->resize(1200, 760);
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }

    template <typename T> T *find(const char *name) const
    {
        T *found = m_window->findChild<T *>(QLatin1String(name));
        if (!found) {
            qFatal("no widget %s", name);
        }
        return found;
    }

    void press(Qt::Key key) const { QTest::keyClick(m_window.get(), key, Qt::ControlModifier); }

    void clickHeading(const char *table, int column) const
    {
        const QHeaderView *header = find<QTableView>(table)->horizontalHeader();
        const QPoint place(
            header->sectionViewportPosition(column) + header->sectionSize(column) / 2, header->height() / 2);
        QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, place);
    }

    QStringList column(const char *table, int column) const
    {
        const QAbstractItemModel *model = find<QTableView>(table)->model();
        QStringList cells;
        for (int row = 0; row < model->rowCount(); ++row) {
            cells += model->index(row, column).data().toString();
        }
        return cells;
    }

    QString emptyText(const char *table) const { return find<QTableView>(table)->accessibleDescription(); }

    const QString program = QStringLiteral("Gorizont Server");
    QTemporaryDir m_settings;
    ServerConfig m_config;
    std::unique_ptr<SensorRegistry> m_registry;
    std::unique_ptr<AlarmWatch> m_alarms;
    std::unique_ptr<Journal> m_journal;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(TestPanels)
#include "tst_panels.moc"
