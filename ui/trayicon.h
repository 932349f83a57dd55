#pragma once

#include "core/alarms/alarm.h"
#include "core/registry/sensorregistry.h"
#include "ui/models/health.h"

#include <QObject>
#include <QSystemTrayIcon>

class QMenu;
class QTimer;

namespace gorizont {

class AlarmWatch;
class MainWindow;

/// The program in the tray: a click hides the window and brings it back; the icon shows the worst state of the site, and
/// notifications tell what waits for the dispatcher. Works on while the window is hidden, at a slow pace. GUI thread.
class TrayIcon : public QObject
{
    Q_OBJECT

public:
    /// Shows the icon while the desktop has a tray, and tells the window whether it may hide there.
    TrayIcon(MainWindow &window, const SensorRegistry &registry, const AlarmWatch &alarms, QObject *parent = nullptr);
    ~TrayIcon() override;

    QSystemTrayIcon &icon() { return m_icon; }

    void refresh();

private:
    void followTray();
    void notify(const QList<gorizont::Alarm> &alarms);

    MainWindow &m_window;
    const SensorRegistry &m_registry;
    const AlarmWatch &m_alarms;
    QSystemTrayIcon m_icon;
    std::unique_ptr<QMenu> m_menu;
    QTimer *m_timer;
    Health m_shown = Health::Off;
};

} // namespace gorizont
