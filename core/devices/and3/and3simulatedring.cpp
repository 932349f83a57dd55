#include "core/devices/and3/and3simulatedring.h"

#include <QtEndian>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gorizont::and3 {

namespace {

using namespace std::chrono_literals;

constexpr qint64 cells = 128;
constexpr qint64 samplesInPacket = 32;
constexpr SimulatedRing::Time samplePeriod = 100ms;
constexpr qint64 ticksInMicrosecond = 40; ///< of 25 ns
constexpr qsizetype packetBytes = 148;

/// The sensor takes an acceleration for a tilt by the angle a/g, in 1/8 arc-second, with the sign turned over.
qint16 rawOf(double acceleration)
{
    constexpr double gravity = 9813.47; // mm/s²
    const double arcSeconds = acceleration / gravity * (180 / std::numbers::pi) * 3600;
    return static_cast<qint16>(std::lround(std::clamp(-8 * arcSeconds, -32768.0, 32767.0)));
}

template <typename T> void put(QByteArray &bytes, qsizetype offset, T value)
{
    qToLittleEndian(value, bytes.data() + offset);
}

} // namespace

void SimulatedRing::restart(Time now)
{
    m_stretches = {{0, now}};
    m_bootedAt = now;
    m_isRunning = true;
}

void SimulatedRing::clear(Time now)
{
    m_stretches = {{0, now}};
    m_stoppedCount = 0;
    m_isRunning = false;
}

void SimulatedRing::stop(Time now)
{
    m_stoppedCount = count(now);
    m_isRunning = false;
}

void SimulatedRing::run(Time now)
{
    if (!m_isRunning) {
        m_stretches.push_back({m_stoppedCount, now});
        m_isRunning = true;
    }
}

void SimulatedRing::overrun(Time now)
{
    constexpr qint64 whole = cells * samplesInPacket;
    if (m_isRunning) {
        m_stretches.push_back({count(now), now - whole * samplePeriod});
    } else {
        m_stretches.push_back({m_stoppedCount, now - whole * samplePeriod});
        m_stoppedCount += whole;
    }
}

quint32 SimulatedRing::samples(Time now) const
{
    return static_cast<quint32>(count(now));
}

qint64 SimulatedRing::count(Time now) const
{
    const Stretch &last = m_stretches.back();
    return m_isRunning ? last.first + (now - last.start) / samplePeriod : m_stoppedCount;
}

SimulatedRing::Time SimulatedRing::timeOf(qint64 sample) const
{
    const auto after =
        std::upper_bound(m_stretches.begin() + 1, m_stretches.end(), sample, [](qint64 wanted, const Stretch &stretch) {
            return wanted < stretch.first;
        });
    const Stretch &stretch = *std::prev(after);
    return stretch.start + (sample - stretch.first) * samplePeriod;
}

QByteArray SimulatedRing::packet(int cell, Time now, const BuildingMotion &motion) const
{
    QByteArray bytes(packetBytes, '\0');
    const qint64 newest = count(now) / samplesInPacket - 1;
    const qint64 number = newest - (newest - cell + cells) % cells;
    if (newest < 0 || number < 0) {
        return bytes;
    }
    const qint64 first = number * samplesInPacket;
    for (qsizetype i = 0; i < samplesInPacket; ++i) {
        const Time at = std::max(timeOf(first + i), Time(0));
        put<qint16>(bytes, 2 * i, rawOf(motion.accelerationX(at)));
        put<qint16>(bytes, 64 + 2 * i, rawOf(motion.accelerationY(at)));
    }
    const Time end = timeOf(first + samplesInPacket - 1) + samplePeriod;
    const auto start = static_cast<quint64>((timeOf(first) - m_bootedAt).count() * ticksInMicrosecond);
    const auto stop = static_cast<quint64>((end - m_bootedAt).count() * ticksInMicrosecond);
    put<quint32>(bytes, 128, static_cast<quint32>(start));
    put<quint32>(bytes, 132, static_cast<quint32>(stop));
    put<quint32>(bytes, 136, static_cast<quint32>(stop >> 32));
    put<quint16>(bytes, 140, 0); // errors
    put<quint16>(bytes, 142, 330); // drz
    put<quint16>(bytes, 144, 1200); // AX
    put<quint16>(bytes, 146, 1200); // AY
    return bytes;
}

} // namespace gorizont::and3
