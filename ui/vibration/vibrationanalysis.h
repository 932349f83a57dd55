#pragma once

#include "core/analysis/spectrumpeaks.h"
#include "core/devices/lvims/lvimscapture.h"

#include <QFuture>

namespace gorizont {

/// A spectrum and its highest peaks.
struct VibrationSpectrum
{
    Spectrum lines; ///< empty: there is none
    QList<SpectrumPeak> peaks; ///< the highest first
};

/// Of a waveform, computed here: through a window of Hann over the whole of it. Takes its time.
VibrationSpectrum ownSpectrum(
    const lvims::CaptureInformation &information, const QList<qint32> &codes, lvims::CodeUnit unit);

/// The same on a thread of the global pool; nothing is computed for a future that was cancelled before its turn.
QFuture<VibrationSpectrum> ownSpectrumLater(
    const lvims::CaptureInformation &information, const QList<qint32> &codes, lvims::CodeUnit unit);

/// What the module made itself.
VibrationSpectrum spectrumOfModule(
    const lvims::CaptureInformation &information, const QList<qint32> &codes, lvims::CodeUnit unit);

} // namespace gorizont
