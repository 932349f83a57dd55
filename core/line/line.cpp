#include "core/line/line.h"

#include <QLoggingCategory>

#include <thread>

namespace gorizont {

namespace {

Q_LOGGING_CATEGORY(logBytes, "gorizont.line.bytes", QtInfoMsg)

using namespace std::chrono_literals;

/// After a damaged answer a good one may still follow (garbage looked like a frame), but not for long.
constexpr auto afterDamage = 100ms;

/// No device of the program answers with more; a line that never stops talking must not eat the memory.
constexpr qsizetype longestBacklog = 65536; ///< bytes

} // namespace

Line::~Line() = default;

SteadyTime Line::now() const
{
    return std::chrono::steady_clock::now();
}

void Line::sleepUntil(SteadyTime time)
{
    std::this_thread::sleep_until(time);
}

int Line::sliceUntil(const QDeadlineTimer &deadline) const
{
    return static_cast<int>(std::min<qint64>(deadline.remainingTime(), m_pauseTick.count()));
}

Result<void> Line::setPort(const PortSettings &)
{
    return Fault::Refused;
}

Result<QByteArray> Line::exchange(const Exchange &exchange)
{
    QByteArray answer;
    const auto done = exchangeMany(exchange, [&answer](QByteArrayView found) {
        answer = found.toByteArray();
        return false;
    });
    return done ? Result<QByteArray>(answer) : done.fault();
}

Result<void> Line::exchangeMany(const Exchange &exchange, const TakeAnswer &take)
{
    if (const auto quiet = waitForQuiet(std::max(exchange.quietBefore, m_requiredQuiet)); !quiet) {
        return quiet.fault();
    }
    if (const auto sent = writeRequest(exchange.request, exchange.writeTimeout); !sent) {
        return sent.fault();
    }
    return receive(exchange.scan, exchange.readTimeout, take);
}

Result<void> Line::send(
    const QByteArray &bytes, std::chrono::milliseconds timeout, std::chrono::microseconds quietBefore)
{
    if (const auto quiet = waitForQuiet(std::max(quietBefore, m_requiredQuiet)); !quiet) {
        return quiet.fault();
    }
    return writeRequest(bytes, timeout);
}

/// Bytes that arrive before the request (late answers, noise) are counted and thrown away; they are not silence, but
/// a line that never falls silent is asked all the same.
Result<void> Line::waitForQuiet(std::chrono::microseconds silence)
{
    m_requiredQuiet = 0us;
    const SteadyTime giveUp = now() + silence + m_pauseTick;
    for (;;) {
        if (isInterrupted()) {
            return Fault::Cancelled;
        }
        const auto stale = readSome(0us);
        if (!stale) {
            return stale.fault();
        }
        const SteadyTime current = now();
        if (!stale->isEmpty()) {
            m_bytesReceived += static_cast<quint64>(stale->size());
            m_lastByteAt = current;
            qCDebug(logBytes) << "dropped" << stale->toHex(' ');
        }
        const SteadyTime quietAt = m_lastByteAt + silence;
        if (current >= quietAt || current >= giveUp) {
            return {};
        }
        sleepUntil(std::min<SteadyTime>(quietAt, current + m_pauseTick));
    }
}

Result<void> Line::writeRequest(const QByteArray &bytes, std::chrono::milliseconds timeout)
{
    const auto written = writeAll(bytes, timeout);
    m_lastByteAt = now();
    if (!written) {
        ++m_writeErrors;
        return written;
    }
    m_bytesSent += static_cast<quint64>(bytes.size());
    qCDebug(logBytes) << ">" << bytes.toHex(' ');
    return {};
}

Result<void> Line::receive(const ScanFunction &scan, std::chrono::milliseconds timeout, const TakeAnswer &take)
{
    QByteArray received;
    Fault reason = Fault::Timeout;
    SteadyTime deadline = now() + timeout;
    for (;;) {
        const auto slice = readSlice(deadline);
        if (!slice) {
            return slice.fault() == Fault::Timeout ? reason : slice.fault();
        }
        received += *slice;
        for (Scan found = scan(received); found.skip > 0 || found.state != Scan::State::Incomplete;
             found = scan(received)) {
            if (found.state == Scan::State::Complete) {
                if (!take(QByteArrayView(received).sliced(found.skip, found.length))) {
                    return {};
                }
                reason = Fault::Timeout;
                deadline = now() + timeout;
            }
            if (found.state == Scan::State::Damaged) {
                reason = Fault::Checksum;
                deadline = std::min(deadline, now() + afterDamage);
            }
            received.remove(0, found.skip + found.length);
        }
        if (received.size() > longestBacklog) {
            return Fault::BadReply;
        }
    }
}

/// The next bytes, in slices so that interrupt() is heard. Timeout when the deadline passes.
Result<QByteArray> Line::readSlice(SteadyTime deadline)
{
    for (;;) {
        if (isInterrupted()) {
            return Fault::Cancelled;
        }
        const auto left = std::chrono::ceil<std::chrono::microseconds>(deadline - now());
        if (left <= 0us) {
            return Fault::Timeout;
        }
        auto bytes = readSome(std::min<std::chrono::microseconds>(left, m_pauseTick));
        if (!bytes) {
            return bytes;
        }
        if (!bytes->isEmpty()) {
            m_lastByteAt = now();
            m_bytesReceived += static_cast<quint64>(bytes->size());
            qCDebug(logBytes) << "<" << bytes->toHex(' ');
            return bytes;
        }
    }
}

} // namespace gorizont
