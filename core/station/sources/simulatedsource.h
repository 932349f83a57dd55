#pragma once

#include "core/station/sources/source.h"
#include "core/station/sources/sourcefile.h"

namespace gorizont::station {

/// The signals and vanes of ACK.SRC.
class SimulatedSource : public Source
{
public:
    explicit SimulatedSource(const SourcePlan &plan)
        : m_plan(plan)
    {
    }

    QString name() const override;
    double rate() const override { return m_plan.rate; }
    QString open() override { return {}; }
    QString measure(const SampleMoment &moment, RawSample &sample) override;

private:
    SourcePlan m_plan;
};

/// Adds \a value to what \a channel has; digital inputs are on from 0.5 on.
void addTo(RawSample &sample, const SourceChannel &channel, double value);

} // namespace gorizont::station
