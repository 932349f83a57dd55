#pragma once

#include "core/line/line.h"

#include <QByteArrayList>
#include <QList>

namespace gorizont::test {

/// A Line whose other end is a script: for each request that is expected, the pieces in which the answer arrives. Its
/// clock is its own: silence costs no real time. A request that is not the expected one is remembered in complaints().
class FakeLine : public Line
{
public:
    struct Piece
    {
        QByteArray bytes;
        std::chrono::milliseconds delay{0}; ///< after the request, or after the piece before
    };

    explicit FakeLine(std::chrono::milliseconds pauseTick = std::chrono::milliseconds(100))
        : Line(pauseTick)
    {
    }

    /// The next request must be \a request; \a answer arrives in one piece. An empty answer is silence.
    FakeLine &expect(const QByteArray &request, const QByteArray &answer);
    FakeLine &expectPieces(const QByteArray &request, const QList<Piece> &pieces);
    /// The same, cut into pieces of \a size bytes that arrive a millisecond apart.
    FakeLine &expectInPieces(const QByteArray &request, const QByteArray &answer, qsizetype size = 1);
    /// After the next expected request has been written the line is gone.
    FakeLine &vanishAfter(const QByteArray &request);

    bool isDone() const { return m_next == m_script.size(); } ///< every expected request came
    QByteArrayList complaints() const { return m_complaints; }
    std::chrono::milliseconds elapsed() const; ///< on the line's own clock
    QList<std::chrono::milliseconds> requestTimes() const { return m_requestTimes; }
    QList<std::chrono::milliseconds> writeTimeouts() const { return m_writeTimeouts; } ///< one for each request
    std::chrono::microseconds longestSlice() const { return m_longestSlice; } ///< that was waited without a look around

    Result<void> open() override;
    void close() override { m_isOpen = false; }
    bool isOpen() const override { return m_isOpen; }

protected:
    Result<void> writeAll(QByteArrayView bytes, std::chrono::milliseconds timeout) override;
    Result<QByteArray> readSome(std::chrono::microseconds timeout) override;
    SteadyTime now() const override { return m_now; }
    void sleepUntil(SteadyTime time) override;

private:
    struct Turn
    {
        QByteArray request;
        QList<Piece> pieces;
        bool vanishes = false;
    };
    struct Arrival
    {
        SteadyTime at;
        QByteArray bytes;
    };

    QList<Turn> m_script;
    qsizetype m_next = 0;
    QList<Arrival> m_arrivals;
    QByteArrayList m_complaints;
    QList<std::chrono::milliseconds> m_requestTimes;
    QList<std::chrono::milliseconds> m_writeTimeouts;
    std::chrono::microseconds m_longestSlice{0};
    SteadyTime m_start{std::chrono::hours(1)};
    SteadyTime m_now{m_start};
    bool m_isOpen = true;
};

/// `7E 9B 01` → bytes; blanks are ignored.
QByteArray hex(const char *text);

} // namespace gorizont::test
