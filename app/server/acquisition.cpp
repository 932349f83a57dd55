#include "app/server/acquisition.h"

#include "core/simulation/simulatedline.h"

namespace gorizont {

namespace {

LineWorker::MakeLine lineMaker(const Acquisition::Settings &settings, const LineConfig &line, SteadyTime started)
{
    const auto tick = settings.common.timing.pauseTick;
    if (line.device.startsWith(QStringLiteral("sim:"), Qt::CaseInsensitive)) {
        return [=, seed = settings.seed]() -> std::unique_ptr<Line> {
            SimulatedBus::Options options;
            options.seed = seed;
            return std::make_unique<SimulatedLine>(line, options, started, tick);
        };
    }
    return [=, naming = settings.ports] { return makeLine(line, naming, tick); };
}

} // namespace

Acquisition::Acquisition(const Settings &settings, SensorRegistry &registry, Journal &journal)
{
    const SteadyTime started = std::chrono::steady_clock::now();
    for (const LineConfig &line : settings.lines) {
        if (!line.isOn) {
            continue;
        }
        PollingSettings own = settings.common;
        own.line = line;
        Entry entry;
        entry.port = line.index;
        entry.worker = std::make_unique<LineWorker>(own, lineMaker(settings, line, started));
        entry.thread = std::make_unique<QThread>();
        entry.thread->setObjectName(QStringLiteral("line %1").arg(line.title()));
        LineWorker *worker = entry.worker.get();
        worker->moveToThread(entry.thread.get());
        QObject::connect(entry.thread.get(), &QThread::started, worker, &LineWorker::start);
        QObject::connect(entry.thread.get(), &QThread::finished, worker, &LineWorker::stop, Qt::DirectConnection);
        QObject::connect(worker, &LineWorker::readingsReady, &registry, &SensorRegistry::update);
        QObject::connect(worker, &LineWorker::blockReady, &registry, &SensorRegistry::addBlock);
        QObject::connect(worker, &LineWorker::captureReady, &registry, &SensorRegistry::addCapture);
        QObject::connect(worker, &LineWorker::informationReady, &registry, &SensorRegistry::setInformation);
        QObject::connect(worker, &LineWorker::lineChanged, &registry, &SensorRegistry::updateLine);
        QObject::connect(worker, &LineWorker::journal, &journal, &Journal::append);
        m_entries.push_back(std::move(entry));
    }
}

Acquisition::~Acquisition() = default;

void Acquisition::start()
{
    for (const Entry &entry : m_entries) {
        entry.thread->start();
    }
}

bool Acquisition::stop(std::chrono::milliseconds limit)
{
    for (const Entry &entry : m_entries) {
        entry.worker->interrupt();
        entry.thread->quit();
    }
    const QDeadlineTimer deadline(limit);
    bool haveAllEnded = true;
    for (const Entry &entry : m_entries) {
        haveAllEnded = entry.thread->wait(deadline) && haveAllEnded;
    }
    return haveAllEnded;
}

void Acquisition::retry()
{
    for (const Entry &entry : m_entries) {
        entry.worker->retry();
    }
}

LineWorker *Acquisition::worker(int port) const
{
    for (const Entry &entry : m_entries) {
        if (entry.port == port) {
            return entry.worker.get();
        }
    }
    return nullptr;
}

} // namespace gorizont
