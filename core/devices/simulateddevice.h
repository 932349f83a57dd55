#pragma once

#include "core/line/line.h"

#include <QByteArray>
#include <QByteArrayView>

#include <chrono>

namespace gorizont {

/// The other end of a line in miniature: a device that hears every byte the host sends and answers when it is meant.
/// Its time is given, never asked for, so that a test may run a month in a second.
class SimulatedDevice
{
public:
    /// Since the start of the simulation.
    using Time = std::chrono::microseconds;

    explicit SimulatedDevice(int number, int address)
        : m_number(number)
        , m_address(address)
    {
    }
    virtual ~SimulatedDevice();
    SimulatedDevice(const SimulatedDevice &) = delete;
    SimulatedDevice &operator=(const SimulatedDevice &) = delete;

    int number() const { return m_number; } ///< N of the sensor it stands for
    int address() const { return m_address; }

    /// Hears \a bytes from the host at time \a now and returns the answer, or nothing.
    virtual QByteArray receive(QByteArrayView bytes, Time now) = 0;

    /// How long the device worked on what the last receive() gave back; it is sent so much later.
    virtual Time workTime() const { return Time(0); }

    /// How the host sends from now on. A device that does not listen like this hears noise, that is nothing.
    virtual void hostSpeaks(const PortSettings &) {}

    /// The controller restarts (fault `reboot`).
    virtual void reboot(Time now) = 0;

    /// Whether it has cut the connections to it since the last call; only a device on a network does, when it restarts.
    virtual bool takeDisconnect() { return false; }

    /// Every sample kept so far is overwritten before it could be read (fault `overrun`); nothing for devices without a
    /// ring.
    virtual void overrunRing(Time) {}

protected:
    void setAddress(int address) { m_address = address; }

private:
    int m_number;
    int m_address;
};

} // namespace gorizont
