#include "core/station/service/requestlistener.h"

namespace gorizont::station {

namespace {

using namespace std::chrono_literals;

/// No dispatcher pauses for so long inside of a frame; a shorter silence may be a radio modem that hands on packets.
constexpr auto longestSilence = 1s;

constexpr qsizetype extrasSize = (ack::extraFloats + ack::extraTimes) * 4;

bool isDataCommand(quint8 command)
{
    return ack::valuesPerParameter(command) > 0;
}

} // namespace

RequestListener::RequestListener(IsOwn isOwn, std::chrono::microseconds byteTime)
    : m_isOwn(std::move(isOwn))
    , m_byteTime(byteTime)
{
}

QList<ack::Asked> RequestListener::hear(QByteArrayView bytes, SteadyTime now)
{
    giveUpStale(now);
    if (m_heard.isEmpty()) {
        m_frameBegan = now;
    }
    m_lastHeard = now;
    m_heard += bytes;
    QList<ack::Asked> requests;
    qsizetype done = 0;
    for (;;) {
        const QByteArrayView rest = QByteArrayView(m_heard).sliced(done);
        const Scan found = ack::scanFrame(rest, [this](const ack::Header &header) { return blockLength(header); });
        if (found.state == Scan::State::Complete) {
            if (const auto asked = take(rest.sliced(found.skip, found.length))) {
                requests.append(*asked);
            }
        }
        done += found.skip + found.length;
        if (found.skip + found.length > 0) {
            m_frameBegan = now;
        }
        if (found.state == Scan::State::Incomplete) {
            m_heard.remove(0, done);
            return requests;
        }
    }
}

/// Empty: no station says this header, so it is part of something else.
std::optional<qsizetype> RequestListener::blockLength(const ack::Header &header) const
{
    if (header.address == 0) {
        return std::nullopt;
    }
    if (header.command == ack::transferCommand) {
        if (header.length == 0) {
            return 0;
        }
        return header.digital <= ack::longestFile
            ? std::optional<qsizetype>(qsizetype{header.length} + header.digital + 1)
            : std::nullopt;
    }
    if (header.command != 0) {
        return isDataCommand(header.command) && header.length == 0 ? std::optional<qsizetype>(0) : std::nullopt;
    }
    if (header.length == 0) {
        return 0;
    }
    if (header.address != m_question.address) {
        return std::nullopt;
    }
    const qsizetype values = qsizetype{header.length} * ack::valuesPerParameter(m_question.command) * 4;
    return values + (m_question.command == ack::lastDataCommand ? extrasSize : 0) + 1;
}

/// Empty: said by, or to, somebody else.
std::optional<ack::Asked> RequestListener::take(QByteArrayView frame)
{
    const auto asked = ack::decodeRequest(frame);
    if (!asked) {
        return std::nullopt;
    }
    m_question =
        isDataCommand(asked->command) ? ack::Question{asked->address, asked->command, 0} : ack::Question{0, 0, 0};
    return m_isOwn(asked->address) ? std::optional<ack::Asked>(*asked) : std::nullopt;
}

void RequestListener::giveUpStale(SteadyTime now)
{
    const auto header = ack::readHeader(m_heard);
    const qsizetype length = ack::headerSize + (header ? blockLength(*header).value_or(0) : 0);
    if (now - m_lastHeard > longestSilence || now - m_frameBegan > longestSilence + 2 * length * m_byteTime) {
        m_heard.clear();
    }
}

} // namespace gorizont::station
