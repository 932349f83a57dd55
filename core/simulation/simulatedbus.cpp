#include "core/simulation/simulatedbus.h"

#include "core/devices/drivercatalog.h"

namespace gorizont {

namespace {

using namespace std::chrono_literals;
using Kind = SimulatedFault::Kind;

constexpr auto lateness = 1500ms;
constexpr auto pieceGap = 3ms;

/// What a long answer is cut into: the host hears its beginning while the device still sends the rest.
constexpr qsizetype longestPiece = 1024; ///< bytes

SimulatedBus::Time byteTime(const PortSettings &port, int dataBits)
{
    const double stop = port.stopBits == StopBits::One ? 1 : port.stopBits == StopBits::Two ? 2 : 1.5;
    const double bits = 1 + dataBits + (port.parity == Parity::None ? 0 : 1) + stop;
    return SimulatedBus::Time(static_cast<qint64>(1e6 * bits / port.baudRate));
}

} // namespace

SimulatedBus::SimulatedBus(const LineConfig &line, const Options &options)
    : m_options(options)
    , m_dataBits(line.dataBits)
    , m_isStruck(static_cast<std::size_t>(options.faults.size()), false)
    , m_random(static_cast<quint32>(options.seed) + static_cast<quint32>(line.index))
{
    for (const SensorConfig &sensor : line.sensors) {
        if (auto device = makeSimulatedDevice(sensor, options.seed)) {
            m_devices.push_back(std::move(device));
        }
    }
    setPort({line.baudRate, line.parity, line.stopBits});
}

void SimulatedBus::setPort(const PortSettings &port)
{
    m_port = port;
    m_byteTime = byteTime(port, m_dataBits);
    for (const auto &device : m_devices) {
        device->hostSpeaks(port);
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
            append(pieces, answer, heard + m_options.responseDelay + device->workTime(), now);
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
        return appendEven(pieces, sent, start);
    }
    for (qsizetype at = 0; at < sent.size();) {
        const qsizetype size = std::min<qsizetype>(sent.size() - at, m_random.bounded(1, 6));
        start += wireTime(size) + pieceGap;
        pieces.append({sent.mid(at, size), start});
        at += size;
    }
}

void SimulatedBus::appendEven(QList<Piece> &pieces, const QByteArray &bytes, Time start) const
{
    for (qsizetype at = 0; at < bytes.size(); at += longestPiece) {
        const QByteArray piece = bytes.mid(at, longestPiece);
        pieces.append({piece, start + wireTime(at + piece.size())});
    }
}

} // namespace gorizont
