#pragma once

#include "core/station/stationpipeline.h"

namespace gorizont::test {

/// A station on the bench: parameters by hand, seconds one after another, raw values by the index of the parameter.
class StationBench
{
public:
    using Raw = std::vector<std::optional<double>>;

    explicit StationBench(const station::StationConfig &config)
        : pipeline(config)
    {
    }

    /// One second, or several alike.
    void step(const Raw &raw, int seconds = 1, std::optional<quint32> digital = {})
    {
        for (int i = 0; i < seconds; ++i) {
            m_now += std::chrono::seconds(1);
            pipeline.step({m_now, firstClock + m_seconds++, raw, digital});
        }
    }

    const WeatherParameter &at(int index) const { return pipeline.weather().parameters.at(index); }
    SteadyTime now() const { return m_now; }

    static constexpr qint64 firstClock = 1'800'000'000;
    station::StationPipeline pipeline;

private:
    SteadyTime m_now{};
    qint64 m_seconds = 0;
};

/// y = x, a window of ten seconds.
inline station::ParameterConfig parameter(char code, int number = 1)
{
    station::ParameterConfig config;
    config.code = QChar::fromLatin1(code);
    config.number = number;
    config.averaging = std::chrono::seconds(10);
    config.conversion.coefficients = {0, 1};
    return config;
}

inline station::StationConfig stationOf(const QList<station::ParameterConfig> &parameters)
{
    station::StationConfig config;
    config.parameters = parameters;
    config.corrections.resize(parameters.size());
    return config;
}

/// A and M; directions count from 1 m/s.
inline station::StationConfig windStation()
{
    station::ParameterConfig speed = parameter('M');
    speed.unit = QStringLiteral("m/s");
    speed.limits = {0.3, 60};
    speed.error = 0.7;
    station::ParameterConfig direction = parameter('A');
    direction.limits = {0, 360};
    return stationOf({direction, speed});
}

} // namespace gorizont::test
