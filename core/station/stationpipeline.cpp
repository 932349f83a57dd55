#include "core/station/stationpipeline.h"

#include <algorithm>
#include <cmath>

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

std::optional<double> meanOf(const ParameterWindows &windows)
{
    if (const auto *scalar = std::get_if<ScalarWindows>(&windows)) {
        return scalar->mean();
    }
    const auto *direction = std::get_if<DirectionWindows>(&windows);
    return direction ? direction->mean() : std::nullopt;
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

void StationPipeline::step(const RawSecond &second)
{
    endPeriod(second.time);
    takeRaw(second);
    judgeSupply();
    for (const int index : m_order) {
        judge(index);
    }
    judgeDirections();
    push();
    m_weather.events = m_precipitation.events();
}

void StationPipeline::takeRaw(const RawSecond &second)
{
    if (second.digital) {
        m_weather.digital = *second.digital;
        if (m_precipitationBit) {
            m_precipitation.update((*second.digital >> *m_precipitationBit & 1U) != 0, second.clock);
        }
    }
    for (int i = 0; i < sentParameters(); ++i) {
        Track &track = this->track(i);
        const auto place = static_cast<std::size_t>(i);
        track.raw = place < second.raw.size() ? second.raw[place] : std::nullopt;
        if (!track.raw && second.digital && track.digitalBit >= 0) {
            track.raw = *second.digital >> track.digitalBit & 1U;
        }
        if ((track.raw && !std::isfinite(*track.raw)) || track.isFaulty) {
            track.raw.reset();
        }
        track.wasMeasured = track.wasMeasured || track.raw;
    }
}

void StationPipeline::judgeSupply()
{
    m_isSupplyBad = false;
    for (const int index : m_supplies) {
        judge(index);
    }
    for (const int index : m_supplies) {
        const Track &supply = track(index);
        m_isSupplyBad = m_isSupplyBad || (!m_isTest && supply.wasMeasured && !supply.judged.isGood());
    }
    for (const int index : m_supplies) {
        Judged &judged = track(index).judged;
        if (m_isSupplyBad && judged.isGood()) {
            judged.verdict = Verdict::SupplyBad;
        }
    }
}

void StationPipeline::judge(int index)
{
    Track &track = this->track(index);
    const Temperatures temperatures{temperature(track.inputThermometer), temperature(m_thermometer)};
    track.judged = track.judge.judge(track.raw, temperatures, meanOf(track.windows));
    if (m_isSupplyBad && track.judged.physical) {
        track.judged.verdict = Verdict::SupplyBad;
    }
    if (track.judged.isGood()) {
        track.lastGood = track.judged.physical;
    }
}

void StationPipeline::judgeDirections()
{
    for (const int index : m_order) {
        Track &track = this->track(index);
        if (std::holds_alternative<DirectionWindows>(track.windows) && track.judged.isGood() && isCalm(track)) {
            track.judged.verdict = Verdict::Calm;
        }
    }
}

bool StationPipeline::isCalm(const Track &direction) const
{
    if (direction.speed < 0) {
        return false;
    }
    const ParameterConfig &config = m_config.parameters[direction.speed];
    const auto speed = track(direction.speed).judged.good();
    return !speed || *speed < config.limits.left.value_or(0) + config.error.value_or(0);
}

std::optional<double> StationPipeline::temperature(int thermometer) const
{
    return thermometer < 0 ? std::nullopt : track(thermometer).lastGood;
}

void StationPipeline::push()
{
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        Track &track = m_tracks[i];
        track.rawWindows.push(track.raw);
        if (auto *scalar = std::get_if<ScalarWindows>(&track.windows)) {
            const bool isMaximum = scalar->push(track.judged.good());
            if (isMaximum && track.direction >= 0) {
                Track &direction = this->track(track.direction);
                std::get<DirectionWindows>(direction.windows).noteGust(direction.judged.good());
            }
        } else if (auto *direction = std::get_if<DirectionWindows>(&track.windows)) {
            direction->push(track.judged.good());
        } else if (track.speed >= 0) {
            std::get<VectorWindows>(track.windows)
                .push(this->track(track.speed).judged.good(), this->track(track.direction).judged.good());
        }
    }
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        WeatherParameter &parameter = m_weather.parameters[static_cast<qsizetype>(i)];
        m_tracks[i].rawWindows.fill(parameter);
        std::visit([&parameter](const auto &windows) { windows.fill(parameter); }, m_tracks[i].windows);
    }
}

void StationPipeline::requested(SteadyTime time)
{
    if (!m_periodEnd) {
        m_periodEnd = time + ticks(m_config.settings.maximumHold);
    }
}

void StationPipeline::endPeriod(SteadyTime time)
{
    if (!m_periodEnd || time <= *m_periodEnd) {
        return;
    }
    m_periodEnd.reset();
    for (Track &track : m_tracks) {
        if (auto *scalar = std::get_if<ScalarWindows>(&track.windows)) {
            scalar->beginPeriod();
        } else if (auto *direction = std::get_if<DirectionWindows>(&track.windows)) {
            direction->beginPeriod();
        }
    }
}

WindExtras StationPipeline::windExtras() const
{
    WindExtras extras;
    const auto first = [this](QChar code) -> const WeatherParameter * {
        for (int i = 0; i < sentParameters(); ++i) {
            if (m_config.parameters[i].isA(code)) {
                return &m_weather.parameters[i];
            }
        }
        return nullptr;
    };
    if (const WeatherParameter *direction = first(weathercode::windDirection)) {
        extras.directionDeviation = direction->deviation;
    }
    if (const WeatherParameter *speed = first(weathercode::windSpeed)) {
        extras.speedDeviation = speed->deviation;
        extras.speedMaximum = speed->maxPeriod;
    }
    return extras;
}

} // namespace gorizont::station
