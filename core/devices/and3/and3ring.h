#pragma once

#include "core/devices/and3/and3packet.h"
#include "core/values/reading.h"
#include "core/values/sampleblock.h"

#include <optional>

namespace gorizont::and3 {

/// Which packets of a sensor's ring have been read and which are next (spec/and3.md, Ring). Pure: hears of the count of
/// measurements and of packets, asks nobody. Packet n of a run (since the sensor's start) holds samples 32n…32n+31 and
/// lies in cell n mod 128.
class RingReader
{
public:
    enum class Change : quint8 {
        None,
        Restarted, ///< the sensor counts anew
        Overran, ///< packets were overwritten before they could be read
    };

    struct Step
    {
        int firstCell = 0;
        int count = 0;
    };

    struct Taken
    {
        QList<SampleBlock> blocks; ///< one a valid packet
        int rejected = 0; ///< packets that are not valid
        bool isOutOfStep = false; ///< a packet does not begin where the one before ended
    };

    /// \a number N of the sensor, \a scale mm/s² of one raw unit.
    RingReader(int number, double scale)
        : m_number(number)
        , m_scale(scale)
    {
    }

    /// The sensor has measured \a samples at \a now; \a hasRebooted: it said that it started anew since the last time.
    Change observe(quint32 samples, bool hasRebooted, UtcTime now);

    quint64 available() const { return m_samples / packetSamples - m_next; } ///< packets
    quint64 lost() const { return m_lost; } ///< packets that the last overrun cost

    /// What to read next; only while something is available.
    Step nextStep() const;

    /// Takes the packets of the last step, which are then read.
    Taken take(const QList<Packet> &packets);

    RingProgress progress() const { return {m_samples / packetSamples, m_read}; }

private:
    void beginRun(quint32 samples);
    SampleBlock makeBlock(const Packet &packet, bool follows);
    UtcTime expectedStart() const;

    int m_number;
    double m_scale;
    bool m_isRunning = false; ///< a count has been heard
    quint64 m_samples = 0; ///< measured since the start of the run, beyond 32 bits
    UtcTime m_observedAt; ///< when m_samples was heard
    quint64 m_next = 0; ///< the packet to read next
    bool m_hasTaken = false; ///< a packet of this run
    quint64 m_read = 0; ///< packets, of all runs
    quint64 m_lost = 0; ///< packets
    std::optional<quint64> m_lastStop; ///< of the packet before m_next, 25 ns; empty: it was not read or not valid
    UtcTime m_nextStart; ///< of the first sample of the packet after the last one, by sample count
};

} // namespace gorizont::and3
