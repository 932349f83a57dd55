#include "tests/support/talk.h"

#include "core/devices/drivercatalog.h"
#include "tests/support/talkweather.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>

namespace gorizont::test {

namespace {

struct ConditionName
{
    QLatin1String name;
    Condition condition;
};

constexpr std::array<ConditionName, 12> conditionNames{{
    {QLatin1String("TiltNotReady"), Condition::TiltNotReady},
    {QLatin1String("TemperatureNotReady"), Condition::TemperatureNotReady},
    {QLatin1String("TransducerSilent"), Condition::TransducerSilent},
    {QLatin1String("TransducerCrc"), Condition::TransducerCrc},
    {QLatin1String("TransducerRange"), Condition::TransducerRange},
    {QLatin1String("TemperatureReadError"), Condition::TemperatureReadError},
    {QLatin1String("TemperatureRange"), Condition::TemperatureRange},
    {QLatin1String("FanError"), Condition::FanError},
    {QLatin1String("ThermostatError"), Condition::ThermostatError},
    {QLatin1String("Rebooted"), Condition::Rebooted},
    {QLatin1String("RingOverrun"), Condition::RingOverrun},
    {QLatin1String("SyncError"), Condition::SyncError},
}};

/// As in the source: `Timeout`, `BadReply`.
QString spelled(Fault fault)
{
    switch (fault) {
    case Fault::Timeout: return QStringLiteral("Timeout");
    case Fault::Checksum: return QStringLiteral("Checksum");
    case Fault::BadReply: return QStringLiteral("BadReply");
    case Fault::Refused: return QStringLiteral("Refused");
    case Fault::Closed: return QStringLiteral("Closed");
    case Fault::Cancelled: return QStringLiteral("Cancelled");
    }
    return {};
}

QString spelled(Conditions conditions)
{
    QStringList names;
    for (const ConditionName &entry : conditionNames) {
        if (conditions.testFlag(entry.condition)) {
            names.append(entry.name);
        }
    }
    names.sort();
    return names.isEmpty() ? QStringLiteral("none") : names.join(u' ');
}

QString spelled(const std::optional<quint16> &word, const QString &expected)
{
    if (!word) {
        return QStringLiteral("none");
    }
    const bool isHex = expected.startsWith(QLatin1String("0x"), Qt::CaseInsensitive);
    return isHex ? QStringLiteral("0x%1").arg(*word, 4, 16, QLatin1Char('0')) : QString::number(*word);
}

/// CH_STATUS of a channel; `off`: it is not in use.
QString spelled(const Vibration &vibration, int channel)
{
    const VibrationChannel known = vibration.channels.value(channel);
    return known.isEnabled ? QString::number(static_cast<int>(known.state)) : QStringLiteral("off");
}

/// MEAS_TYPE and value; `none`: it is not in use.
QString spelled(const Vibration &vibration, int channel, int index, const QString &expected)
{
    for (const VibrationMeasurement &measurement : vibration.channels.value(channel).measurements) {
        if (measurement.index == index) {
            return QStringLiteral("%1 %2").arg(
                QString::number(measurement.type), spelledNumber(measurement.value, expected));
        }
    }
    return QStringLiteral("none");
}

/// How a value stands in a recording, in the manner of \a expected; `?` for a key that does not exist.
QString actual(const Measurement &measurement, const QString &key, const QString &expected)
{
    const auto tilt = measurement.tilt;
    if (key == QLatin1String("tiltX")) {
        return spelledNumber(tilt ? std::optional(tilt->x) : std::nullopt, expected);
    }
    if (key == QLatin1String("tiltY")) {
        return spelledNumber(tilt ? std::optional(tilt->y) : std::nullopt, expected);
    }
    if (key == QLatin1String("temperature")) {
        return spelledNumber(measurement.temperature, expected);
    }
    if (key == QLatin1String("heaterPower")) {
        return spelledNumber(measurement.heaterPower, expected);
    }
    if (key == QLatin1String("fanFrequency")) {
        return spelledNumber(measurement.fanFrequency, expected);
    }
    if (key == QLatin1String("rawStatus")) {
        return spelled(measurement.rawStatus, expected);
    }
    if (key == QLatin1String("rawMode")) {
        return spelled(measurement.rawMode, expected);
    }
    if (key == QLatin1String("conditions")) {
        return spelled(measurement.conditions);
    }
    static const QRegularExpression channelKey(QStringLiteral("^channel(\\d)$"));
    static const QRegularExpression measurementKey(QStringLiteral("^measurement(\\d)\\.(\\d)$"));
    if (const auto match = channelKey.match(key); match.hasMatch() && measurement.vibration) {
        return spelled(*measurement.vibration, match.captured(1).toInt());
    }
    if (const auto match = measurementKey.match(key); match.hasMatch() && measurement.vibration) {
        return spelled(*measurement.vibration, match.captured(1).toInt(), match.captured(2).toInt(), expected);
    }
    static const QStringList ofWeather{
        QStringLiteral("parameters"), QStringLiteral("digital"), QStringLiteral("events")};
    if (ofWeather.contains(key) || key.contains(u'.')) {
        return spelledWeather(measurement.weather, key, expected);
    }
    return QStringLiteral("?");
}

/// The order of names, the case of hexadecimal digits and a plus sign mean nothing.
QString normalized(const QString &key, const QString &value)
{
    if (key == QLatin1String("conditions")) {
        QStringList names = value.split(u' ');
        names.sort();
        return names.join(u' ');
    }
    if (value.startsWith(QLatin1String("0x"), Qt::CaseInsensitive)) {
        return value.toLower();
    }
    return value.startsWith(u'+') ? value.mid(1) : value;
}

DriverSettings settingsFor(const SensorConfig &sensor)
{
    DriverSettings settings;
    settings.sensor = sensor;
    return settings;
}

/// Plays the groups one after the other to one driver on one line.
class Player
{
public:
    explicit Player(const Talk &talk)
        : m_talk(talk)
        , m_driver(makeDriver(settingsFor(talk.sensor)))
    {
    }

