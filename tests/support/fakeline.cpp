#include "tests/support/fakeline.h"

namespace gorizont::test {

QByteArray hex(const char *text)
{
    return QByteArray::fromHex(QByteArray(text));
}

FakeLine &FakeLine::expect(const QByteArray &request, const QByteArray &answer)
{
    return expectPieces(request, answer.isEmpty() ? QList<Piece>() : QList<Piece>{{answer, {}}});
}

FakeLine &FakeLine::expectPieces(const QByteArray &request, const QList<Piece> &pieces)
{
    m_script.append({request, pieces, false});
    return *this;
}

FakeLine &FakeLine::expectInPieces(const QByteArray &request, const QByteArray &answer, qsizetype size)
{
    QList<Piece> pieces;
    for (qsizetype at = 0; at < answer.size(); at += size) {
        pieces.append({answer.mid(at, size), std::chrono::milliseconds(1)});
    }
    return expectPieces(request, pieces);
}

FakeLine &FakeLine::vanishAfter(const QByteArray &request)
{
    m_script.append({request, {}, true});
    return *this;
}

std::chrono::milliseconds FakeLine::elapsed() const
{
    return std::chrono::duration_cast<std::chrono::milliseconds>(m_now - m_start);
}

Result<void> FakeLine::open()
{
    m_isOpen = true;
    return {};
}

Result<void> FakeLine::writeAll(QByteArrayView bytes, std::chrono::milliseconds timeout)
{
    if (!m_isOpen) {
        return Fault::Closed;
    }
    m_requestTimes.append(elapsed());
    m_writeTimeouts.append(timeout);
    if (isDone()) {
        m_complaints.append("unexpected: " + bytes.toByteArray().toHex(' '));
        return {};
    }
    const Turn &turn = m_script.at(m_next++);
    if (turn.request != bytes) {
        m_complaints.append("expected " + turn.request.toHex(' ') + " got " + bytes.toByteArray().toHex(' '));
        return {};
    }
    SteadyTime at = m_now;
    for (const Piece &piece : turn.pieces) {
        at += piece.delay;
        m_arrivals.append({at, piece.bytes});
    }
    m_isOpen = !turn.vanishes;
    return {};
}

Result<QByteArray> FakeLine::readSome(std::chrono::microseconds timeout)
{
    if (!m_isOpen) {
        return Fault::Closed;
    }
    m_longestSlice = std::max(m_longestSlice, timeout);
    if (m_arrivals.isEmpty() || m_arrivals.first().at > m_now + timeout) {
        m_now += timeout;
        return QByteArray();
    }
    m_now = std::max(m_now, m_arrivals.first().at);
    return m_arrivals.takeFirst().bytes;
}

void FakeLine::sleepUntil(SteadyTime time)
{
    m_longestSlice = std::max(m_longestSlice, std::chrono::ceil<std::chrono::microseconds>(time - m_now));
    m_now = std::max(m_now, time);
}

} // namespace gorizont::test
