#include "core/station/service/rawmapping.h"

#include <algorithm>

namespace gorizont::station {

namespace {

constexpr int channelsOfFirstBoard = 32;

void put(RawSecond &second, int parameter, const std::optional<double> &value)
{
    if (parameter >= 0 && value) {
        second.raw[static_cast<std::size_t>(parameter)] = value;
    }
}

void putBoard(RawSecond &second, const StationConfig &config, const BoardConfig &board, const RawSample &sample)
{
    const int first = firstChannelOf(config, board.kind == BoardKind::L154 ? ObjectKind::L154 : ObjectKind::Fastwel);
    for (const BoardInput &input : board.analogue) {
        const auto channel = static_cast<std::size_t>(first + input.channel);
        if (channel < mostAnalogue) {
            put(second, config.indexOf(input.parameter), sample.analogue[channel]);
        }
    }
    if (board.frequency) {
        put(second, config.indexOf(*board.frequency), sample.frequency);
    }
}

void putWinds(RawSecond &second, const StationConfig &config, const RawSample &sample)
{
    for (std::size_t i = 0; i < mostWinds; ++i) {
        const int number = static_cast<int>(i) + 1;
        for (const auto &[code, value] :
             {std::pair{weathercode::windDirection, sample.winds[i].phase},
              std::pair{weathercode::windSpeed, sample.winds[i].frequency}}) {
            const int parameter = config.indexOf({code, number});
            if (parameter >= 0 && !second.raw[static_cast<std::size_t>(parameter)]) {
                put(second, parameter, value);
            }
        }
    }
}

std::optional<quint32> digitalWord(const RawSample &sample)
{
    std::optional<quint32> word;
    for (std::size_t i = 0; i < mostDigital; ++i) {
        if (sample.digital[i]) {
            word = word.value_or(0) | (quint32{*sample.digital[i]} << i);
        }
    }
    return word;
}

} // namespace

int firstChannelOf(const StationConfig &config, ObjectKind board)
{
    return board == ObjectKind::Fastwel && config.boards.size() > 1 ? channelsOfFirstBoard : 0;
}

RawSecond secondOf(const StationConfig &config, const RawSample &sample)
{
    RawSecond second;
    second.raw.resize(static_cast<std::size_t>(config.parameters.size()));
    for (const BoardConfig &board : config.boards) {
        putBoard(second, config, board, sample);
    }
    putWinds(second, config, sample);
    second.digital = digitalWord(sample);
    return second;
}

} // namespace gorizont::station
