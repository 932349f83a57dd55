#include "ui/vibration/vibrationcapture.h"

namespace gorizont {

using lvims::Capture;

VibrationCapture::VibrationCapture(QObject *parent)
    : QObject(parent)
{
    m_pause.setSingleShot(true);
    connect(&m_pause, &QTimer::timeout, this, &VibrationCapture::step);
    connect(&m_step, &QFutureWatcherBase::finished, this, &VibrationCapture::take);
}

void VibrationCapture::start(LineWorker &worker, const lvims::Service &service, int channel, MayGoOn mayGoOn)
{
    stop();
    m_worker = &worker;
    m_service = service;
    m_channel = channel;
    m_mayGoOn = std::move(mayGoOn);
    begin(Capture::Kind::Waveform);
}

void VibrationCapture::stop()
{
    m_pause.stop();
    m_step.setFuture({});
    m_capture.reset();
}

void VibrationCapture::begin(Capture::Kind kind)
{
    m_kind = kind;
    m_capture = std::make_shared<Capture>(m_service->capture(kind, m_channel));
    Q_EMIT progressed(kind, 0, 0);
    if (m_capture) { // nobody has stopped it because of that
        step();
    }
}

/// Each step comes from here anew, never from the one before it: in between the line has its turns.
void VibrationCapture::step()
{
    if (!m_mayGoOn()) {
        fail(Fault::Closed);
        return;
    }
    auto promise = std::make_shared<QPromise<Result<void>>>();
    promise->start();
    m_step.setFuture(promise->future());
    m_worker->submit([promise, capture = m_capture](Line &line) {
        promise->addResult(capture->step(line, std::chrono::steady_clock::now()));
        promise->finish();
    });
}

/// A step that was never heard belongs to a thread that has ended.
void VibrationCapture::take()
{
    if (!m_capture) {
        return;
    }
    const QFuture<Result<void>> future = m_step.future();
    const Result<void> done = future.resultCount() == 1 ? future.result() : Result<void>(Fault::Cancelled);
    if (!done) {
        fail(done.fault());
        return;
    }
    if (m_capture->isDone()) {
        const CapturedSignal signal{m_kind, m_capture->information(), m_capture->codes()};
        m_capture.reset();
        Q_EMIT captured(signal);
        goOn();
        return;
    }
    Q_EMIT progressed(m_kind, m_capture->codes().size(), m_capture->information().size);
    if (m_capture) {
        m_pause.start(m_capture->pause());
    }
}

/// A module that is away is not asked for the rest.
void VibrationCapture::fail(Fault fault)
{
    const CaptureFailure failure{
        m_kind,
        fault,
        m_capture->exception(),
        m_capture->disturbances(),
        m_capture->isLate(),
        fault == Fault::BadReply && m_capture->information().rate > 0 && m_capture->information().size == 0};
    m_capture.reset();
    Q_EMIT failed(failure);
    if (isLineFault(fault) || (fault == Fault::Timeout && !failure.isLate)) {
        Q_EMIT finished();
    } else {
        goOn();
    }
}

void VibrationCapture::goOn()
{
    switch (m_kind) {
    case Capture::Kind::Waveform: begin(Capture::Kind::Spectrum5000); break;
    case Capture::Kind::Spectrum5000: begin(Capture::Kind::Spectrum200); break;
    case Capture::Kind::Spectrum200: Q_EMIT finished(); break;
    }
}

} // namespace gorizont
