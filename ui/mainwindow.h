#pragma once

#include "core/config/serverconfig.h"
#include "core/net/clientinfo.h"
#include "core/registry/journal.h"
#include "core/registry/sensorregistry.h"
#include "ui/models/siteitem.h"
#include "ui/service/servicedesk.h"

#include <QMainWindow>
#include <QPointer>

#include <functional>

class QLabel;
class QMenu;
class QMessageBox;
class QSplitter;
class QTimer;

namespace gorizont {

class AlarmWatch;
class AttentionBanner;
class AttentionDialog;
class InfoPanel;
class SiteTree;
class StatePanel;

/// The main window (manual 000, section 4). Shows what the registry and the journal hold and asks nothing of the
/// acquisition. It draws at most four times a second and not at all while nobody can see it. GUI thread.
class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    /// Registry, journal and alarms outlive the window.
    MainWindow(
        SensorRegistry &registry, Journal &journal, AlarmWatch &alarms, const ServerConfig &config,
        const QList<Complaint> &complaints, QWidget *parent = nullptr);
    ~MainWindow() override;

    /// CanHide=1: stays in the tray, or starts minimised where there is no tray.
    void showAtStart();

    /// The window may vanish instead of being minimised, because a tray icon brings it back.
    void setHidesToTray(bool hidesToTray) { m_hidesToTray = hidesToTray; }

    void select(SiteItem item);

    /// Service menus and windows for the ports that \a worker knows. Its workers outlive the window. \a keep: where records
    /// of devices go.
    void offerService(const WorkerOfPort &worker, Journal &journal, const KeepRecords &keep = {});

    /// One more tab above, for \a page that needs the whole height, laid out as it was kept; the window owns it from
    /// now on. \a key brings it up and gives it the keyboard.
    void addWidePage(QWidget *page, const QString &title, const QKeySequence &key);

public Q_SLOTS:
    /// One line of `_data`, for the tab <Измерения>.
    void appendMeasurement(const QString &line);
    /// State of the Modbus server for the status bar.
    void setServerStatus(const QString &text);
    /// All clients of \a service as they are now, for the tab <Клиенты>.
    void setClients(const QString &service, const QList<gorizont::ClientInfo> &clients);
    void raiseWindow();
    /// The list of messages for the dispatcher.
    void showAttention();
    /// Hides a window that is seen, brings back one that is not.
    void toggle();
    /// Ends the program as the system asks for it: whatever CanClose says, nobody is asked.
    void endWithoutQuestion();

Q_SIGNALS:
    /// The user wants the program to end, and confirmed it if CanClose=0.
    void exitRequested();
    /// F5: whatever did not answer is to be tried at once: ports that are gone, parked sensors, the archive.
    void retryRequested();
    /// The user wants to see the register map; who makes the window knows it.
    void registerMapRequested();
    /// As above, the tags of OPC DA.
    void opcTagsRequested();
    /// The user wants this connection to be cut off, and confirmed it.
    void clientDismissed(const QString &service, const QHostAddress &address, quint16 port);

protected:
    void closeEvent(QCloseEvent *event) override;
    void changeEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void buildPanels(Journal &journal);
    void buildMenus();
    void buildViewMenu();
    void buildStatusBar();
    int selectedLine() const; ///< index of the port that is selected or has the selected sensor; −1: none
    QAction *addGoAction(QMenu *menu, const QString &title, int digit, const std::function<void()> &go);
    void placeInSight();
    void restoreLayout();
    void saveLayout() const;

    void refresh();
    void retry();
    void restoreColumns();
    void updateRefreshing();
    void showItem(SiteItem item);
    void showInfoTab(int tab);
    void setWide(bool isWide);
    void goToPort();
    void goToSensor();
    void showComplaints();
    void askExit();

    SensorRegistry &m_registry;
    AlarmWatch &m_alarms;
    const ServerConfig m_config;
    QList<Complaint> m_complaints; ///< not shown yet
    QPointer<QMessageBox> m_exitQuestion; ///< while it waits for an answer

    SiteTree *m_tree = nullptr;
    AttentionBanner *m_banner = nullptr;
    AttentionDialog *m_attention = nullptr; ///< made when it is first wanted
    StatePanel *m_state = nullptr;
    InfoPanel *m_info = nullptr;
    QSplitter *m_columns = nullptr;
    QSplitter *m_rows = nullptr;
    QMenu *m_view = nullptr;
    QAction *m_endOfPages = nullptr; ///< in the menu <Вид>, behind the last of the pages
    QByteArray m_rowsState; ///< of m_rows while a wide page hides the lower panel
    QLabel *m_counts = nullptr;
    QLabel *m_server = nullptr;
    QLabel *m_clock = nullptr;
    QTimer *m_refreshTimer = nullptr;

    bool m_isDirty = true; ///< readings came since the last refresh
    bool m_hidesToTray = false;
    bool m_isExitConfirmed = false;
    int m_lastLine = 0; ///< selected last, for Ctrl+3 and Ctrl+4
    int m_lastSensor = 0;

    std::unique_ptr<ServiceDesk> m_service; ///< goes first, so that its ports are polled again
};

} // namespace gorizont
