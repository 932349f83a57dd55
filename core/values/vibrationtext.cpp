#include "core/values/vibrationtext.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace gorizont::vibrationtext {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(LVims)
};

/// `0, 2`: the channels in use that are in \a state.
QString channelsIn(const Vibration &vibration, ChannelState state)
{
    QStringList channels;
    for (const VibrationChannel &channel : vibration.channels) {
        if (channel.isEnabled && channel.state == state) {
            channels.append(QString::number(channel.channel));
        }
    }
    return channels.join(QStringLiteral(", "));
}

} // namespace

QString stateText(ChannelState state)
{
    switch (state) {
    case ChannelState::Good: return Text::tr("good");
    case ChannelState::ShortCircuit: return Text::tr("the line of the sensor is shorted");
    case ChannelState::Break: return Text::tr("the line of the sensor is broken");
    case ChannelState::NoData: return Text::tr("no data");
    }
    return Text::tr("state %1").arg(static_cast<int>(state));
}

QString stateText(const VibrationChannel &channel)
{
    return channel.isEnabled ? stateText(channel.state) : Text::tr("off");
}

QString raised(const VibrationMeasurement &measurement)
{
    QStringList words;
    const auto add = [&words](const std::optional<bool> &flag, const QString &word) {
        if (flag.value_or(false)) {
            words.append(word);
        }
    };
    add(measurement.fault, Text::tr("fault"));
    add(measurement.warning, Text::tr("warning"));
    add(measurement.stop, Text::tr("stop"));
    add(measurement.isBaselineExceeded, Text::tr("far from its usual value"));
    return words.join(QStringLiteral(", "));
}

QString unknown(const VibrationMeasurement &measurement)
{
    QStringList words;
    const auto add = [&words](const std::optional<bool> &flag, const QString &word) {
        if (!flag) {
            words.append(word + u'?');
        }
    };
    add(measurement.fault, Text::tr("fault"));
    add(measurement.warning, Text::tr("warning"));
    add(measurement.stop, Text::tr("stop"));
    return words.join(QStringLiteral(", "));
}

QString lineFaults(const Vibration &vibration)
{
    QStringList parts;
    if (const QString shorted = channelsIn(vibration, ChannelState::ShortCircuit); !shorted.isEmpty()) {
        parts.append(Text::tr("Line of the sensor shorted: channel %1").arg(shorted));
    }
    if (const QString broken = channelsIn(vibration, ChannelState::Break); !broken.isEmpty()) {
        parts.append(
            parts.isEmpty() ? Text::tr("Line of the sensor broken: channel %1").arg(broken)
                            : Text::tr("line of the sensor broken: channel %1").arg(broken));
    }
    return parts.join(QStringLiteral("; "));
}

QString number(double value)
{
    const double modulus = std::abs(value);
    const int decimals = modulus < 100 ? 4 : modulus < 1000 ? 3 : modulus < 10000 ? 2 : 1;
    return QString::number(value, 'f', decimals);
}

} // namespace gorizont::vibrationtext
