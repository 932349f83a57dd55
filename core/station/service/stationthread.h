#pragma once

#include "core/station/service/station.h"

#include <QLockFile>

namespace gorizont::station {

/// A station in a thread of its own, and the lock that keeps a second program off its data. Used by the thread that makes it; the
/// signals of station() arrive there.
class StationThread
{
public:
    explicit StationThread(const StationSetup &setup);
    ~StationThread();
    StationThread(const StationThread &) = delete;
    StationThread &operator=(const StationThread &) = delete;

    /// False: another program runs a station with these data. Makes their folder.
    bool acquire();
    void start();
    /// False: it did not end within \a limit.
    bool stop(std::chrono::milliseconds limit);

    /// Lives in the thread of the station.
    Station &station() { return *m_station; }
    const StationSetup &setup() const { return m_setup; }

private:
    StationSetup m_setup;
    std::unique_ptr<QLockFile> m_lock;
    QThread m_thread;
    std::unique_ptr<Station> m_station;
};

} // namespace gorizont::station
