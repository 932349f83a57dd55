#include "core/station/sources/simulatedsource.h"

#include <QCoreApplication>

namespace gorizont::station {

namespace {

constexpr double on = 0.5; ///< a digital signal is on from here

void addTo(std::optional<double> &known, double value)
{
    known = known.value_or(0) + value;
}

} // namespace

void addTo(RawSample &sample, const SourceChannel &channel, double value)
{
    const auto index = static_cast<std::size_t>(channel.index);
    switch (channel.kind) {
    case ChannelKind::Analogue: return addTo(sample.analogue[index], value);
    case ChannelKind::Frequency: return addTo(sample.frequency, value);
    case ChannelKind::Pulses: return addTo(sample.pulses[index], value);
    case ChannelKind::Digital: sample.digital[index] = sample.digital[index].value_or(false) || value >= on; return;
    case ChannelKind::Wind:
    case ChannelKind::Output: return;
    }
}

QString SimulatedSource::name() const
{
    return QCoreApplication::translate("gorizont::Sources", "simulated signals");
}

QString SimulatedSource::measure(const SampleMoment &moment, RawSample &sample)
{
    for (const auto &[channel, signal] : m_plan.signals_) {
        const auto noise = static_cast<quint64>(channel.index) + 64 * (channel.kind == ChannelKind::Analogue ? 0 : 1);
        addTo(sample, channel, signal.value(moment.time, moment.step, noise));
    }
    for (const OutputSignal &signal : m_plan.outputSignals) {
        addTo(sample, signal.channel, (moment.outputs >> signal.output) & 1 ? signal.level : 0);
    }
    for (const auto &[index, vane] : m_plan.vanes) {
        sample.winds[static_cast<std::size_t>(index)] = {vane.frequencyAt(moment.time), vane.phaseAt(moment.time)};
    }
    return {};
}

} // namespace gorizont::station
