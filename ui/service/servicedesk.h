#pragma once

#include "core/config/serverconfig.h"
#include "ui/service/servicedialog.h"

#include <map>

class QAction;
class QMenu;

namespace gorizont {

/// The worker of section [Port{port}]; null when that port is off.
using WorkerOfPort = std::function<LineWorker *(int port)>;

/// Who may be serviced now, the menus that offer it, and the windows that are open: one a port and device. Owns them, so
/// that every port is polled again when it goes. GUI thread.
class ServiceDesk : public QObject
{
    Q_OBJECT

public:
    /// Everything outlives the desk; \a window is the parent of the windows.
    ServiceDesk(
        const ServerConfig &config, SensorRegistry &registry, Journal &journal, WorkerOfPort worker, KeepRecords keep,
        QWidget *window);
    ~ServiceDesk() override;

    /// ShowAdvanced=1.
    bool isOffered() const { return m_config.showsAdvanced; }
    /// Fills \a menu for a port, an index into SensorRegistry::lines(), or for none (−1).
    void fill(QMenu *menu, int line);
    /// The context menu of a port.
    void showMenu(int line, const QPoint &position);

    /// Why the sensors of \a type on \a line cannot be serviced now, a sentence. Empty: they can.
    QString objection(SensorType type, int line) const;
    /// Warns and opens, or raises the window that is open.
    void open(SensorType type, int line);

private:
    void addEntry(QMenu *menu, SensorType type, int line);
    void warn(SensorType type, int line);
    void openDialog(SensorType type, int line);
    ServiceDialog *dialog(SensorType type, int port) const;

    const ServerConfig &m_config;
    SensorRegistry &m_registry;
    Journal &m_journal;
    WorkerOfPort m_worker;
    KeepRecords m_keep;
    QWidget *m_window;
    std::map<std::pair<SensorType, int>, QPointer<ServiceDialog>> m_dialogs;
    QPointer<QMessageBox> m_warning; ///< while it waits for an answer
};

} // namespace gorizont
