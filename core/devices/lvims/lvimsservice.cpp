#include "core/devices/lvims/lvimsservice.h"

#include "core/devices/attempts.h"

#include <thread>

namespace gorizont::lvims {

namespace {

constexpr quint16 firstTransaction = 0x8001; ///< of service; polling has others

} // namespace

Service::Service(const Address &address, const Timing &timing)
    : m_link(address, timing, firstTransaction)
{
}

Result<Words> Service::read(Line &line, const Range &range)
{
    return withAttempts([&] { return m_link.read(line, range); });
}

Result<Identity> Service::identity(Line &line)
{
    const auto words = read(line, identityRange);
    return words ? Result<Identity>(identityOf(*words)) : words.fault();
}

Result<Vibration> Service::state(Line &line, std::optional<double> fullScale)
{
    Vibration vibration;
    for (int i = 0; i < channelCount; ++i) {
        const auto words = read(line, channelRange(i));
        if (!words) {
            return words.fault();
        }
        vibration.channels.append(channelOf(Words(0, words->values()), i, fullScale));
    }
    const auto relays = read(line, relayRange);
    if (!relays) {
        return relays.fault();
    }
    vibration.relays = relaysOf(relays->doubleWord(moduleRegister("RELE_STATE")));
    return vibration;
}

Result<Words> Service::settings(Line &line, const Register &set)
{
    QList<quint16> values;
    while (values.size() < set.size) {
        const int count = std::min<int>(modbustcp::mostRegistersToRead, set.size - static_cast<int>(values.size()));
        const auto words = read(line, {static_cast<quint16>(set.address + values.size()), count});
        if (!words) {
            return words.fault();
        }
        values += words->values();
    }
    return Words(0, values);
}

Result<Capture> Service::captureWhole(Line &line, Capture::Kind kind, int channel) const
{
    Capture whole = capture(kind, channel);
    while (!whole.isDone()) {
        const auto done = whole.step(line, std::chrono::steady_clock::now());
        if (!done) {
            return done.fault();
        }
        if (line.isInterrupted()) {
            return Fault::Cancelled;
        }
        std::this_thread::sleep_for(whole.pause());
    }
    return whole;
}

} // namespace gorizont::lvims