    QStringList play()
    {
        if (!m_driver) {
            return {QStringLiteral("no driver for the sensor \"%1\"").arg(m_talk.sensor.name)};
        }
        for (const Talk::Group &group : m_talk.groups) {
            playGroup(group);
        }
        return m_findings;
    }

private:
    void playGroup(const Talk::Group &group)
    {
        loadScript(group);
        const bool isFetchOnly = std::all_of(group.expectations.begin(), group.expectations.end(), [](const auto &e) {
            return isBlocks(e);
        });
        if (!isFetchOnly) {
            checkPoll(group);
        }
        for (const Talk::Expectation &expectation : group.expectations) {
            if (isBlocks(expectation)) {
                checkFetch(expectation);
            }
        }
        const int line = group.expectations.isEmpty() ? 0 : group.expectations.first().line;
        for (const QByteArray &complaint : m_line.complaints().mid(m_complaints)) {
            add(line, QString::fromLatin1(complaint));
        }
        m_complaints = m_line.complaints().size();
        if (!m_line.isDone()) {
            add(line, QStringLiteral("the driver sent less than was recorded"));
        }
    }

    static bool isBlocks(const Talk::Expectation &e) { return e.key == QLatin1String("blocks"); }

    void loadScript(const Talk::Group &group)
    {
        const bool vanishes = std::any_of(group.expectations.begin(), group.expectations.end(), [](const auto &e) {
            return e.key == QLatin1String("fault") && e.value == QLatin1String("Closed");
        });
        for (const Talk::Exchange &exchange : group.exchanges) {
            const bool isLast = &exchange == &group.exchanges.last();
            if (vanishes && isLast) {
                m_line.vanishAfter(exchange.request);
            } else {
                m_line.expectPieces(exchange.request, exchange.pieces);
            }
        }
    }

    void checkPoll(const Talk::Group &group)
    {
        const auto result = m_driver->poll(m_line);
        for (const Talk::Expectation &expectation : group.expectations) {
            if (isBlocks(expectation)) {
                continue;
            }
            QString got = result ? QStringLiteral("a measurement") : QStringLiteral("fault ") + spelled(result.fault());
            if (expectation.key == QLatin1String("fault")) {
                got = result ? got : spelled(result.fault());
            } else if (result) {
                got = actual(*result, expectation.key, expectation.value);
            }
            compare(expectation, got);
        }
    }

    void checkFetch(const Talk::Expectation &expectation)
    {
        if (!m_driver->hasBacklog()) {
            compare(expectation, QStringLiteral("no backlog"));
            return;
        }
        const auto blocks = m_driver->fetch(m_line);
        compare(
            expectation, blocks ? QString::number(blocks->size()) : QStringLiteral("fault ") + spelled(blocks.fault()));
    }

    void compare(const Talk::Expectation &expectation, const QString &got)
    {
        if (normalized(expectation.key, expectation.value) != normalized(expectation.key, got)) {
            add(expectation.line,
                QStringLiteral("%1: expected %2, got %3").arg(expectation.key, expectation.value, got));
        }
    }

    void add(int line, const QString &what) { m_findings.append(QStringLiteral("line %1: %2").arg(line).arg(what)); }

    const Talk &m_talk;
    std::unique_ptr<Driver> m_driver;
    FakeLine m_line;
    qsizetype m_complaints = 0;
    QStringList m_findings;
};

} // namespace

QStringList playTalk(const Talk &talk)
{
    return talk.mistakes.isEmpty() ? Player(talk).play() : talk.mistakes;
}

} // namespace gorizont::test
