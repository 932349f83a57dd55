#pragma once

#include "core/devices/and3/and3service.h"
#include "ui/service/servicedialog.h"

namespace gorizont {

class And3Form;

/// «Настройка датчиков АН-Д3» (manual 000, section 9): a new address is written, the controller restarts, the line is
/// scanned again. GUI thread.
class And3Dialog : public ServiceDialog
{
    Q_OBJECT

public:
    explicit And3Dialog(
        const ServicePort &port, QWidget *parent = nullptr,
        std::chrono::milliseconds restartTime = and3::Service::restartTime);

protected:
    ScanPanel::Probe probe() const override;
    void showSensor() override;
    void readLive() override;
    QString unfinished(bool isLeaving) const override;
    void updateControls() override;
    void onScanned() override;

private:
    /// An address that was stored and holds only after a reset.
    struct Stored
    {
        int from = 0;
        int to = 0;
        bool isReset = false; ///< the reset was sent
    };

    and3::Service service() const { return and3::Service(port().timing); }
    void write();
    void onWritten(int to, const Result<and3::AddressChange> &change);
    void askForReset();
    void reset();
    void onReset(int to, const Result<void> &reset);
    void waitForRestart();

    And3Form *m_form;
    QTimer *m_restart; ///< a hundredth of the time that a restart takes
    int m_restartPercent = 0;
    std::optional<Stored> m_stored;
    QString m_outcome; ///< what became of it
};

} // namespace gorizont
