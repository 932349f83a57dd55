#include "core/devices/ind3/ind3protocol210.h"

#include "core/devices/ind3/ind3values.h"
#include "core/protocol/bytes.h"
#include "core/protocol/checksums.h"

namespace gorizont::ind3::v210 {

namespace {

constexpr int readAnglesPacket = 0x01;
constexpr int pingPacket = 0x03;
constexpr char pingAnswer = '\x35';
constexpr qsizetype anglesLength = 7; ///< data and SS

QByteArray encodeRequest(int packet, int address)
{
    QByteArray bytes = QByteArray::fromHex("7E9A");
    appendByte(bytes, packet);
    appendByte(bytes, address);
    appendByte(bytes, 0x100 - (packet + address));
    appendByte(bytes, 0x7E);
    return bytes;
}

/// Nothing marks the beginning of an answer: it is tried at every byte until a check sum is good.
Scan scanAngles(QByteArrayView bytes, const QByteArray &request)
{
    if (bytes.size() < anglesLength) {
        return Scan::incomplete();
    }
    if (bytes.startsWith(request)) {
        return Scan::incomplete(request.size());
    }
    return byteSum(bytes.first(anglesLength)) == 0 ? Scan::complete(0, anglesLength) : Scan::damaged(0, 1);
}

/// An echo may hold the byte that is waited for, as address or check sum.
Scan scanPing(QByteArrayView bytes, const QByteArray &request)
{
    qsizetype at = 0;
    while (at < bytes.size()) {
        const QByteArrayView rest = bytes.sliced(at);
        if (rest.startsWith(request)) {
            at += request.size();
        } else if (QByteArrayView(request).startsWith(rest)) {
            return Scan::incomplete(at);
        } else if (rest.front() == pingAnswer) {
            return Scan::complete(at, 1);
        } else {
            ++at;
        }
    }
    return Scan::incomplete(bytes.size());
}

} // namespace

std::optional<Request> readAngles(int address)
{
    if (!isAddress(address)) {
        return std::nullopt;
    }
    const QByteArray bytes = encodeRequest(readAnglesPacket, address);
    return Request{bytes, [bytes](QByteArrayView received) { return scanAngles(received, bytes); }};
}

std::optional<Request> ping(int address)
{
    if (!isAddress(address)) {
        return std::nullopt;
    }
    const QByteArray bytes = encodeRequest(pingPacket, address);
    return Request{bytes, [bytes](QByteArrayView received) { return scanPing(received, bytes); }};
}

Result<Tilt> decodeAngles(QByteArrayView answer)
{
    if (answer.size() != anglesLength || byteSum(answer) != 0) {
        return Fault::BadReply;
    }
    const auto tilt = decodeAngleBlock(answer.chopped(1));
    return tilt ? Result(*tilt) : Result<Tilt>(Fault::BadReply);
}

} // namespace gorizont::ind3::v210
