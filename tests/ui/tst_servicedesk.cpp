#include "core/alarms/alarmwatch.h"
#include "tests/ui/servicebench.h"
#include "ui/mainwindow.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTreeView>
#include <QtTest>

using namespace gorizont;
using namespace gorizont::test;

/// The way from the main window to a service window and back: menus, warning, several ports.
class TestServiceDesk : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_settings.isValid());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
    }

    /// COM16 with an ИН-Д3, COM17 with an АН-Д3, an УСМ-ИСН and a МК-14, COM18 off.
    void init()
    {
        const QList<SensorConfig> inclinometers{serviceSensor(SensorType::InD, 1, 1, 11)};
        const QList<SensorConfig> accelerometers{
            serviceSensor(SensorType::AnD3, 1, 2, 5), serviceSensor(SensorType::UsmIsn, 2, 4, 9),
            serviceSensor(SensorType::Mk14, 3, 5, 3)};
        LineConfig second = serviceLine(accelerometers);
        second.index = 5;
        second.com = 17;
        LineConfig off = serviceLine({serviceSensor(SensorType::InD, 1, 3, 11)});
        off.index = 6;
        off.com = 18;
        off.isOn = false;
        m_config.lines = {serviceLine(inclinometers), second, off};
        m_config.showsAdvanced = true;
        m_registry = std::make_unique<SensorRegistry>(m_config.lines, StatusRules());
        m_first = std::make_unique<ServiceBench>(m_config.lines.at(0), inclinometers);
        m_second = std::make_unique<ServiceBench>(m_config.lines.at(1), accelerometers);
        for (const auto *bench : {m_first.get(), m_second.get()}) {
            connect(bench->worker.get(), &LineWorker::lineChanged, m_registry.get(), &SensorRegistry::updateLine);
            connect(bench->worker.get(), &LineWorker::readingsReady, m_registry.get(), &SensorRegistry::update);
        }
        open();
        QTRY_COMPARE_WITH_TIMEOUT(m_registry->lines().at(0).status.state, LineState::Open, patience);
        QTRY_COMPARE_WITH_TIMEOUT(m_registry->lines().at(1).status.state, LineState::Open, patience);
    }
    void cleanup()
    {
        m_window.reset();
        m_first.reset();
        m_second.reset();
    }

    /// Manual 000, sections 8.3 and 9.3.
    void menuBelongsToThePort()
    {
        m_window->select(SiteItem::line(0));
        QTRY_VERIFY_WITH_TIMEOUT(entry("serviceInD3")->isEnabled(), patience);
        QCOMPARE(entry("serviceInD3")->text(), QStringLiteral("Settings of ИН-Д3 sensors on COM16"));
        QCOMPARE(entry("serviceAnD3")->text(), QStringLiteral("Settings of АН-Д3 sensors on COM16"));
        m_window->select(SiteItem::sensor(1));
        QCOMPARE(entry("serviceAnD3")->text(), QStringLiteral("Settings of АН-Д3 sensors on COM17"));
        m_window->select(SiteItem::server());
        QCOMPARE(entry("serviceAnD3")->text(), QStringLiteral("Settings of АН-Д3 sensors"));
    }

    void entriesSayWhyTheyAreDisabled()
    {
        m_window->select(SiteItem::server());
        QCOMPARE(reason("serviceInD3"), QStringLiteral("Select a port in the tree first."));
        m_window->select(SiteItem::line(1));
        QTRY_COMPARE_WITH_TIMEOUT(
            reason("serviceInD3"), QStringLiteral("There is no ИН-Д3 in the list of this port."), patience);
        QCOMPARE(reason("serviceAnD3"), QString());
        QCOMPARE(reason("serviceUsm"), QString());
        QCOMPARE(reason("serviceMk14"), QString());
        QCOMPARE(entry("serviceMk14")->text(), QStringLiteral("Settings of the weather station МК-14 on COM17"));
        m_window->select(SiteItem::line(2));
        QCOMPARE(reason("serviceInD3"), QStringLiteral("The port is off (On=0)."));
        m_window->select(SiteItem::line(0));
        QCOMPARE(reason("serviceUsm"), QStringLiteral("There is no УСМ-ИСН in the list of this port."));
        QCOMPARE(reason("serviceMk14"), QStringLiteral("There is no МК-14 in the list of this port."));
        m_first->isPlugged = false;
        QTRY_COMPARE_WITH_TIMEOUT(reason("serviceInD3"), QStringLiteral("The port is not open."), patience);
        QCOMPARE(reason("serviceAnD3"), QStringLiteral("The port is not open."));
    }

    void contextMenuByMouseAndKeyboard()
    {
        auto *tree = m_window->findChild<QTreeView *>(QStringLiteral("siteTree"));
        m_window->select(SiteItem::line(0));
        const QPoint port = tree->visualRect(tree->currentIndex()).center();
        const QPoint global = tree->viewport()->mapToGlobal(port);
        QContextMenuEvent mouse(QContextMenuEvent::Mouse, port, global);
        QCoreApplication::sendEvent(tree->viewport(), &mouse);
        closeMenu(QStringLiteral("Settings of ИН-Д3 sensors on COM16"));

        m_window->select(SiteItem::line(1));
        QContextMenuEvent keyboard(
            QContextMenuEvent::Keyboard, tree->visualRect(tree->currentIndex()).center(), global);
        QCoreApplication::sendEvent(tree, &keyboard);
        closeMenu(QStringLiteral("Settings of ИН-Д3 sensors on COM17"));

        m_window->select(SiteItem::sensor(0)); // no menu for it
        const QPoint sensor = tree->visualRect(tree->currentIndex()).center();
        QContextMenuEvent other(QContextMenuEvent::Mouse, sensor, tree->viewport()->mapToGlobal(sensor));
        QCoreApplication::sendEvent(tree->viewport(), &other);
        QVERIFY(!m_window->findChild<QMenu *>(QStringLiteral("portMenu")));
    }

    void withoutAdvancedThereIsNoMenu()
    {
        m_config.showsAdvanced = false;
        open();
        QVERIFY(!m_window->findChild<QMenu *>(QStringLiteral("serviceMenu")));
        m_window->select(SiteItem::line(0));
        auto *tree = m_window->findChild<QTreeView *>(QStringLiteral("siteTree"));
        const QPoint port = tree->visualRect(tree->currentIndex()).center();
        QContextMenuEvent mouse(QContextMenuEvent::Mouse, port, tree->viewport()->mapToGlobal(port));
        QCoreApplication::sendEvent(tree->viewport(), &mouse);
        QVERIFY(!m_window->findChild<QMenu *>(QStringLiteral("portMenu")));
    }

    /// Manual 000, section 8.4.
    void warnsBeforeItSuspendsPolling()
    {
        trigger(0, "serviceInD3");
        QVERIFY(box()->text().contains(QStringLiteral("COM16")));
        box()->findChild<QPushButton *>(QStringLiteral("warningCancel"))->click();
        QTRY_VERIFY_WITH_TIMEOUT(!box(), patience);
        QVERIFY(dialogs().isEmpty());
        QCOMPARE(m_first->state(), LineState::Open);

        trigger(0, "serviceInD3");
        box()->findChild<QPushButton *>(QStringLiteral("warningOk"))->click();
        QTRY_COMPARE_WITH_TIMEOUT(m_first->state(), LineState::Service, patience);
        QCOMPARE(dialogs().size(), 1);
        QVERIFY(!dialogs().first()->isModal());
    }

    void severalPortsAndOneWindowEach()
    {
        service(0, "serviceInD3");
        QTRY_COMPARE_WITH_TIMEOUT(m_first->state(), LineState::Service, patience);
        service(1, "serviceAnD3");
        QTRY_COMPARE_WITH_TIMEOUT(m_second->state(), LineState::Service, patience);
        QCOMPARE(dialogs().size(), 2);

        trigger(0, "serviceInD3"); // raises the one that is open
        QVERIFY(!box());
        QCOMPARE(dialogs().size(), 2);
        m_window->select(SiteItem::line(0));
        QTRY_COMPARE_WITH_TIMEOUT(reason("serviceAnD3"), QStringLiteral("The port is in service already."), patience);

        m_first->forgetAnswers();
        m_window->findChild<QDialog *>(QStringLiteral("ind3Dialog"))->close();
        QTRY_VERIFY_WITH_TIMEOUT(m_first->isPolled(), patience);
        QCOMPARE(m_second->state(), LineState::Service);
        service(0, "serviceInD3"); // and again
        QTRY_COMPARE_WITH_TIMEOUT(m_first->state(), LineState::Service, patience);
    }

    void aPortOfTwoTypesHasOneWindowAtATime()
    {
        service(1, "serviceUsm");
        QTRY_COMPARE_WITH_TIMEOUT(m_second->state(), LineState::Service, patience);
        auto *dialog = m_window->findChild<QDialog *>(QStringLiteral("usmDialog"));
        QVERIFY(dialog);
        QCOMPARE(dialog->windowTitle(), QStringLiteral("Settings of УСМ-ИСН sensors on COM17"));
        QTRY_COMPARE_WITH_TIMEOUT(reason("serviceAnD3"), QStringLiteral("The port is in service already."), patience);
        m_second->forgetAnswers();
        dialog->close();
        QTRY_VERIFY_WITH_TIMEOUT(m_second->isPolled(), patience);
    }

    /// What clients, files and screens get meanwhile: the last values, status 0700 (spec/gorizont.md, section 5).
    void readingsKeepTheirValues()
    {
        QTRY_VERIFY_WITH_TIMEOUT(m_first->isPolled(), patience);
        service(0, "serviceInD3");
        QTRY_COMPARE_WITH_TIMEOUT(m_registry->sensors().front().reading.status, quint16(0x0700), patience);
        QVERIFY(m_registry->sensors().front().reading.tilt.has_value());
        QTRY_VERIFY_WITH_TIMEOUT(m_registry->lines().front().status.state == LineState::Service, patience);
    }

    void theEndOfTheWindowResumesPolling()
    {
        service(0, "serviceInD3");
        QTRY_COMPARE_WITH_TIMEOUT(m_first->state(), LineState::Service, patience);
        m_first->forgetAnswers();
        m_window.reset();
        QTRY_VERIFY_WITH_TIMEOUT(m_first->isPolled(), patience);
    }

    void theEndOfTheProgramDoesNotHang()
    {
        service(0, "serviceInD3");
        QTRY_COMPARE_WITH_TIMEOUT(m_first->state(), LineState::Service, patience);
        QVERIFY(m_window->close());
        m_window.reset();
        m_first->endThread(); // waits for ever if a step hangs
        QVERIFY(m_first->thread.isFinished());
    }

