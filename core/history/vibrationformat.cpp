#include "core/history/vibrationformat.h"

#include <algorithm>
#include <cmath>

namespace gorizont {

namespace {

constexpr char tab = '\t';
constexpr int channelCount = 4;
constexpr int measurementCount = 8;
constexpr int relayCount = 8;
constexpr int digits = 7; ///< as many as a float has

const VibrationMeasurement *measurementOf(const VibrationChannel &channel, int index)
{
    const auto found = std::ranges::find(channel.measurements, index, &VibrationMeasurement::index);
    return found != channel.measurements.end() ? &*found : nullptr;
}

void appendMeasurement(QByteArray &record, const VibrationMeasurement *measurement)
{
    const bool hasValue = measurement != nullptr && measurement->value && std::isfinite(*measurement->value);
    record += tab + (measurement != nullptr ? QByteArray::number(measurement->type) : QByteArray());
    record += tab + (hasValue ? QByteArray::number(*measurement->value, 'g', digits) : QByteArray());
}

void appendChannel(QByteArray &record, const VibrationChannel *channel)
{
    record += tab + (channel != nullptr ? QByteArray::number(static_cast<int>(channel->state)) : QByteArray());
    for (int index = 0; index < measurementCount; ++index) {
        appendMeasurement(record, channel != nullptr ? measurementOf(*channel, index) : nullptr);
    }
}

QByteArray bitsOf(const QList<Relay> &relays, bool Relay::*flag)
{
    QByteArray bits(relayCount, '0');
    for (const Relay &relay : relays) {
        if (relay.*flag && relay.index >= 0 && relay.index < relayCount) {
            bits[relayCount - 1 - relay.index] = '1';
        }
    }
    return bits;
}

QByteArray relayDigits(const QList<Relay> &relays)
{
    return relays.isEmpty()
        ? QByteArray()
        : QByteArrayList{bitsOf(relays, &Relay::isEnabled), bitsOf(relays, &Relay::hasError), bitsOf(relays, &Relay::isPhysical), bitsOf(relays, &Relay::isLogical)}
              .join(' ');
}

void appendModule(QByteArray &record, const Reading &reading)
{
    const Vibration vibration = reading.vibration.value_or(Vibration());
    record += tab + statusDigits(reading.status);
    for (int number = 0; number < channelCount; ++number) {
        const auto found = std::ranges::find(vibration.channels, number, &VibrationChannel::channel);
        appendChannel(record, found != vibration.channels.end() && found->isEnabled ? &*found : nullptr);
    }
    record += tab + relayDigits(vibration.relays);
}

} // namespace

bool hasVibrationColumns(const SensorConfig &sensor)
{
    return sensor.type == SensorType::LVims;
}

QByteArray vibrationRecord(const QDateTime &local, const QByteArray &channels, const QList<SensorColumns> &sensors)
{
    QByteArray record = recordBeginning(local, channels);
    for (const SensorColumns &sensor : sensors) {
        if (hasVibrationColumns(sensor.config)) {
            appendModule(record, sensor.reading);
        }
    }
    return record + "\r\n";
}

} // namespace gorizont
