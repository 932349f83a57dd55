#include "core/devices/mk14/mk14simulator.h"

#include "core/devices/mk14/mk14options.h"
#include "core/devices/mk14/mk14simulatedframe.h"

#include <QDateTime>

namespace gorizont::mk14 {

namespace {

using namespace simulated;
using namespace std::chrono_literals;

constexpr auto answerTime = 15ms;
constexpr auto forgets = 1s; ///< what was begun and not ended
constexpr qsizetype head = 9;
constexpr int fileCommand = 0xFF;

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
