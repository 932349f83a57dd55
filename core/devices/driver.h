#pragma once

#include "core/line/line.h"
#include "core/values/deviceinformation.h"
#include "core/values/journalentry.h"
#include "core/values/reading.h"
#include "core/values/sampleblock.h"
#include "core/values/sensorconfig.h"
#include "core/values/vibrationcapture.h"

namespace gorizont {

/// What a driver needs to know beside the line.
struct DriverSettings
{
    SensorConfig sensor;
    Timing timing;
    double gravity = 9.81347; ///< m/s², [Common] Gravity
    int ringPackets = 8192; ///< SrsBufSize
    bool asksInformation = false; ///< CanInfo
};

/// A driver's event for the user's journal; the engine adds time, port and sensor.
struct DriverNote
{
    JournalKind kind = JournalKind::Info;
    QString text;
};

/// What keeps the devices of a line from restarting: a watchdog in them waits for anything that is said on the line.
struct KeepAlive
{
    QByteArray message; ///< to say when there is nothing else to say; nobody answers it
    std::chrono::seconds after{0}; ///< silence after which it is said
    bool operator==(const KeepAlive &) const = default;
};

/// Speaks with one sensor. Lives in the thread of its line, may block only inside Line::exchange(), reads top to
/// bottom: ask, get, check, next.
class Driver
{
public:
    explicit Driver(DriverSettings settings)
        : m_settings(std::move(settings))
    {
    }
    virtual ~Driver();
    Driver(const Driver &) = delete;
    Driver &operator=(const Driver &) = delete;

    /// One turn: the current values. A fault is one failed turn, whatever was exchanged before it.
    virtual Result<Measurement> poll(Line &line) = 0;

    /// Bulk data wait in the device. fetch() takes one bounded step of them; the offset stays in the driver, so the
    /// line is free for others between any two steps.
    virtual bool hasBacklog() const { return false; }

    /// When hasBacklog() becomes true without a turn. Empty: it does not.
    virtual std::optional<SteadyTime> backlogAt() const { return std::nullopt; }

    /// An empty list: that step brought nothing, the transfer goes on or is over. Called only while hasBacklog().
    virtual Result<QList<SampleBlock>> fetch(Line &line);

    /// The line was opened anew, or polling goes on after a pause: nothing is known about what happened meanwhile.
    virtual void restart() {}

    /// Also said while polling is suspended for service. Empty: the device has no such watchdog.
    virtual std::optional<KeepAlive> keepAlive() const { return std::nullopt; }

    /// How long nothing should be said on the line, so that the watchdog of a device that hangs restarts it. Asked after
    /// a failed turn; zero: there is no need, or it was told already.
    virtual std::chrono::seconds takeSilence() { return std::chrono::seconds(0); }

    /// Events since the last call, once for each change of state.
    QList<DriverNote> takeNotes() { return std::exchange(m_notes, {}); }

    /// What the device has said of itself, if something of it is new since the last call.
    std::optional<DeviceInformation> takeInformation() { return std::exchange(m_information, std::nullopt); }

    /// What was captured whole since the last call, in the order it came.
    QList<SignalCapture> takeCaptures() { return std::exchange(m_captures, {}); }

    const DriverSettings &settings() const { return m_settings; }

protected:
    void note(JournalKind kind, const QString &text) { m_notes.append({kind, text}); }
    void report(const DeviceInformation &information) { m_information = information; }
    void deliver(const SignalCapture &captured) { m_captures.append(captured); }

private:
    DriverSettings m_settings;
    QList<DriverNote> m_notes;
    std::optional<DeviceInformation> m_information;
    QList<SignalCapture> m_captures;
};

} // namespace gorizont
