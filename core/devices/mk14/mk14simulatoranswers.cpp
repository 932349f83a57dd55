// What the simulated station answers to a data command.

#include "core/devices/mk14/mk14simulatedframe.h"
#include "core/devices/mk14/mk14simulator.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace gorizont::mk14 {

namespace {

using namespace simulated;
using namespace std::chrono_literals;

constexpr auto window = 60s; ///< of the means

} // namespace

QByteArray Simulator::data(int command, Time now) const
{
    const bool isStarting = m_startedAt && now - *m_startedAt < startTime;
    if (!m_hasData || isStarting) {
        return header(address(), 0, inputs(now));
    }
    QByteArray block;
    for (const ParameterName &parameter : m_parameters) {
        appendParameter(block, parameter, command, now);
    }
    if (command == 8) {
        block += extras(now);
    }
    return header(address(), static_cast<int>(m_parameters.size()), inputs(now)) + summed(block);
}

void Simulator::appendParameter(QByteArray &block, const ParameterName &parameter, int command, Time now) const
{
    const Statistics found = statistics(parameter, now);
    const double instant = m_weather.value(parameter.code, parameter.number, now);
    QList<double> values{found.mean};
    if (command == 2 || (command >= 4 && command <= 6)) {
        values << instant;
    }
    if (command >= 3 && command <= 6) {
        values << found.minimum << found.maximum;
    }
    if (command == 5 || command == 6) {
        values << std::abs(found.mean) / 200; // as if 1000 units were 5 V
    }
    if (command == 6) {
        values << std::abs(instant) / 200;
    }
    if (command == 7) {
        values << found.maximum << found.deviation;
    }
    for (const double value : values) {
        appendValue(block, parameter.code, value);
    }
}

/// Over the window of the mean, a value a second; minimum and maximum since the last request. A direction is averaged over its
/// sines and cosines.
Simulator::Statistics Simulator::statistics(const ParameterName &parameter, Time now) const
{
    const bool isAngle = parameter.code == u'A';
    Statistics found;
    double sum = 0;
    double squares = 0;
    double sine = 0;
    double cosine = 0;
    int count = 0;
    for (Time at = now; at > now - window && at >= 0s; at -= 1s, ++count) {
        const double value = m_weather.value(parameter.code, parameter.number, at);
        sum += value;
        squares += value * value;
        sine += std::sin(value * std::numbers::pi / 180);
        cosine += std::cos(value * std::numbers::pi / 180);
        if (count == 0) {
            found.minimum = found.maximum = value;
        } else if (at > m_askedAt) {
            found.minimum = std::min(found.minimum, value);
            found.maximum = std::max(found.maximum, value);
        }
    }
    const double direction = std::atan2(sine, cosine) * 180 / std::numbers::pi;
    found.mean = isAngle ? direction + (direction < 0 ? 360 : 0) : sum / count;
    const double length = std::min(1.0, std::hypot(sine, cosine) / count);
    found.deviation = isAngle ? std::sqrt(std::max(0.0, -2 * std::log(std::max(length, 1e-9)))) * 180 / std::numbers::pi
                              : std::sqrt(std::max(0.0, squares / count - sum / count * sum / count));
    return found;
}

QByteArray Simulator::extras(Time now) const
{
    QByteArray block;
    appendValue(block, u'A', statistics({u'A', 1, {}, {}}, now).deviation);
    const Statistics speed = statistics({u'M', 1, {}, {}}, now);
    appendValue(block, u'M', speed.deviation);
    appendValue(block, u'M', speed.maximum);
    const auto second = std::chrono::floor<std::chrono::seconds>(now);
    const qint64 clockAtStart = m_clockAtStart;
    QList<qint64> times; // newest first
    for (auto shower = second / SimulatedWeather::showerPeriod; shower >= 0 && times.size() < 10; --shower) {
        const auto begins = shower * SimulatedWeather::showerPeriod + SimulatedWeather::showerStart;
        const auto ends = shower * SimulatedWeather::showerPeriod + SimulatedWeather::showerEnd;
        if (ends <= second) {
            times << -(clockAtStart + ends.count());
        }
        if (begins <= second) {
            times << clockAtStart + begins.count();
        }
    }
    for (int i = 0; i < 10; ++i) {
        appendWord(block, static_cast<quint32>(static_cast<qint32>(times.value(i, 0))));
    }
    return block;
}

void Simulator::appendValue(QByteArray &block, QChar code, double value) const
{
    if (m_isSupplyBad) {
        appendWord(block, 0xFFFFFFFF);
        return;
    }
    const float sent = m_fixed.value(code, static_cast<float>(value));
    quint32 bits = 0;
    std::memcpy(&bits, &sent, sizeof bits);
    appendWord(block, bits);
}

} // namespace gorizont::mk14
