#pragma once

#include "core/devices/lvims/lvimsservice.h"
#include "core/engine/lineworker.h"

#include <QFutureWatcher>
#include <QObject>

#include <functional>
#include <memory>

namespace gorizont {

/// A waveform or a spectrum as the module keeps it.
struct CapturedSignal
{
    lvims::Capture::Kind kind = lvims::Capture::Kind::Waveform;
    lvims::CaptureInformation information;
    QList<qint32> codes;
};

/// Why a capture ended before it was whole.
struct CaptureFailure
{
    lvims::Capture::Kind kind = lvims::Capture::Kind::Waveform;
    Fault fault = Fault::Timeout;
    int exception = 0; ///< of Modbus; 0: none
    int disturbances = 0; ///< attempts that were spoilt
    bool isLate = false; ///< the module answers and keeps no waveform
    bool isEmpty = false; ///< it says that there is nothing in it
};

/// The waveform of one channel and both spectra that its module makes, one after another, fetched while polling goes on: a step is one
/// exchange in a turn of the line, and between any two the line is free for its sensors. GUI thread; it waits for
/// nothing.
class VibrationCapture : public QObject
{
    Q_OBJECT

public:
    /// Whether the line may be used just now.
    using MayGoOn = std::function<bool()>;

    explicit VibrationCapture(QObject *parent = nullptr);

    /// A capture that runs is forgotten. \a worker outlives it. \a mayGoOn: asked before each step, false ends all.
    void start(LineWorker &worker, const lvims::Service &service, int channel, MayGoOn mayGoOn);
    /// At once; what is under way in the thread of the line is told to nobody.
    void stop();
    bool isRunning() const { return m_capture != nullptr || m_pause.isActive(); }

Q_SIGNALS:
    /// \a total: samples, or numbers of a spectrum; 0: not known yet.
    void progressed(gorizont::lvims::Capture::Kind kind, qsizetype done, qsizetype total);
    void captured(const gorizont::CapturedSignal &signal);
    void failed(const gorizont::CaptureFailure &failure);
    /// All three are there or have failed.
    void finished();

private:
    void begin(lvims::Capture::Kind kind);
    void step();
    void take();
    void fail(Fault fault);
    void goOn();

    LineWorker *m_worker = nullptr;
    std::optional<lvims::Service> m_service;
    int m_channel = 0;
    MayGoOn m_mayGoOn;
    lvims::Capture::Kind m_kind = lvims::Capture::Kind::Waveform;
    std::shared_ptr<lvims::Capture> m_capture; ///< of the thread of the line during a step, of this one between two
    QFutureWatcher<Result<void>> m_step; ///< the last that was begun
    QTimer m_pause;
};

} // namespace gorizont
