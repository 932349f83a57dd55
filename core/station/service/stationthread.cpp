#include "core/station/service/stationthread.h"

#include <QDeadlineTimer>
#include <QDir>

namespace gorizont::station {

namespace {

using namespace std::chrono_literals;

constexpr auto endLimit = 10s;

} // namespace

StationThread::StationThread(const StationSetup &setup)
    : m_setup(setup)
    , m_station(std::make_unique<Station>(setup))
{
    m_thread.setObjectName(QStringLiteral("station"));
    Station *station = m_station.get();
    station->moveToThread(&m_thread);
    QObject::connect(&m_thread, &QThread::started, station, &Station::start);
    QObject::connect(&m_thread, &QThread::finished, station, &Station::stop, Qt::DirectConnection);
}

StationThread::~StationThread()
{
    stop(endLimit);
}

bool StationThread::acquire()
{
    QDir().mkpath(m_setup.dataFolder);
    m_lock = std::make_unique<QLockFile>(QDir(m_setup.dataFolder).filePath(QStringLiteral("gorizont-station.lock")));
    m_lock->setStaleLockTime(0); // a station may run for years; only a dead process makes a lock stale
    // A folder that cannot hold a lock: the records will complain about it.
    return m_lock->tryLock() || m_lock->error() != QLockFile::LockFailedError;
}

void StationThread::start()
{
    m_thread.start();
}

bool StationThread::stop(std::chrono::milliseconds limit)
{
    m_thread.quit();
    return m_thread.wait(QDeadlineTimer(limit));
}

} // namespace gorizont::station
