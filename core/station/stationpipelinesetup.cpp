#include "core/station/stationpipeline.h"

namespace gorizont::station {

namespace {

bool isWindCode(const ParameterConfig &parameter)
{
    return parameter.isA(weathercode::windSpeed) || parameter.isA(weathercode::windDirection)
        || parameter.isA(weathercode::windVector);
}

WeatherParameter described(const ParameterConfig &config)
{
    WeatherParameter parameter;
    parameter.code = config.code;
    parameter.number = config.number;
    parameter.name = config.name.isEmpty() ? config.shortName : config.name;
    parameter.unit = config.unit;
    return parameter;
}

} // namespace

StationPipeline::StationPipeline(const StationConfig &config)
    : m_config(config)
    , m_isTest(config.isTest())
    , m_thermometer(config.thermometer())
    , m_precipitationBit(config.precipitationBit())
{
    for (int i = 0; i < m_config.parameters.size(); ++i) {
        addTrack(i);
    }
    for (const int index : m_config.processingOrder()) {
        if (track(index).isSupply) {
            m_supplies.append(index);
        } else if (!m_config.parameters[index].isA(weathercode::windVector)) {
            m_order.append(index);
        }
    }
    placeDigitalInputs();
    if (!m_isTest) {
        addWinds();
    }
}

WindowSettings StationPipeline::windowSettings(const ParameterConfig &parameter, int index) const
{
    WindowSettings settings;
    settings.length = m_config.averaging(index).count();
    settings.instant = m_config.instantSeconds(index);
    const bool isAlwaysAveraged = m_isTest || isWindCode(parameter);
    settings.neededGood =
        isAlwaysAveraged ? 0 : m_config.settings.goodPercent / 100 * static_cast<double>(settings.length);
    settings.hasDeviation = m_config.settings.hasDeviation;
    return settings;
}

void StationPipeline::addTrack(int parameter)
{
    const ParameterConfig &config = m_config.parameters[parameter];
    const Corrections corrections = m_config.corrections.value(parameter);
    WindowSettings settings = windowSettings(config, parameter);
    ParameterJudge judge(config, corrections);
    const auto &gamma = m_config.gamma;
    if (m_isTest) {
        judge.beginTest();
    } else if (gamma && gamma->isDirect() && m_config.indexOf(gamma->parameter) == parameter) {
        judge.measureGamma(*gamma);
        settings.isInstantOnly = true;
    }
    const auto windows = [&]() -> ParameterWindows {
        if (config.isA(weathercode::windVector)) {
            return VectorWindows(settings);
        }
        if (config.isA(weathercode::windDirection) && !m_isTest) {
            return DirectionWindows(settings);
        }
        return ScalarWindows(settings);
    };
    m_tracks.push_back({judge, RawWindows(settings), windows()});
    m_tracks.back().inputThermometer =
        corrections.inputThermometer ? m_config.indexOf(*corrections.inputThermometer) : m_thermometer;
    m_tracks.back().isFaulty = corrections.isFaulty;
    m_tracks.back().isSupply = config.isA(weathercode::supply);
    m_weather.parameters.append(described(config));
}

void StationPipeline::placeDigitalInputs()
{
    for (qsizetype board = 0; board < m_config.boards.size(); ++board) {
        for (const BoardInput &input : m_config.boards[board].digital) {
            const int index = m_config.indexOf(input.parameter);
            if (index >= 0) {
                track(index).digitalBit = m_config.bitOf(board, input);
            }
        }
    }
}

void StationPipeline::addWinds()
{
    for (int direction = 0; direction < m_config.parameters.size(); ++direction) {
        const ParameterConfig &config = m_config.parameters[direction];
        const int speed = m_config.indexOf({weathercode::windSpeed, config.number});
        if (!config.isA(weathercode::windDirection) || speed < 0) {
            continue;
        }
        int wind = m_config.indexOf({weathercode::windVector, config.number});
        if (wind < 0) {
            WindowSettings settings = windowSettings(config, direction);
            const VectorWindows windows(settings);
            settings.length = 1; // nothing is measured
            m_tracks.push_back({ParameterJudge({}, {}), RawWindows(settings), windows});
            WeatherParameter parameter = described(m_config.parameters[speed]);
            parameter.code = weathercode::windVector;
            parameter.name.clear();
            m_weather.parameters.append(parameter);
            wind = static_cast<int>(m_tracks.size()) - 1;
        }
        joinWind(speed, direction, wind);
    }
}

void StationPipeline::joinWind(int speed, int direction, int wind)
{
    track(speed).direction = direction;
    track(direction).speed = speed;
    track(wind).speed = speed;
    track(wind).direction = direction;
}

} // namespace gorizont::station
