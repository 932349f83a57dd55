#include "core/devices/usmisn/usmisnrecords.h"

#include "core/values/geometry.h"

#include <QByteArrayList>
#include <QDateTime>

#include <algorithm>
#include <array>

namespace gorizont::usmisn {

bool RecordBook::add(const Value &record)
{
    const bool hasValue = record.state == ValueState::Measured || record.state == ValueState::OutOfRange;
    if (!hasValue || record.timestamp == 0) {
        return false;
    }
    const Key key{record.channel.serial(), record.measurement, record.channel.channel()};
    return m_records.try_emplace(key, record).second;
}

QList<Value> RecordBook::records() const
{
    QList<Value> list;
    list.reserve(size());
    for (const auto &[key, record] : m_records) {
        list.append(record);
    }
    return list;
}

qint64 RecordBook::missing() const
{
    qint64 missing = 0;
    const Key *last = nullptr;
    for (const auto &[key, record] : m_records) {
        if (last && last->serial == key.serial && key.measurement > last->measurement) {
            missing += qint64(key.measurement) - last->measurement - 1;
        }
        last = &key;
    }
    return missing;
}

DeviceRecord deviceRecord(const Value &record, int number)
{
    const QString name =
        QStringLiteral("%1 %2").arg(record.channel.value, 10, 10, QLatin1Char('0')).arg(record.measurement);
    return {number, UtcTime(std::chrono::seconds(record.timestamp)), name, csv::line(record)};
}

namespace {

constexpr std::chrono::seconds bothAxes{10}; ///< measuring takes 1.5 s an axis, the shortest period of a recorder 900 s

/// A recorder measures X and then Y, and counts both.
bool areOneMeasurement(const Value &x, const Value &y)
{
    return x.channel.serial() == y.channel.serial() && x.channel.channel() == channelX
        && y.channel.channel() == channelY && y.measurement - x.measurement <= 1
        && qAbs(y.timestamp - x.timestamp) <= std::chrono::seconds(bothAxes).count();
}

} // namespace

Readings readingsOf(const QList<Value> &records, const SensorConfig &sensor)
{
    Readings readings;
    const AxisTransform transform(sensor);
    for (qsizetype i = 0; i + 1 < records.size(); ++i) {
        const Value &x = records.at(i);
        const Value &y = records.at(i + 1);
        const bool isMeasured = x.state == ValueState::Measured && y.state == ValueState::Measured;
        if (!isMeasured || !areOneMeasurement(x, y)) {
            continue;
        }
        Reading reading;
        reading.number = sensor.number;
        reading.time = UtcTime(std::chrono::seconds(x.timestamp));
        reading.isAnswer = true;
        reading.tilt = correctedTilt({x.value * arcSecondsInDegree, y.value * arcSecondsInDegree}, transform, sensor);
        reading.temperature = y.temperature - sensor.offsetT;
        readings.append(reading);
    }
    return readings;
}

namespace csv {

namespace {

constexpr qsizetype columns = 8;

QByteArray degrees(double value)
{
    return QByteArray::number(value, 'f', 5);
}

} // namespace

QByteArray header()
{
    return "time,timestamp,serial,channel,measurement,value,variation,temperature\r\n";
}

QByteArray line(const Value &record)
{
    const QByteArray time = QDateTime::fromSecsSinceEpoch(record.timestamp, Qt::UTC).toString(Qt::ISODate).toLatin1();
    const QByteArrayList fields{
        time,
        QByteArray::number(record.timestamp),
        QByteArray::number(record.channel.serial()).rightJustified(8, '0'),
        QByteArray::number(record.channel.channel()),
        QByteArray::number(record.measurement),
        record.state == ValueState::Measured ? degrees(record.value) : QByteArray(),
        degrees(record.variation),
        QByteArray::number(record.temperature, 'f', 2)};
    return fields.join(',') + "\r\n";
}

std::optional<Value> parse(const QByteArray &line)
{
    const QByteArrayList fields = line.trimmed().split(',');
    if (fields.size() != columns) {
        return std::nullopt;
    }
    std::array<bool, 7> isGood{};
    Value record;
    record.timestamp = fields.at(1).toLongLong(&isGood[0]);
    record.channel = ChannelId::of(fields.at(2).toUInt(&isGood[1]), fields.at(3).toInt(&isGood[2]));
    record.measurement = fields.at(4).toUInt(&isGood[3]);
    record.state = fields.at(5).isEmpty() ? ValueState::OutOfRange : ValueState::Measured;
    record.value = fields.at(5).isEmpty() ? 0 : fields.at(5).toDouble(&isGood[4]);
    isGood[4] = isGood[4] || fields.at(5).isEmpty();
    record.variation = fields.at(6).toDouble(&isGood[5]);
    record.temperature = fields.at(7).toDouble(&isGood[6]);
    const bool isAllGood = std::all_of(isGood.begin(), isGood.end(), [](bool good) { return good; });
    return isAllGood && record.timestamp > 0 ? std::optional(record) : std::nullopt;
}

} // namespace csv

} // namespace gorizont::usmisn
