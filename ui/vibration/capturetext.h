#pragma once

#include "core/values/linestatus.h"
#include "core/values/vibration.h"
#include "ui/vibration/vibrationanalysis.h"
#include "ui/vibration/vibrationcapture.h"

namespace gorizont {

/// Sentences of the page <Вибрация>. Pure.
namespace capturetext {

QString kind(lvims::Capture::Kind kind); ///< `waveform`, `spectrum up to 200 Hz`
QString progress(lvims::Capture::Kind kind, qsizetype done, qsizetype total);

/// Why a capture failed, and what to do.
QString failure(const CaptureFailure &failure);
/// Why a line cannot be used; empty: it can.
QString objection(LineState state);
/// What is wrong with a channel; empty: nothing.
QString channel(const VibrationChannel &channel);

/// `12.34`, with as many digits as deserve to be read.
QString number(double value);
/// `own: 50.000 Hz (120.1); …`, empty without peaks.
QString peaks(const QString &name, const QList<SpectrumPeak> &peaks);

} // namespace capturetext

} // namespace gorizont
