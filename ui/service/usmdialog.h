#pragma once

#include "core/devices/usmisn/usmisnfetch.h"
#include "core/devices/usmisn/usmisnrecords.h"
#include "core/devices/usmisn/usmisnservice.h"
#include "ui/service/servicedialog.h"

namespace gorizont {

class RecordStream;
class UsmForm;

/// «Настройка датчиков УСМ-ИСН» (manual 002, section 3). What takes long is made of short steps and can be stopped; only a
/// download holds the line as long as the device sends. GUI thread.
class UsmDialog : public ServiceDialog
{
    Q_OBJECT

public:
    /// How long the window waits; a test is in a hurry.
    struct Pauses
    {
        std::chrono::milliseconds silence = std::chrono::seconds(30); ///< longer than the watchdog of a device
        std::chrono::milliseconds betweenStops = usmisn::Service::repeatStop; ///< of broadcasts, which nobody answers
    };

    explicit UsmDialog(const ServicePort &port, QWidget *parent = nullptr)
        : UsmDialog(port, parent, Pauses())
    {
    }
    UsmDialog(const ServicePort &port, QWidget *parent, const Pauses &pauses);
    ~UsmDialog() override;

protected:
    ScanPanel::Probe probe() const override;
    void showSensor() override;
    void readLive() override {} ///< each measurement would take three seconds of the line
    QString unfinished(bool isLeaving) const override;
    void updateControls() override;
    void breakOff() override;

private:
    /// What takes longer than a step, and is not a change of a setting.
    enum class Task : quint8 { None, Find, Measure, Silence, Wake, Download };

    void connectForm();
    bool begin(Task task); ///< false: the line is not free
    void end();
    void dropTask();
    bool isGoingOn(Task task) const { return m_task == task && isInService(); }

    void read(const QString &before);
    void showRead(int to, const Result<usmisn::Identity> &identity, const QString &before);
    void find();
    void findNext(const QList<quint32> &left, const QStringList &report, int first);
    void measure();
    void measureChannel(int channel, qint64 timestamp);

    void askAddress();
    void changeAddress(int newAddress);
    void onAddressChanged(int from, int to, const Result<void> &changed);
    void askPort(bool isReset);
    void changePort(bool isReset, const PortSettings &wanted);
    void tellAll(const QString &what, const std::function<Result<void>(const usmisn::Service &, Line &)> &tell);
    void keepSilent();
    void countSilence();

    void askStart();
    void startCycle(const usmisn::Recording &recording);
    void wake();
    void wakeNext();
    void onWakeTried(const Result<void> &stopped);
    void endWaking(const QString &text, bool isAwake);

    void findArchive();
    void download(usmisn::RecordMask mask);
    void transferNext();
    void takeRecords();
    void endDownload();
    QString downloadText(const Result<void> &result) const;
    void saveRecords();

    UsmForm *m_form;
    const usmisn::Service m_service;
    const Pauses m_pauses;
    Task m_task = Task::None;
    std::optional<usmisn::Identity> m_identity; ///< of the device that is shown
    QString m_before; ///< to be said with what the next reading brings

    QTimer *m_silence; ///< a hundredth of the silence
    int m_silencePercent = 0;

    int m_wakeAddress = 0; ///< everybody: by broadcasts
    int m_wakeAttempts = 0;
    bool m_isWakingStopped = false;

    usmisn::RecordBook m_book; ///< of the device with this serial number
    quint32 m_bookSerial = 0;
    std::optional<SensorConfig> m_archived; ///< for which the archive keeps them; empty: it does not
    std::optional<usmisn::RecordFetch> m_fetch; ///< while something is downloaded
    std::shared_ptr<RecordStream> m_stream; ///< likewise
    QTimer *m_drain; ///< looks into the stream
    qsizetype m_sizeBefore = 0; ///< of the book, when the download began
    bool m_isBroken = false; ///< the last download: only All brings what New will not send again
};

} // namespace gorizont
