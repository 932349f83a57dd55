#include "core/devices/ind3/ind3values.h"

#include "core/protocol/bytes.h"

#include <QStringConverter>

#include <array>
#include <cmath>

namespace gorizont::ind3 {

namespace {

constexpr qsizetype blockLength = 6;
constexpr quint32 negativeBit = 0x800000;
constexpr quint32 minutesBit = 0x400000;
constexpr quint32 magnitudeMask = 0x3FFFFF; ///< 1/256 of the unit
constexpr int secondsInMinute = 60;

constexpr std::array<int, 8> bauds{1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200};
constexpr std::array<int, 4> periods{10, 20, 50, 100}; // ms

constexpr const char *nameEncoding = "windows-1251";

double decodeAngle(QByteArrayView triple)
{
    const quint32 word = byteAt(triple, 0) | static_cast<quint32>(byteAt(triple, 1)) << 8
        | static_cast<quint32>(byteAt(triple, 2)) << 16;
    const double magnitude = (word & magnitudeMask) / 256.0 * (word & minutesBit ? secondsInMinute : 1);
    return word & negativeBit && magnitude > 0 ? -magnitude : magnitude;
}

bool appendAngle(QByteArray &block, double angle)
{
    double units = std::round(std::abs(angle) * 256);
    quint32 flags = angle < 0 && units > 0 ? negativeBit : 0;
    if (units > magnitudeMask) {
        units = std::round(std::abs(angle) * 256 / secondsInMinute);
        flags |= minutesBit;
    }
    if (!(units <= magnitudeMask)) { // NaN too
        return false;
    }
    const quint32 word = flags | static_cast<quint32>(units);
    appendByte(block, static_cast<int>(word & 0xFF));
    appendByte(block, static_cast<int>(word >> 8 & 0xFF));
    appendByte(block, static_cast<int>(word >> 16));
    return true;
}

template <std::size_t N> std::optional<int> indexOf(const std::array<int, N> &values, int value)
{
    for (std::size_t i = 0; i < N; ++i) {
        if (values[i] == value) {
            return static_cast<int>(i);
        }
    }
    return std::nullopt;
}

template <std::size_t N> std::optional<int> valueAt(const std::array<int, N> &values, int index)
{
    if (index < 0 || index >= static_cast<int>(N)) {
        return std::nullopt;
    }
    return values[static_cast<std::size_t>(index)];
}

} // namespace

std::optional<Tilt> decodeAngleBlock(QByteArrayView block)
{
    if (block.size() != blockLength) {
        return std::nullopt;
    }
    return Tilt{decodeAngle(block.last(3)), decodeAngle(block.first(3))};
}

std::optional<QByteArray> encodeAngleBlock(const Tilt &tilt)
{
    QByteArray block;
    if (!appendAngle(block, tilt.y) || !appendAngle(block, tilt.x)) {
        return std::nullopt;
    }
    return block;
}

std::optional<int> baudOfCode(int code)
{
    return valueAt(bauds, code - 1);
}

std::optional<int> codeOfBaud(int baud)
{
    const auto index = indexOf(bauds, baud);
    return index ? std::optional(*index + 1) : std::nullopt;
}

std::optional<int> ticksOfCode(int code)
{
    return code >= 0 && code <= mostTicksCode ? std::optional(1 << code) : std::nullopt;
}

std::optional<int> codeOfTicks(int ticks)
{
    for (int code = 0; code <= mostTicksCode; ++code) {
        if (ticks == 1 << code) {
            return code;
        }
    }
    return std::nullopt;
}

std::optional<std::chrono::milliseconds> periodOfCode(int code)
{
    const auto period = valueAt(periods, code);
    return period ? std::optional(std::chrono::milliseconds(*period)) : std::nullopt;
}

std::optional<int> codeOfPeriod(std::chrono::milliseconds period)
{
    for (int code = 0; code <= mostPeriodCode; ++code) {
        if (periodOfCode(code) == period) {
            return code;
        }
    }
    return std::nullopt;
}

std::optional<QByteArray> encodeName(const QString &name)
{
    QStringEncoder encoder(nameEncoding);
    if (!encoder.isValid()) {
        return std::nullopt;
    }
    const QByteArray bytes = encoder.encode(name);
    // What the encoding does not hold is replaced, and does not come back.
    if (bytes.isEmpty() || bytes.size() > longestName || decodeName(bytes) != name) {
        return std::nullopt;
    }
    return bytes;
}

QString decodeName(QByteArrayView bytes)
{
    while (bytes.endsWith('\0')) { // some fill up what is left of the sixteen bytes
        bytes.chop(1);
    }
    QStringDecoder decoder(nameEncoding);
    return decoder.isValid() ? QString(decoder.decode(bytes)) : QString::fromLatin1(bytes);
}

} // namespace gorizont::ind3
