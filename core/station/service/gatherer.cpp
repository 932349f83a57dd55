#include "core/station/service/gatherer.h"

#include "core/protocol/ackmessages.h"
#include "core/station/service/weatheranswer.h"

namespace gorizont::station {

namespace {

using namespace std::chrono_literals;

constexpr auto thinking = 1s; ///< of a station, beyond the time that bytes take
constexpr auto writeTimeout = 1s;
constexpr int usualParameters = 32; ///< of a station of which nothing is known
constexpr qint64 bitsOfByte = 12;

std::chrono::milliseconds answerTimeout(const GatheredObject &object)
{
    const qint64 parameters = object.ids.isEmpty() ? usualParameters : object.ids.size();
    const qint64 extras = (ack::extraFloats + ack::extraTimes) * 4;
    const qint64 bytes = 2 * ack::headerSize + parameters * ack::valuesPerParameter(object.command) * 4 + extras + 1;
    return thinking + std::chrono::milliseconds(1000 * bytes * bitsOfByte / std::max(object.line.baudRate, 1));
}

} // namespace

Result<ack::Answer> askObject(Line &line, const GatheredObject &object, quint32 outputs, int attempts)
{
    const ack::Question question{
        static_cast<quint8>(object.number), static_cast<quint8>(object.command), static_cast<int>(object.ids.size())};
    const Request request = ack::ask(question, outputs);
    Result<ack::Answer> answer = Fault::Timeout;
    for (int i = 0; i < attempts; ++i) {
        const auto bytes = line.exchange(
            {request.bytes, request.scan, writeTimeout, answerTimeout(object), std::chrono::microseconds(0)});
        answer = bytes ? ack::decodeAnswer(*bytes, question) : Result<ack::Answer>(bytes.fault());
        if (answer || isLineFault(answer.fault())) {
            return answer;
        }
    }
    return answer;
}

Gatherer::Gatherer(const GatheredObject &object, int attempts, MakeLine makeLine)
    : m_object(object)
    , m_attempts(attempts)
    , m_makeLine(std::move(makeLine))
{
}

Gatherer::~Gatherer() = default;

/// Empty: the line is open.
QString Gatherer::openLine()
{
    if (!m_line) {
        m_line = m_makeLine();
        if (!m_line) {
            return tr("no line leads there");
        }
        m_interruptible = m_line.get();
        if (m_isInterrupted) {
            m_line->interrupt();
        }
    }
    return m_line->isOpen() || m_line->open() ? QString() : m_line->lastError().text;
}

void Gatherer::poll(quint32 outputs)
{
    GatheredWeather result;
    result.number = m_object.number;
    result.command = m_object.command;
    result.problem = openLine();
    if (result.problem.isEmpty()) {
        const auto answer = askObject(*m_line, m_object, outputs, m_attempts);
        result.isAnswer = static_cast<bool>(answer);
        if (answer) {
            result.weather = weatherOf(m_object.command, *answer, m_object.ids);
            result.extras = extrasOf(*answer);
        } else {
            result.problem = faultName(answer.fault());
        }
    }
    Q_EMIT gathered(result);
}

void Gatherer::interrupt()
{
    m_isInterrupted = true;
    if (Line *line = m_interruptible) {
        line->interrupt();
    }
}

} // namespace gorizont::station
