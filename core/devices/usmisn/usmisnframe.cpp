#include "core/devices/usmisn/usmisnframe.h"

#include <array>

namespace gorizont::usmisn {

namespace {

struct Spelling
{
    const char *name;
    const char *everybody;
};

/// In the order of Instruction.
constexpr std::array<Spelling, 15> spellings{{
    {"GetSerial", "0"},
    {"GetType", "0"},
    {"GetProgVersion", "0"},
    {"GetDateCalibration", "0"},
    {"GetCountCalibration", "0"},
    {"GetInfo", "0"},
    {"GetAddress", "000"},
    {"SetAddress", "000"},
    {"SetPortSettings", "000"},
    {"ResetPortSettings", "000"},
    {"GetValue", "0"},
    {"GetRecord", "0"},
    {"StartCycle", "0"},
    {"StopCycle", "0"},
    {"GetCRC", "0"},
}};

const Spelling &spellingOf(Instruction instruction)
{
    return spellings[static_cast<std::size_t>(instruction)];
}

constexpr QByteArrayView opening("%/");
constexpr qsizetype longestAddress = 3; ///< digits
constexpr qsizetype envelopeParts = 5; ///< kind, address, transaction, instruction, data

/// Empty: not one to three digits, or above 255.
std::optional<int> addressIn(const QByteArray &text)
{
    if (text.isEmpty() || text.size() > longestAddress) {
        return std::nullopt;
    }
    int address = 0;
    for (const char c : text) {
        if (c < '0' || c > '9') {
            return std::nullopt;
        }
        address = 10 * address + (c - '0');
    }
    return address <= 255 ? std::optional(address) : std::nullopt;
}

/// Where the bytes from \a start on may begin a message that has not begun yet.
qsizetype openingFrom(QByteArrayView bytes, qsizetype start)
{
    const qsizetype found = bytes.indexOf(opening, start);
    if (found >= 0) {
        return found;
    }
    return !bytes.isEmpty() && bytes.back() == '%' && bytes.size() > start ? bytes.size() - 1 : bytes.size();
}

/// Whether a message that began at \a start may end with the `%` at \a end: `/%`, or `%` before CR.
bool isClosing(QByteArrayView bytes, qsizetype start, qsizetype end)
{
    const bool hasSlash = end >= start + opening.size() + 1 && bytes.at(end - 1) == '/';
    return hasSlash || (end + 1 < bytes.size() && bytes.at(end + 1) == '\r');
}

} // namespace

QByteArray nameOf(Instruction instruction)
{
    return spellingOf(instruction).name;
}

QByteArray encodeRequest(const Question &question, const QByteArray &data)
{
    const Spelling &spelling = spellingOf(question.instruction);
    const QByteArray address =
        question.address == everybody ? QByteArray(spelling.everybody) : QByteArray::number(question.address);
    return "%/Q/" + address + '/' + question.transaction + '/' + spelling.name + '/' + data + "/%";
}

std::optional<Answer> decodeAnswer(QByteArrayView message, const Question &question)
{
    if (message.size() < opening.size() + 1 || message.size() > longestMessage || !message.startsWith(opening)
        || message.back() != '%') {
        return std::nullopt;
    }
    QByteArrayView inner = message.sliced(opening.size()).chopped(1);
    if (inner.endsWith('/')) {
        inner.chop(1);
    }
    const QByteArrayList parts = inner.toByteArray().split('/');
    if (parts.size() != envelopeParts || parts.at(0) != "R" || parts.at(2) != question.transaction
        || parts.at(3) != spellingOf(question.instruction).name) {
        return std::nullopt;
    }
    const auto address = addressIn(parts.at(1));
    if (!address || (question.address != everybody && *address != question.address)) {
        return std::nullopt;
    }
    Answer answer{*address, parts.at(4).split(',')};
    for (QByteArray &field : answer.fields) {
        while (field.startsWith(' ')) {
            field.remove(0, 1);
        }
    }
    return answer;
}

/// `/%` may also be the slash of a broken message and the beginning of the next one: only an answer to the question ends
/// there at once, for everything else the next byte decides.
Scan scanAnswer(QByteArrayView bytes, const Question &question)
{
    qsizetype start = openingFrom(bytes, 0);
    qsizetype end = start;
    while (start + opening.size() <= bytes.size()) {
        end = bytes.indexOf('%', std::max(end + 1, start + opening.size()));
        if (end < 0) {
            const bool isEndless = bytes.size() - start > longestMessage;
            return Scan::incomplete(isEndless ? openingFrom(bytes, bytes.size() - 1) : start);
        }
        const bool isTooLong = end - start + 1 > longestMessage;
        if (!isTooLong && isClosing(bytes, start, end)
            && decodeAnswer(bytes.sliced(start, end - start + 1), question)) {
            return Scan::complete(start, end - start + 1);
        }
        if (end + 1 == bytes.size()) {
            return Scan::incomplete(isTooLong ? end : start);
        }
        const bool isOpening = bytes.at(end + 1) == '/';
        if (isOpening || isTooLong || isClosing(bytes, start, end)) {
            start = isOpening ? end : openingFrom(bytes, end + 1);
            end = start;
        }
    }
    return Scan::incomplete(start);
}

quint32 crcOf(QByteArrayView message)
{
    quint32 crc = 0xFFFFFFFF;
    for (const char c : message) {
        crc ^= static_cast<quint8>(c);
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc & 1) ? (crc >> 1) ^ 0xEDB88320 : crc >> 1;
        }
    }
    return ~crc;
}

QByteArray Transactions::next()
{
    const QByteArray text = QByteArray::number(m_next).rightJustified(3, '0');
    m_next = m_next == m_last ? m_first : m_next + 1;
    return text;
}

} // namespace gorizont::usmisn
