#pragma once

#include "core/devices/lvims/lvimslink.h"

namespace gorizont::lvims {

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

/// Makes a module keep a waveform or a spectrum and fetches it, step by step: between any two the line is free for others. What
/// another client does to the selection is noticed and the transfer begun anew. Thread of the line.
class Capture
{
public:
    enum class Kind : quint8 { Waveform, Spectrum5000, Spectrum200 };

    Capture(Link link, Kind kind, int channel);

    /// One exchange, up to three times when its answer is lost. Timeout: the module does not answer, or keeps no waveform within
    /// twice its length and a second. Refused: it answers with exceptions; BadReply: another client disturbed every
    /// attempt, or what came makes no sense. After a fault the capture is over.
    Result<void> step(Line &line, SteadyTime now);

    bool isDone() const { return m_phase == Phase::Done; }
    std::chrono::milliseconds pause() const; ///< before the next step
    int disturbances() const { return m_disturbances; } ///< attempts that another client, or an exception, has spoilt
    bool isLate() const { return m_isLate; } ///< it timed out because the module answers and keeps no waveform
    int exception() const { return m_link.exception(); } ///< of Modbus, in the last step; 0: none

    /// Both are whole when isDone().
    const CaptureInformation &information() const { return m_information; }
    const QList<qint32> &codes() const { return m_codes; }

    static constexpr int mostAttempts = 3; ///< of a transfer
    static constexpr int samplesOfAnEcho = 60; ///< a request

private:
    enum class Phase : quint8 { Look, Trigger, Wait, Inform, Fetch, Done };

    bool isWaveform() const { return m_kind == Kind::Waveform; }
    int type() const { return m_kind == Kind::Spectrum200 ? 1 : 0; }
    quint16 selector() const { return static_cast<quint16>(isWaveform() ? m_id : type()); }
    QList<quint16> selection(quint32 offset) const;
    Result<void> look(Line &line);
    Result<void> trigger(Line &line, SteadyTime now);
    Result<void> wait(Line &line, SteadyTime now);
    Result<void> inform(Line &line);
    Result<void> fetch(Line &line);
    Result<void> again(Fault reason);
    Result<Words> select(Line &line, quint32 offset, const Range &range);

    Link m_link;
    Kind m_kind;
    int m_channel;
    Phase m_phase = Phase::Look;
    int m_before = 0; ///< ST_WF_UP_ID before the command
    int m_id = 0; ///< ST_WF_UP_ID of what is fetched
    bool m_wasBusy = false; ///< ST_WF_RDY_CNT was 0 after the command
    std::chrono::milliseconds m_length{0}; ///< WF_ACQ_TIME
    SteadyTime m_deadline{};
    int m_disturbances = 0;
    bool m_isLate = false;
    CaptureInformation m_information;
    QList<qint32> m_codes;
};

} // namespace gorizont::lvims
