#include "core/devices/usmisn/usmisndriver.h"

#include <QCoreApplication>

namespace gorizont::usmisn {

namespace {

using namespace std::chrono_literals;

constexpr auto sayAgainAfter = 10s; ///< well below the 26 s of the watchdog
constexpr auto healingSilence = 30s;

/// The transactions of polling and of service differ, so that a late answer to the one is none to the other.
constexpr int lastTransaction = 499;

class DriverText
{
    Q_DECLARE_TR_FUNCTIONS(UsmIsnDriver)
};

/// What is worth a line in the journal when it changes.
enum class Trouble : quint8 { None, OtherDevice, NoChannel, BadRequest };

/// Asks who is there, then measures X and Y. Thread of the line.
class UsmIsnDriver : public Driver
{
public:
    explicit UsmIsnDriver(DriverSettings driverSettings)
        : Driver(std::move(driverSettings))
        , m_transactions(1, lastTransaction)
        , m_verifies(option(QStringLiteral("verifycrc"), false))
        , m_revives(option(QStringLiteral("usmrevive"), true))
    {
    }

    Result<Measurement> poll(Line &line) override
    {
        const auto measurement = measure(line);
        const bool isSilent = !measurement && measurement.fault() == Fault::Timeout; // whoever answers does not hang
        m_failures = isSilent ? m_failures + 1 : 0;
        return measurement;
    }

    void restart() override { m_isIdentified = false; }
    std::optional<KeepAlive> keepAlive() const override { return watchdogFood(); }

    std::chrono::seconds takeSilence() override
    {
        const bool isHanging = m_revives && m_failures >= settings().timing.readErrorLimit;
        m_failures = isHanging ? 0 : m_failures;
        return isHanging ? healingSilence : 0s;
    }

private:
    bool option(const QString &key, bool fallback) const
    {
        const QString text = settings().sensor.options.value(key).trimmed();
        return text.isEmpty() ? fallback : text != QLatin1String("0");
    }

    Asking asking() { return {settings().sensor.address, m_transactions.next()}; }

    Result<QByteArray> exchange(Line &line, const Ask &ask, std::chrono::milliseconds patience) const
    {
        const Request request = ask.request();
        return line.exchange(
            {.request = request.bytes,
             .scan = request.scan,
             .writeTimeout = settings().timing.writeCommand,
             .readTimeout = patience,
             .quietBefore = {}});
    }

    Result<Measurement> measure(Line &line)
    {
        if (!isAddress(settings().sensor.address)) {
            return Fault::Refused;
        }
        if (const auto known = identify(line); !known) {
            return known.fault();
        }
        const auto x = value(line, channelX);
        if (!x) {
            return x.fault();
        }
        const auto y = value(line, channelY);
        if (!y) {
            return y.fault();
        }
        return measurementOf(*x, *y);
    }

    /// Refused: it is another device of the series. Once after each start of polling.
    Result<void> identify(Line &line)
    {
        if (m_isIdentified) {
            return {};
        }
        const Ask ask = asking().plain(Instruction::GetType);
        const auto answer = exchange(line, ask, settings().timing.readCommand);
        if (!answer) {
            return answer.fault();
        }
        const auto type = decodeType(*answer, ask.question);
        if (!type) {
            return type.fault();
        }
        m_isIdentified = *type == inclinometerType;
        if (!m_isIdentified) {
            tell(
                Trouble::OtherDevice,
                DriverText::tr("A device of type %1 answers, not an УСМ-ИСН (28); it is not polled. Check the address.")
                    .arg(*type));
            return Fault::Refused;
        }
        return {};
    }

    Result<Value> value(Line &line, int channel)
    {
        const auto ask = asking().getValue(static_cast<quint64>(channel));
        const auto answer = exchange(line, *ask, measuringPatience);
        if (!answer) {
            return answer.fault();
        }
        const auto value = decodeValue(*answer, ask->question);
        if (!value) {
            return value.fault();
        }
        const bool hasValue = value->state == ValueState::Measured || value->state == ValueState::OutOfRange;
        if (hasValue && value->channel.channel() != channel) {
            return Fault::BadReply;
        }
        if (m_verifies) {
            if (const auto verified = verify(line, *answer); !verified) {
                return verified.fault();
            }
        }
        return *value;
    }

    /// Checksum: what came is not what the device sent.
    Result<void> verify(Line &line, const QByteArray &message)
    {
        const Ask ask = asking().plain(Instruction::GetCrc);
        const auto answer = exchange(line, ask, settings().timing.readCommand);
        if (!answer) {
            return answer.fault();
        }
        const auto crc = decodeCrc(*answer, ask.question);
        if (!crc) {
            return crc.fault();
        }
        return *crc == crcOf(message) ? Result<void>() : Fault::Checksum;
    }

    Measurement measurementOf(const Value &x, const Value &y)
    {
        Measurement measurement;
        Trouble trouble = Trouble::None;
        bool isWhole = true;
        for (const Value *value : {&x, &y}) {
            isWhole = isWhole && value->state == ValueState::Measured;
            switch (value->state) {
            case ValueState::Measured: measurement.temperature = value->temperature; break;
            case ValueState::OutOfRange:
                measurement.temperature = value->temperature;
                measurement.conditions |= Condition::TransducerRange;
                break;
            case ValueState::ErrorSensor: measurement.conditions |= Condition::TransducerSilent; break;
            case ValueState::ErrorChannel: trouble = Trouble::NoChannel; break;
            case ValueState::ErrorData: trouble = Trouble::BadRequest; break;
            }
        }
        if (isWhole) {
            measurement.tilt = Tilt{x.value * arcSecondsInDegree, y.value * arcSecondsInDegree};
            measurement.variation = TiltVariation{x.variation, y.variation};
        }
        tell(trouble, sentenceFor(trouble));
        return measurement;
    }

    static QString sentenceFor(Trouble trouble)
    {
        switch (trouble) {
        case Trouble::NoChannel:
            return DriverText::tr("The device has no channel for one of its axes (ErrorCH). Check the address.");
        case Trouble::BadRequest: return DriverText::tr("The device does not understand the request (ErrorData).");
        case Trouble::None:
        case Trouble::OtherDevice: break;
        }
        return {};
    }

    void tell(Trouble trouble, const QString &sentence)
    {
        if (trouble != std::exchange(m_trouble, trouble) && trouble != Trouble::None) {
            note(JournalKind::Error, sentence);
        }
    }

    Transactions m_transactions;
    bool m_verifies;
    bool m_revives;
    bool m_isIdentified = false;
    int m_failures = 0; ///< in a row, since the line was last silenced for it
    Trouble m_trouble = Trouble::None;
};

} // namespace

KeepAlive watchdogFood()
{
    return {encodeRequest({everybody, "000", Instruction::GetSerial}), sayAgainAfter};
}

std::unique_ptr<Driver> makeDriver(DriverSettings settings)
{
    return std::make_unique<UsmIsnDriver>(std::move(settings));
}

} // namespace gorizont::usmisn
