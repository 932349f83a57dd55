#include "core/devices/lvims/lvimsdriver.h"

#include "core/devices/lvims/lvimscapturing.h"

#include <QCoreApplication>

namespace gorizont::lvims {

namespace {

class DriverText
{
    Q_DECLARE_TR_FUNCTIONS(LVimsDriver)
};

constexpr quint16 firstTransaction = 0x0001; ///< of polling; service has others

/// What is worth a line in the journal when it changes.
enum class Trouble : quint8 { None, BootLoader, Exception };

QString nameOf(CaptureKind kind)
{
    switch (kind) {
    case CaptureKind::Waveform: return DriverText::tr("The waveform of channel %1");
    case CaptureKind::Spectrum5000: return DriverText::tr("The spectrum of channel %1 up to 5000 Hz");
    case CaptureKind::Spectrum200: return DriverText::tr("The spectrum of channel %1 up to 200 Hz");
    }
    return {};
}

QString reasonOf(Fault fault)
{
    switch (fault) {
    case Fault::Refused: return DriverText::tr("the module refuses it. It is tried again at the next time.");
    case Fault::BadReply:
        return DriverText::tr("another client of the module disturbed it. It is tried again at the next time.");
    default: return DriverText::tr("the module did not finish it in time. It is tried again at the next time.");
    }
}

/// Asks what has changed, then for that. Thread of the line.
class LVimsDriver : public Driver
{
public:
    explicit LVimsDriver(DriverSettings driverSettings)
        : Driver(std::move(driverSettings))
        , m_options(Options::from(settings().sensor))
        , m_link(m_options.address, settings().timing, firstTransaction)
        , m_capturing(m_options.capture, m_options.address, settings().timing)
    {
        for (const QString &complaint : m_options.complaints + m_options.capture.complaints) {
            note(JournalKind::Error, complaint);
        }
        forget();
    }

    Result<Measurement> poll(Line &line) override
    {
        const auto done = update(line);
        m_isAnswering = static_cast<bool>(done);
        if (!done) {
            if (const int exception = m_link.exception()) {
                tell(
                    Trouble::Exception,
                    DriverText::tr("The module refuses to be read (exception %1 of Modbus). Check the keys Unit and "
                                   "ReadFunction of the sensor.")
                        .arg(exception));
            }
            return done.fault();
        }
        m_trouble = Trouble::None;
        Measurement measurement;
        measurement.vibration = m_vibration;
        measurement.conditions.setFlag(Condition::TransducerSilent, m_vibration.isWithoutSensors());
        return measurement;
    }

    void restart() override
    {
        forget();
        m_capturing.abandon();
    }

    /// A module that does not answer, or is in its boot loader, captures nothing.
    bool hasBacklog() const override { return m_isAnswering && m_capturing.hasStep(std::chrono::steady_clock::now()); }
    std::optional<SteadyTime> backlogAt() const override
    {
        return m_isAnswering ? m_capturing.nextStepAt() : std::nullopt;
    }

    /// A capture that fails is no failure of the sensor: its values come with the turns.
    Result<QList<SampleBlock>> fetch(Line &line) override
    {
        const auto outcome = m_capturing.step(line, std::chrono::steady_clock::now(), m_enabled);
        if (!outcome) {
            return outcome.fault();
        }
        if (*outcome) {
            conclude(**outcome);
        }
        return QList<SampleBlock>();
    }

private:
    void conclude(const Capturing::Outcome &outcome)
    {
        if (outcome.signal) {
            SignalCapture captured = *outcome.signal;
            captured.number = settings().sensor.number;
            captured.time = utcNow();
            deliver(captured);
        }
        if (!outcome.isNews) {
            return;
        }
        const QString what = nameOf(outcome.kind).arg(outcome.channel);
        if (outcome.fault) {
            note(JournalKind::Error, DriverText::tr("%1 cannot be captured: %2").arg(what, reasonOf(*outcome.fault)));
        } else {
            note(JournalKind::On, DriverText::tr("%1 is captured again.").arg(what));
        }
    }

    void forget()
    {
        m_isAnswering = false;
        m_mode = 0;
        m_known.clear();
        m_knownSettings.reset();
        m_knownRelays.reset();
    }

    /// Refused: the module is in its boot loader, or it answered with an exception.
    Result<void> update(Line &line)
    {
        if (const auto working = findWorking(line); !working) {
            return working.fault();
        }
        const auto words = m_link.read(line, statusRange);
        if (!words) {
            return words.fault();
        }
        const Status status = statusOf(*words);
        if (const auto read = updateSettings(line, status.settings); !read) {
            return read.fault();
        }
        for (int i = 0; i < channelCount; ++i) {
            if (const auto read = updateChannel(line, i, status.channels[static_cast<std::size_t>(i)].state); !read) {
                return read.fault();
            }
        }
        return updateRelays(line, status.relays);
    }

