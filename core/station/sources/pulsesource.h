#pragma once

#include "core/station/sources/source.h"

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

namespace gorizont::station {

/// The two circuits of a port that a wind sensor is on.
struct ModemLines
{
    bool isReferenceOn = false; ///< CTS
    bool isMainOn = false; ///< DSR
    bool operator==(const ModemLines &) const = default;
};

/// A port whose circuits can be waited for.
class ModemPort
{
public:
    virtual ~ModemPort() = default;
    virtual QString name() const = 0;
    /// Empty: good. Else why not.
    virtual QString open() = 0;
    virtual void close() = 0;
    /// Waits until a circuit changes, or until interrupt() is called. Empty: the port is gone, or was interrupted.
    virtual std::optional<ModemLines> waitForChange() = 0;
    /// Ends the wait of \a waiting, if there is one. Thread-safe; to be repeated until that thread has ended.
    virtual void interrupt(std::thread &waiting) = 0;
};

/// The circuits of a serial port, by the ioctls of Linux. Elsewhere it cannot be opened.
std::unique_ptr<ModemPort> makeModemPort(const QString &device);

/// A wind sensor on a port: counts the edges of its pulses in a thread of its own.
class PulseSource : public Source
{
public:
    /// \a wind: which sensor it is, 0 … mostWinds − 1.
    PulseSource(std::unique_ptr<ModemPort> port, const WindPulses::Settings &settings, std::size_t wind);
    ~PulseSource() override;

    QString name() const override { return m_port->name(); }
    double rate() const override { return 4; }
    QString open() override;
    QString measure(const SampleMoment &moment, RawSample &sample) override;

private:
    void count();
    void stop();

    std::unique_ptr<ModemPort> m_port;
    WindPulses::Settings m_settings;
    std::size_t m_wind;
    std::mutex m_mutex;
    std::optional<WindPulses> m_pulses; ///< under m_mutex
    std::atomic_bool m_isStopping{false};
    std::atomic_bool m_isGone{false}; ///< the counting thread has ended, or is about to
    std::thread m_thread;
};

} // namespace gorizont::station
