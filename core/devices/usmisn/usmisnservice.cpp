#include "core/devices/usmisn/usmisnservice.h"

namespace gorizont::usmisn {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds measuringPatience = 3s;
constexpr int firstTransaction = 500; ///< polling has those below

/// Takes what \a result brought into \a value; a fault otherwise.
template <typename T, typename Target> Result<void> keep(const Result<T> &result, Target &value)
{
    if (!result) {
        return result.fault();
    }
    value = *result;
    return {};
}

/// A line of the list that was damaged is not among the answers; nothing else says so.
bool hasBothAxes(const QList<Channel> &channels)
{
    return channels.size() == 2 && channels.first().id.channel() == channelX
        && channels.last().id.channel() == channelY;
}

} // namespace

Service::Service(const Timing &timing)
    : m_timing(timing)
    , m_transactions(std::make_shared<Transactions>(firstTransaction))
{
}

Exchange Service::exchangeOf(const Ask &ask, std::chrono::milliseconds patience) const
{
    const Request request = ask.request();
    return {
        .request = request.bytes,
        .scan = request.scan,
        .writeTimeout = m_timing.writeCommand,
        .readTimeout = patience,
        .quietBefore = {}};
}

Result<QByteArray> Service::exchange(Line &line, const Ask &ask, std::chrono::milliseconds patience) const
{
    return line.exchange(exchangeOf(ask, patience));
}

Result<QByteArray> Service::exchange(Line &line, const Ask &ask) const
{
    return exchange(line, ask, m_timing.readCommand);
}

Result<void> Service::send(Line &line, const std::optional<Ask> &ask) const
{
    return ask ? line.send(ask->bytes(), m_timing.writeCommand, m_timing.addressChange) : Fault::Refused;
}

/// Refused: there is no such request, or the device says ErrorData.
Result<void> Service::echoed(Line &line, const std::optional<Ask> &ask) const
{
    if (!ask) {
        return Fault::Refused;
    }
    const auto answer = exchange(line, *ask);
    return answer ? decodeEcho(*answer, *ask) : answer.fault();
}

Result<int> Service::askType(Line &line, int address) const
{
    const Ask ask = to(address).plain(Instruction::GetType);
    const auto answer = exchange(line, ask);
    return answer ? decodeType(*answer, ask.question) : answer.fault();
}

Result<int> Service::probe(Line &line, int address) const
{
    if (!isAddress(address)) {
        return Fault::Refused;
    }
    return withAttemptsUnlessSilent([&] { return askType(line, address); });
}

template <typename T>
Result<T> Service::ask(
    Line &line, int address, Instruction instruction, Result<T> (*decode)(QByteArrayView, const Question &)) const
{
    return withAttempts([&]() -> Result<T> {
        const Ask ask = to(address).plain(instruction);
        const auto answer = exchange(line, ask);
        return answer ? decode(*answer, ask.question) : answer.fault();
    });
}

Result<QList<Channel>> Service::channels(Line &line, int address) const
{
    return withAttempts([&]() -> Result<QList<Channel>> {
        const Ask ask = to(address).plain(Instruction::GetInfo);
        QList<Channel> channels;
        std::optional<Fault> fault;
        const auto done = line.exchangeMany(exchangeOf(ask, m_timing.readCommand), [&](QByteArrayView answer) {
            const auto channel = decodeInfo(answer, ask.question);
            if (!channel) {
                fault = channel.fault();
            } else if (*channel) {
                channels.append(**channel);
            }
            return channel && channel->has_value();
        });
        if (!done || fault) {
            return done ? *fault : done.fault();
        }
        return hasBothAxes(channels) ? Result<QList<Channel>>(channels) : Fault::BadReply;
    });
}

/// What another device of the series answers beside its serial number is not known, so it is not asked.
Result<Identity> Service::read(Line &line, int address) const
{
    Identity identity;
    identity.address = address;
    auto kept = keep(withAttempts([&] { return askType(line, address); }), identity.type);
    kept = kept ? keep(serial(line, address), identity.serial) : kept;
    if (!kept || !identity.isInclinometer()) {
        return kept ? Result<Identity>(identity) : kept.fault();
    }
    kept = keep(ask(line, address, Instruction::GetProgVersion, decodeProgVersion), identity.program);
    kept = kept
        ? keep(ask(line, address, Instruction::GetDateCalibration, decodeDateCalibration), identity.calibratedOn)
        : kept;
    kept = kept
        ? keep(ask(line, address, Instruction::GetCountCalibration, decodeCountCalibration), identity.calibrations)
        : kept;
    kept = kept ? keep(channels(line, address), identity.channels) : kept;
    return kept ? Result<Identity>(identity) : kept.fault();
}

Result<quint32> Service::serial(Line &line, int address) const
{
    return ask(line, address, Instruction::GetSerial, decodeSerial);
}

/// Who answers a broadcast; 0: it repeats the address of the broadcast.
Result<int> Service::owner(Line &line, const std::optional<Ask> &ask, std::chrono::milliseconds patience) const
{
    if (!ask) {
        return Fault::Refused;
    }
    const auto answer = exchange(line, *ask, patience);
    return answer ? Result<int>(addressOf(*answer, ask->question)) : answer.fault();
}

/// GetValue is answered with the address of the broadcast, GetRecord with that of the device; and a device that hears its
/// channel in GetValue is there.
Result<int> Service::find(Line &line, quint32 serial) const
{
    const quint64 channel = ChannelId::of(serial, channelX).value;
    const auto heard =
        withAttemptsUnlessSilent([&] { return owner(line, to(everybody).getValue(channel), measuringPatience); });
    if (!heard || *heard != everybody) {
        return heard;
    }
    return withAttempts(
        [&] { return owner(line, to(everybody).getRecord(1, RecordMask::All, channel), m_timing.readData); });
}

Result<int> Service::ownAddress(Line &line) const
{
    return ask(line, everybody, Instruction::GetAddress, decodeAddress);
}

Result<Value> Service::measure(Line &line, int address, int channel, qint64 timestamp) const
{
    const auto attempt = [&]() -> Result<Value> {
        const auto ask = to(address).getValue(static_cast<quint64>(channel), timestamp);
        if (!ask || !isAddress(address)) {
            return Fault::Refused;
        }
        const auto answer = exchange(line, *ask, measuringPatience);
        return answer ? decodeValue(*answer, ask->question) : answer.fault();
    };
    return timestamp == 0 ? withAttempts(attempt) : attempt();
}

Result<void> Service::records(
    Line &line, int address, int count, RecordMask mask, int channel, const TakeRecord &take) const
{
    const auto ask = to(address).getRecord(count, mask, static_cast<quint64>(channel));
    if (!ask || !isAddress(address)) {
        return Fault::Refused;
    }
    Result<void> result;
    const auto done = line.exchangeMany(exchangeOf(*ask, m_timing.readData), [&](QByteArrayView answer) {
        const auto record = decodeRecord(answer, ask->question);
        if (!record) {
            result = record.fault();
            return record.fault() != Fault::Refused;
        }
        if (!*record) {
            return false;
        }
        if (!take(**record)) {
            result = Fault::Cancelled;
            return false;
        }
        return true;
    });
    return done ? result : done;
}

} // namespace gorizont::usmisn