    Result<void> findWorking(Line &line)
    {
        if (m_mode != workingMode) {
            const bool isNew = m_mode == 0;
            const auto words = m_link.read(line, isNew ? identityRange : modeRange);
            if (!words) {
                return words.fault();
            }
            if (isNew) {
                introduce(identityOf(*words));
            }
            m_mode = words->word(moduleRegister("DEVMODE"));
        }
        if (m_mode != bootLoaderMode) {
            return {};
        }
        tell(
            Trouble::BootLoader,
            DriverText::tr("The module is in its boot loader and measures nothing. Restart it, or load its program."));
        return Fault::Refused;
    }

    void introduce(const Identity &identity)
    {
        DeviceInformation information;
        information.number = settings().sensor.number;
        information.firmware = identity.firmware;
        report(information);
    }

    Result<void> updateSettings(Line &line, quint16 id)
    {
        if (m_knownSettings == id) {
            return {};
        }
        constexpr Register mask = settingRegister("CH_EN_MASK");
        constexpr auto first = static_cast<quint16>(moduleRegister("CUR_SETTINGS").address + mask.address);
        const auto words = m_link.read(line, {first, mask.size});
        if (!words) {
            return words.fault();
        }
        m_enabled = Words(mask.address, words->values()).word(mask);
        m_knownSettings = id;
        for (VibrationChannel &channel : m_vibration.channels) {
            channel.isEnabled = isEnabled(channel.channel);
        }
        return {};
    }

    bool isEnabled(int channel) const { return (m_enabled >> channel & 1) != 0; }

    Result<void> updateChannel(Line &line, int index, quint16 id)
    {
        if (m_known.value(index, -1) == id) {
            return {};
        }
        const auto words = m_link.read(line, channelRange(index));
        if (!words) {
            return words.fault();
        }
        VibrationChannel channel = channelOf(Words(0, words->values()), index, m_options.fullScale);
        channel.isEnabled = isEnabled(index);
        auto &channels = m_vibration.channels;
        while (channels.size() <= index) {
            channels.append(VibrationChannel{static_cast<int>(channels.size()), {}, {}, {}});
        }
        tellState(channels.at(index).state, channel);
        channels[index] = channel;
        m_known[index] = id;
        return {};
    }

    Result<void> updateRelays(Line &line, quint16 id)
    {
        if (m_knownRelays == id) {
            return {};
        }
        const auto words = m_link.read(line, relayRange);
        if (!words) {
            return words.fault();
        }
        m_vibration.relays = relaysOf(words->doubleWord(moduleRegister("RELE_STATE")));
        m_knownRelays = id;
        return {};
    }

    void tellState(ChannelState before, const VibrationChannel &channel)
    {
        if (before == channel.state) {
            return;
        }
        switch (channel.state) {
        case ChannelState::ShortCircuit:
            note(
                JournalKind::Error,
                DriverText::tr("Channel %1: the line of the sensor is shorted. Check its cable.").arg(channel.channel));
            break;
        case ChannelState::Break:
            note(
                JournalKind::Error,
                DriverText::tr("Channel %1: the line of the sensor is broken. Check its cable.").arg(channel.channel));
            break;
        case ChannelState::Good:
            if (before != ChannelState::NoData) {
                note(JournalKind::On, DriverText::tr("Channel %1: the sensor works again.").arg(channel.channel));
            }
            break;
        case ChannelState::NoData: break;
        }
    }

    void tell(Trouble trouble, const QString &sentence)
    {
        if (trouble != std::exchange(m_trouble, trouble)) {
            note(JournalKind::Error, sentence);
        }
    }

    Options m_options;
    Link m_link;
    Capturing m_capturing;
    bool m_isAnswering = false; ///< the last turn was good
    int m_mode = 0; ///< DEVMODE; 0: not asked yet
    QHash<int, int> m_known; ///< ST_CH_UP_ID of what was read last, by channel
    std::optional<quint16> m_knownSettings;
    std::optional<quint16> m_knownRelays;
    quint16 m_enabled = 0; ///< CH_EN_MASK
    Vibration m_vibration;
    Trouble m_trouble = Trouble::None;
};

} // namespace

std::unique_ptr<Driver> makeDriver(DriverSettings settings)
{
    return std::make_unique<LVimsDriver>(std::move(settings));
}

} // namespace gorizont::lvims
