#pragma once

#include "app/station/options.h"
#include "core/history/logfile.h"
#include "core/station/service/stationthread.h"

#include <QObject>

namespace gorizont {

/// The composition root of gorizont-station: the station in its thread, its journal on stderr and in the log of the month, its
/// values on stdout when they are wanted. Main thread.
class StationApplication : public QObject
{
    Q_OBJECT

public:
    explicit StationApplication(const StationOptions &options, QObject *parent = nullptr);

    /// False: another program works with the same data.
    bool acquire() { return m_thread.acquire(); }
    void start() { m_thread.start(); }
    void reload();
    /// False: a thread did not end in time and the process has to end hard.
    bool shutdown();

private:
    void write(const JournalEntry &entry);
    void print(const Weather &weather, qint64 clock);

    StationOptions m_options;
    LogFile m_log;
    bool m_isLogWanted = true; ///< by ACK.PSE
    bool m_isLogBad = false;
    bool m_isStdoutClosed = false;
    station::StationThread m_thread;
};

} // namespace gorizont
