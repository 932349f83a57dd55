#include "core/devices/lvims/lvimslink.h"

namespace gorizont::lvims {

Result<QByteArray> Link::exchange(Line &line, const QByteArray &pdu)
{
    m_exception = 0;
    if (pdu.isEmpty()) {
        return Fault::Refused;
    }
    const Request request = modbustcp::request({m_transaction++, m_address.unit}, pdu);
    const auto answer = line.exchange(
        {.request = request.bytes,
         .scan = request.scan,
         .writeTimeout = m_timing.writeCommand,
         .readTimeout = m_timing.readCommand,
         .quietBefore = {}});
    if (answer) {
        m_exception = modbustcp::exceptionCode(*answer).value_or(0);
    }
    return answer;
}

Result<Words> Link::readWith(Line &line, const QByteArray &pdu, const Range &range)
{
    const auto answer = exchange(line, pdu);
    if (!answer) {
        return answer.fault();
    }
    const auto values = modbustcp::registers(*answer, range.count);
    return values ? Result<Words>(Words(range.first, *values)) : values.fault();
}

Result<Words> Link::read(Line &line, const Range &range)
{
    return readWith(line, modbustcp::readRegisters(m_address.readFunction, range.first, range.count), range);
}

Result<void> Link::write(Line &line, quint16 first, const QList<quint16> &values)
{
    const QByteArray pdu = modbustcp::writeRegisters(first, values);
    const auto answer = exchange(line, pdu);
    return answer ? modbustcp::confirmation(*answer, pdu) : answer.fault();
}

Result<Words> Link::writeAndRead(Line &line, quint16 writeFirst, const QList<quint16> &values, const Range &range)
{
    return readWith(line, modbustcp::writeAndReadRegisters(range.first, range.count, writeFirst, values), range);
}

} // namespace gorizont::lvims
