#pragma once

#include "core/devices/buildingmotion.h"

#include <QByteArray>

#include <vector>

namespace gorizont::and3 {

/// The ring of a simulated АН-Д3: 128 packets of 32 samples at 10 Hz that are computed from the building's motion when
/// they are asked for. Pure in time: it knows only what it is told.
class SimulatedRing
{
public:
    using Time = BuildingMotion::Time;

    /// Empty and recording.
    void restart(Time now);
    void clear(Time now); ///< empty and stopped
    void stop(Time now);
    void run(Time now);
    /// As if nobody had read for longer than the ring holds.
    void overrun(Time now);

    bool isRunning() const { return m_isRunning; }
    quint32 samples(Time now) const; ///< measured since the start

    /// The 148 bytes of \a cell, 0…127; zeros when nothing has been written there.
    QByteArray packet(int cell, Time now, const BuildingMotion &motion) const;

private:
    /// Samples from `first` on were taken at equal intervals from `start` on.
    struct Stretch
    {
        qint64 first = 0;
        Time start{0};
    };

    qint64 count(Time now) const;
    Time timeOf(qint64 sample) const;

    std::vector<Stretch> m_stretches{{}};
    Time m_bootedAt{0};
    qint64 m_stoppedCount = 0; ///< while it is stopped
    bool m_isRunning = true;
};

} // namespace gorizont::and3
