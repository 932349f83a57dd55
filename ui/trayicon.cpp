#include "ui/trayicon.h"

#include "core/alarms/alarmtext.h"
#include "core/alarms/alarmwatch.h"
#include "ui/mainwindow.h"
#include "ui/models/icons.h"
#include "ui/models/statetext.h"

#include <QApplication>
#include <QMenu>
#include <QTimer>

namespace gorizont {

namespace {

constexpr std::chrono::seconds refreshPeriod(2);
constexpr std::chrono::milliseconds noticeTime(15000); ///< how long a notification stays, where the desktop obeys

} // namespace

TrayIcon::TrayIcon(MainWindow &window, const SensorRegistry &registry, const AlarmWatch &alarms, QObject *parent)
    : QObject(parent)
    , m_window(window)
    , m_registry(registry)
    , m_alarms(alarms)
    , m_icon(icons::tray(Health::Off))
    , m_menu(std::make_unique<QMenu>())
    , m_timer(new QTimer(this))
{
    m_menu->setObjectName(QStringLiteral("trayMenu"));
    QAction *restore = m_menu->addAction(tr("&Restore"), &m_window, &MainWindow::raiseWindow);
    restore->setObjectName(QStringLiteral("trayRestore"));
    m_menu->setDefaultAction(restore);
    m_menu->addSeparator();
    QAction *exit = m_menu->addAction(tr("E&xit"), &m_window, &QWidget::close);
    exit->setObjectName(QStringLiteral("trayExit"));
    m_icon.setContextMenu(m_menu.get());
    connect(&m_icon, &QSystemTrayIcon::activated, this, [this](QSystemTrayIcon::ActivationReason reason) {
        if (reason == QSystemTrayIcon::Trigger) {
            m_window.toggle();
        }
    });
    connect(&m_icon, &QSystemTrayIcon::messageClicked, this, [this] {
        m_window.raiseWindow();
        m_window.showAttention();
    });
    connect(&alarms, &AlarmWatch::noticeDue, this, &TrayIcon::notify);
    connect(&alarms, &AlarmWatch::changed, this, &TrayIcon::refresh);
    connect(m_timer, &QTimer::timeout, this, &TrayIcon::refresh);
    m_timer->start(refreshPeriod);
    refresh();
}

TrayIcon::~TrayIcon() = default;

void TrayIcon::refresh()
{
    followTray();
    const Health worst = siteHealth(m_registry);
    if (worst != m_shown) {
        m_shown = worst;
        m_icon.setIcon(icons::tray(worst));
    }
    QString toolTip = m_window.windowTitle() + u'\n' + statetext::counts(countHealth(m_registry));
    if (const auto waiting = m_alarms.unacknowledged().size(); waiting > 0) {
        toolTip += u'\n' + tr("Messages for the dispatcher: %1").arg(waiting);
    }
    if (toolTip != m_icon.toolTip()) {
        m_icon.setToolTip(toolTip);
    }
}

/// Where there is no tray, the task bar calls for attention; banner, list and journal have it all.
void TrayIcon::notify(const Alarms &alarms)
{
    const alarmtext::Notice notice = alarmtext::notice(alarms);
    if (m_icon.isVisible()) {
        m_icon.showMessage(
            notice.title, notice.text, icons::state(Health::Error), static_cast<int>(noticeTime.count()));
    }
    QApplication::alert(&m_window);
}

/// The tray may come after the program (both started with the session) and may go (its panel has crashed); a window that
/// is hidden in it must not go with it.
void TrayIcon::followTray()
{
    const bool hasTray = QSystemTrayIcon::isSystemTrayAvailable();
    if (hasTray == m_icon.isVisible()) {
        return;
    }
    m_icon.setVisible(hasTray);
    m_window.setHidesToTray(hasTray);
    if (!hasTray && m_window.isHidden()) {
        m_window.showMinimized();
    }
}

} // namespace gorizont
