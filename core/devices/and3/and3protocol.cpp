#include "core/devices/and3/and3protocol.h"

#include "core/protocol/bytes.h"
#include "core/protocol/checksums.h"

#include <algorithm>
#include <array>
#include <limits>

namespace gorizont::and3 {

namespace {

/// Lengths of whole frames in ascending order; 0 fills up.
using Sizes = std::array<qsizetype, longestRead>;

constexpr qsizetype frameSize(qsizetype data)
{
    return headerSize + data + sumSize;
}

/// What the answers to an operation may measure; empty for a byte that is no operation.
constexpr Sizes answerSizes(quint8 op)
{
    switch (static_cast<Op>(op)) {
    case Op::Information: return {frameSize(4)};
    case Op::Mode:
    case Op::RingState:
    case Op::ClearRing:
    case Op::SetByte:
    case Op::CopyConfiguration: return {frameSize(0)};
    case Op::Reset: return {frameSize(0), frameSize(2)};
    case Op::ComplexRead: return {frameSize(18)};
    case Op::ReadPackets:
        return {frameSize(packetSize), frameSize(2 * packetSize), frameSize(3 * packetSize), frameSize(4 * packetSize)};
    case Op::WriteConfiguration: return {frameSize(2)};
    case Op::ReadConfiguration: return {frameSize(32)};
    }
    return {};
}

Sizes expectedSizes(const Request &request)
{
    if (request.op != Op::ReadPackets) {
        return answerSizes(static_cast<quint8>(request.op));
    }
    return {frameSize(packetSize * std::max<qsizetype>(request.b2, 1))}; // a count of 0 means one packet, too
}

quint16 sumOf(QByteArrayView frame)
{
    return *readLittle<quint16>(frame, frame.size() - sumSize);
}

bool isGood(QByteArrayView frame)
{
    return crc16CcittFalse(frame.chopped(sumSize)) == sumOf(frame);
}

enum class Look : quint8 { Nothing, Pending, Good, Damaged };

struct Frame
{
    Look look = Look::Nothing;
    qsizetype size = 0; ///< when Good or Damaged
};

/// Takes the beginning of \a rest for a frame of one of the sizes.
Frame lookAt(QByteArrayView rest, const Sizes &sizes)
{
    Frame frame;
    for (const qsizetype size : sizes) {
        if (size == 0) {
            break;
        }
        if (rest.size() < size) {
            return {Look::Pending, 0};
        }
        if (isGood(rest.first(size))) {
            return {Look::Good, size};
        }
        frame = {Look::Damaged, size};
    }
    return frame;
}

/// The way through the received bytes, from left to right; see findAnswer().
class Searcher
{
public:
    Searcher(QByteArrayView received, const Request &request)
        : m_received(received)
        , m_echo(request.toBytes())
        , m_sizes(expectedSizes(request))
    {
    }

    Search search()
    {
        qsizetype at = 0;
        while (at < m_received.size()) {
            const qsizetype step = hasHead(at) ? stepOverOwn(at) : stepOverForeign(at);
            if (step == 0) {
                return {m_found, m_passedLateAnswer};
            }
            at += step;
        }
        return {verdict(), m_passedLateAnswer};
    }

private:
    /// The head of the expected answer, as far as it has arrived.
    bool hasHead(qsizetype at) const
    {
        const QByteArrayView head = m_received.sliced(at).first(std::min(headerSize, m_received.size() - at));
        return m_echo.startsWith(head);
    }

    /// How far to go on from a place that begins like the answer; 0: the answer is found.
    qsizetype stepOverOwn(qsizetype at)
    {
        const QByteArrayView rest = m_received.sliced(at);
        const Frame frame = rest.size() < headerSize ? Frame{Look::Pending, 0} : lookAt(rest, m_sizes);
        const bool isEcho = rest.startsWith(m_echo);
        if (frame.look == Look::Good && !(isEcho && frame.size == m_echo.size())) {
            m_found = Scan::complete(at, frame.size);
            return 0;
        }
        if (frame.look == Look::Pending) {
            markPending(at);
            return 1;
        }
        if (isEcho) {
            return m_echo.size();
        }
        if (m_echo.startsWith(rest)) { // shorter answers than their request: the echo may not be whole yet
            markPending(at);
        } else if (m_damagedAt < 0) {
            m_damagedAt = at;
            m_damagedSize = frame.size;
        }
        return 1;
    }

    /// A good frame of another sensor or operation is passed over whole, whatever its data look like.
    qsizetype stepOverForeign(qsizetype at)
    {
        const QByteArrayView rest = m_received.sliced(at);
        if (byteAt(rest, 0) == 0) {
            return 1;
        }
        const Frame frame =
            rest.size() < headerSize ? Frame{Look::Pending, 0} : lookAt(rest, answerSizes(byteAt(rest, 1)));
        if (frame.look == Look::Good) {
            m_passedLateAnswer = true;
            return frame.size;
        }
        if (frame.look == Look::Pending) {
            markPending(at);
        }
        return 1;
    }

    void markPending(qsizetype at) { m_pendingAt = std::min(m_pendingAt, at); }

    /// Nothing complete: damaged, unless what looks so may lie inside a frame that is still arriving.
    Scan verdict() const
    {
        if (m_damagedAt >= 0 && m_damagedAt < m_pendingAt) {
            return Scan::damaged(m_damagedAt, damagedLength());
        }
        return Scan::incomplete(std::min(m_pendingAt, m_received.size()));
    }

    /// Up to the next place where the answer may begin: garbage that looked like a head must not swallow it.
    qsizetype damagedLength() const
    {
        const qsizetype next = m_received.indexOf(QByteArrayView(m_echo).first(headerSize), m_damagedAt + 1);
        return next < 0 ? m_damagedSize : std::min(m_damagedSize, next - m_damagedAt);
    }

    QByteArrayView m_received;
    QByteArray m_echo;
    Sizes m_sizes;
    Scan m_found;
    bool m_passedLateAnswer = false;
    qsizetype m_damagedAt = -1;
    qsizetype m_damagedSize = 0;
    qsizetype m_pendingAt = std::numeric_limits<qsizetype>::max();
};

} // namespace

QByteArray Request::toBytes() const
{
    QByteArray bytes;
    appendByte(bytes, address);
    appendByte(bytes, static_cast<quint8>(op));
    appendByte(bytes, b1);
    appendByte(bytes, b2);
    appendLittle<quint16>(bytes, crc16CcittFalse(bytes));
    return bytes;
}

Search findAnswer(QByteArrayView received, const Request &request)
{
    return Searcher(received, request).search();
}

ScanFunction answerTo(const Request &request)
{
    return [request](QByteArrayView received) { return findAnswer(received, request).scan; };
}

QByteArrayView dataOf(QByteArrayView answer)
{
    return answer.size() < headerSize + sumSize ? QByteArrayView() : answer.sliced(headerSize).chopped(sumSize);
}

} // namespace gorizont::and3
