#pragma once

#include "core/engine/lineworker.h"
#include "core/line/openline.h"
#include "core/registry/journal.h"
#include "core/registry/sensorregistry.h"
#include "core/station/service/stationthread.h"

#include <QCoreApplication>
#include <QThread>

#include <map>
#include <memory>
#include <vector>

namespace gorizont {

/// All line workers, each in a thread of its own, connected to the registry and the journal. Main thread.
class Acquisition
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::Acquisition)

public:
    struct Settings
    {
        QList<LineConfig> lines;
        PollingSettings common; ///< its line is replaced by each of the lines
        PortNaming ports;
        quint64 seed = 1; ///< of the simulated lines
    };

    Acquisition(const Settings &settings, SensorRegistry &registry, Journal &journal);
    ~Acquisition();

    void start();

    /// Ends all waits and threads; false when one of them did not end within \a limit.
    bool stop(std::chrono::milliseconds limit);

    /// Opens ports that wait for PReOpen or PClose and asks parked sensors, at once.
    void retry();

    /// The worker of section [Port\a port]; null when the port is off.
    LineWorker *worker(int port) const;

private:
    struct Entry
    {
        int port = 0;
        std::unique_ptr<LineWorker> worker;
        std::unique_ptr<QThread> thread;
    };
    struct OwnStation
    {
        std::unique_ptr<station::StationThread> thread;
        QString problem; ///< why it does not run; empty: it may
    };

    LineWorker::MakeLine lineMaker(
        const Settings &settings, const LineConfig &line, SteadyTime started, Journal &journal);
    OwnStation &stationIn(const QString &folder, const PortNaming &ports, Journal &journal);

    std::map<QString, OwnStation> m_stations; ///< by folder; before the workers, whose lines use them
    std::vector<Entry> m_entries;
};

} // namespace gorizont
