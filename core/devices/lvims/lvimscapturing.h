#pragma once

#include "core/devices/lvims/lvimscapture.h"
#include "core/values/captureplan.h"

#include <map>
#include <optional>

namespace gorizont::lvims {

/// Continuous capture: every few seconds the wanted signals of the wanted channels, one after another and one exchange a step, so
/// that the line is free between any two. A round that would begin while the last one is still being fetched is left out. Thread of
/// the line.
class Capturing
{
public:
    Capturing(const CapturePlan &plan, const Address &address, const Timing &timing);

    /// What was being fetched is given up; the next round begins when it is due.
    void abandon();

    /// A step can be taken at \a now.
    bool hasStep(SteadyTime now) const;
    /// When hasStep() becomes true; empty: never.
    std::optional<SteadyTime> nextStepAt() const;

    /// Something that has come, or has failed, with the last step.
    struct Outcome
    {
        CaptureKind kind = CaptureKind::Waveform;
        int channel = 0;
        std::optional<SignalCapture> signal; ///< its number and time are not set
        std::optional<Fault> fault; ///< why there is none
        bool isNews = false; ///< the last one of this kind and channel went otherwise; the first that is good is none
    };

    /// One exchange. \a enabledMask: bit I: the module uses channel I. A fault is one of the line; what the module does wrong
    /// is an outcome.
    Result<std::optional<Outcome>> step(Line &line, SteadyTime now, quint16 enabledMask);

private:
    using Job = std::pair<int, CaptureKind>; ///< channel, kind

    void beginRound(SteadyTime now, quint16 enabledMask);
    void beginNext();
    Outcome outcomeOf(const Job &job, std::optional<Fault> fault);

    const CapturePlan m_plan;
    const Address m_address;
    const Timing m_timing;
    quint16 m_transaction; ///< where the next capture begins to count
    std::optional<SteadyTime> m_roundAt; ///< the next one; empty: at once
    QList<Job> m_jobs; ///< of this round; the first one is being fetched
    std::optional<Capture> m_capture; ///< of the first job
    SteadyTime m_stepAt{}; ///< not before
    std::map<Job, std::optional<Fault>> m_last; ///< how the last one ended
};

} // namespace gorizont::lvims
