#include "core/history/historyformat.h"

#include "core/values/statusword.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace gorizont {

namespace {

constexpr char tab = '\t';
constexpr auto lineEnd = "\r\n";

/// `%8.{decimals}f` of the C locale, without negative zeros.
QByteArray field(double value, int decimals)
{
    if (!std::isfinite(value)) {
        return {};
    }
    std::array<char, 400> buffer; // the largest double has 309 digits before its point
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    QByteArray text(buffer.data(), end.ptr - buffer.data());
    const bool isZero =
        std::all_of(text.cbegin(), text.cend(), [](char c) { return c == '-' || c == '.' || c == '0'; });
    if (isZero && text.startsWith('-')) {
        text.remove(0, 1);
    }
    return text.rightJustified(8);
}

QByteArray field(const std::optional<double> &value, int decimals)
{
    return value ? field(*value, decimals) : QByteArray();
}

/// A sensor without a heater has 0.0; one with a heater that never told its power has nothing.
QByteArray heaterField(const SensorColumns &sensor)
{
    return sensor.reading.heaterPower || sensor.config.hasThermostat ? field(sensor.reading.heaterPower, 1)
                                                                     : field(0.0, 1);
}

QByteArray beginning(const QDateTime &local, const QByteArray &channels)
{
    return local.toString(u"hh:mm:ss dd.MM.yy").toLatin1() + tab + channels;
}

void appendTilt(QByteArray &record, const SensorColumns &sensor)
{
    const Reading &reading = sensor.reading;
    record += tab + (reading.tilt ? field(reading.tilt->x, 1) : QByteArray());
    record += tab + (reading.tilt ? field(reading.tilt->y, 1) : QByteArray());
    record += tab + (sensor.config.measuresTemperature ? field(reading.temperature, 2) : QByteArray());
    record += tab + heaterField(sensor);
    record += tab + statusDigits(reading.status);
}

/// The table of manual 6.3 has its middle columns swapped: both maxima stand before both deviations.
void appendAcceleration(QByteArray &record, const Reading &reading)
{
    const std::optional<AccelStatistics> &known = reading.acceleration;
    record += tab + (known ? field(known->maximumX, 2) : QByteArray());
    record += tab + (known ? field(known->maximumY, 2) : QByteArray());
    record += tab + (known ? field(known->rmsX, 2) : QByteArray());
    record += tab + (known ? field(known->rmsY, 2) : QByteArray());
    record += tab + statusDigits(reading.status);
}

} // namespace

QByteArray historyField(const std::optional<double> &value, int decimals)
{
    return field(value, decimals);
}

QByteArray recordBeginning(const QDateTime &local, const QByteArray &channels)
{
    return beginning(local, channels);
}

QDateTime localTime(UtcTime time, const QTimeZone &zone)
{
    const auto milliseconds = std::chrono::floor<std::chrono::milliseconds>(time).time_since_epoch().count();
    return zone.isValid() ? QDateTime::fromMSecsSinceEpoch(milliseconds, zone)
                          : QDateTime::fromMSecsSinceEpoch(milliseconds);
}

QByteArray channelDigits(const QList<LineStatus> &lines)
{
    QByteArray digits(4, '3');
    for (const LineStatus &line : lines) {
        if (line.port < 1 || line.port > 16) {
            continue;
        }
        digits = digits.rightJustified(line.port, '3');
        digits[digits.size() - line.port] = static_cast<char>('0' + channelCode(line.state));
    }
    return digits;
}

QByteArray statusDigits(quint16 word)
{
    QByteArray text = QByteArray::number(word >> 12).rightJustified(2);
    for (int bit = 11; bit >= 0; --bit) {
        if (bit % 4 == 3) {
            text += ' ';
        }
        text += (word >> bit) & 1 ? '1' : '0';
    }
    return text;
}

QByteArray dataRecord(const QDateTime &local, const QByteArray &channels, const QList<SensorColumns> &sensors)
{
    QByteArray record = beginning(local, channels);
    for (const SensorColumns &sensor : sensors) {
        if (sensor.config.measuresTilt) {
            appendTilt(record, sensor);
        }
    }
    return record + lineEnd;
}

QByteArray accelerationRecord(const QDateTime &local, const QByteArray &channels, const QList<SensorColumns> &sensors)
{
    QByteArray record = beginning(local, channels);
    for (const SensorColumns &sensor : sensors) {
        if (sensor.config.measuresAcceleration) {
            appendAcceleration(record, sensor.reading);
        }
    }
    return record + lineEnd;
}

QString logRecord(const JournalEntry &entry, const QTimeZone &zone)
{
    QString text = entry.text;
    std::replace_if(
        text.begin(), text.end(), [](QChar c) { return c.category() == QChar::Other_Control; }, QChar(u' '));
    return QString::number(static_cast<int>(entry.kind)) + u' '
        + localTime(entry.time, zone).toString(u"hh:mm:ss dd.MM.yy") + QStringLiteral("   ") + text
        + QLatin1String(lineEnd);
}

QString monthFileName(QDate month, MonthFile file)
{
    static constexpr std::array names{"data", "adata", "log", "wdata"};
    return month.toString(u"yyyy_MM_") + QLatin1String(names.at(static_cast<std::size_t>(file)))
        + QStringLiteral(".txt");
}

QString sampleFileName(const QDateTime &start, int number, QChar axis)
{
    return start.toString(u"yy_MM_dd_hh_mm_ss_") + QString::number(number) + axis + QStringLiteral(".wrd");
}

} // namespace gorizont
