#pragma once

#include "core/values/journalentry.h"
#include "core/values/linestatus.h"
#include "core/values/reading.h"
#include "core/values/sampleblock.h"
#include "core/values/vibrationcapture.h"

#include <QHash>
#include <QMutex>

namespace gorizont {

/// What other threads left for the writer of the history. A disk that hangs for an hour must not eat the memory: of
/// readings and lines only the last of each is kept, of samples, events and captures the newest up to a limit. Thread-safe.
class HistoryInbox
{
public:
    static constexpr qsizetype mostEntries = 10000;
    static constexpr qsizetype mostCodes = 4'000'000; ///< of all captures that wait; one waits however long it is

    struct Contents
    {
        QHash<int, Reading> readings; ///< N → the last one
        QHash<int, LineStatus> lines; ///< port → the last one
        QHash<int, QList<SampleBlock>> blocks; ///< N → in the order of arrival; what follows a dropped one says so
        QList<JournalEntry> entries;
        QList<SignalCapture> captures; ///< in the order of arrival
        qsizetype samplesDropped = 0;
        qsizetype entriesDropped = 0;
        qsizetype capturesDropped = 0;
    };

    /// How much waits.
    struct Backlog
    {
        qsizetype samples = 0;
        qsizetype entries = 0;
    };

    /// \a mostSamples: of one sensor.
    explicit HistoryInbox(qsizetype mostSamples)
        : m_mostSamples(mostSamples)
    {
    }

    void put(const Readings &batch);
    void put(const LineStatus &status);

    /// True: the writer has to be woken, nobody did since it last took the contents.
    [[nodiscard]] bool put(const SampleBlock &block);
    [[nodiscard]] bool put(const JournalEntry &entry);
    [[nodiscard]] bool put(const SignalCapture &captured);

    /// Everything; the inbox is empty then.
    Contents take();
    Backlog backlog() const;

private:
    void dropOldSamples(QList<SampleBlock> &blocks, qsizetype &kept);

    const qsizetype m_mostSamples;
    mutable QMutex m_mutex;
    Contents m_contents;
    QHash<int, qsizetype> m_samples; ///< N → how many samples wait
    qsizetype m_codes = 0; ///< of the captures that wait
    bool m_isWriterWoken = false;
};

} // namespace gorizont
