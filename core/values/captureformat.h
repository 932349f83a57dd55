#pragma once

#include "core/values/vibrationcapture.h"

#include <QByteArray>

/// Waveforms and spectra as files. Pure; the same in every locale.
namespace gorizont {

/// `time,code,value`: s since the first sample, ADC code, physical quantity. Commas, points, LF.
QByteArray waveformCsv(const CaptureInformation &information, const QList<qint32> &codes);

/// `frequency,amplitude`: Hz, physical quantity. Commas, points, LF.
QByteArray spectrumCsv(const CaptureInformation &information, const QList<qint32> &codes);

/// One channel of 32-bit floats, the largest modulus of the physical quantity being 1.
QByteArray waveformWav(const CaptureInformation &information, const QList<qint32> &codes);

} // namespace gorizont
