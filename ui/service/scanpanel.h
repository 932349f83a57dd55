#pragma once

#include "core/devices/addressscan.h"
#include "ui/service/servicesession.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace gorizont {

/// «Всего обнаружено датчиков на линии [n] [Сканировать]»: scans the addresses of a line one short step at a time and keeps
/// what is known of them afterwards. GUI thread.
class ScanPanel : public QWidget
{
    Q_OBJECT

public:
    using Probe = std::function<Result<void>(Line &, int)>;

    explicit ScanPanel(QWidget *parent = nullptr);

    /// Forgets the last scan. \a session outlives the scan, or abort() comes before its end.
    void start(ServiceSession &session, const Probe &probe);
    /// After the probe that runs.
    void stop();
    /// At once, because nobody answers any more.
    void abort();
    bool isScanning() const { return m_isScanning; }
    void setScanEnabled(bool isEnabled);

    QList<int> found() const { return m_found; } ///< ascending
    /// Addresses to give to a sensor. Empty unless a scan was complete.
    QList<int> free() const;
    bool isComplete() const { return m_isComplete; }

    /// A sensor was found in another way.
    void add(int address);
    /// A sensor has a new address.
    void move(int from, int to);
    /// Something is not where the scan found it: no address is to be given away before the next one.
    void distrust();

Q_SIGNALS:
    void scanWanted();
    void sensorFound(int address);
    void finished();

private:
    void probeNext();
    void take(const Result<void> &probed);
    void finish();
    void refresh();
    QString progressText() const;
    QString resultText() const;

    QLabel *m_count;
    QPushButton *m_button;
    QProgressBar *m_progress;
    QLabel *m_text;

    QPointer<ServiceSession> m_session;
    Probe m_probe;
    AddressScan m_scan;
    QList<int> m_found;
    QList<int> m_unclear;
    quint64 m_run = 0; ///< answers to earlier scans are not for this one
    bool m_isScanEnabled = false;
    bool m_isScanning = false;
    bool m_isStopping = false;
    bool m_isComplete = false;
};

} // namespace gorizont
