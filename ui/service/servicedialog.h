#pragma once

#include "core/registry/journal.h"
#include "core/values/devicerecord.h"
#include "ui/service/scanpanel.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QMessageBox;
class QPushButton;
class QTimer;
class QVBoxLayout;

namespace gorizont {

class PortGroup;

/// Takes what was downloaded from a sensor of the site, for good.
using KeepRecords = std::function<void(const DeviceRecords &)>;

/// One port and who may speak with it. All of it outlives the windows.
struct ServicePort
{
    LineConfig line;
    Timing timing;
    LineWorker &worker;
    SensorRegistry &registry;
    Journal &journal;
    KeepRecords keep = {}; ///< empty: records of devices are kept nowhere
};

/// What the service windows of all devices have in common (manual 000, sections 8 and 9): the port, the scan, the list of
/// addresses, what was said last, and the ways out. GUI thread.
class ServiceDialog : public QDialog
{
    Q_OBJECT

public:
    ~ServiceDialog() override;

    /// Takes the port and begins with a scan.
    void enter();

    /// Every way out for a user. Asks first if something would be lost; what is being written is waited for.
    void reject() override;

protected:
    using Action = std::function<void()>;

    ServiceDialog(SensorType type, const ServicePort &port, QWidget *parent);

    /// The constructor of a device puts its \a groups between the port and the scan, and perhaps a button beside Exit.
    /// \a tabOrder: from the first group down to the scan.
    void setUp(QWidget *groups, const QWidgetList &tabOrder, QPushButton *besideExit = nullptr);

    /// The port is in service: looks for its sensors, by a scan if a device has no better way.
    virtual void findSensors() { startScan(); }
    virtual ScanPanel::Probe probe() const = 0;
    /// Reads the sensor address() and shows it; none is to be shown if that is 0.
    virtual void showSensor() = 0;
    /// Once a second while nothing else is done.
    virtual void readLive() = 0;
    /// What would be lost by showing another sensor, or by leaving the port, as a question. Empty: nothing.
    virtual QString unfinished(bool isLeaving) const = 0;
    /// What may be pressed now.
    virtual void updateControls() = 0;
    /// A scan has ended; the sensor to show is chosen after this.
    virtual void onScanned() {}
    /// The port is left: a step that runs is to end soon, for polling waits for it.
    virtual void breakOff() {}

    const ServicePort &port() const { return m_port; }
    ScanPanel *scan() const { return m_scan; }
    QComboBox *addresses() const { return m_addresses; }
    int address() const { return m_address; } ///< of the sensor that is shown; 0: none
    bool isInService() const { return m_session && m_session->isActive(); }
    bool isReady() const; ///< in service, and neither scanning nor busy
    bool isLeaving() const { return m_isLeaving; } ///< nothing more is to be written

    /// Runs one short step; every step that was begun is answered.
    template <typename Step, typename Answer> void run(Step step, Answer answer)
    {
        m_session->run(std::move(step), std::move(answer));
    }

    /// A sensor found by the scan that comes at once is shown if it has the address \a preferred, else the first one.
    void startScan(int preferred = 0);
    /// From here to endWork() nothing else may be begun; what is being written is told should the window vanish.
    void beginWork(const QString &writing = {});
    void endWork(bool isGood = true);
    /// The sensor that is shown has moved.
    void moveTo(int newAddress);
    /// Polling goes on while the window stays. \a text: why.
    void leavePort(const QString &text);
    /// A sensor that was found in another way than by a scan is shown.
    void showFoundAt(int address);

    void say(const QString &text, const QString &more = {}); ///< in the lines at the bottom
    void note(JournalKind kind, int address, const QString &text); ///< in the journal
    /// Asks \a question; \a go on \a yes, else \a stay. Goes at once if there is no question.
    void confirm(const QString &question, const QString &yes, const Action &go, const Action &stay = {});

private:
    void leave();
    void endSession();
    void start();
    void showFound();
    void listFound();
    void choose(int index);
    void togglePort();
    void refresh();
    void showMessage();

    const SensorType m_type;
    const ServicePort m_port;
    ServiceSession *m_session = nullptr; ///< child; null: the port is polled
    PortGroup *m_portGroup;
    QComboBox *m_addresses;
    ScanPanel *m_scan;
    QLabel *m_message;
    QPushButton *m_exit;
    QTimer *m_liveTimer;
    QPointer<QMessageBox> m_question; ///< while it waits for an answer
    QPointer<QWidget> m_focused; ///< before the work began

    QString m_end; ///< why the port was lost
    QString m_said;
    QString m_writing; ///< what is being written just now
    int m_writingTo = 0; ///< address
    int m_address = 0;
    int m_preferred = 0;
    bool m_isEntering = false;
    bool m_isBusy = false;
    bool m_isLeaving = false;
};

} // namespace gorizont
