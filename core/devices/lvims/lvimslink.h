#pragma once

#include "core/devices/lvims/lvimsprotocol.h"
#include "core/line/line.h"
#include "core/protocol/modbustcp.h"
#include "core/values/timing.h"

namespace gorizont::lvims {

/// How a module is addressed.
struct Address
{
    quint8 unit = 1; ///< Unit{i}
    modbustcp::ReadFunction readFunction = modbustcp::ReadFunction::HoldingRegisters; ///< ReadFunction{i}
    bool operator==(const Address &) const = default;
};

/// Reads and writes registers over a line, one exchange a call, each with a transaction of its own. Thread of the line.
class Link
{
public:
    /// \a firstTransaction: polling and service begin at different ones, so that a late answer to the one is none to the other.
    Link(const Address &address, const Timing &timing, quint16 firstTransaction)
        : m_address(address)
        , m_timing(timing)
        , m_transaction(firstTransaction)
    {
    }

    /// Refused: an exception, exception() says which one. BadReply: another number of registers came.
    Result<Words> read(Line &line, const Range &range);
    Result<void> write(Line &line, quint16 first, const QList<quint16> &values);
    /// Writes \a values, then reads, in one go: no other client comes between.
    Result<Words> writeAndRead(Line &line, quint16 writeFirst, const QList<quint16> &values, const Range &range);

    /// Of the last call; 0: none.
    int exception() const { return m_exception; }

private:
    Result<QByteArray> exchange(Line &line, const QByteArray &pdu);
    Result<Words> readWith(Line &line, const QByteArray &pdu, const Range &range);

    Address m_address;
    Timing m_timing;
    quint16 m_transaction;
    int m_exception = 0;
};

} // namespace gorizont::lvims
