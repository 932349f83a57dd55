#pragma once

#include "core/values/result.h"

/// The host retries, delivery is not guaranteed: how often a service asks for one thing.
namespace gorizont {

constexpr int mostAttempts = 3;

/// Somebody answered, but not clearly.
inline bool isGarbled(Fault fault)
{
    return fault == Fault::Checksum || fault == Fault::BadReply;
}

/// A lost or damaged answer may be better the next time; a refusal stays one, and a lost line too.
inline bool isWorthAnother(Fault fault)
{
    return fault == Fault::Timeout || isGarbled(fault);
}

/// The first good result of \a attempt, else its last one.
template <typename Attempt> auto withAttempts(Attempt attempt)
{
    auto result = attempt();
    for (int i = 1; i < mostAttempts && !result && isWorthAnother(result.fault()); ++i) {
        result = attempt();
    }
    return result;
}

/// The same for a question to somebody who may not be there: silence is an answer.
template <typename Attempt> auto withAttemptsUnlessSilent(Attempt attempt)
{
    auto result = attempt();
    for (int i = 1; i < mostAttempts && !result && isGarbled(result.fault()); ++i) {
        result = attempt();
    }
    return result;
}

/// Whether somebody answers who was asked for by \a probe several times. True: somebody does, however clearly.
template <typename Probe> Result<bool> isSomebodyThere(Probe probe)
{
    Result<void> heard = Fault::Timeout;
    for (int i = 0; i < mostAttempts && !heard && heard.fault() == Fault::Timeout; ++i) {
        heard = probe();
    }
    if (!heard && isLineFault(heard.fault())) {
        return heard.fault();
    }
    return heard || heard.fault() != Fault::Timeout;
}

} // namespace gorizont
