#pragma once

#include "core/line/line.h"

#include <QDate>
#include <QString>

#include <chrono>
#include <optional>

/// What the messages of an УСМ-ИСН carry. Manual 002, section 3; spec/usm-isn.md, 3, 4, 6.
namespace gorizont::usmisn {

constexpr int inclinometerType = 28; ///< what GetType tells of an УСМ-ИСН; another one is another device of the series
constexpr int channelX = 1;
constexpr int channelY = 2;
constexpr double arcSecondsInDegree = 3600;
constexpr int memorySize = 1720; ///< records; the oldest are overwritten

/// A channel everywhere in the world: serial number × 100 + number of the channel.
struct ChannelId
{
    quint64 value = 0;

    quint32 serial() const { return static_cast<quint32>(value / 100); } ///< of the device, eight digits
    int channel() const { return static_cast<int>(value % 100); } ///< 1 X, 2 Y
    static ChannelId of(quint32 serial, int channel) { return {quint64(serial) * 100 + quint64(channel)}; }
    auto operator<=>(const ChannelId &) const = default;
};

/// One channel, as GetInfo lists it.
struct Channel
{
    ChannelId id;
    QString type; ///< `A`
    QString units; ///< `Grad`: degrees
    QString description; ///< `Angle_X`
    bool operator==(const Channel &) const = default;
};

enum class ValueState : quint8 {
    Measured,
    OutOfRange, ///< beyond the range of measurement: there is no value
    ErrorSensor, ///< the device failed to measure; its transducer may be broken
    ErrorChannel, ///< the device has no such channel
    ErrorData, ///< the device does not understand the request
};

/// One measurement of one channel: the answer to GetValue, and one record of the memory.
struct Value
{
    ValueState state = ValueState::Measured; ///< Error…: everything else is empty
    qint64 timestamp = 0; ///< seconds since 1970, UTC; 0: not stored
    ChannelId channel;
    quint32 measurement = 0; ///< MeasID, the counter of stored measurements; 0: not stored
    double value = 0; ///< degrees; 0 when OutOfRange
    double variation = 0; ///< degrees, mean absolute deviation of 512 measurements
    double temperature = 0; ///< °C, of the device
    QString description; ///< of the channel
    int gain = 0;
    int voltage = 0; ///< V
    bool operator==(const Value &) const = default;
};

/// Which records GetRecord looks for. New: those not yet read; what is sent counts as read, whether it arrives or not.
enum class RecordMask : quint8 { All, New };

/// What StartCycle tells the recorder.
struct Recording
{
    qint64 now = 0; ///< seconds since 1970, UTC: the clock of the device is set to it
    qint64 start = 0; ///< the same, of the first measurement
    std::chrono::seconds period{3600}; ///< 900…43200 s
    std::chrono::seconds delay{0}; ///< 0…600 s before each measurement, so that devices do not measure at once
    bool operator==(const Recording &) const = default;
};

constexpr std::chrono::seconds shortestPeriod{900};
constexpr std::chrono::seconds longestPeriod{43200};
constexpr std::chrono::seconds longestDelay{600};

constexpr int slowestBaud = 110;
constexpr int fastestBaud = 115200;
constexpr PortSettings factoryPort{9600, Parity::None, StopBits::One};

inline bool isAddress(int address)
{
    return address >= 1 && address <= 255;
}

/// Whether a device may be sent these: speed, parity N, E or O, stop bits 1, 1.5 or 2.
bool isPossible(const PortSettings &port);
/// Whether a device may be sent this; the first measurement must lie in its future.
bool isPossible(const Recording &recording);

} // namespace gorizont::usmisn
