// What a setting takes, and how it goes into its registers.

#include "core/devices/lvims/lvimssettings.h"
#include "core/devices/lvims/lvimswords.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gorizont::lvims {

namespace {

class SettingText
{
    Q_DECLARE_TR_FUNCTIONS(LVimsSettings)
};

using Kind = Setting::Kind;

constexpr quint16 channelBits = (1 << channelCount) - 1;

/// Empty: no whole number, decimal or after 0x, from \a least to \a most.
std::optional<int> wholeNumber(const QString &text, int least, int most)
{
    bool isNumber = false;
    const bool isHex = text.startsWith(u"0x", Qt::CaseInsensitive);
    const int number = isHex ? text.mid(2).toInt(&isNumber, 16) : text.toInt(&isNumber, 10);
    return isNumber && number >= least && number <= most ? std::optional(number) : std::nullopt;
}

std::optional<double> realNumber(QString text)
{
    bool isNumber = false;
    const double number = text.replace(u',', u'.').toDouble(&isNumber);
    return isNumber && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// Its first number in the highest byte, as masks are written. Empty: these are not four numbers.
std::optional<quint32> ipAddress(const QString &text)
{
    const QStringList parts = text.split(u'.');
    quint32 address = 0;
    for (const QString &part : parts) {
        const auto number = part.size() <= 3 ? wholeNumber(part, 0, 255) : std::nullopt;
        if (!number || part.startsWith(u'+')) {
            return std::nullopt;
        }
        address = address << 8 | static_cast<quint32>(*number);
    }
    return parts.size() == 4 ? std::optional(address) : std::nullopt;
}

/// Of one machine: neither "this network" nor loopback, neither of a group nor reserved.
bool isHost(quint32 address)
{
    const quint32 first = address >> 24;
    return first >= 1 && first <= 223 && first != 127;
}

bool isMask(quint32 address)
{
    const quint32 zeros = ~address;
    return address != 0 && (zeros & (zeros + 1)) == 0;
}

/// The first number of an address stands in the low byte of its first register.
QList<quint16> fromIpAddress(quint32 address)
{
    const quint32 turned = address >> 24 | (address >> 8 & 0xFF00) | (address << 8 & 0xFF0000) | (address & 0xFF) << 24;
    return fromDoubleWord(turned);
}

/// Empty: not in steps of 0.1 Hz, or too much.
std::optional<quint32> tenths(const QString &text)
{
    constexpr double nearEnough = 1e-6;
    const auto hertz = realNumber(text);
    if (!hertz || *hertz < 0 || *hertz > highestCutOff) {
        return std::nullopt;
    }
    const double wanted = *hertz * 10;
    return std::abs(wanted - std::round(wanted)) < nearEnough * std::max(1.0, wanted)
        ? std::optional(static_cast<quint32>(std::llround(wanted)))
        : std::nullopt;
}

QList<quint16> oneWord(std::optional<int> number)
{
    return number ? QList<quint16>{static_cast<quint16>(*number)} : QList<quint16>();
}

QList<quint16> addressWords(const QString &text, Kind kind)
{
    const auto address = ipAddress(text);
    const bool isGood = address
        && (kind == Kind::NetworkMask   ? isMask(*address)
                : kind == Kind::Gateway ? *address == 0 || isHost(*address)
                                        : isHost(*address));
    return isGood ? fromIpAddress(*address) : QList<quint16>();
}

QList<quint16> realWords(const QString &text)
{
    const auto number = realNumber(text);
    const float value = number ? static_cast<float>(*number) : 0.0F;
    return number && std::isfinite(value) ? fromReal(value) : QList<quint16>();
}

/// The registers of \a setting; empty: it does not take \a text. \a before: its registers now.
QList<quint16> wordsOf(const Setting &setting, const QString &text, const QList<quint16> &before)
{
    switch (setting.kind) {
    case Kind::Text: return fromText(text, setting.size);
    case Kind::Host:
    case Kind::NetworkMask:
    case Kind::Gateway: return addressWords(text, setting.kind);
    case Kind::Real: return realWords(text);
    case Kind::Milliseconds: return oneWord(wholeNumber(text, shortestWaveform, longestWaveform));
    case Kind::MeasurementType: return oneWord(wholeNumber(text, 0, lastMeasurementType));
    case Kind::Switch: return oneWord(wholeNumber(text, 0, 1));
    case Kind::Frequency: {
        const auto steps = tenths(text);
        return steps ? fromDoubleWord(*steps) : QList<quint16>();
    }
    case Kind::ChannelMask: break;
    }
    const auto mask = wholeNumber(text, 0, channelBits);
    return mask ? oneWord((before.value(0) & ~channelBits) | *mask) : QList<quint16>();
}

QString limitsOf(const Setting &setting)
{
    switch (setting.kind) {
    case Kind::Text: return {};
    case Kind::Host: return SettingText::tr("an IPv4 address of one machine, such as 192.168.1.10");
    case Kind::NetworkMask: return SettingText::tr("a mask of a network, such as 255.255.255.0");
    case Kind::Gateway: return SettingText::tr("an IPv4 address, or 0.0.0.0 for none");
    case Kind::ChannelMask: return SettingText::tr("a sum of 1, 2, 4, 8 for channels 0…3, or 0");
    case Kind::Milliseconds:
        return SettingText::tr("a whole number of ms, %1…%2").arg(shortestWaveform).arg(longestWaveform);
    case Kind::Real: return SettingText::tr("a number");
    case Kind::MeasurementType: return SettingText::tr("a type of measurement, 0…%1").arg(lastMeasurementType);
    case Kind::Switch: return SettingText::tr("0 or 1");
    case Kind::Frequency: return SettingText::tr("a frequency in Hz, not below 0, in steps of 0.1");
    }
    return {};
}

} // namespace

QString change(QList<quint16> &image, const Setting &setting, const QString &text)
{
    const bool isText = setting.kind == Kind::Text;
    const QList<quint16> words =
        wordsOf(setting, isText ? text : text.trimmed(), image.mid(setting.address, setting.size));
    if (words.size() != setting.size || image.size() != settingsSize) {
        return SettingText::tr("%1 takes %2, not \"%3\".").arg(setting.name, limitsOf(setting), text);
    }
    std::copy(words.cbegin(), words.cend(), image.begin() + setting.address);
    return {};
}

} // namespace gorizont::lvims
