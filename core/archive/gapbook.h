#pragma once

#include "core/archive/archivestore.h"

namespace gorizont {

/// The gaps of the archive where the ledger, which follows what happens now, and what fills gaps afterwards meet: a gap
/// may go on, and change, long after a part of it was filled. Within a transaction; false: the store failed. Archive
/// thread.
class GapBook
{
public:
    explicit GapBook(ArchiveStore &store)
        : m_store(store)
    {
    }

    /// As the ledger tells it; what is filled in it stays filled.
    bool lay(const Gap &gap);

    /// A sensor of which nothing was known before \a until is known from \a from on.
    bool layBefore(int number, UtcTime from, UtcTime until);

    /// Neighbouring gaps, none of them filled.
    struct Unknown
    {
        TimeSpan span;
        bool followsFilled = false; ///< otherwise it begins with a valid value
        bool goesOn = false; ///< otherwise it ends with one
    };
    /// What \a span touches of them. A gap that goes on does so until \a now.
    std::optional<QList<Unknown>> unknown(int number, const TimeSpan &span, UtcTime now);

    /// \a parts of gaps are filled from \a source; ascending.
    bool fill(int number, const QList<TimeSpan> &parts, const QString &source);

private:
    ArchiveStore &m_store;
};

} // namespace gorizont
