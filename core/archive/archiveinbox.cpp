#include "core/archive/archiveinbox.h"

#include <QMutexLocker>

#include <algorithm>
#include <utility>

namespace gorizont {

namespace {

void extend(TimeSpan &span, UtcTime from, UtcTime to)
{
    span.from = span == TimeSpan() ? from : std::min(span.from, from);
    span.to = std::max(span.to, to);
}

} // namespace

void ArchiveInbox::put(const Readings &batch)
{
    const QMutexLocker lock(&m_mutex);
    m_contents.readings.insert(m_contents.readings.end(), batch.begin(), batch.end());
    if (m_contents.readings.size() > mostReadings) {
        dropOldest();
    }
}

/// A good part at once, so that it is not done again for every reading.
void ArchiveInbox::dropOldest()
{
    const auto count = static_cast<std::ptrdiff_t>(m_contents.readings.size() - mostReadings * 9 / 10);
    const auto end = m_contents.readings.begin() + count;
    for (auto reading = m_contents.readings.begin(); reading != end; ++reading) {
        if (reading->isAnswer) {
            extend(m_contents.dropped[reading->number], reading->time, reading->time);
        }
    }
    m_contents.readings.erase(m_contents.readings.begin(), end);
}

void ArchiveInbox::put(const LineStatus &status, UtcTime now)
{
    const QMutexLocker lock(&m_mutex);
    const auto known = m_states.constFind(status.port);
    if (known == m_states.constEnd() || *known != status.state) {
        m_states.insert(status.port, status.state);
        m_contents.lines.append({status, now});
    }
    if (m_contents.lines.size() > mostEntries) {
        m_contents.lines.removeFirst();
    }
}

void ArchiveInbox::put(const SampleBlock &block)
{
    const QMutexLocker lock(&m_mutex);
    m_contents.blocks.append(block);
    if (m_torn.remove(block.number)) {
        m_contents.blocks.last().followsPrevious = false;
    }
    if (m_contents.blocks.size() > mostBlocks) {
        dropOldestBlock();
    }
}

/// What comes behind it follows nothing.
void ArchiveInbox::dropOldestBlock()
{
    const SampleBlock block = m_contents.blocks.takeFirst();
    ++m_contents.blocksDropped;
    if (block.rate > 0) {
        const auto length = std::chrono::duration<double>(static_cast<double>(block.x.size()) / block.rate);
        extend(
            m_contents.droppedBlocks[block.number], block.start,
            block.start + std::chrono::round<std::chrono::microseconds>(length));
    }
    const auto isNext = [&block](const SampleBlock &other) { return other.number == block.number; };
    const auto next = std::find_if(m_contents.blocks.begin(), m_contents.blocks.end(), isNext);
    if (next != m_contents.blocks.end()) {
        next->followsPrevious = false;
    } else {
        m_torn.insert(block.number);
    }
}

void ArchiveInbox::put(const JournalEntry &entry)
{
    const QMutexLocker lock(&m_mutex);
    m_contents.entries.append(entry);
    if (m_contents.entries.size() > mostEntries) {
        m_contents.entries.removeFirst();
        ++m_contents.entriesDropped;
    }
}

void ArchiveInbox::put(const Backfill &backfill)
{
    const QMutexLocker lock(&m_mutex);
    m_contents.backfills.append(backfill);
    if (m_contents.backfills.size() > mostBackfills) {
        m_contents.backfills.removeFirst();
        ++m_contents.backfillsDropped;
    }
}

ArchiveInbox::Contents ArchiveInbox::take()
{
    const QMutexLocker lock(&m_mutex);
    return std::exchange(m_contents, {});
}

std::size_t ArchiveInbox::waitingReadings() const
{
    const QMutexLocker lock(&m_mutex);
    return m_contents.readings.size();
}

} // namespace gorizont
