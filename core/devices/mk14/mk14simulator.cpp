#include "core/devices/mk14/mk14simulator.h"

#include "core/devices/mk14/mk14options.h"

#include <QDateTime>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace gorizont::mk14 {

namespace {

using namespace std::chrono_literals;

constexpr auto answerTime = 15ms;
constexpr auto forgets = 1s; ///< what was begun and not ended
constexpr auto window = 60s; ///< of the means
constexpr qsizetype head = 9;
constexpr int fileCommand = 0xFF;

int sumOf(const QByteArray &bytes)
{
    int sum = 0;
    for (const char byte : bytes) {
        sum += static_cast<unsigned char>(byte);
    }
    return sum & 0xFF;
}

QByteArray summed(QByteArray bytes)
{
    return bytes + static_cast<char>(static_cast<unsigned char>(-sumOf(bytes)));
}

void appendWord(QByteArray &bytes, quint32 word)
{
    for (int shift = 0; shift < 32; shift += 8) {
        bytes += static_cast<char>(static_cast<unsigned char>(word >> shift & 0xFF));
    }
}

quint32 wordAt(const QByteArray &bytes, qsizetype at)
{
    quint32 word = 0;
    for (int i = 3; i >= 0; --i) {
        word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    return word;
}

int byteOf(const QByteArray &bytes, qsizetype at)
{
    return static_cast<unsigned char>(bytes[at]);
}

QByteArray header(int address, int length, quint32 digital)
{
    QByteArray bytes("\xBB");
    bytes += static_cast<char>(static_cast<unsigned char>(address));
    bytes += '\0';
    bytes += static_cast<char>(static_cast<unsigned char>(length));
    appendWord(bytes, digital);
    return summed(bytes);
}

} // namespace

Simulator::Simulator(const SensorConfig &sensor, quint64 seed, qint64 clock)
    : SimulatedDevice(sensor.number, sensor.address)
    , m_weather(seed)
    , m_parameters(Options::from(sensor).parameters)
    , m_clockAtStart(clock)
{
}

QByteArray Simulator::receive(QByteArrayView bytes, Time now)
{
    m_workTime = Time(0);
    if (now - m_heardAt > forgets) {
        m_heard.clear();
    }
    m_heardAt = now;
    m_heard.append(bytes.data(), bytes.size());
    QByteArray answers;
    while (m_heard.size() >= head) {
        const qsizetype before = m_heard.size();
        answers += takeRequest(now);
        if (m_heard.size() == before) {
            break;
        }
    }
    return answers;
}

/// Takes one request, or one byte that begins none, from what was heard; nothing while the request is not whole.
QByteArray Simulator::takeRequest(Time now)
{
    if (byteOf(m_heard, 0) != 0xBB || sumOf(m_heard.left(head)) != 0) {
        m_heard.remove(0, 1);
        return {};
    }
    const qsizetype name = byteOf(m_heard, 3);
    const bool isFile = byteOf(m_heard, 2) == fileCommand && name > 0;
    const qsizetype block = isFile ? name + qsizetype{wordAt(m_heard, 4)} + 1 : 0;
    if (block > 100'000) {
        m_heard.remove(0, 1);
        return {};
    }
    if (m_heard.size() < head + block) {
        return {};
    }
    const QByteArray request = m_heard.left(head + block);
    m_heard.remove(0, request.size());
    return byteOf(request, 1) == address() ? obey(request, now) : QByteArray();
}

QByteArray Simulator::obey(const QByteArray &request, Time now)
{
    const int command = byteOf(request, 2);
    const quint32 digital = wordAt(request, 4);
    m_workTime = answerTime;
    if (command >= 1 && command <= 8) {
        m_outputs = digital;
        const QByteArray answer = data(command, now);
        m_askedAt = now;
        return answer;
    }
    if (command != fileCommand) {
        return {};
    }
    if (request.size() == head) {
        m_clockAtStart = qint64{digital} - std::chrono::floor<std::chrono::seconds>(now).count();
        return header(address(), 0, inputs(now));
    }
    const QByteArray block = request.mid(head);
    if (sumOf(block) != 0) {
        return {};
    }
    const int name = byteOf(request, 3);
    m_files.insert(block.left(name), block.mid(name, static_cast<qsizetype>(digital)));
    return header(address(), 0, inputs(now));
}

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

quint32 Simulator::inputs(Time now) const
{
    const Time phase = now % SimulatedWeather::showerPeriod;
    const bool isRaining = phase >= SimulatedWeather::showerStart && phase < SimulatedWeather::showerEnd;
    return 1U | (isRaining ? 2U : 0U) | (m_outputs & 0xFFFF) << 16;
}

qint64 Simulator::clock(Time now) const
{
    return m_clockAtStart + std::chrono::floor<std::chrono::seconds>(now).count();
}

void Simulator::reboot(Time now)
{
    m_heard.clear();
    m_outputs = 0;
    m_startedAt = now;
}

/// Stations show local time.
std::unique_ptr<SimulatedDevice> makeSimulator(const SensorConfig &sensor, quint64 seed)
{
    const QDateTime now = QDateTime::currentDateTime();
    const bool isUtc = Options::from(sensor).isClockUtc;
    return std::make_unique<Simulator>(
        sensor, seed, now.toSecsSinceEpoch() + (isUtc ? 0 : qint64{now.offsetFromUtc()}));
}

} // namespace gorizont::mk14
