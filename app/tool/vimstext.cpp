#include "app/tool/vimstext.h"

#include "app/tool/output.h"
#include "app/tool/session.h"
#include "app/tool/text.h"
#include "core/values/vibrationkinds.h"
#include "core/values/vibrationtext.h"

#include <algorithm>

namespace gorizont::tool {

using Qt::Literals::StringLiterals::operator""_s;

namespace {

using namespace lvims;

constexpr int decimals = 4;

QString numberText(const std::optional<double> &value, int places)
{
    return value ? fixed(*value, places) : none;
}

QString lineOf(const VibrationMeasurement &measurement)
{
    QStringList parts{
        u"  %1: %2 %3"_s.arg(measurement.index).arg(measurement.type).arg(measurementName(measurement.type)),
        numberText(measurement.value, decimals) + u' ' + MeasurementUnits().of(measurement.type)};
    if (const QString words = vibrationtext::raised(measurement); !words.isEmpty()) {
        parts.append(words);
    }
    return parts.join(u"; "_s);
}

SpectrumBin highestOf(const Capture &capture)
{
    const auto bins = spectrumOf(capture.information(), capture.codes());
    const auto highest = std::max_element(bins.begin(), bins.end(), [](const SpectrumBin &a, const SpectrumBin &b) {
        return a.amplitude < b.amplitude;
    });
    return highest == bins.end() ? SpectrumBin() : *highest;
}

} // namespace

QString textOf(const Identity &identity)
{
    const QString mode = identity.mode == bootLoaderMode ? Text::tr("boot loader")
        : identity.mode == workingMode                   ? Text::tr("at work")
                                                         : QString::number(identity.mode);
    return Text::tr("%1, serial number %2, program %3, board %4, %5")
        .arg(identity.name, identity.serial, identity.firmware, identity.board, mode);
}

QString textOf(const Vibration &vibration)
{
    QStringList lines;
    for (const VibrationChannel &channel : vibration.channels) {
        lines.append(Text::tr("channel %1: %2").arg(channel.channel).arg(vibrationtext::stateText(channel)));
        for (const VibrationMeasurement &measurement : channel.measurements) {
            lines.append(lineOf(measurement));
        }
    }
    for (const Relay &relay : vibration.relays) {
        if (relay.isEnabled || relay.isLogical || relay.isPhysical || relay.hasError) {
            lines.append(Text::tr("relay %1: logical %2, physical %3, error %4, enabled %5")
                             .arg(relay.index)
                             .arg(int(relay.isLogical))
                             .arg(int(relay.isPhysical))
                             .arg(int(relay.hasError))
                             .arg(int(relay.isEnabled)));
        }
    }
    return lines.join(u'\n');
}

QString textOf(const Capture &capture, Capture::Kind kind)
{
    const CaptureInformation &information = capture.information();
    if (kind == Capture::Kind::Waveform) {
        return Text::tr("channel %1: %2 samples, %3 Hz")
            .arg(information.channel)
            .arg(information.size)
            .arg(fixed(information.rate, 1));
    }
    const SpectrumBin highest = highestOf(capture);
    return Text::tr("channel %1: %2 bins, highest %3 at %4 Hz")
        .arg(information.channel)
        .arg(information.size / 2)
        .arg(fixed(highest.amplitude, decimals), fixed(highest.frequency, 3));
}

QString textOf(const SettingErrors &errors, Fault fault)
{
    return errors == SettingErrors(0, 0)
        ? faultText(fault)
        : Text::tr("the module refuses the settings (LAST_WR_ERROR %1, LAST_CHECK_SETTINGS_ERR %2); it keeps those it "
                   "had")
              .arg(errors.first)
              .arg(errors.second);
}

void insertCapture(QJsonObject &object, const Capture &capture, Capture::Kind kind)
{
    const CaptureInformation &information = capture.information();
    object.insert(u"channel"_s, information.channel);
    object.insert(u"rate"_s, information.rate);
    object.insert(u"disturbances"_s, capture.disturbances());
    if (kind == Capture::Kind::Waveform) {
        object.insert(u"id"_s, information.id);
        object.insert(u"samples"_s, qint64(information.size));
        return;
    }
    const SpectrumBin highest = highestOf(capture);
    object.insert(u"spectrum"_s, kind == Capture::Kind::Spectrum200 ? 200 : 5000);
    object.insert(u"bins"_s, qint64(information.size / 2));
    object.insert(u"peakFrequency"_s, highest.frequency);
    object.insert(u"peakAmplitude"_s, highest.amplitude);
}

} // namespace gorizont::tool
