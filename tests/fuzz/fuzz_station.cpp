#include "core/station/correctionfile.h"
#include "core/station/stationpipeline.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

using namespace gorizont;
using namespace gorizont::station;

namespace {

void demand(bool isTrue)
{
    if (!isTrue) {
        std::abort();
    }
}

bool isSound(const std::optional<double> &value)
{
    return !value || std::isfinite(*value);
}

/// A few seconds of whatever station the files describe, with short windows.
void run(StationConfig config)
{
    using std::chrono::seconds;
    for (ParameterConfig &parameter : config.parameters) {
        parameter.averaging = std::min(parameter.averaging, seconds(5));
    }
    for (BoardConfig &board : config.boards) {
        board.instantSeconds = std::min(board.instantSeconds, 5);
    }
    config.settings.averaging = std::min(config.settings.averaging, seconds(5));
    StationPipeline pipeline(config);
    for (int second = 0; second < 4; ++second) {
        RawSecond raw;
        raw.time = SteadyTime(seconds(second));
        raw.raw.assign(static_cast<std::size_t>(config.parameters.size()), 1.5 * second);
        raw.digital = 0x55555555U << (second % 2);
        pipeline.step(raw);
        pipeline.requested(raw.time);
    }
    demand(pipeline.sentParameters() == config.parameters.size());
    for (const WeatherParameter &parameter : pipeline.weather().parameters) {
        demand(isSound(parameter.mean) && isSound(parameter.instant) && isSound(parameter.deviation));
        demand(!parameter.minimum || *parameter.minimum <= *parameter.maximum);
    }
}

} // namespace

/// Any bytes, as every file of a station, make a configuration that works, with at most 201 complaints.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    StationFiles files;
    for (const char *name : {"ACK.INI", "ACK.PAR", "ACK.PSE", "ACK.LCD", "ACK.FWL", "ACK.GAM"}) {
        files.insert(QString::fromLatin1(name), bytes);
    }
    const StationReading reading = readStation(files);
    demand(reading.complaints.size() <= Complaints::limit + 1);
    demand(reading.config.parameters.size() <= mostParameters);
    demand(reading.config.corrections.size() == reading.config.parameters.size());
    demand(reading.config.processingOrder().size() == reading.config.parameters.size());
    run(reading.config);

    ParameterConfig parameter;
    parameter.code = u'T';
    parameter.conversion.coefficients = {0, 1};
    StationConfig corrected;
    corrected.parameters = {parameter};
    Corrections corrections;
    Complaints complaints;
    for (const auto kind :
         {CorrectionKind::Input, CorrectionKind::Meteo, CorrectionKind::Correct, CorrectionKind::Real}) {
        readCorrection(kind, QStringLiteral("X.T01"), bytes, corrections, complaints);
    }
    demand(complaints.list().isEmpty() != corrections.isFaulty);
    corrections.isFaulty = false;
    corrected.corrections = {corrections};
    run(corrected);
    return 0;
}
