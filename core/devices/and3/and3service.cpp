#include "core/devices/and3/and3service.h"

#include "core/devices/attempts.h"

#include <algorithm>

namespace gorizont::and3 {

namespace {

template <typename T> Result<T> parsed(const Result<QByteArray> &answer, std::optional<T> (*parse)(QByteArrayView))
{
    if (!answer) {
        return answer.fault();
    }
    const auto value = parse(*answer);
    return value ? Result<T>(*value) : Result<T>(Fault::BadReply);
}

template <typename T> Result<void> withoutValue(const Result<T> &result)
{
    return result ? Result<void>() : Result<void>(result.fault());
}

bool isAddress(int address)
{
    return address >= 1 && address <= 255;
}

} // namespace

Service::Service(const Timing &timing)
    : m_timing(timing)
{
}

Result<QByteArray> Service::exchange(Line &line, const Request &request) const
{
    return line.exchange(
        {.request = request.toBytes(),
         .scan = answerTo(request),
         .writeTimeout = m_timing.writeCommand,
         .readTimeout = m_timing.readCommand,
         .quietBefore = std::max(leastSilence, m_timing.addressChange)});
}

Result<ComplexRead> Service::askValues(Line &line, int address) const
{
    if (!isAddress(address)) {
        return Fault::Refused;
    }
    return parsed(exchange(line, Request::complexRead(static_cast<quint8>(address))), parseComplexRead);
}

Result<void> Service::probe(Line &line, int address) const
{
    return withoutValue(withAttemptsUnlessSilent([&] { return askValues(line, address); }));
}

Result<ComplexRead> Service::readValues(Line &line, int address) const
{
    return withAttempts([&] { return askValues(line, address); });
}

Result<Settings> Service::read(Line &line, int address) const
{
    const auto values = readValues(line, address);
    if (!values) {
        return values.fault();
    }
    const auto to = static_cast<quint8>(address);
    const auto firmware = withAttempts(
        [&] { return parsed(exchange(line, Request::information(to, InformationKind::Firmware)), parseFirmware); });
    if (!firmware && firmware.fault() != Fault::Timeout) {
        return firmware.fault();
    }
    const auto configuration = withAttempts([&] { return askConfiguration(line, to, ConfigurationKind::Current); });
    if (!configuration) {
        return configuration.fault();
    }
    Settings settings{.address = address, .firmware = {}, .configuration = *configuration, .values = *values};
    if (firmware) {
        settings.firmware = *firmware;
    }
    return settings;
}

Result<Configuration> Service::askConfiguration(Line &line, quint8 address, ConfigurationKind kind) const
{
    return parsed(exchange(line, Request::configuration(address, kind)), parseConfiguration);
}

/// One question. BadReply: the sensor holds something else.
Result<void> Service::isHeld(Line &line, quint8 address, ConfigurationKind kind, const Configuration &expected) const
{
    const auto read = askConfiguration(line, address, kind);
    if (!read) {
        return read.fault();
    }
    return *read == expected ? Result<void>() : Result<void>(Fault::BadReply);
}

Result<void> Service::tell(Line &line, const Request &request) const
{
    return withoutValue(withAttempts([&] { return exchange(line, request); }));
}

AddressChange Service::storeAddress(Line &line, int address, int newAddress) const
{
    if (!isAddress(address) || !isAddress(newAddress)) {
        return {AddressStep::Probe, Fault::Refused};
    }
    const auto isTaken = isSomebodyThere([&] { return probe(line, newAddress); });
    if (!isTaken || *isTaken) {
        return {AddressStep::Probe, isTaken ? Fault::Refused : isTaken.fault()};
    }
    const auto to = static_cast<quint8>(address);
    if (const auto copied = tell(line, Request::copyConfiguration(to)); !copied) {
        return {AddressStep::Copy, copied};
    }
    const auto copy = checkedCopy(line, to);
    if (!copy) {
        return {AddressStep::Check, copy.fault()};
    }
    Configuration wanted = *copy;
    wanted[addressIndex] = static_cast<quint8>(newAddress);
    if (const auto set = tell(line, Request::setByte(to, addressIndex, wanted[addressIndex])); !set) {
        return {AddressStep::Set, set};
    }
    int unanswered = 0;
    const auto verified = withAttempts([&] {
        const auto held = isHeld(line, to, ConfigurationKind::Temporary, wanted);
        unanswered += held ? 0 : 1;
        return held;
    });
    return verified ? store(line, to, wanted, unanswered) : AddressChange{AddressStep::Verify, verified};
}

/// The temporary configuration after the copy. BadReply: its address is not the one that the sensor answers at, so its
/// bytes do not mean what they should.
Result<Configuration> Service::checkedCopy(Line &line, quint8 address) const
{
    if (const auto answers = readValues(line, address); !answers) {
        return answers.fault();
    }
    return withAttempts([&]() -> Result<Configuration> {
        const auto copy = askConfiguration(line, address, ConfigurationKind::Temporary);
        return copy && (*copy)[addressIndex] != address ? Fault::BadReply : copy;
    });
}

/// The answer to 220 may look like an echo, so only the non-volatile memory itself tells. No answer 221 says which of the
/// configurations it is about: as many as were not \a unanswered in time may still come and say the same, and it takes one
/// more to be sure.
AddressChange Service::store(Line &line, quint8 address, const Configuration &wanted, int unanswered) const
{
    AddressStep step = AddressStep::Store;
    const auto stored = withAttempts([&]() -> Result<void> {
        step = AddressStep::Store;
        const auto sent = exchange(line, Request::writeConfiguration(address));
        if (!sent && !isWorthAnother(sent.fault())) {
            return sent.fault();
        }
        step = AddressStep::VerifyStored;
        Result<void> held;
        for (int i = 0; i <= unanswered && held; ++i) {
            held = withAttempts([&] { return isHeld(line, address, ConfigurationKind::NonVolatile, wanted); });
        }
        return held;
    });
    return {stored ? AddressStep::Done : step, stored};
}

Result<void> Service::reset(Line &line, int address) const
{
    if (const auto there = readValues(line, address); !there) {
        return there.fault();
    }
    const auto told = tell(line, Request::reset(static_cast<quint8>(address)));
    return told || !isLineFault(told.fault()) ? Result<void>() : told;
}

} // namespace gorizont::and3
