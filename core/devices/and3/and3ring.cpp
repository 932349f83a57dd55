#include "core/devices/and3/and3ring.h"

#include "core/devices/and3/and3protocol.h"

#include <algorithm>

namespace gorizont::and3 {

namespace {

using namespace std::chrono_literals;

constexpr quint64 safePackets = 119; ///< the oldest of them will not be overwritten while it is read
constexpr double sampleRate = 10; ///< Hz
constexpr std::chrono::microseconds samplePeriod = 100ms;
constexpr std::chrono::microseconds longestDrift = 1s;

quint64 oldestSafe(quint64 samples)
{
    const quint64 packets = samples / packetSamples;
    return packets > safePackets ? packets - safePackets : 0;
}

} // namespace

/// The count has 32 bits and wraps after 13.6 years: steps are taken modulo 2^32, and a step of more than half of that
/// is a step back. A sensor that restarts in the very hours of the wrap is recognised by its reboot flag.
RingReader::Change RingReader::observe(quint32 samples, bool hasRebooted, UtcTime now)
{
    m_observedAt = now;
    const quint32 step = samples - static_cast<quint32>(m_samples);
    const bool isBackwards = step >= 0x8000'0000;
    if (!m_isRunning || hasRebooted || isBackwards) {
        const Change change = m_isRunning ? Change::Restarted : Change::None;
        beginRun(samples);
        return change;
    }
    m_samples += step;
    if (!m_hasTaken) { // nothing read yet is nothing lost: the oldest safe packet moves along
        m_next = std::max(m_next, oldestSafe(m_samples));
    }
    if (available() <= safePackets) {
        return Change::None;
    }
    const quint64 newest = m_samples / packetSamples - 1;
    m_lost = newest - m_next;
    m_next = newest;
    m_lastStop.reset();
    return Change::Overran;
}

void RingReader::beginRun(quint32 samples)
{
    m_isRunning = true;
    m_samples = samples;
    m_next = oldestSafe(samples);
    m_hasTaken = false;
    m_lastStop.reset();
}

RingReader::Step RingReader::nextStep() const
{
    const int cell = static_cast<int>(m_next % ringCells);
    const auto waiting = static_cast<int>(std::min<quint64>(available(), longestRead));
    return {cell, std::min(waiting, ringCells - cell)};
}

RingReader::Taken RingReader::take(const QList<Packet> &packets)
{
    Taken taken;
    for (const Packet &packet : packets) {
        if (packet.isValid()) {
            const bool follows = m_lastStop == packet.start;
            taken.isOutOfStep = taken.isOutOfStep || (m_lastStop && !follows);
            taken.blocks.append(makeBlock(packet, follows));
            m_lastStop = packet.stop;
        } else {
            ++taken.rejected;
            m_lastStop.reset();
        }
        ++m_next;
        ++m_read;
        m_hasTaken = true;
    }
    return taken;
}

/// The time of a block. The packets carry ticks of the sensor's own clock, which nobody sets; so the count of samples
/// heard last is tied to the host's clock. Inside a run without gaps the time goes on by the count of samples, free
/// of the jitter of the polls; after a gap, or when the two differ by more than a second (the sensor's crystal drifts,
/// the host's clock was set), it is taken from the host's clock anew.
SampleBlock RingReader::makeBlock(const Packet &packet, bool follows)
{
    const UtcTime expected = expectedStart();
    const auto drift = m_nextStart - expected;
    const UtcTime start = follows && std::chrono::abs(drift) <= longestDrift ? m_nextStart : expected;
    m_nextStart = start + packetSamples * samplePeriod;
    return {m_number, start, sampleRate, m_scale, follows, packet.x, packet.y};
}

/// Of the first sample of packet m_next, by the host's clock.
UtcTime RingReader::expectedStart() const
{
    const auto ago = static_cast<qint64>(m_samples - m_next * packetSamples);
    return m_observedAt - ago * samplePeriod;
}

} // namespace gorizont::and3
