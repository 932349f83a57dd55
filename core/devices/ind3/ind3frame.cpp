#include "core/devices/ind3/ind3frame.h"

#include "core/devices/ind3/ind3values.h"
#include "core/protocol/bytes.h"
#include "core/protocol/checksums.h"

namespace gorizont::ind3 {

namespace {

constexpr char delimiter = '\x7E';
constexpr char escape = '\x7D';
constexpr char escapeFlip = '\x20';

constexpr qsizetype shortestContent = 4; ///< PP KK AA SS
constexpr qsizetype headLength = 3; ///< PP KK AA
constexpr qsizetype longestContent = 2 * (shortestContent + longestName); ///< every byte escaped

struct DataLength
{
    qsizetype least = 0;
    qsizetype most = 0;
};

/// Of the answer.
DataLength answerLength(Packet packet)
{
    switch (packet) {
    case Packet::ReadAngles:
    case Packet::GetOffset: return {6, 6};
    case Packet::Version: return {5, 5};
    case Packet::Error:
    case Packet::GetBaud:
    case Packet::GetTicks:
    case Packet::GetPeriod: return {1, 1};
    case Packet::GetName: return {1, longestName};
    case Packet::Revision: return {2, 2};
    case Packet::SerialNumber: return {4, 4};
    case Packet::SetBaud:
    case Packet::SetName:
    case Packet::SetOffset:
    case Packet::SetAddress:
    case Packet::SetTicks:
    case Packet::SetPeriod: return {0, 0};
    }
    return {};
}

/// Empty: ends in the middle of an escape.
std::optional<QByteArray> unescaped(QByteArrayView content)
{
    QByteArray bytes;
    for (qsizetype i = 0; i < content.size(); ++i) {
        if (content.at(i) != escape) {
            bytes += content.at(i);
        } else if (++i < content.size()) {
            bytes += static_cast<char>(content.at(i) ^ escapeFlip);
        } else {
            return std::nullopt;
        }
    }
    return bytes;
}

/// \a content: unescaped, with a good check sum.
Frame frameOf(QByteArrayView content)
{
    const quint16 packet = readBig<quint16>(content, 0).value_or(0);
    return {
        static_cast<Packet>(packet), byteAt(content, 2),
        content.sliced(headLength, content.size() - shortestContent).toByteArray()};
}

/// What stands between two delimiters: the answer, something else that is whole (Incomplete: look further), or damage.
Scan::State judge(QByteArrayView content, Packet asked, int address)
{
    if (content.size() < shortestContent || content.size() > longestContent) {
        return Scan::State::Incomplete;
    }
    const auto plain = unescaped(content);
    if (!plain || plain->size() < shortestContent || xorSum(*plain) != 0) {
        return Scan::State::Damaged;
    }
    return isAnswer(frameOf(*plain), asked, address) ? Scan::State::Complete : Scan::State::Incomplete;
}

} // namespace

QByteArray encodeFrame(const Frame &frame)
{
    QByteArray content;
    appendBig(content, static_cast<quint16>(frame.packet));
    appendByte(content, frame.address);
    content += frame.data;
    appendByte(content, xorSum(content));

    QByteArray bytes(1, delimiter);
    for (const char c : std::as_const(content)) {
        if (c == delimiter || c == escape) {
            bytes += escape;
            bytes += static_cast<char>(c ^ escapeFlip);
        } else {
            bytes += c;
        }
    }
    return bytes += delimiter;
}

std::optional<Frame> decodeFrame(QByteArrayView bytes)
{
    const bool isDelimited = bytes.size() >= 2 && bytes.front() == delimiter && bytes.back() == delimiter;
    if (!isDelimited) {
        return std::nullopt;
    }
    const QByteArrayView inner = bytes.sliced(1, bytes.size() - 2);
    const auto content = unescaped(inner);
    if (inner.contains(delimiter) || !content || content->size() < shortestContent || xorSum(*content) != 0) {
        return std::nullopt;
    }
    return frameOf(*content);
}

bool isAnswer(const Frame &frame, Packet asked, int address)
{
    const bool isExpected = frame.packet == asked || (asked == Packet::Version && frame.packet == Packet::Error);
    // The echo of a request has data where the answer has none, or the other way round.
    const DataLength length = answerLength(frame.packet);
    return isExpected && frame.address == address && frame.data.size() >= length.least
        && frame.data.size() <= length.most;
}

/// Every delimiter may open a frame, also the one that closes another; so damage never takes the next frame along.
Scan scanAnswer(QByteArrayView bytes, Packet asked, int address)
{
    qsizetype start = bytes.indexOf(delimiter);
    while (start >= 0) {
        const qsizetype end = bytes.indexOf(delimiter, start + 1);
        if (end < 0) {
            const bool isEndless = bytes.size() - start - 1 > longestContent;
            return Scan::incomplete(isEndless ? bytes.size() : start);
        }
        switch (judge(bytes.sliced(start + 1, end - start - 1), asked, address)) {
        case Scan::State::Complete: return Scan::complete(start, end - start + 1);
        case Scan::State::Damaged: return Scan::damaged(start, end - start);
        case Scan::State::Incomplete: start = end; break;
        }
    }
    return Scan::incomplete(bytes.size());
}

bool isQuestion(Packet packet)
{
    return packet != Packet::Error && answerLength(packet).most > 0;
}

} // namespace gorizont::ind3
