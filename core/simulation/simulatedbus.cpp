#include "core/simulation/simulatedbus.h"

#include "core/devices/drivercatalog.h"

namespace gorizont {

namespace {

using namespace std::chrono_literals;
using Kind = SimulatedFault::Kind;

constexpr auto lateness = 1500ms;
constexpr auto pieceGap = 3ms;

SimulatedBus::Time byteTime(const LineConfig &line)
{
    const double stop = line.stopBits == StopBits::One ? 1 : line.stopBits == StopBits::Two ? 2 : 1.5;
    const double bits = 1 + line.dataBits + (line.parity == Parity::None ? 0 : 1) + stop;
    return SimulatedBus::Time(static_cast<qint64>(1e6 * bits / line.baudRate));
}

} // namespace

SimulatedBus::SimulatedBus(const LineConfig &line, const Options &options)
    : m_options(options)
    , m_byteTime(byteTime(line))
    , m_isStruck(static_cast<std::size_t>(options.faults.size()), false)
    , m_random(static_cast<quint32>(options.seed) + static_cast<quint32>(line.index))
{
    for (const SensorConfig &sensor : line.sensors) {
        if (auto device = makeSimulatedDevice(sensor, options.seed)) {
            m_devices.push_back(std::move(device));
        }
    }
}

QList<SimulatedBus::Piece> SimulatedBus::receive(QByteArrayView bytes, Time now)
{
    strikeOnce(now);
    const Time heard = now + wireTime(bytes.size());
    QList<Piece> pieces;
    for (const auto &device : m_devices) {
        const QByteArray answer = device->receive(bytes, heard);
        if (!answer.isEmpty() && !isSilent(device->number(), now)) {
            append(pieces, answer, heard + m_options.responseDelay, now);
        }
    }
    return pieces;
}

void SimulatedBus::strikeOnce(Time now)
{
    for (qsizetype i = 0; i < m_options.faults.size(); ++i) {
        const SimulatedFault &fault = m_options.faults.at(i);
        const bool isEvent = fault.kind == Kind::Reboot || fault.kind == Kind::Overrun;
        if (!isEvent || now < fault.from || m_isStruck[static_cast<std::size_t>(i)]) {
            continue;
        }
        m_isStruck[static_cast<std::size_t>(i)] = true;
        for (const auto &device : m_devices) {
            if (device->number() != static_cast<int>(fault.value)) {
                continue;
            }
            if (fault.kind == Kind::Reboot) {
                device->reboot(now);
            } else {
                device->overrunRing(now);
            }
        }
    }
}

bool SimulatedBus::isSilent(int number, Time now) const
{
    for (const SimulatedFault &fault : m_options.faults) {
        if (fault.kind == Kind::Silent && static_cast<int>(fault.value) == number && fault.isActive(now)) {
            return true;
        }
    }
    return false;
}

bool SimulatedBus::happens(Kind kind, Time now)
{
    for (const SimulatedFault &fault : m_options.faults) {
        if (fault.kind == kind && fault.isActive(now) && m_random.generateDouble() * 100 < fault.value) {
            return true;
        }
    }
    return false;
}

void SimulatedBus::append(QList<Piece> &pieces, const QByteArray &answer, Time start, Time now)
{
    QByteArray sent = answer;
    if (happens(Kind::Crc, now)) {
        // A byte in the middle, so that delimiters stay; two bits, so that a parity of bytes does not hide it.
        const qsizetype middle = sent.size() / 2;
        sent[middle] = static_cast<char>(sent.at(middle) ^ 0x24);
    }
    if (happens(Kind::Garbage, now)) {
        QByteArray garbage;
        for (int i = 0, count = m_random.bounded(1, 9); i < count; ++i) {
            garbage.append(static_cast<char>(m_random.bounded(256)));
        }
        sent.prepend(garbage);
    }
    if (happens(Kind::Late, now)) {
        start += lateness;
    }
    if (!happens(Kind::Pieces, now)) {
        pieces.append({sent, start + wireTime(sent.size())});
        return;
    }
    for (qsizetype at = 0; at < sent.size();) {
        const qsizetype size = std::min<qsizetype>(sent.size() - at, m_random.bounded(1, 6));
        start += wireTime(size) + pieceGap;
        pieces.append({sent.mid(at, size), start});
        at += size;
    }
}

} // namespace gorizont
