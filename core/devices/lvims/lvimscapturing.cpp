#include "core/devices/lvims/lvimscapturing.h"

namespace gorizont::lvims {

namespace {

/// Every capture counts its requests from another number, between those of polling and those of service, so that a late answer to
/// the one before is none to it.
constexpr quint16 firstTransaction = 0x4000;
constexpr quint16 transactionsApart = 0x0400;
constexpr quint16 endOfTransactions = 0x8000;

} // namespace

Capturing::Capturing(const CapturePlan &plan, const Address &address, const Timing &timing)
    : m_plan(plan)
    , m_address(address)
    , m_timing(timing)
    , m_transaction(firstTransaction)
{
}

void Capturing::abandon()
{
    m_jobs.clear();
    m_capture.reset();
}

bool Capturing::hasStep(SteadyTime now) const
{
    const auto at = nextStepAt();
    return at && *at <= now;
}

std::optional<SteadyTime> Capturing::nextStepAt() const
{
    if (!m_plan.isOn()) {
        return std::nullopt;
    }
    return m_capture ? m_stepAt : m_roundAt.value_or(SteadyTime());
}

Result<std::optional<Capturing::Outcome>> Capturing::step(Line &line, SteadyTime now, quint16 enabledMask)
{
    if (!m_capture) {
        beginRound(now, enabledMask);
        if (!m_capture) {
            return std::optional<Outcome>();
        }
    }
    const auto done = m_capture->step(line, now);
    m_stepAt = now + m_capture->pause();
    if (!done && isLineFault(done.fault())) {
        abandon();
        return done.fault();
    }
    if (done && !m_capture->isDone()) {
        return std::optional<Outcome>();
    }
    const auto outcome = outcomeOf(m_jobs.first(), done ? std::nullopt : std::optional(done.fault()));
    m_jobs.removeFirst();
    beginNext();
    return std::optional(outcome);
}

/// Rounds begin on a grid; those that would have begun meanwhile are left out.
void Capturing::beginRound(SteadyTime now, quint16 enabledMask)
{
    const SteadyTime planned = m_roundAt.value_or(now);
    m_roundAt = planned + ((now - planned) / m_plan.every + 1) * m_plan.every;
    for (const int channel : m_plan.channels) {
        for (const CaptureKind kind : m_plan.kinds) {
            if (enabledMask >> channel & 1) {
                m_jobs.append({channel, kind});
            }
        }
    }
    beginNext();
}

void Capturing::beginNext()
{
    m_capture.reset();
    if (m_jobs.isEmpty()) {
        return;
    }
    const auto &[channel, kind] = m_jobs.first();
    m_capture.emplace(Link(m_address, m_timing, m_transaction), kind, channel);
    m_transaction = static_cast<quint16>(m_transaction + transactionsApart);
    if (m_transaction >= endOfTransactions) {
        m_transaction = firstTransaction;
    }
}

Capturing::Outcome Capturing::outcomeOf(const Job &job, std::optional<Fault> fault)
{
    Outcome outcome;
    outcome.channel = job.first;
    outcome.kind = job.second;
    outcome.fault = fault;
    const auto last = m_last.find(job);
    outcome.isNews = last == m_last.end() ? fault.has_value() : last->second != fault;
    m_last[job] = fault;
    if (!fault) {
        SignalCapture signal;
        signal.kind = job.second;
        signal.information = m_capture->information();
        signal.codes = m_capture->codes();
        outcome.signal = signal;
    }
    return outcome;
}

} // namespace gorizont::lvims
