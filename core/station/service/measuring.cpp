#include "core/station/service/measuring.h"

#include "core/line/openline.h"
#include "core/station/service/rawmapping.h"
#include "core/station/sources/pulsesource.h"
#include "core/station/sources/recordedsource.h"
#include "core/station/sources/simulatedsource.h"
#include "core/station/sources/sysfssource.h"

#include <QCoreApplication>
#include <QFile>

#include <cmath>

namespace gorizont::station {

namespace {

constexpr qint64 secondsOfDay = 86'400;
constexpr qint64 secondsOfMinute = 60;

class Text
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::Measuring)
};

QString portOf(const StationObject &object, const Measuring::Ports &ports)
{
    LineConfig line;
    line.com = object.com;
    line.device = object.device;
    return deviceName(line, {ports.directory});
}

void addWinds(const StationPlan &plan, const Measuring::Ports &ports, QList<SourceWatch::MakeSource> &sources)
{
    std::size_t wind = 0;
    for (const StationObject &object : plan.config.objects) {
        if (object.kind != ObjectKind::Wind || wind >= mostWinds) {
            continue;
        }
        const int index = static_cast<int>(wind);
        // A simulated vane stands for the sensor whose number it has.
        if (!plan.sources.vanes.contains(index)) {
            const WindPulses::Settings settings{
                plan.config.settings.pulseFilter, ticks(plan.config.settings.frequencyTicks), object.windMultiplier};
            const QString port = portOf(object, ports);
            sources.append(
                [port, settings, wind] { return std::make_unique<PulseSource>(makeModemPort(port), settings, wind); });
        }
        ++wind;
    }
}

QList<SourceWatch::MakeSource> sourcesOf(const StationPlan &plan, const Measuring::Ports &ports)
{
    QList<SourceWatch::MakeSource> sources;
    const SourcePlan &source = plan.sources;
    for (const Recording &recording : source.recordings) {
        sources.append([recording, rate = source.rate] { return std::make_unique<RecordedSource>(recording, rate); });
    }
    const bool readsFiles = std::any_of(source.files.begin(), source.files.end(), [](const FileChannel &file) {
        return file.channel.kind != ChannelKind::Output;
    });
    if (readsFiles) {
        sources.append([source] { return std::make_unique<SysfsSource>(source); });
    }
    if (source.hasSignals()) {
        sources.append([source] { return std::make_unique<SimulatedSource>(source); });
    }
    addWinds(plan, ports, sources);
    return sources;
}

QList<FileChannel> outputsOf(const SourcePlan &plan)
{
    QList<FileChannel> outputs;
    for (const FileChannel &file : plan.files) {
        if (file.channel.kind == ChannelKind::Output) {
            outputs.append(file);
        }
    }
    return outputs;
}

} // namespace

Measuring::Measuring(const StationPlan &plan, const Ports &ports, SourceWatch::Tell tell, SteadyTime now)
    : m_config(plan.config)
    , m_outputFiles(outputsOf(plan.sources))
    , m_pipeline(plan.config)
    , m_tell(tell)
    , m_sources(sourcesOf(plan, ports), plan.config.settings.watchdog, std::move(tell), now)
{
    if (plan.config.gamma) {
        m_gamma.emplace(*plan.config.gamma);
    }
}

void Measuring::step(SteadyTime now, qint64 clock)
{
    const RawSample sample = m_sources.take(now);
    RawSecond second = secondOf(m_config, sample);
    second.time = now;
    second.clock = clock;
    stepGamma(sample, clock, second);
    m_pipeline.step(second);
    m_last = second;
}

void Measuring::stepGamma(const RawSample &sample, qint64 clock, RawSecond &second)
{
    if (!m_gamma) {
        return;
    }
    const GammaConfig &gamma = *m_config.gamma;
    const auto pulses = sample.pulses[static_cast<std::size_t>(gamma.inputBit)];
    const std::chrono::minutes minute(clock % secondsOfDay / secondsOfMinute);
    const GammaSensor::Second step = m_gamma->step(std::llround(pulses.value_or(0)), minute);
    const int index = m_config.indexOf(gamma.parameter);
    if (index >= 0 && pulses) {
        second.raw[static_cast<std::size_t>(index)] = step.frequency;
    }
    m_blinker = step.isBlinkerOn ? quint32{1} << gamma.blinkerBit : 0;
    applyOutputs();
    if (step.check) {
        m_tell(
            step.check->isGood(),
            (step.check->isGood()
                 ? Text::tr("Self-check of the gamma sensor: good (%1 pulses, %2 with the blinker).")
                 : Text::tr("Self-check of the gamma sensor: it does not react to the blinker (%1 pulses, "
                            "%2 with the blinker)."))
                .arg(step.check->pulsesClosed)
                .arg(step.check->pulsesOpen));
    }
}

void Measuring::setOutputs(quint32 word)
{
    m_outputs = word;
    applyOutputs();
}

void Measuring::applyOutputs()
{
    const quint32 word = m_outputs | m_blinker;
    if (m_applied == word) {
        return;
    }
    m_sources.setOutputs(word);
    QString problem;
    for (const FileChannel &output : m_outputFiles) {
        const bool isOn = (word >> output.channel.index) & 1;
        if (m_applied && (((*m_applied >> output.channel.index) & 1) != 0) == isOn) {
            continue;
        }
        QFile file(output.path);
        // Not WriteOnly alone, which would make a file where there is no device.
        if (!file.open(QIODevice::WriteOnly | QIODevice::ExistingOnly | QIODevice::Unbuffered)
            || file.write(isOn ? "1" : "0") != 1) {
            problem = output.path + QStringLiteral(": ") + file.errorString();
        }
    }
    // An output that was not set is tried again with the next request.
    m_applied = problem.isEmpty() ? std::optional(word) : std::nullopt;
    if (problem.isEmpty() == m_isOutputBad) {
        m_isOutputBad = !problem.isEmpty();
        m_tell(
            problem.isEmpty(),
            problem.isEmpty() ? Text::tr("The outputs are set again.")
                              : Text::tr("An output cannot be set (%1); it is tried again and again.").arg(problem));
    }
}

} // namespace gorizont::station
