#include "core/devices/lvims/lvimssettings.h"

#include "core/devices/lvims/lvimswords.h"

#include <algorithm>
#include <vector>

namespace gorizont::lvims {

namespace {

using Kind = Setting::Kind;

Setting settingAt(const QString &name, Kind kind, const Register &entry, int channel = 0, int item = 0)
{
    return {name, kind, entry.at(channel, item), entry.size};
}

void appendFilter(QList<Setting> &settings, const QString &name, quint16 filter)
{
    constexpr Register enabled = filterRegister("IIR_EN");
    constexpr Register low = filterRegister("IIR_FC_L");
    constexpr Register high = filterRegister("IIR_FC_H");
    settings.append(
        {name + QStringLiteral(".EN"), Kind::Switch, static_cast<quint16>(filter + enabled.address), enabled.size});
    settings.append(
        {name + QStringLiteral(".FC"), Kind::Frequency, static_cast<quint16>(filter + low.address),
         static_cast<quint16>(low.size + high.size)});
}

void appendChannel(QList<Setting> &settings, int channel)
{
    const QString prefix = QStringLiteral("CH%1.").arg(channel);
    settings.append(
        settingAt(prefix + QStringLiteral("SENSOR_K"), Kind::Real, settingRegister("CH_SENSOR_K"), channel));
    settings.append(
        settingAt(prefix + QStringLiteral("SENSOR_B"), Kind::Real, settingRegister("CH_SENSOR_B"), channel));
    for (int m = 0; m < measurementCount; ++m) {
        const QString measurement = prefix + QStringLiteral("MEAS%1").arg(m);
        settings.append(settingAt(
            measurement + QStringLiteral(".TYPE"), Kind::MeasurementType, settingRegister("MEAS_TYPE"), channel, m));
        appendFilter(settings, measurement + QStringLiteral(".IIR_HP"), settingRegister("MEAS_IIR_HP").at(channel, m));
        appendFilter(settings, measurement + QStringLiteral(".IIR_LP"), settingRegister("MEAS_IIR_LP").at(channel, m));
    }
}

QList<Setting> makeSettings()
{
    QList<Setting> settings{
        settingAt(QStringLiteral("CUSTOM_NAME"), Kind::Text, settingRegister("CUSTOM_NAME")),
        settingAt(QStringLiteral("IP_ADDR"), Kind::Host, settingRegister("IP_ADDR")),
        settingAt(QStringLiteral("IP_MASK"), Kind::NetworkMask, settingRegister("IP_MASK")),
        settingAt(QStringLiteral("IP_GATE"), Kind::Gateway, settingRegister("IP_GATE")),
        settingAt(QStringLiteral("CH_EN_MASK"), Kind::ChannelMask, settingRegister("CH_EN_MASK")),
        settingAt(QStringLiteral("CH_SENS_PWR"), Kind::ChannelMask, settingRegister("CH_SENS_PWR")),
        settingAt(QStringLiteral("WF_ACQ_TIME"), Kind::Milliseconds, settingRegister("WF_ACQ_TIME"))};
    for (int channel = 0; channel < channelCount; ++channel) {
        appendChannel(settings, channel);
    }
    return settings;
}

/// Enough to find the same float again.
QString realText(float value)
{
    constexpr int digits = 9;
    const QString brief = QString::number(static_cast<double>(value), 'g', digits - 2);
    return brief.toFloat() == value ? brief : QString::number(static_cast<double>(value), 'g', digits);
}

/// Of each register that belongs to a setting whose value differs.
std::vector<bool> touched(const QList<quint16> &before, const QList<quint16> &after)
{
    std::vector<bool> marks(static_cast<std::size_t>(settingsSize), false);
    for (qsizetype i = 0; i < settingsSize; ++i) {
        marks[static_cast<std::size_t>(i)] = before.value(i) != after.value(i);
    }
    for (const Setting &setting : allSettings()) {
        const auto first = marks.begin() + setting.address;
        if (std::find(first, first + setting.size, true) != first + setting.size) {
            std::fill(first, first + setting.size, true);
        }
    }
    return marks;
}

QString wordsText(const QList<quint16> &image, int first, int count)
{
    constexpr int most = 4;
    QStringList words;
    for (int i = first; i < first + std::min(count, most); ++i) {
        words += QStringLiteral("%1").arg(image.value(i), 4, 16, QLatin1Char('0')).toUpper();
    }
    return words.join(u' ') + (count > most ? QStringLiteral(" …") : QString());
}

SettingDifference differenceOf(const Setting &setting, const QList<quint16> &before, const QList<quint16> &after)
{
    return {setting.name, valueOf(before, setting), valueOf(after, setting), isOfNetwork(setting)};
}

/// What lies behind the end of a name is not part of it.
bool isSame(const Setting &setting, const QList<quint16> &before, const QList<quint16> &after)
{
    return setting.kind == Kind::Text
        ? valueOf(before, setting) == valueOf(after, setting)
        : before.mid(setting.address, setting.size) == after.mid(setting.address, setting.size);
}

void appendUndescribed(QList<SettingDifference> &found, const QList<quint16> &before, const QList<quint16> &after)
{
    std::vector<bool> marks = touched(before, after);
    for (const Setting &setting : allSettings()) {
        std::fill_n(marks.begin() + setting.address, setting.size, false);
    }
    for (auto first = std::find(marks.begin(), marks.end(), true); first != marks.end();) {
        const auto end = std::find(first, marks.end(), false);
        const int at = static_cast<int>(first - marks.begin());
        const int count = static_cast<int>(end - first);
        const QString name =
            count == 1 ? QStringLiteral("SET+%1").arg(at) : QStringLiteral("SET+%1…%2").arg(at).arg(at + count - 1);
        found.append({name, wordsText(before, at, count), wordsText(after, at, count), false});
        first = std::find(end, marks.end(), true);
    }
}

} // namespace

const QList<Setting> &allSettings()
{
    static const QList<Setting> settings = makeSettings();
    return settings;
}

const Setting *settingNamed(const QString &name)
{
    const auto found = std::find_if(allSettings().cbegin(), allSettings().cend(), [&name](const Setting &setting) {
        return setting.name.compare(name.trimmed(), Qt::CaseInsensitive) == 0;
    });
    return found == allSettings().cend() ? nullptr : &*found;
}

bool isOfNetwork(const Setting &setting)
{
    return setting.kind == Kind::Host || setting.kind == Kind::NetworkMask || setting.kind == Kind::Gateway;
}

QString valueOf(const QList<quint16> &image, const Setting &setting)
{
    const Words words(0, image);
    Register entry;
    entry.address = setting.address;
    entry.size = setting.size;
    switch (setting.kind) {
    case Kind::Text: return words.text(entry);
    case Kind::Host:
    case Kind::NetworkMask:
    case Kind::Gateway: return words.ipAddress(entry);
    case Kind::Real: return realText(words.real(entry));
    case Kind::Frequency: return QString::number(words.doubleWord(entry) / 10.0, 'f', 1);
    case Kind::ChannelMask:
    case Kind::Milliseconds:
    case Kind::MeasurementType:
    case Kind::Switch: break;
    }
    return QString::number(words.word(entry));
}

QList<SettingDifference> differences(const QList<quint16> &before, const QList<quint16> &after)
{
    QList<SettingDifference> found;
    for (const Setting &setting : allSettings()) {
        if (!isSame(setting, before, after)) {
            found.append(differenceOf(setting, before, after));
        }
    }
    appendUndescribed(found, before, after);
    return found;
}

QList<SettingPiece> piecesToWrite(const QList<quint16> &there, const QList<quint16> &wanted)
{
    constexpr qsizetype most = 120; // function 16 takes 123
    const std::vector<bool> marks = touched(there, wanted);
    QList<SettingPiece> pieces;
    for (qsizetype i = 0; i < wanted.size(); ++i) {
        if (!marks[static_cast<std::size_t>(i)]) {
            continue;
        }
        const bool goesOn = !pieces.isEmpty() && pieces.constLast().values.size() < most
            && pieces.constLast().offset + pieces.constLast().values.size() == i;
        if (!goesOn) {
            pieces.append(SettingPiece{static_cast<quint16>(i), {}});
        }
        pieces.last().values.append(wanted.at(i));
    }
    return pieces;
}

} // namespace gorizont::lvims
