#include "ui/models/valuetext.h"

#include "core/values/statusword.h"

#include <QDateTime>

namespace gorizont {

namespace valuetext {

namespace {

constexpr double arcSecondsOfDegree = 3600;
constexpr quint64 samplesOfPacket = 32;

QString seconds(std::chrono::microseconds time)
{
    return fixed(std::chrono::duration<double>(time).count(), 3);
}

} // namespace

QString absent()
{
    return QStringLiteral("—");
}

QString orAbsent(const QString &text)
{
    return text.isEmpty() ? absent() : text;
}

QString fixed(std::optional<double> value, int decimals)
{
    return value ? QString::asprintf("%.*f", decimals, *value) : absent();
}

QString signedFixed(std::optional<double> value, int decimals)
{
    return value ? QString::asprintf("%+.*f", decimals, *value) : absent();
}

QString degrees(std::optional<double> arcSeconds)
{
    return arcSeconds ? signedFixed(*arcSeconds / arcSecondsOfDegree, 3) : absent();
}

QString degreesAndArcSeconds(double arcSeconds)
{
    return QStringLiteral("%1 (%2)").arg(degrees(arcSeconds), signedFixed(arcSeconds, 1));
}

QString tilt(const std::optional<Tilt> &tilt)
{
    if (!tilt) {
        return absent();
    }
    return QStringLiteral("%1 %2 (%3 %4)")
        .arg(degrees(tilt->x), degrees(tilt->y), signedFixed(tilt->x, 1), signedFixed(tilt->y, 1));
}

QString acceleration(
    const std::optional<AccelStatistics> &statistics, const std::optional<RingProgress> &ring, quint64 saved)
{
    if (!statistics && !ring) {
        return absent();
    }
    QString text = statistics ? QString::asprintf(
                       "%.2f %.1f (%.2f|%.2f %.2f)", statistics->maximum, statistics->direction, statistics->rms,
                       statistics->rmsX, statistics->rmsY)
                              : absent();
    if (ring) {
        text += QStringLiteral(" %1:%2 (%3) %4")
                    .arg(ring->packetsMeasured)
                    .arg(ring->packetsRead)
                    .arg(ring->packetsRead * samplesOfPacket)
                    .arg(saved);
    }
    return text;
}

QString thermostat(std::optional<double> heaterPower, std::optional<double> fanFrequency)
{
    if (!heaterPower && !fanFrequency) {
        return absent();
    }
    return QStringLiteral("%1 (%2)").arg(fixed(heaterPower, 1), fixed(fanFrequency, 1));
}

QString poll(const Reading &reading, SteadyTime now)
{
    if (!reading.answeredAt) {
        return absent();
    }
    const QString period = reading.period.count() > 0 ? seconds(reading.period) : absent();
    return QStringLiteral("%1|%2|%3").arg(period, seconds(reading.exchange), age(now - *reading.answeredAt));
}

QString duration(std::chrono::nanoseconds elapsed)
{
    const auto total = std::max<qint64>(0, std::chrono::floor<Seconds>(elapsed).count());
    return QString::asprintf(
        "%lld:%02lld:%02lld", static_cast<long long>(total / 3600), static_cast<long long>(total / 60 % 60),
        static_cast<long long>(total % 60));
}

QString age(std::chrono::nanoseconds elapsed)
{
    const QString full = duration(elapsed);
    return elapsed < std::chrono::hours(1) ? full.mid(2) : full;
}

QString binary(quint16 word)
{
    QString bits = QString::number(word, 2).rightJustified(16, u'0');
    for (const int at : {12, 8, 4}) {
        bits.insert(at, u' ');
    }
    return bits;
}

QString words(std::optional<quint16> status, std::optional<quint16> mode)
{
    if (!status && !mode) {
        return absent();
    }
    return QStringLiteral("%1 : %2").arg(status ? binary(*status) : absent(), mode ? binary(*mode) : absent());
}

QString status(quint16 word)
{
    return QStringLiteral("%1%2").arg(word >> 12, 2).arg(binary(word).mid(4));
}

QString clock(UtcTime time)
{
    const auto milliseconds = std::chrono::floor<std::chrono::milliseconds>(time.time_since_epoch()).count();
    return QDateTime::fromMSecsSinceEpoch(milliseconds).toString(QStringLiteral("hh:mm:ss dd.MM.yy"));
}

} // namespace valuetext

namespace {

/// The sensor is polled and answers: its code is none of those of ports and of missing answers.
bool isInContact(quint16 status)
{
    const StatusCode code = statusCode(status);
    return !(status & statusbit::NotPolled) && (code == StatusCode::Good || code >= StatusCode::TransducerSilent);
}

std::optional<double> ofThermostat(const SensorConfig &sensor, const std::optional<double> &value)
{
    return sensor.hasThermostat || value.value_or(0) > 0 ? value : std::nullopt;
}

} // namespace

std::optional<Tilt> validTilt(const Reading &reading)
{
    return isTiltValid(reading.status) ? reading.tilt : std::nullopt;
}

std::optional<double> validTemperature(const Reading &reading)
{
    return isTemperatureValid(reading.status) ? reading.temperature : std::nullopt;
}

std::optional<AccelStatistics> validAcceleration(const Reading &reading)
{
    return isAccelerationValid(reading.status) ? reading.acceleration : std::nullopt;
}

std::optional<double> validHeaterPower(const SensorConfig &sensor, const Reading &reading)
{
    return isInContact(reading.status) ? ofThermostat(sensor, reading.heaterPower) : std::nullopt;
}

std::optional<double> validFanFrequency(const SensorConfig &sensor, const Reading &reading)
{
    return isInContact(reading.status) ? ofThermostat(sensor, reading.fanFrequency) : std::nullopt;
}

std::optional<Vibration> validVibration(const Reading &reading)
{
    return isInContact(reading.status) ? reading.vibration : std::nullopt;
}

} // namespace gorizont
