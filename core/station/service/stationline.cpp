#include "core/station/service/stationline.h"

namespace gorizont::station {

namespace {

using namespace std::chrono_literals;

constexpr auto byteTime = 100us;

} // namespace

StationLine::Wire::Wire(Station &station)
    : answerer(station.answerer())
    , listener(answerer.isOwn, byteTime)
{
}

StationLine::StationLine(Station &station, const QString &problem, std::chrono::milliseconds pauseTick)
    : Line(pauseTick)
    , m_station(station)
    , m_wire(std::make_shared<Wire>(station))
    , m_problem(problem)
{
}

StationLine::~StationLine() = default;

Result<void> StationLine::open()
{
    if (!m_problem.isEmpty()) {
        setLastError(0, m_problem);
        return Fault::Closed;
    }
    m_isOpen = true;
    return {};
}

Result<void> StationLine::writeAll(QByteArrayView bytes, std::chrono::milliseconds)
{
    if (!m_isOpen) {
        return Fault::Closed;
    }
    QMetaObject::invokeMethod(
        &m_station,
        [wire = m_wire, sent = bytes.toByteArray()] {
            QByteArray answers;
            for (const ack::Asked &asked : wire->listener.hear(sent, std::chrono::steady_clock::now())) {
                answers += wire->answerer.answer(asked);
            }
            const std::lock_guard lock(wire->mutex);
            wire->toHost += answers;
            wire->arrived.notify_one();
        },
        Qt::QueuedConnection);
    return {};
}

Result<QByteArray> StationLine::readSome(std::chrono::microseconds timeout)
{
    if (!m_isOpen) {
        return Fault::Closed;
    }
    std::unique_lock lock(m_wire->mutex);
    m_wire->arrived.wait_for(lock, timeout, [this] { return !m_wire->toHost.isEmpty(); });
    return std::exchange(m_wire->toHost, QByteArray());
}

} // namespace gorizont::station
