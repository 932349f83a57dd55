#include "core/devices/lvims/lvimsservice.h"

#include "core/devices/attempts.h"
#include "core/devices/lvims/lvimsdriver.h"

#include <thread>

namespace gorizont::lvims {

namespace {

constexpr quint16 firstTransaction = 0x8001; ///< of service; polling has others
constexpr quint32 applySettings = 0x564942CC;
constexpr quint32 saveSettings = 0x56494253; ///< to flash
constexpr quint32 loadSettings = 0x564942AA; ///< from flash, and use them
const QList<quint16> restartModule{0x424F, 0x4F53, 0x5245, 0x5354};

} // namespace

Service::Service(const Address &address, const Timing &timing)
    : m_link(address, timing, firstTransaction)
{
}

Service Service::of(const SensorConfig &sensor, const Timing &timing)
{
    return {Options::from(sensor).address, timing};
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
        if (const auto read = readMore(line, set, values); !read) {
            return read.fault();
        }
    }
    return Words(0, values);
}

Result<void> Service::readMore(Line &line, const Register &set, QList<quint16> &values)
{
    const int count = std::min<int>(modbustcp::mostRegistersToRead, set.size - static_cast<int>(values.size()));
    const auto words = read(line, {static_cast<quint16>(set.address + values.size()), count});
    if (!words) {
        return words.fault();
    }
    values += words->values();
    return {};
}

Result<void> Service::write(Line &line, const SettingPiece &piece)
{
    const auto first = static_cast<quint16>(moduleRegister("MUT_SETTINGS").address + piece.offset);
    return withAttempts([&] { return m_link.write(line, first, piece.values); });
}

Result<void> Service::restoreSettings(Line &line, const QList<quint16> &values, bool toFlash)
{
    m_errors = {0, 0};
    if (values.size() != settingsSize) {
        return Fault::Refused;
    }
    for (qsizetype at = 0; at < values.size(); at += modbustcp::mostRegistersToWrite) {
        const SettingPiece piece{static_cast<quint16>(at), values.mid(at, modbustcp::mostRegistersToWrite)};
        if (const auto written = write(line, piece); !written) {
            (void)checkErrors(line);
            return written;
        }
    }
    // What the module thought of settings that it was told to use before says nothing of these.
    auto done = checkErrors(line);
    done = !done && done.fault() == Fault::Refused && m_errors.first == 0 ? Result<void>() : done;
    done = done ? command(line, applySettings) : done;
    return done && toFlash ? command(line, saveSettings) : done;
}

Result<void> Service::tell(Line &line, quint32 word)
{
    return m_link.write(line, moduleRegister("SETTINGS_CMD").address, fromDoubleWord(word));
}

Result<void> Service::apply(Line &line)
{
    return tell(line, applySettings);
}

Result<void> Service::saveToFlash(Line &line)
{
    return tell(line, saveSettings);
}

Result<void> Service::loadFromFlash(Line &line)
{
    return tell(line, loadSettings);
}

Result<void> Service::restart(Line &line)
{
    if (!line.isOpen()) {
        return Fault::Closed;
    }
    const auto written = m_link.write(line, moduleRegister("REBOOT_CMD").address, restartModule);
    const bool isGone = !written && (written.fault() == Fault::Timeout || written.fault() == Fault::Closed);
    return isGone ? Result<void>() : written;
}

Result<SettingErrors> Service::readErrors(Line &line)
{
    const auto words =
        read(line, Range::from(moduleRegister("LAST_WR_ERROR"), moduleRegister("LAST_CHECK_SETTINGS_ERR")));
    if (!words) {
        return words.fault();
    }
    return SettingErrors(
        words->word(moduleRegister("LAST_WR_ERROR")), words->doubleWord(moduleRegister("LAST_CHECK_SETTINGS_ERR")));
}

Result<void> Service::command(Line &line, quint32 word)
{
    const auto written = tell(line, word);
    const auto checked = checkErrors(line);
    return written ? checked : written;
}

/// Refused: the module complains of what was written last.
Result<void> Service::checkErrors(Line &line)
{
    const auto errors = readErrors(line);
    if (!errors) {
        return errors.fault();
    }
    m_errors = *errors;
    return m_errors == SettingErrors(0, 0) ? Result<void>() : Fault::Refused;
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
