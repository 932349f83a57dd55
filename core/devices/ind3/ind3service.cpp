#include "core/devices/ind3/ind3service.h"

#include "core/devices/ind3/ind3modbus.h"
#include "core/devices/ind3/ind3protocol210.h"
#include "core/protocol/modbusrtu.h"

#include <array>
#include <functional>

namespace gorizont::ind3 {

namespace {

Result<void> withoutValue(const Result<Tilt> &result)
{
    return result ? Result<void>() : Result<void>(result.fault());
}

/// Takes what \a result brought into \a value; a fault otherwise.
template <typename T, typename Value> Result<void> keep(const Result<T> &result, Value &value)
{
    if (!result) {
        return result.fault();
    }
    value = *result;
    return {};
}

/// The same, but a sensor that does not know the question keeps \a value empty.
Result<void> keepIfKnown(const Result<Tilt> &result, std::optional<Tilt> &value)
{
    const bool isUnknown = !result && (result.fault() == Fault::Timeout || result.fault() == Fault::Refused);
    return isUnknown ? Result<void>() : keep(result, value);
}

} // namespace

Service::Service(const Timing &timing, Dialect dialect)
    : m_timing(timing)
    , m_dialect(dialect)
{
}

/// Refused: there is no such request.
Result<QByteArray> Service::exchange(Line &line, const std::optional<Request> &request) const
{
    if (!request) {
        return Fault::Refused;
    }
    return line.exchange(
        {.request = request->bytes,
         .scan = request->scan,
         .writeTimeout = m_timing.writeCommand,
         .readTimeout = m_timing.readCommand,
         .quietBefore = m_dialect == Dialect::Modbus ? modbusrtu::frameSilence : std::chrono::microseconds(0)});
}

Result<Tilt> Service::askTilt(Line &line, int address) const
{
    switch (m_dialect) {
    case Dialect::V210: return question(line, v210::readAngles(address), v210::decodeAngles);
    case Dialect::Modbus: return question(line, modbus::readAngles(address), modbus::decodeAngles);
    case Dialect::V211: break;
    }
    return question(line, ind3::ask(Packet::ReadAngles, address), decodeAngles);
}

Result<void> Service::probe(Line &line, int address) const
{
    return withoutValue(withAttemptsUnlessSilent([&] { return askTilt(line, address); }));
}

Result<Tilt> Service::readTilt(Line &line, int address) const
{
    return withAttempts([&] { return askTilt(line, address); });
}

Result<Settings> Service::read(Line &line, int address) const
{
    switch (m_dialect) {
    case Dialect::V211: return read211(line, address);
    case Dialect::Modbus: return readModbus(line, address);
    case Dialect::V210: break;
    }
    return Fault::Refused;
}

/// The version, or why the sensor does not tell it.
Result<void> Service::readVersion(Line &line, Settings &settings) const
{
    const auto answer = withAttempts([&] { return exchange(line, ind3::ask(Packet::Version, settings.address)); });
    if (!answer) {
        return answer.fault();
    }
    settings.selfTest = decodeSelfTest(*answer);
    if (settings.selfTest) {
        return {};
    }
    return keep(decodeVersion(*answer), settings.version);
}

/// The offset comes last: an old sensor lets it time out.
Result<Settings> Service::read211(Line &line, int address) const
{
    Settings settings;
    settings.address = address;
    const auto about = [address](Packet packet) { return ind3::ask(packet, address); };
    const std::array<std::function<Result<void>()>, 8> steps{
        [&] { return readVersion(line, settings); },
        [&] { return keep(ask(line, about(Packet::Revision), decodeRevision), settings.revision); },
        [&] { return keep(ask(line, about(Packet::SerialNumber), decodeSerialNumber), settings.serialNumber); },
        [&] { return keep(ask(line, about(Packet::GetBaud), decodeBaud), settings.baud); },
        [&] { return keep(ask(line, about(Packet::GetName), decodeNameAnswer), settings.name); },
        [&] { return keep(ask(line, about(Packet::GetTicks), decodeTicks), settings.ticks); },
        [&] { return keep(ask(line, about(Packet::GetPeriod), decodePeriod), settings.period); },
        [&] { return keepIfKnown(ask(line, about(Packet::GetOffset), decodeOffset), settings.offset); }};
    for (const auto &step : steps) {
        if (const auto done = step(); !done) {
            return done.fault();
        }
    }
    return settings;
}

Result<Settings> Service::readModbus(Line &line, int address) const
{
    const auto read = ask(line, modbus::readSettings(address), modbus::decodeSettings);
    if (!read) {
        return read.fault();
    }
    Settings settings;
    settings.address = address;
    settings.revision = read->revision;
    settings.serialNumber = read->serialNumber;
    settings.baud = read->baud;
    settings.ticks = read->ticks;
    settings.period = read->period;
    const auto offset = ask(line, modbus::readOwnOffset(address), modbus::decodeOwnOffset);
    if (const auto kept = keepIfKnown(offset, settings.offset); !kept) {
        return kept.fault();
    }
    return settings;
}

/// 2.11 answers to a setting with an empty frame, Modbus may answer with an exception.
Result<void> Service::confirmed(const Result<QByteArray> &answer) const
{
    if (!answer) {
        return answer.fault();
    }
    return m_dialect == Dialect::Modbus ? modbusrtu::confirmation(*answer) : Result<void>();
}

Result<void> Service::changeAddress(Line &line, int address, int newAddress) const
{
    const std::optional<Request> request = addressRequest(address, newAddress);
    if (!request) {
        return Fault::Refused;
    }
    const auto isTaken = isSomebodyThere([&] { return probe(line, newAddress); });
    if (!isTaken || *isTaken) {
        return isTaken ? Fault::Refused : isTaken.fault();
    }
    const auto moved = withAttempts([&]() -> Result<void> {
        const auto sent = confirmed(exchange(line, request));
        if (!sent && !isWorthAnother(sent.fault())) {
            return sent;
        }
        return probe(line, newAddress); // its answer may have been lost, and by Modbus come from either address
    });
    if (!moved && !isWorthAnother(moved.fault())) {
        return moved;
    }
    const auto isAtOld = answersSteadily(line, address);
    if (!isAtOld) {
        return isAtOld.fault();
    }
    return *isAtOld ? Result<void>(Fault::BadReply) : moved;
}

std::optional<Request> Service::addressRequest(int address, int newAddress) const
{
    switch (m_dialect) {
    case Dialect::V211: return setAddress(address, newAddress);
    case Dialect::Modbus: return modbus::setAddress(address, newAddress);
    case Dialect::V210: break;
    }
    return std::nullopt;
}

/// A late answer may still come from an address where nobody is any more, so one silence is enough to believe that.
Result<bool> Service::answersSteadily(Line &line, int address) const
{
    for (int i = 0; i < mostAttempts; ++i) {
        const auto heard = probe(line, address);
        if (!heard && isLineFault(heard.fault())) {
            return heard.fault();
        }
        if (!heard && heard.fault() == Fault::Timeout) {
            return false;
        }
    }
    return true;
}

} // namespace gorizont::ind3
