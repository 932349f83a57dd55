#pragma once

#include "core/engine/lineworker.h"
#include "core/line/openline.h"
#include "core/registry/journal.h"
#include "core/registry/sensorregistry.h"

#include <QThread>

#include <memory>
#include <vector>

namespace gorizont {

/// All line workers, each in a thread of its own, connected to the registry and the journal. Main thread.
class Acquisition
{
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

    std::vector<Entry> m_entries;
};

} // namespace gorizont
