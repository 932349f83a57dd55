#pragma once

#include "core/devices/lvims/lvimslink.h"
#include "core/values/vibrationcapture.h"

namespace gorizont::lvims {

using gorizont::CaptureInformation;
using gorizont::CodeUnit;
using gorizont::SpectrumBin;
using gorizont::spectrumOf;

/// Makes a module keep a waveform or a spectrum and fetches it, step by step: between any two the line is free for others. What
/// another client does to the selection is noticed and the transfer begun anew. Thread of the line.
class Capture
{
public:
    using Kind = CaptureKind;

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
