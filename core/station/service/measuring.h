#pragma once

#include "core/station/gammasensor.h"
#include "core/station/service/stationplan.h"
#include "core/station/sources/sourcerunner.h"
#include "core/station/stationpipeline.h"

namespace gorizont::station {

/// The sources of a station and what it makes of them, once a second. Lives in the thread of the station; never waits.
class Measuring
{
public:
    struct Ports
    {
        QString directory; ///< COMn is DIR/COMn; empty: the system's
    };

    Measuring(const StationPlan &plan, const Ports &ports, SourceWatch::Tell tell, SteadyTime now);

    /// The second that ends \a now; \a clock by the clock of the station.
    void step(SteadyTime now, qint64 clock);

    /// The control word that a dispatcher sent. Outputs go to their files when they change.
    void setOutputs(quint32 word);

    StationPipeline &pipeline() { return m_pipeline; }
    /// Raw values of the last second, by the index of the parameter.
    const RawSecond &lastSecond() const { return m_last; }

private:
    void stepGamma(const RawSample &sample, qint64 clock, RawSecond &second);
    void applyOutputs();

    StationConfig m_config;
    QList<FileChannel> m_outputFiles;
    StationPipeline m_pipeline;
    std::optional<GammaSensor> m_gamma;
    SourceWatch::Tell m_tell;
    SourceWatch m_sources;
    RawSecond m_last;
    quint32 m_outputs = 0; ///< by the dispatcher
    quint32 m_blinker = 0; ///< bit of the gamma sensor
    std::optional<quint32> m_applied;
    bool m_isOutputBad = false;
};

} // namespace gorizont::station