private:
    void open()
    {
        m_alarms = std::make_unique<AlarmWatch>(*m_registry);
        m_window = std::make_unique<MainWindow>(*m_registry, m_first->journal, *m_alarms, m_config, QList<Complaint>());
        m_window->offerService(
            [this](int port) -> LineWorker * {
                return port == 4 ? m_first->worker.get() : port == 5 ? m_second->worker.get() : nullptr;
            },
            m_first->journal);
        m_window->showAtStart();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }

    QAction *entry(const char *name) const
    {
        auto *menu = m_window->findChild<QMenu *>(QStringLiteral("serviceMenu"));
        Q_EMIT menu->aboutToShow();
        for (QAction *action : menu->actions()) {
            if (action->objectName() == QLatin1String(name)) {
                return action;
            }
        }
        qFatal("no action %s", name);
    }

    /// Empty: the entry is enabled.
    QString reason(const char *name) const
    {
        const QAction *action = entry(name);
        return action->isEnabled() ? QString() : action->toolTip();
    }

    void trigger(int line, const char *name) const
    {
        m_window->select(SiteItem::line(line));
        entry(name)->trigger();
    }

    void service(int line, const char *name) const
    {
        m_window->select(SiteItem::line(line));
        QTRY_VERIFY_WITH_TIMEOUT(entry(name)->isEnabled(), patience);
        entry(name)->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(box(), patience);
        box()->findChild<QPushButton *>(QStringLiteral("warningOk"))->click();
        QTRY_VERIFY_WITH_TIMEOUT(!box(), patience);
    }

    QMessageBox *box() const { return m_window->findChild<QMessageBox *>(QStringLiteral("serviceWarning")); }

    QList<ServiceDialog *> dialogs() const { return m_window->findChildren<ServiceDialog *>(); }

    void closeMenu(const QString &firstEntry) const
    {
        auto *menu = m_window->findChild<QMenu *>(QStringLiteral("portMenu"));
        QVERIFY(menu && menu->isVisible());
        QCOMPARE(menu->actions().constFirst()->text(), firstEntry);
        menu->close();
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->findChild<QMenu *>(QStringLiteral("portMenu")), patience);
    }

    QTemporaryDir m_settings;
    ServerConfig m_config;
    std::unique_ptr<SensorRegistry> m_registry;
    std::unique_ptr<AlarmWatch> m_alarms;
    std::unique_ptr<ServiceBench> m_first;
    std::unique_ptr<ServiceBench> m_second;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(TestServiceDesk)
#include "tst_servicedesk.moc"
