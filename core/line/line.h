#pragma once

#include "core/protocol/scan.h"
#include "core/values/lineconfig.h"
#include "core/values/result.h"
#include "core/values/timing.h"

#include <QByteArray>
#include <QDeadlineTimer>
#include <QHash>
#include <QString>

#include <atomic>
#include <optional>

namespace gorizont {

/// One request and what to expect for it.
struct Exchange
{
    QByteArray request;
    ScanFunction scan;
    std::chrono::milliseconds writeTimeout{100};
    std::chrono::milliseconds readTimeout{200};
    std::chrono::microseconds quietBefore{0}; ///< silence that the device needs before the request
};

/// How the bytes of a serial line are sent, as far as a device can be told.
struct PortSettings
{
    int baudRate = 9600; ///< baud
    Parity parity = Parity::None;
    StopBits stopBits = StopBits::One;
    bool operator==(const PortSettings &) const = default;
};

/// A half-duplex way to devices. Lives in the thread of its port and blocks there, in slices of at most the pause
/// tick; only interrupt() and resume() may be called from another thread. Owned by the LineWorker; drivers borrow it
/// for one turn.
class Line
{
public:
    struct Error
    {
        int code = 0; ///< the system's or Qt's number
        QString text;
    };

    explicit Line(std::chrono::milliseconds pauseTick)
        : m_pauseTick(pauseTick)
    {
    }
    virtual ~Line();
    Line(const Line &) = delete;
    Line &operator=(const Line &) = delete;

    /// Opens the line; Fault::Closed with lastError() set when that fails.
    virtual Result<void> open() = 0;
    virtual void close() = 0;
    virtual bool isOpen() const = 0;

    /// Sends the request and reads until `scan` finds its answer: the only request/answer loop of the program.
    /// Returns the bytes of the answer. Timeout: no whole answer in time. Checksum: only damaged answers. Closed: the
    /// line is gone and was closed. Cancelled: interrupt() was called.
    Result<QByteArray> exchange(const Exchange &exchange);

    /// Whether one more answer is wanted.
    using TakeAnswer = std::function<bool(QByteArrayView answer)>;

    /// The same for a request with many answers: hands each to \a take until it wants no more. The time-out is that between
    /// two of them, so noise does not prolong it.
    Result<void> exchangeMany(const Exchange &exchange, const TakeAnswer &take);

    /// Sends a request that nobody answers (broadcast).
    Result<void> send(
        const QByteArray &bytes, std::chrono::milliseconds timeout, std::chrono::microseconds quietBefore);

    /// Throws away what has arrived and nobody asked for. Closed: the line is gone.
    Result<void> discardInput() { return waitForQuiet(std::chrono::microseconds(0)); }

    /// Empty: the line does not know, or has none.
    virtual std::optional<PortSettings> port() const { return std::nullopt; }
    /// From now on bytes are sent and heard like this, until the next call or until the port is opened again: then it is
    /// as the configuration says. Refused: the line cannot. Closed: the port took them badly and was closed.
    virtual Result<void> setPort(const PortSettings &port);

    /// The next request waits until the line was silent for this long, whoever sends it.
    void requireQuiet(std::chrono::microseconds silence) { m_requiredQuiet = silence; }

    /// The word that polling repeats to the device at an address because the user has set it there since the program started, such
    /// as the outputs of a weather station. Empty: nobody has. Thread of the line; it outlives closing and opening.
    std::optional<quint32> standingWord(int address) const
    {
        const auto found = m_standingWords.constFind(address);
        return found == m_standingWords.constEnd() ? std::nullopt : std::optional(*found);
    }
    void setStandingWord(int address, quint32 word) { m_standingWords.insert(address, word); }

    /// Ends the running and every later wait with Fault::Cancelled until resume(). Thread-safe.
    void interrupt() { m_isInterrupted.store(true, std::memory_order_relaxed); }
    void resume() { m_isInterrupted.store(false, std::memory_order_relaxed); }
    bool isInterrupted() const { return m_isInterrupted.load(std::memory_order_relaxed); }

    quint64 bytesSent() const { return m_bytesSent; }
    quint64 bytesReceived() const { return m_bytesReceived; }
    quint64 writeErrors() const { return m_writeErrors; }
    const Error &lastError() const { return m_lastError; }

protected:
    /// Writes everything. Closed: the line is gone, or did not take the bytes within \a timeout; it is closed then.
    virtual Result<void> writeAll(QByteArrayView bytes, std::chrono::milliseconds timeout) = 0;

    /// Waits at most \a timeout for bytes and returns all that are there. Empty: none came, the line is still good.
    /// Closed: the line is gone.
    virtual Result<QByteArray> readSome(std::chrono::microseconds timeout) = 0;

    /// The clock of the line; a line of a test brings its own, so that silence costs it no time.
    virtual SteadyTime now() const;
    virtual void sleepUntil(SteadyTime time);

    /// How long to wait at once, in ms, for something that may take until \a deadline.
    int sliceUntil(const QDeadlineTimer &deadline) const;

    void setLastError(int code, const QString &text) { m_lastError = {code, text}; }

private:
    Result<QByteArray> readSlice(SteadyTime deadline);
    Result<void> waitForQuiet(std::chrono::microseconds silence);
    Result<void> writeRequest(const QByteArray &bytes, std::chrono::milliseconds timeout);
    Result<void> receive(const ScanFunction &scan, std::chrono::milliseconds timeout, const TakeAnswer &take);

    std::chrono::milliseconds m_pauseTick;
    std::chrono::microseconds m_requiredQuiet{0};
    SteadyTime m_lastByteAt{};
    std::atomic_bool m_isInterrupted{false};
    quint64 m_bytesSent = 0;
    quint64 m_bytesReceived = 0;
    quint64 m_writeErrors = 0;
    Error m_lastError;
    QHash<int, quint32> m_standingWords; ///< by address
};

} // namespace gorizont
