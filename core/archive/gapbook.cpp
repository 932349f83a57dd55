#include "core/archive/gapbook.h"

#include "core/archive/gapmath.h"

#include <algorithm>

namespace gorizont {

bool GapBook::lay(const Gap &gap)
{
    const auto parts = m_store.gapsBeginning(gap.number, {gap.from, gap.to.value_or(UtcTime::max())});
    if (!parts) {
        return false;
    }
    const auto isFilled = [](const Gap &part) { return !part.filledFrom.isEmpty() && part.to; };
    if (std::none_of(parts->begin(), parts->end(), isFilled)) {
        return m_store.putGap(gap);
    }
    Gap rest = gap;
    for (const Gap &part : *parts) {
        if (!isFilled(part)) {
            if (!m_store.removeGap(part.number, part.from)) {
                return false;
            }
            continue;
        }
        rest.to = part.from;
        if (rest.from < part.from && !m_store.putGap(rest)) {
            return false;
        }
        rest.from = std::max(rest.from, *part.to);
    }
    rest.to = gap.to;
    return (gap.to && rest.from >= *gap.to) || m_store.putGap(rest);
}

bool GapBook::layBefore(int number, UtcTime from, UtcTime until)
{
    const auto first = m_store.firstGap(number);
    if (!first && m_store.database().fault() != ArchiveFault::None) {
        return false;
    }
    const UtcTime to = std::min(until, first.value_or(until));
    return from >= to || m_store.putGap({number, from, to, GapReason::ProgramStopped, {}});
}

std::optional<QList<GapBook::Unknown>> GapBook::unknown(int number, const TimeSpan &span, UtcTime now)
{
    const auto gaps = m_store.gaps(number, span);
    if (!gaps) {
        return {};
    }
    QList<Unknown> all;
    UtcTime filledUntil = UtcTime::min();
    for (const Gap &gap : *gaps) {
        const UtcTime to = gap.to.value_or(now);
        if (!gap.filledFrom.isEmpty()) {
            filledUntil = to;
        } else if (!all.isEmpty() && all.last().span.to >= gap.from) {
            all.last().span.to = std::max(all.last().span.to, to);
            all.last().goesOn = all.last().goesOn || !gap.to;
        } else if (gap.from < to) {
            all.append({{gap.from, to}, filledUntil == gap.from, !gap.to});
        }
    }
    return all;
}

bool GapBook::fill(int number, const QList<TimeSpan> &parts, const QString &source)
{
    if (parts.isEmpty()) {
        return true;
    }
    const auto before = m_store.gaps(number, {parts.first().from, parts.last().to});
    if (!before) {
        return false;
    }
    QList<Gap> after = *before;
    for (const TimeSpan &part : parts) {
        after = filled(after, part, source);
    }
    after = joined(after);
    for (const Gap &gap : *before) {
        if (!after.contains(gap) && !m_store.removeGap(number, gap.from)) {
            return false;
        }
    }
    for (const Gap &gap : std::as_const(after)) {
        if (!before->contains(gap) && !m_store.putGap(gap)) {
            return false;
        }
    }
    return true;
}

} // namespace gorizont
