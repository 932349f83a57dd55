#include "core/alarms/alarmwatch.h"
#include "ui/mainwindow.h"
#include "ui/models/clientmodel.h"
#include "ui/pages/tableview.h"

#include "tests/ui/modeltext.h"
#include "tests/ui/samplesite.h"
#include "translations/translation.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QHeaderView>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QtTest>

using namespace gorizont;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr UtcTime start(1700000000s); // 22:13:20 14.11.23 UTC

ClientInfo client(const char *address, quint16 port)
{
    ClientInfo info;
    info.address = QHostAddress(QString::fromLatin1(address));
    info.port = port;
    info.since = start;
    return info;
}

ClientInfo busyClient()
{
    ClientInfo info = client("192.168.1.20", 50211);
    info.lastRequest = start + 100s;
    info.requests = 1234;
    info.errors = 5;
    info.bytesReceived = 14808;
    info.bytesSent = 9876543210;
    return info;
}

const QString modbus = u"Modbus TCP"_s;
const QString adc24 = u"ADC24 TCP"_s;

} // namespace

/// The tab <Клиенты> in the real window, in Russian.
class TestClients : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        qputenv("TZ", "UTC");
        QVERIFY(m_settings.isValid());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
        QVERIFY(installTranslation(u"ru"_s));
    }
    void init()
    {
        QFile::remove(QSettings(QSettings::NativeFormat, QSettings::UserScope, program, program).fileName());
        m_config = test::sampleConfig();
        m_config.showsAdvanced = true;
        open();
    }
    void cleanup() { m_window.reset(); }

    void rows()
    {
        ClientModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.refresh(start + 165s);
        model.setClients(modbus, {busyClient(), client("fe80::1", 7)});
        model.setClients(adc24, {client("10.0.0.3", 65535)});
        QCOMPARE(
            test::modelText(model, true),
            u"Сервер | Клиент | Подключён | Запросов | Последний | Ошибок | Принято | Отправлено\n"
            "Modbus TCP | 192.168.1.20:50211 | 22:13:20 14.11.23 | 1234 | 01:05 | 5 | 14808 | 9876543210\n"
            "Modbus TCP | [fe80::1]:7 | 22:13:20 14.11.23 | 0 | — | 0 | 0 | 0\n"
            "ADC24 TCP | 10.0.0.3:65535 | 22:13:20 14.11.23 | 0 | — | 0 | 0 | 0"_s);
        model.refresh(start + 100s + 1h);
        QCOMPARE(model.index(0, ClientModel::LastRequest).data().toString(), u"1:00:00"_s);
        model.refresh(start); // the clock was set back
        QCOMPARE(model.index(0, ClientModel::LastRequest).data().toString(), u"00:00"_s);
    }

    void everyHeadingExplainsItself()
    {
        const ClientModel model;
        for (int column = 0; column < model.columnCount(); ++column) {
            QVERIFY(!model.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty());
        }
    }

    /// Once a second the list comes anew: whoever is still there keeps his row, and with it the selection.
    void rowsFollowTheirClients()
    {
        ClientModel model;
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.setClients(modbus, {client("10.0.0.1", 1), client("10.0.0.2", 2), client("10.0.0.3", 3)});
        model.setClients(adc24, {client("10.0.0.1", 1)});
        const QPersistentModelIndex third(model.index(2, ClientModel::Address));
        ClientInfo asked = client("10.0.0.3", 3);
        asked.requests = 9;
        model.setClients(modbus, {client("10.0.0.1", 1), asked, client("10.0.0.2", 4)});
        QVERIFY(third.isValid());
        QCOMPARE(third.row(), 1);
        QCOMPARE(addresses(model), QStringList({u"10.0.0.1:1"_s, u"10.0.0.3:3"_s, u"10.0.0.1:1"_s, u"10.0.0.2:4"_s}));
        QCOMPARE(model.index(1, ClientModel::Requests).data().toString(), u"9"_s);
        model.setClients(modbus, {});
        QVERIFY(!third.isValid());
        QCOMPARE(test::modelText(model), u"ADC24 TCP | 10.0.0.1:1 | 22:13:20 14.11.23 | 0 | — | 0 | 0 | 0"_s);
        model.setClients(adc24, {});
        QCOMPARE(model.rowCount(), 0);
    }

    void tabIsOneOfTheServer()
    {
        const auto *tabs = find<QTabWidget>("stateTabs");
        QCOMPARE(visibleTabs(), QStringList({u"Порты"_s, u"Датчики"_s, u"Клиенты"_s}));
        QTest::keyClick(m_window.get(), Qt::Key_9, Qt::ControlModifier);
        QCOMPARE(tabs->tabText(tabs->currentIndex()), u"Клиенты"_s);
        QCOMPARE(find<TableView>("clientsTable")->emptyText(), u"Никто не подключён."_s);
        m_window->select(SiteItem::line(0));
        QCOMPARE(visibleTabs(), QStringList(u"Порт"_s));
        m_window->select(SiteItem::server());
        QCOMPARE(tabs->tabText(tabs->currentIndex()), u"Клиенты"_s);
    }

    /// ShowAdvanced=0 knows no such tab, also when it was the last one that was seen.
    void tabIsForAdvancedUsers()
    {
        showClients();
        m_window->close();
        open();
        const auto *tabs = find<QTabWidget>("stateTabs");
        QCOMPARE(tabs->tabText(tabs->currentIndex()), u"Клиенты"_s);
        m_window->close();
        m_config.showsAdvanced = false;
        open();
        m_window->setClients(modbus, {busyClient()});
        QCOMPARE(visibleTabs(), QStringList({u"Порты"_s, u"Датчики"_s}));
        QCOMPARE(find<QTabWidget>("stateTabs")->currentIndex(), 0);
        QVERIFY(!m_window->findChild<QAction *>(u"goAction9"_s));
    }

    void clicksSortByNumbers()
    {
        ClientInfo few = client("10.0.0.10", 80);
        few.requests = 9;
        few.lastRequest = start + 5s;
        ClientInfo many = client("10.0.0.9", 80);
        many.requests = 10;
        many.lastRequest = start + 1s;
        m_window->setClients(modbus, {few, many, client("10.0.0.9", 9)});
        showClients();
        const QAbstractItemModel &shown = *find<TableView>("clientsTable")->model();
        clickHeading(ClientModel::Address);
        QCOMPARE(addresses(shown), QStringList({u"10.0.0.9:9"_s, u"10.0.0.9:80"_s, u"10.0.0.10:80"_s}));
        clickHeading(ClientModel::Requests);
        QCOMPARE(addresses(shown), QStringList({u"10.0.0.9:9"_s, u"10.0.0.10:80"_s, u"10.0.0.9:80"_s}));
        // the youngest request first; who has asked nothing is last in both directions
        clickHeading(ClientModel::LastRequest);
        QCOMPARE(addresses(shown), QStringList({u"10.0.0.10:80"_s, u"10.0.0.9:80"_s, u"10.0.0.9:9"_s}));
        clickHeading(ClientModel::LastRequest);
        QCOMPARE(addresses(shown), QStringList({u"10.0.0.9:80"_s, u"10.0.0.10:80"_s, u"10.0.0.9:9"_s}));
    }

    void tableIsCopiedAndItsColumnsAreKept()
    {
        m_window->setClients(modbus, {client("10.0.0.1", 1)});
        showClients();
        auto *table = find<TableView>("clientsTable");
        QVERIFY(table->tableAsText().endsWith(u"\nModbus TCP\t10.0.0.1:1\t22:13:20 14.11.23\t0\t—\t0\t0\t0"_s));
        table->horizontalHeader()->moveSection(5, 0);
        table->horizontalHeader()->resizeSection(ClientModel::Since, 222);
        m_window->close();
        open();
        QCOMPARE(find<TableView>("clientsTable")->horizontalHeader()->visualIndex(5), 0);
        QCOMPARE(find<TableView>("clientsTable")->columnWidth(ClientModel::Since), 222);
    }

    /// Nobody is cut off without a question, and the question stops nothing: the list goes on changing below it.
    void clientIsCutOff()
    {
        QSignalSpy dismissed(m_window.get(), &MainWindow::clientDismissed);
        m_window->setClients(modbus, {client("10.0.0.1", 1), busyClient()});
        showClients();
        auto *button = find<QPushButton>("dismissButton");
        QVERIFY(!button->isEnabled());
        QVERIFY(!find<QAction>("dismissAction")->isEnabled());
        find<TableView>("clientsTable")->selectRow(1);
        QVERIFY(button->isEnabled());
        button->click();
        QCOMPARE(
            find<QMessageBox>("dismissQuestion")->text(), u"Отключить клиента 192.168.1.20:50211 от Modbus TCP?"_s);
        find<QPushButton>("dismissNo")->click();
        QTRY_VERIFY(!m_window->findChild<QMessageBox *>(u"dismissQuestion"_s));
        QCOMPARE(dismissed.size(), 0);

        find<QAction>("dismissAction")->trigger();
        find<QAction>("dismissAction")->trigger();
        QCOMPARE(m_window->findChildren<QMessageBox *>(u"dismissQuestion"_s).size(), 1);
        m_window->setClients(modbus, {});
        QVERIFY(!button->isEnabled());
        find<QPushButton>("dismissYes")->click();
        QCOMPARE(dismissed.size(), 1);
        QCOMPARE(dismissed.first().at(0).toString(), modbus);
        QCOMPARE(dismissed.first().at(1).value<QHostAddress>(), QHostAddress(u"192.168.1.20"_s));
        QCOMPARE(dismissed.first().at(2).value<quint16>(), quint16(50211));
    }

    void severalAreCutOffAtOnce()
    {
        QSignalSpy dismissed(m_window.get(), &MainWindow::clientDismissed);
        m_window->setClients(modbus, {client("10.0.0.1", 1), client("10.0.0.2", 2)});
        m_window->setClients(adc24, {client("10.0.0.2", 2)});
        showClients();
        auto *table = find<TableView>("clientsTable");
        table->setFocus();
        table->selectAll();
        QTest::keyClick(table, Qt::Key_Delete);
        QCOMPARE(find<QMessageBox>("dismissQuestion")->text(), u"Отключить 3 клиентов?"_s);
        find<QPushButton>("dismissYes")->click();
        QStringList all;
        for (const QList<QVariant> &one : dismissed) {
            all += one.at(0).toString() + u' ' + one.at(2).toString();
        }
        all.sort();
        QCOMPARE(all, QStringList({u"ADC24 TCP 2"_s, u"Modbus TCP 1"_s, u"Modbus TCP 2"_s}));
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

    void showClients() const { find<QAction>("goAction9")->trigger(); }

    QStringList visibleTabs() const
    {
        const auto *tabs = find<QTabWidget>("stateTabs");
        QStringList titles;
        for (int i = 0; i < tabs->count(); ++i) {
            if (tabs->isTabVisible(i)) {
                titles += tabs->tabText(i);
            }
        }
        return titles;
    }

    static QStringList addresses(const QAbstractItemModel &model)
    {
        QStringList cells;
        for (int row = 0; row < model.rowCount(); ++row) {
            cells += model.index(row, ClientModel::Address).data().toString();
        }
        return cells;
    }

    void clickHeading(int column) const
    {
        const QHeaderView *header = find<TableView>("clientsTable")->horizontalHeader();
        const QPoint place(
            header->sectionViewportPosition(column) + header->sectionSize(column) / 2, header->height() / 2);
        QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, place);
    }

    const QString program = u"Gorizont Server"_s;
    QTemporaryDir m_settings;
    ServerConfig m_config;
    std::unique_ptr<SensorRegistry> m_registry;
    std::unique_ptr<AlarmWatch> m_alarms;
    std::unique_ptr<Journal> m_journal;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(TestClients)
#include "tst_clients.moc"
