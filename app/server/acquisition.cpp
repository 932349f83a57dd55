#include "app/server/acquisition.h"

#include "core/simulation/simulatedline.h"
#include "core/station/service/stationline.h"

#include <QDir>

namespace gorizont {

namespace {

const QString stationScheme = QStringLiteral("station:");

} // namespace

/// The station in \a folder, which runs in this process for all lines that lead to it.
Acquisition::OwnStation &Acquisition::stationIn(const QString &folder, const PortNaming &ports, Journal &journal)
{
    OwnStation &own = m_stations[folder];
    if (!own.thread) {
        station::StationSetup setup;
        setup.configFolder = folder;
        setup.dataFolder = folder;
        setup.ports = ports;
        own.thread = std::make_unique<station::StationThread>(setup);
        QObject::connect(&own.thread->station(), &station::Station::journal, &journal, &Journal::append);
        if (!QDir(folder).exists()) {
            own.problem = tr("there is no folder %1").arg(QDir::toNativeSeparators(folder));
        } else if (!own.thread->acquire()) {
            own.problem = tr("another program runs the station in %1").arg(QDir::toNativeSeparators(folder));
        }
    }
    return own;
}

LineWorker::MakeLine Acquisition::lineMaker(
    const Settings &settings, const LineConfig &line, SteadyTime started, Journal &journal)
{
    const auto tick = settings.common.timing.pauseTick;
    if (line.device.startsWith(QStringLiteral("sim:"), Qt::CaseInsensitive)) {
        return [=, seed = settings.seed]() -> std::unique_ptr<Line> {
            SimulatedBus::Options options;
            options.seed = seed;
            return std::make_unique<SimulatedLine>(line, options, started, tick);
        };
    }
    if (line.device.startsWith(stationScheme, Qt::CaseInsensitive)) {
        OwnStation &own = stationIn(line.device.sliced(stationScheme.size()), settings.ports, journal);
        return [host = &own.thread->station(), problem = own.problem, tick]() -> std::unique_ptr<Line> {
            return std::make_unique<station::StationLine>(*host, problem, tick);
        };
    }
    return [=, naming = settings.ports] { return makeLine(line, naming, tick); };
}

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
        entry.worker = std::make_unique<LineWorker>(own, lineMaker(settings, line, started, journal));
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
    for (const auto &[folder, own] : m_stations) {
        if (own.problem.isEmpty()) {
            own.thread->start();
        }
    }
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
    for (const auto &[folder, own] : m_stations) {
        const std::chrono::milliseconds left(std::max<qint64>(deadline.remainingTime(), 0));
        haveAllEnded = own.thread->stop(left) && haveAllEnded;
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
