#include "core/protocol/ackmessages.h"

#include "core/protocol/bytes.h"

#include <array>

namespace gorizont::ack {

namespace {

constexpr quint32 noValue = 0xFFFFFFFF;
constexpr qsizetype valueSize = 4;
constexpr int extras = extraFloats + extraTimes;

/// Of the block with its check sum.
qsizetype blockSize(int values)
{
    return values * valueSize + 1;
}

/// Whether \a length, LEN of an answer to CMD 8, counts the values behind the parameters too (spec/mk14.md, 3).
bool countsExtras(const Question &question, int length)
{
    return question.parameters > 0 && length == question.parameters + extras;
}

int parameterCount(const Question &question, int length)
{
    return question.command == lastDataCommand && countsExtras(question, length) ? length - extras : length;
}

qsizetype answerBlock(const Question &question, int length)
{
    if (length == 0) {
        return 0;
    }
    const int more = question.command == lastDataCommand ? extras : 0;
    return blockSize(parameterCount(question, length) * valuesPerParameter(question.command) + more);
}

Scan scanAnswer(QByteArrayView bytes, const Question &question)
{
    return scanFrame(bytes, [&question](const Header &header) -> std::optional<qsizetype> {
        if (header.command != 0 || header.address != question.address) {
            return std::nullopt;
        }
        return answerBlock(question, header.length);
    });
}

/// A bare header with CMD 0 and LEN 0 (spec/mk14.md, 4).
Scan scanConfirmation(QByteArrayView bytes, quint8 address)
{
    return scanFrame(bytes, [address](const Header &header) -> std::optional<qsizetype> {
        const bool isIt = header.command == 0 && header.length == 0 && header.address == address;
        return isIt ? std::optional<qsizetype>(0) : std::nullopt;
    });
}

/// Four bytes FF are no value: compared before they become a float, which would be a NaN among many.
std::optional<float> readValue(QByteArrayView bytes, qsizetype offset)
{
    const auto bits = readLittle<quint32>(bytes, offset);
    return bits && *bits != noValue ? readLittle<float>(bytes, offset) : std::nullopt;
}

Values readValues(QByteArrayView bytes, qsizetype offset, int count)
{
    Values values;
    for (int i = 0; i < count; ++i) {
        values.append(readValue(bytes, offset + i * valueSize));
    }
    return values;
}

QList<qint32> readTimes(QByteArrayView bytes, qsizetype offset)
{
    QList<qint32> times;
    for (int i = 0; i < extraTimes; ++i) {
        const qint32 time = readLittle<qint32>(bytes, offset + i * valueSize).value_or(0);
        if (time == 0) {
            break;
        }
        times.append(time);
    }
    return times;
}

void appendValue(QByteArray &bytes, const std::optional<float> &value)
{
    if (value) {
        appendLittle<float>(bytes, *value);
    } else {
        appendLittle<quint32>(bytes, noValue);
    }
}

/// Exactly \a count of \a values, with what is missing as no value.
void appendValues(QByteArray &bytes, const Values &values, int count)
{
    for (int i = 0; i < count; ++i) {
        appendValue(bytes, values.value(i));
    }
}

Request confirmedRequest(quint8 address, const QByteArray &bytes)
{
    return {bytes, [address](QByteArrayView received) { return scanConfirmation(received, address); }};
}

} // namespace

int valuesPerParameter(int command)
{
    constexpr std::array<int, lastDataCommand + 1> counts{0, 1, 2, 3, 4, 5, 6, 3, 1};
    return command >= firstDataCommand && command <= lastDataCommand ? counts[static_cast<std::size_t>(command)] : 0;
}

QList<std::optional<double> WeatherParameter::*> membersOf(int command)
{
    using P = WeatherParameter;
    switch (command) {
    case 2: return {&P::mean, &P::instant};
    case 3: return {&P::mean, &P::minimum, &P::maximum};
    case 4: return {&P::mean, &P::instant, &P::minimum, &P::maximum};
    case 5: return {&P::mean, &P::instant, &P::minimum, &P::maximum, &P::voltage};
    case 6: return {&P::mean, &P::instant, &P::minimum, &P::maximum, &P::voltage, &P::voltageInstant};
    case 7: return {&P::mean, &P::maxPeriod, &P::deviation};
    default: return {&P::mean};
    }
}

Request ask(const Question &question, quint32 outputs)
{
    return {encodeHeader({question.address, question.command, 0, outputs}), [question](QByteArrayView received) {
                return scanAnswer(received, question);
            }};
}

Request askTime(quint8 address, quint32 secondsSince1970)
{
    return confirmedRequest(address, encodeHeader({address, transferCommand, 0, secondsSince1970}));
}

std::optional<Request> askFile(quint8 address, const QByteArray &name, const QByteArray &text)
{
    if (name.isEmpty() || name.size() > longestName || text.size() > longestFile) {
        return std::nullopt;
    }
    const Header header{address, transferCommand, static_cast<quint8>(name.size()), static_cast<quint32>(text.size())};
    return confirmedRequest(address, encodeHeader(header) + encodeBlock(name + text));
}

Result<Answer> decodeAnswer(QByteArrayView frame, const Question &question)
{
    const auto header = readHeader(frame);
    const int each = valuesPerParameter(question.command);
    if (!header || header->command != 0 || header->address != question.address || each == 0
        || frame.size() != headerSize + answerBlock(question, header->length)) {
        return Fault::BadReply;
    }
    Answer answer;
    answer.digital = header->digital;
    if (header->length == 0) {
        return answer;
    }
    const QByteArrayView block = frame.sliced(headerSize);
    if (!isBlockGood(block)) {
        return Fault::BadReply;
    }
    qsizetype at = 0;
    for (int i = 0; i < parameterCount(question, header->length); ++i, at += each * valueSize) {
        answer.parameters.append(readValues(block, at, each));
    }
    if (question.command == lastDataCommand) {
        answer.extras = readValues(block, at, extraFloats);
        answer.precipitation = readTimes(block, at + extraFloats * valueSize);
    }
    return answer;
}

Scan scanRequest(QByteArrayView bytes, quint8 address)
{
    return scanFrame(bytes, [address](const Header &header) -> std::optional<qsizetype> {
        if (header.command == 0 || header.address != address) {
            return std::nullopt;
        }
        if (header.command != transferCommand) {
            return header.length == 0 ? std::optional<qsizetype>(0) : std::nullopt;
        }
        if (header.length == 0) {
            return 0;
        }
        return header.digital <= longestFile ? std::optional<qsizetype>(header.length + header.digital + 1)
                                             : std::nullopt;
    });
}

Result<Asked> decodeRequest(QByteArrayView frame)
{
    const auto header = readHeader(frame);
    if (!header || header->command == 0) {
        return Fault::BadReply;
    }
    Asked asked{header->address, header->command, header->digital, {}, {}};
    const QByteArrayView block = frame.sliced(headerSize);
    if (header->length == 0) {
        return block.isEmpty() ? Result<Asked>(asked) : Fault::BadReply;
    }
    if (header->command != transferCommand || header->digital > longestFile
        || block.size() != static_cast<qsizetype>(header->length) + header->digital + 1 || !isBlockGood(block)) {
        return Fault::BadReply;
    }
    asked.fileName = block.first(header->length).toByteArray();
    asked.file = block.sliced(header->length, header->digital).toByteArray();
    return asked;
}

QByteArray encodeAnswer(quint8 address, int command, const Answer &answer)
{
    if (answer.parameters.isEmpty()) {
        return encodeConfirmation(address, answer.digital);
    }
    QByteArray block;
    for (const Values &values : answer.parameters) {
        appendValues(block, values, valuesPerParameter(command));
    }
    if (command == lastDataCommand) {
        appendValues(block, answer.extras, extraFloats);
        for (int i = 0; i < extraTimes; ++i) {
            appendLittle<qint32>(block, answer.precipitation.value(i));
        }
    }
    const Header header{address, 0, static_cast<quint8>(answer.parameters.size()), answer.digital};
    return encodeHeader(header) + encodeBlock(block);
}

QByteArray encodeConfirmation(quint8 address, quint32 digital)
{
    return encodeHeader({address, 0, 0, digital});
}

} // namespace gorizont::ack
