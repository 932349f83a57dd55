#include "core/station/stationpipeline.h"

#include <algorithm>
#include <cmath>

namespace gorizont::station {

namespace {

std::optional<double> meanOf(const ParameterWindows &windows)
{
    if (const auto *scalar = std::get_if<ScalarWindows>(&windows)) {
        return scalar->mean();
    }
    const auto *direction = std::get_if<DirectionWindows>(&windows);
    return direction ? direction->mean() : std::nullopt;
}

} // namespace

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
    for (Track &track : m_tracks) {
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
