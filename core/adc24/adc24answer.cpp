#include "core/adc24/adc24answer.h"

#include "core/protocol/bytes.h"

#include <algorithm>

namespace gorizont {

namespace {

constexpr quint8 ourAddress = 1;
constexpr quint8 countSamples = 1;
constexpr quint8 readSamples = 3;
constexpr quint8 int16Element = 2;
constexpr double scale = 1.0 / 8; ///< arc-seconds

/// Makes room for an answer of \a size bytes and returns where it begins.
char *appendAnswer(AnswerBuffer &answers, quint8 command, qsizetype size)
{
    const qsizetype at = answers.size();
    answers.resize(at + size);
    char *answer = answers.data() + at;
    answer[0] = static_cast<char>(ourAddress);
    answer[1] = static_cast<char>(command);
    return answer;
}

void appendCount(AnswerBuffer &answers, const Adc24Image &image)
{
    const quint64 available = std::min<quint64>(image.ring().size(), std::numeric_limits<quint32>::max());
    char *answer = appendAnswer(answers, countSamples, 6);
    qToLittleEndian(static_cast<quint32>(available), answer + 2);
}

void appendNoSamples(AnswerBuffer &answers, const Adc24Image &image)
{
    char *answer = appendAnswer(answers, readSamples, 8);
    qToLittleEndian(image.status(), answer + 2);
    qToLittleEndian(quint32{0}, answer + 4);
}

void appendSamples(AnswerBuffer &answers, const Adc24Image &image, quint64 first, quint32 count)
{
    char *answer = appendAnswer(answers, readSamples, adc24::headerSize + 2 * qsizetype{count});
    answer[2] = static_cast<char>(int16Element);
    answer[3] = static_cast<char>(image.status() >> 8);
    qToLittleEndian(count, answer + 4);
    qToLittleEndian(scale, answer + 8);
    qToLittleEndian(image.rate(), answer + 16);
    image.ring().copy(first, count, answer + adc24::headerSize);
}

/// False: this is no request.
bool answer(QByteArrayView request, const Adc24Image &image, AnswerBuffer &answers)
{
    const quint8 command = byteAt(request, 1);
    if (byteAt(request, 0) != ourAddress || (command != countSamples && command != readSamples)) {
        return false;
    }
    if (command == countSamples) {
        appendCount(answers, image);
        return true;
    }
    const quint64 block = readLittle<quint32>(request, 5).value_or(0);
    const quint32 size = std::clamp<quint32>(readLittle<quint32>(request, 9).value_or(0), 1, adc24::mostSamples);
    if (image.ring().size() / size <= block) {
        appendNoSamples(answers, image);
    } else {
        appendSamples(answers, image, block * size, size);
    }
    return true;
}

} // namespace

AnsweredRequests answerAdc24(QByteArrayView received, const Adc24Image &image, AnswerBuffer &answers)
{
    AnsweredRequests done;
    for (; received.size() - done.consumed >= adc24::requestSize; done.consumed += adc24::requestSize) {
        const bool isRequest = answer(received.sliced(done.consumed, adc24::requestSize), image, answers);
        ++(isRequest ? done.requests : done.unanswered);
    }
    return done;
}

} // namespace gorizont
