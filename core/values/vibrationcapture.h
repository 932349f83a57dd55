#pragma once

#include "core/values/timing.h"
#include "core/values/vibration.h"

#include <QList>
#include <QMetaType>

namespace gorizont {

enum class CaptureKind : quint8 { Waveform, Spectrum5000, Spectrum200 };

/// What ADC codes are told in.
enum class CodeUnit : quint8 { Physical, Volts };

/// What a module says of a waveform or a spectrum that it keeps.
struct CaptureInformation
{
    int channel = 0; ///< 0…3
    int id = 0; ///< of the waveform; of a spectrum its type, 0 up to 5000 Hz, 1 up to 200 Hz
    quint32 size = 0; ///< samples; of a spectrum real and imaginary numbers
    double rate = 0; ///< Hz; of a spectrum that of the samples it was made of
    double voltsK = 0; ///< volts = voltsK · code + voltsB
    double voltsB = 0;
    double physicalK = 0; ///< the physical quantity = physicalK · code + physicalB
    double physicalB = 0;
    double windowSum = 0; ///< of a spectrum: of the coefficients of its window
    double windowSum2 = 0; ///< and of their squares
    std::optional<VibrationChannel> state; ///< of the channel when the waveform was kept

    double volts(qint32 code) const { return voltsK * code + voltsB; }
    double physical(qint32 code) const { return physicalK * code + physicalB; }
    /// What a code is multiplied with.
    double scale(CodeUnit unit) const { return unit == CodeUnit::Volts ? voltsK : physicalK; }
    double value(qint32 code, CodeUnit unit) const { return unit == CodeUnit::Volts ? volts(code) : physical(code); }
    double time(qsizetype sample) const { return static_cast<double>(sample) / rate; } ///< s since the first one
    bool operator==(const CaptureInformation &) const = default;
};

struct SpectrumBin
{
    double frequency = 0; ///< Hz
    double amplitude = 0; ///< of a tone of this frequency
    double density = 0; ///< of power, the square of the unit a Hz; 0: the module does not say what its window does
    bool operator==(const SpectrumBin &) const = default;
};

/// A spectrum in physical units or volts (spec/l-vims.md, 5). \a codes: real and imaginary in turns.
QList<SpectrumBin> spectrumOf(
    const CaptureInformation &information, const QList<qint32> &codes, CodeUnit unit = CodeUnit::Physical);

/// A waveform or a spectrum that a driver has fetched whole. Copies share the codes.
struct SignalCapture
{
    int number = 0; ///< N, the sensor
    CaptureKind kind = CaptureKind::Waveform;
    UtcTime time; ///< when it was whole
    CaptureInformation information;
    QList<qint32> codes;
    bool operator==(const SignalCapture &) const = default;
};

} // namespace gorizont

Q_DECLARE_METATYPE(gorizont::SignalCapture)
