#include "ui/vibration/capturetext.h"

#include <QCoreApplication>

#include <cmath>

namespace gorizont::capturetext {

namespace {

class CaptureText
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::CaptureText)
};

using Kind = lvims::Capture::Kind;

} // namespace

QString kind(Kind kind)
{
    switch (kind) {
    case Kind::Waveform: return CaptureText::tr("waveform");
    case Kind::Spectrum5000: return CaptureText::tr("spectrum up to 5000 Hz");
    case Kind::Spectrum200: return CaptureText::tr("spectrum up to 200 Hz");
    }
    return {};
}

QString progress(Kind kind, qsizetype done, qsizetype total)
{
    return total == 0 ? CaptureText::tr("Waiting for the %1…").arg(capturetext::kind(kind))
                      : CaptureText::tr("Fetching the %1: %2 of %3")
                            .arg(capturetext::kind(kind), QString::number(done), QString::number(total));
}

QString failure(const CaptureFailure &failure)
{
    const QString what = kind(failure.kind);
    if (failure.isEmpty) {
        return CaptureText::tr(
                   "There is no data on this channel (%1). Look whether the channel measures and its sensor is "
                   "connected.")
            .arg(what);
    }
    if (failure.isLate) {
        return CaptureText::tr("The module answers and does not finish the %1. Try again, or restart the module.")
            .arg(what);
    }
    switch (failure.fault) {
    case Fault::Timeout:
        return CaptureText::tr("The module does not answer (%1). Check its power and its network cable.").arg(what);
    case Fault::Refused:
        return CaptureText::tr("The module refuses the %1 (exception %2 of Modbus). The channel may have no data, or "
                               "another program let the module keep a new one: try again.")
            .arg(what)
            .arg(failure.exception);
    case Fault::BadReply:
        return failure.disturbances >= lvims::Capture::mostAttempts
            ? CaptureText::tr(
                  "Another client has changed the selection of the module %1 times while the %2 was read. Stop "
                  "its reading, or try again.")
                  .arg(QString::number(failure.disturbances), what)
            : CaptureText::tr("What the module says of the %1 makes no sense. Try again.").arg(what);
    case Fault::Checksum: return CaptureText::tr("The answers are damaged (%1). Try again.").arg(what);
    case Fault::Closed:
        return CaptureText::tr("The port is gone or in service (%1). Capture again when it is back.").arg(what);
    case Fault::Cancelled: break;
    }
    return CaptureText::tr("Broken off (%1).").arg(what);
}

QString objection(LineState state)
{
    switch (state) {
    case LineState::Open: return {};
    case LineState::Service: return CaptureText::tr("The port is in service; nothing is captured until that ends.");
    default: break;
    }
    return CaptureText::tr("The module is away: its port is not open. Check its power and its network cable.");
}

QString channel(const VibrationChannel &channel)
{
    if (!channel.isEnabled) {
        return CaptureText::tr("Channel %1 is switched off in the settings of the module.").arg(channel.channel);
    }
    switch (channel.state) {
    case ChannelState::Good: return {};
    case ChannelState::ShortCircuit:
        return CaptureText::tr("Channel %1: the line of the sensor is shorted. Check its cable.").arg(channel.channel);
    case ChannelState::Break:
        return CaptureText::tr("Channel %1: the line of the sensor is broken. Check its cable.").arg(channel.channel);
    case ChannelState::NoData: return CaptureText::tr("Channel %1 has no data yet.").arg(channel.channel);
    }
    return CaptureText::tr("Channel %1 is in state %2.").arg(channel.channel).arg(static_cast<int>(channel.state));
}

QString number(double value)
{
    constexpr int digits = 5;
    if (value == 0) {
        return QStringLiteral("0");
    }
    const int before = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
    return before > digits + 2 || before < -digits
        ? QString::number(value, 'g', digits)
        : QString::number(value, 'f', std::max(0, digits - std::max(before, 0)));
}

QString peaks(const QString &name, const QList<SpectrumPeak> &peaks)
{
    QStringList texts;
    for (const SpectrumPeak &peak : peaks) {
        texts += CaptureText::tr("%1 Hz (%2)").arg(QString::number(peak.frequency, 'f', 3), number(peak.amplitude));
    }
    return texts.isEmpty() ? QString() : CaptureText::tr("%1: %2").arg(name, texts.join(QStringLiteral(", ")));
}

} // namespace gorizont::capturetext
