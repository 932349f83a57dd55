#pragma once

#include "core/values/result.h"

#include <QList>

#include <array>

namespace gorizont {

/// A scan of the addresses 1…255 of a line, step by step: which one comes next and what was found. Pure; who probes is
/// no matter.
class AddressScan
{
public:
    static constexpr int first = 1;
    static constexpr int last = 255;

    /// Scans \a from … \a to only; such a scan is never complete.
    explicit AddressScan(int from = first, int to = last);

    /// The address to probe now. 0: the scan is over.
    int next() const;
    /// What the probe of next() brought. Timeout: nobody is there. Checksum, BadReply, Refused: somebody is, but what came
    /// is not clear; two sensors with one address look like that. Closed, Cancelled: nothing is known, it has to be probed
    /// again.
    void record(const Result<void> &probed);

    int probed() const { return m_probed; } ///< how many addresses were probed
    int count() const { return m_to - m_from + 1; } ///< how many there are to probe
    /// Every address 1…255 was probed, without a stop: only then is it known which ones are free.
    bool isComplete() const { return m_probed == last; }

    QList<int> found() const { return addresses(Finding::Sensor); } ///< ascending
    QList<int> unclear() const { return addresses(Finding::Unclear); } ///< ascending; taken, but not to be spoken with
    /// Addresses that nobody answered at. Empty as long as the scan is not complete.
    QList<int> free() const { return isComplete() ? addresses(Finding::Nobody) : QList<int>(); }

private:
    enum class Finding : quint8 { Unknown, Nobody, Sensor, Unclear };

    QList<int> addresses(Finding finding) const;

    int m_from;
    int m_to;
    int m_probed = 0;
    std::array<Finding, last + 1> m_findings{}; ///< index: address
};

} // namespace gorizont
