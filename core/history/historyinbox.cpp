#include "core/history/historyinbox.h"

#include <QMutexLocker>

#include <numeric>
#include <utility>

namespace gorizont {

void HistoryInbox::put(const Readings &batch)
{
    const QMutexLocker lock(&m_mutex);
    for (const Reading &reading : batch) {
        m_contents.readings.insert(reading.number, reading);
    }
}

void HistoryInbox::put(const LineStatus &status)
{
    const QMutexLocker lock(&m_mutex);
    m_contents.lines.insert(status.port, status);
}

bool HistoryInbox::put(const SampleBlock &block)
{
    const QMutexLocker lock(&m_mutex);
    QList<SampleBlock> &blocks = m_contents.blocks[block.number];
    qsizetype &waiting = m_samples[block.number];
    blocks.append(block);
    waiting += block.x.size();
    dropOldSamples(blocks, waiting);
    return !std::exchange(m_isWriterWoken, true);
}

bool HistoryInbox::put(const JournalEntry &entry)
{
    const QMutexLocker lock(&m_mutex);
    m_contents.entries.append(entry);
    if (m_contents.entries.size() > mostEntries) {
        m_contents.entries.removeFirst();
        ++m_contents.entriesDropped;
    }
    return !std::exchange(m_isWriterWoken, true);
}

bool HistoryInbox::put(const SignalCapture &captured)
{
    const QMutexLocker lock(&m_mutex);
    QList<SignalCapture> &captures = m_contents.captures;
    captures.append(captured);
    m_codes += captured.codes.size();
    while (m_codes > mostCodes && captures.size() > 1) {
        m_codes -= captures.takeFirst().codes.size();
        ++m_contents.capturesDropped;
    }
    return !std::exchange(m_isWriterWoken, true);
}

HistoryInbox::Contents HistoryInbox::take()
{
    const QMutexLocker lock(&m_mutex);
    m_isWriterWoken = false;
    m_codes = 0;
    m_samples.clear();
    return std::exchange(m_contents, {});
}

HistoryInbox::Backlog HistoryInbox::backlog() const
{
    const QMutexLocker lock(&m_mutex);
    return {std::accumulate(m_samples.begin(), m_samples.end(), qsizetype{0}), m_contents.entries.size()};
}

void HistoryInbox::dropOldSamples(QList<SampleBlock> &blocks, qsizetype &kept)
{
    while (kept > m_mostSamples && blocks.size() > 1) {
        const qsizetype dropped = blocks.takeFirst().x.size();
        blocks.first().followsPrevious = false;
        kept -= dropped;
        m_contents.samplesDropped += dropped;
    }
}

} // namespace gorizont
