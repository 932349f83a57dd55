#include "core/devices/mk14/mk14service.h"

#include "core/devices/attempts.h"
#include "core/devices/mk14/mk14exchange.h"
#include "core/devices/mk14/mk14values.h"

#include <QDateTime>

namespace gorizont::mk14 {

namespace {

bool isAddress(int address)
{
    return address >= 1 && address <= 255;
}

/// Seconds since 1970 as a clock that shows local time counts them.
qint64 stationSeconds(UtcTime now, bool isClockUtc)
{
    const qint64 seconds = std::chrono::round<std::chrono::seconds>(now.time_since_epoch()).count();
    return isClockUtc ? seconds : seconds + QDateTime::fromSecsSinceEpoch(seconds).offsetFromUtc();
}

/// At the slowest speed that a line without a known one may have behind it.
std::chrono::milliseconds writingTime(const Line &line, qsizetype bytes)
{
    constexpr std::chrono::milliseconds slowest{10}; // of a byte, about 1200 baud
    return line.port() ? wireTime(line, bytes) : std::chrono::milliseconds(bytes * slowest.count());
}

Result<void> confirmed(Line &line, const Request &request, const Timing &timing)
{
    const auto answer = line.exchange(
        {.request = request.bytes,
         .scan = request.scan,
         .writeTimeout = timing.writeData + writingTime(line, request.bytes.size()),
         .readTimeout = timing.readData + wireTime(line, request.bytes.size() + ack::headerSize),
         .quietBefore = {}});
    return answer ? Result<void>() : answer.fault();
}

} // namespace

Service::Service(const Options &options, const Timing &timing, Clock now)
    : m_options(options)
    , m_timing(timing)
    , m_now(std::move(now))
{
}

Result<Weather> Service::asked(Line &line, int address, int command, quint32 word) const
{
    if (!isAddress(address) || command < ack::firstDataCommand || command > ack::lastDataCommand) {
        return Fault::Refused;
    }
    const ack::Question question{
        static_cast<quint8>(address), static_cast<quint8>(command), static_cast<int>(m_options.parameters.size())};
    const auto answer = withAttempts([&] { return ask(line, question, word, m_timing); });
    if (!answer) {
        return answer.fault();
    }
    Weather weather;
    put(weather, command, *answer, m_options.parameters);
    return weather;
}

Result<Weather> Service::read(Line &line, int address, int command) const
{
    return asked(line, address, command, outputs(line, address));
}

quint32 Service::outputs(const Line &line, int address) const
{
    return line.standingWord(address).value_or(m_options.outputs);
}

Result<Weather> Service::setOutputs(Line &line, int address, quint32 word) const
{
    auto weather = asked(line, address, ack::firstDataCommand, word);
    if (weather) {
        line.setStandingWord(address, word);
    }
    return weather;
}

Result<qint64> Service::setTime(Line &line, int address) const
{
    if (!isAddress(address)) {
        return Fault::Refused;
    }
    return withAttempts([&]() -> Result<qint64> {
        const qint64 seconds = stationSeconds(m_now(), m_options.isClockUtc);
        const Request request = ack::askTime(static_cast<quint8>(address), static_cast<quint32>(seconds));
        const auto done = confirmed(line, request, m_timing);
        return done ? Result<qint64>(seconds) : done.fault();
    });
}

Result<void> Service::sendFile(Line &line, int address, const QByteArray &name, const QByteArray &text) const
{
    const auto request = isAddress(address) ? ack::askFile(static_cast<quint8>(address), name, text) : std::nullopt;
    return request ? confirmed(line, *request, m_timing) : Fault::Refused;
}

} // namespace gorizont::mk14
