#pragma once

#include "core/engine/polledsensor.h"
#include "core/engine/pollingcycle.h"
#include "core/engine/watchdogcare.h"

#include <memory>
#include <vector>

namespace gorizont {

/// What decides how the sensors of one line are polled.
struct PollingSettings
{
    LineConfig line;
    Timing timing;
    StatusRules rules;
    double gravity = 9.81347; ///< m/s²
    int ringPackets = 8192; ///< SrsBufSize
    bool asksInformation = false; ///< CanInfo
};

/// What one turn brought.
struct TurnReport
{
    struct Event
    {
        JournalKind kind = JournalKind::Info;
        QString text;
        int number = 0; ///< N of the sensor
    };

    Readings readings;
    QList<SampleBlock> blocks;
    QList<SignalCapture> captures;
    QList<Event> events;
    std::optional<DeviceInformation> information; ///< one of the sensors said something new of itself
    std::optional<Fault> lineFault; ///< Closed or Cancelled: what ended the turn is no fault of a sensor
    bool isCycleOver = false;
    SteadyTime nextAt; ///< when the next turn is due
};

/// Whose turn it is on a line: one sensor, or one step of bulk data while nobody waits for the line. Lives in the thread
/// of the line; knows neither how the line is kept open nor who hears of the readings.
class LinePoller
{
public:
    explicit LinePoller(const PollingSettings &settings);

    TurnReport turn(Line &line);

    /// Says something if the line was silent for so long that devices with a watchdog would restart; for a line in service.
    Result<void> keepAwake(Line &line);

    /// Nothing is said for \a length, also not by keepAwake(), so that devices that hang restart.
    void keepSilent(std::chrono::seconds length) { m_care.keepSilent(length, std::chrono::steady_clock::now()); }

    /// Polling starts: the line was opened, or service ended.
    void restart();
    /// Parked sensors are asked at the next opportunity.
    void probeParked();
    /// The line went into \a state: the readings of all its sensors follow.
    Readings lineBecame(LineState state);

    quint64 readErrors() const;
    quint64 crcErrors() const;

private:
    void sensorTurn(Line &line, TurnReport &report);
    void idleTurn(Line &line, TurnReport &report);
    void poll(PolledSensor &sensor, Line &line, TurnReport &report);
    void fetch(PolledSensor &sensor, Line &line, TurnReport &report);
    bool hasBacklog() const;
    void silenceFor(PolledSensor &sensor, TurnReport &report);
    SteadyTime nextTurnAt() const;
    void changeAddress(const PolledSensor &sensor, Line &line);
    std::chrono::milliseconds pauseAfter(const Result<void> &polled) const;
    void addStatusChange(const PolledSensor &sensor, quint16 before, TurnReport &report) const;
    void addWords(PolledSensor &sensor, TurnReport &report) const;

    PollingSettings m_settings;
    std::vector<std::unique_ptr<PolledSensor>> m_sensors;
    PollingCycle m_cycle;
    WatchdogCare m_care;
    bool m_isBehind = false; ///< the free time of the last cycle was too short for all bulk data
    PolledSensor *m_toFetch = nullptr; ///< answered just now and has bulk data: one step of them comes next
    std::size_t m_nextIdle = 0; ///< index of the sensor whose backlog is looked at first
    bool m_mayHaveBacklog = false; ///< look at the backlogs before waiting for the next cycle
    const PolledSensor *m_lastAsked = nullptr;
};

} // namespace gorizont
