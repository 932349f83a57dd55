#pragma once

#include "core/config/serverconfig.h"
#include "core/registry/journal.h"
#include "core/registry/sensorregistry.h"
#include "ui/models/siteitem.h"

#include <QMainWindow>
#include <QPointer>

#include <functional>

class QLabel;
class QMessageBox;
class QSplitter;
class QTimer;

namespace gorizont {

class AttentionBanner;
class InfoPanel;
class SiteTree;
class StatePanel;

/// The main window (manual 000, section 4). Shows what the registry and the journal hold and asks nothing of the
/// acquisition. It draws at most four times a second and not at all while nobody can see it. GUI thread.
class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    /// Registry and journal outlive the window.
    MainWindow(
        SensorRegistry &registry, Journal &journal, const ServerConfig &config, const QList<Complaint> &complaints,
        QWidget *parent = nullptr);
    ~MainWindow() override;

    /// CanHide=1: stays in the tray, or starts minimised where there is no tray.
    void showAtStart();

    /// The window may vanish instead of being minimised, because a tray icon brings it back.
    void setHidesToTray(bool hidesToTray) { m_hidesToTray = hidesToTray; }

    void select(SiteItem item);

public Q_SLOTS:
    /// One line of `_data`, for the tab <Измерения>.
    void appendMeasurement(const QString &line);
    /// State of the Modbus server for the status bar.
    void setServerStatus(const QString &text);
    void raiseWindow();
    /// Hides a window that is seen, brings back one that is not.
    void toggle();

Q_SIGNALS:
    /// The user wants the program to end, and confirmed it if CanClose=0.
    void exitRequested();
    /// The user wants to see the register map; who makes the window knows it.
    void registerMapRequested();

protected:
    void closeEvent(QCloseEvent *event) override;
    void changeEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void buildPanels(Journal &journal);
    void buildMenus();
    void buildStatusBar();
    QAction *addGoAction(QMenu *menu, const QString &title, int digit, const std::function<void()> &go);
    void restoreLayout();
    void saveLayout() const;

    void refresh();
    void updateRefreshing();
    void showItem(SiteItem item);
    void goToPort();
    void goToSensor();
    void showComplaints();
    void askExit();

    SensorRegistry &m_registry;
    const ServerConfig m_config;
    QList<Complaint> m_complaints; ///< not shown yet
    QPointer<QMessageBox> m_exitQuestion; ///< while it waits for an answer

    SiteTree *m_tree = nullptr;
    AttentionBanner *m_banner = nullptr;
    StatePanel *m_state = nullptr;
    InfoPanel *m_info = nullptr;
    QSplitter *m_columns = nullptr;
    QSplitter *m_rows = nullptr;
    QLabel *m_counts = nullptr;
    QLabel *m_server = nullptr;
    QLabel *m_clock = nullptr;
    QTimer *m_refreshTimer = nullptr;

    bool m_isDirty = true; ///< readings came since the last refresh
    bool m_hidesToTray = false;
    bool m_isExitConfirmed = false;
    int m_lastLine = 0; ///< selected last, for Ctrl+3 and Ctrl+4
    int m_lastSensor = 0;
};

} // namespace gorizont
