#include "core/devices/usmisn/usmisnsimulator.h"

#include <cmath>

namespace gorizont::usmisn {

namespace {

using namespace std::chrono_literals;

constexpr auto bootTime = 100ms;
constexpr auto factoryTime = 1s; ///< at 9600-N-1 after the boot
constexpr auto watchdogTime = 26s;
constexpr auto sleepPeriod = 26s; ///< of a recorder; it listens for the first second of each
constexpr auto listeningTime = 1s;
constexpr std::chrono::microseconds measuringTime(1'089'362); ///< 512 measurements at 470 Hz
constexpr auto freeLineTime = 12ms; ///< waits for a free line and turns its transmitter on
constexpr qsizetype longest = 2048; ///< characters of a message
constexpr quint32 firstSerial = 2800000; ///< of sensors whose `SND3` is no number

const PortSettings factory{9600, Parity::None, StopBits::One};

} // namespace

Simulator::Simulator(const SensorConfig &sensor, quint64 seed)
    : SimulatedDevice(sensor.number, sensor.address)
    , m_motion(seed, sensor.number)
{
    bool isNumber = false;
    const quint32 serial = sensor.serialNumber.toUInt(&isNumber);
    m_serial = isNumber && serial <= 99'999'999 ? serial : firstSerial + static_cast<quint32>(sensor.number);
}

/// It was set up for the port at which it is first spoken to.
void Simulator::hostSpeaks(const PortSettings &port)
{
    m_ownPort = m_hasHost ? m_ownPort : port;
    m_hostPort = port;
    m_hasHost = true;
    m_buffer.clear();
}

QByteArray Simulator::receive(QByteArrayView bytes, Time now)
{
    catchUp(now);
    m_workTime = Time(0);
    if (!isListening(now)) {
        m_buffer.clear();
        return {};
    }
    QByteArray answers;
    for (const char byte : bytes) {
        m_buffer += byte;
        const bool isBeginning = m_buffer.size() >= 2 && m_buffer.endsWith("%/");
        if (isBeginning) {
            m_buffer = "%/";
        } else if (m_buffer.size() > longest || (m_buffer.size() >= 2 && !m_buffer.startsWith("%/"))) {
            m_buffer = byte == '%' ? "%" : "";
        } else if (m_buffer.size() >= 4 && m_buffer.endsWith("/%")) {
            m_heardAt = now;
            answers += obey(m_buffer, now);
            m_buffer = "%"; // the next message may begin with it
        }
    }
    return answers;
}

/// What happened since it was last spoken to: measurements of the recorder, resets by the watchdog.
void Simulator::catchUp(Time now)
{
    if (!m_recorder) {
        if (const auto silences = (now - m_heardAt) / watchdogTime; silences > 0) {
            m_resets += static_cast<int>(silences);
            m_heardAt += silences * watchdogTime;
            m_bootedAt = m_heardAt;
            m_buffer.clear();
        }
        return;
    }
    Recorder &recorder = *m_recorder;
    const qint64 clock = recorder.clock + std::chrono::floor<std::chrono::seconds>(now - recorder.since).count();
    for (;;) {
        const qint64 due = recorder.start + recorder.measured * recorder.period + recorder.delay;
        if (due > clock) {
            return;
        }
        const Time at = recorder.since + std::chrono::seconds(due - recorder.clock);
        m_memory.store(measured(1, due, at));
        m_memory.store(measured(2, due, at));
        ++recorder.measured;
    }
}

bool Simulator::isListening(Time now) const
{
    if (m_recorder) {
        const auto asleep = now - m_recorder->since;
        return asleep >= sleepPeriod && asleep % sleepPeriod < listeningTime && m_hostPort == m_ownPort;
    }
    const auto awake = now - m_bootedAt;
    return awake >= bootTime && m_hostPort == (awake < bootTime + factoryTime ? factory : m_ownPort);
}

void Simulator::reboot(Time now)
{
    m_buffer.clear();
    m_bootedAt = now;
    m_heardAt = now;
}

void Simulator::overrunRing(Time now)
{
    for (int i = 0; i < SimulatedMemory::capacity; ++i) {
        m_memory.store(measured(1 + i % 2, 1, now));
    }
}

QByteArray Simulator::obey(const QByteArray &message, Time now)
{
    const QByteArrayList parts = message.sliced(2, message.size() - 4).split('/');
    if (parts.size() != 5 || parts.at(0) != "Q") {
        return {};
    }
    Request request{parts.at(1), parts.at(2), parts.at(3), parts.at(4), parts.at(1).toInt() == 0};
    if (!request.isToAll && request.addressText.toInt() != address()) {
        return {};
    }
    QByteArray answer;
    if (request.command == "GetValue") {
        answer = value(request, now);
    } else if (request.command == "GetRecord") {
        answer = records(request);
    } else if (request.command.startsWith("Get")) {
        answer = identity(request);
    } else {
        answer = setting(request, now);
    }
    m_workTime += answer.isEmpty() ? Time(0) : Time(freeLineTime);
    if (const qsizetype last = answer.lastIndexOf("%/R"); last >= 0) {
        quint32 crc = 0xFFFFFFFF;
        for (qsizetype i = last; i <= answer.lastIndexOf('%'); ++i) {
            crc ^= static_cast<unsigned char>(answer.at(i));
            for (int bit = 0; bit < 8; ++bit) {
                crc = crc & 1 ? crc >> 1 ^ 0xEDB88320 : crc >> 1;
            }
        }
        m_lastCrc = crc ^ 0xFFFFFFFF;
    }
    return answer;
}

SimulatedMemory::Record Simulator::measured(int channel, qint64 timestamp, Time at) const
{
    SimulatedMemory::Record record;
    record.timestamp = timestamp;
    record.channel = channel;
    record.value = (channel == 1 ? m_motion.tiltX(at) : m_motion.tiltY(at)) / 3600;
    record.variation = 0.0002 + std::abs(m_motion.accelerationX(at)) * 1e-5;
    record.temperature = m_motion.temperature(at);
    record.isOutOfRange = m_isOutOfRange;
    return record;
}

QByteArray Simulator::value(const Request &request, Time now)
{
    const QByteArrayList parts = request.data.split(',');
    bool isNumber = false;
    const qint64 timestamp = parts.first().toLongLong(&isNumber);
    if (parts.size() != 2 || !isNumber || timestamp < 0) {
        return request.isToAll ? QByteArray() : reply(request, "ErrorData");
    }
    const int channel = channelNamed(parts.at(1), request.isToAll);
    if (channel == 0) {
        return request.isToAll ? QByteArray() : reply(request, "ErrorCH");
    }
    m_workTime += measuringTime;
    if (m_isBroken) {
        return reply(request, "ErrorSensor");
    }
    const SimulatedMemory::Record record = measured(channel, timestamp, now);
    return reply(request, fields(timestamp == 0 ? record : m_memory.store(record)));
}

/// Printed with the device's own address, even in answer to a broadcast.
QByteArray Simulator::records(const Request &request)
{
    const QByteArrayList parts = request.data.split(',');
    const bool isKnown = parts.size() == 3 && (parts.at(1) == "ALL" || parts.at(1) == "NEW");
    const int channel = isKnown ? channelNamed(parts.at(2), request.isToAll) : 0;
    if (channel == 0) {
        return request.isToAll ? QByteArray() : reply(request, isKnown ? "ErrorCH" : "ErrorData");
    }
    const QByteArray own = QByteArray::number(address());
    QByteArray answers;
    const auto found = m_memory.read(parts.at(0).toInt(), parts.at(1) == "NEW", channel);
    for (const SimulatedMemory::Record &record : found) {
        answers += reply(request, fields(record), own);
    }
    return answers + reply(request, "End", own);
}

std::unique_ptr<SimulatedDevice> makeSimulator(const SensorConfig &sensor, quint64 seed)
{
    return std::make_unique<Simulator>(sensor, seed);
}

} // namespace gorizont::usmisn
