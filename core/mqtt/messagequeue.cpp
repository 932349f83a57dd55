#include "core/mqtt/messagequeue.h"

#include <QDir>

#include <algorithm>
#include <utility>

namespace gorizont {

namespace {

constexpr qint64 chunkSize = 65536; ///< much longer than any record

qsizetype sizeOf(const QueuedMessage &message)
{
    constexpr qsizetype overhead = 64;
    return message.topic.size() + message.payload.size() + overhead;
}

} // namespace

MessageQueue::Limits MessageQueue::Limits::of(qint64 bytes)
{
    constexpr qint64 smallestSegment = 16384;
    Limits limits;
    limits.bytes = bytes;
    limits.segmentBytes = std::clamp(bytes / 64, smallestSegment, limits.segmentBytes);
    return limits;
}

MessageQueue::MessageQueue(const QString &folder, const Limits &limits, Note note)
    : m_folder(folder)
    , m_limits(limits)
    , m_note(std::move(note))
    , m_files(folder, limits.segmentBytes)
    , m_mark(folder + QStringLiteral("/acknowledged.txt"))
{
}

void MessageQueue::open(UtcTime now)
{
    QDir().mkpath(m_folder);
    if (m_files.open()) {
        m_note(
            JournalKind::Info,
            tr("MQTT: the queue did not end with a whole reading; what was unfinished has been removed."));
    }
    if (m_mark.open(QIODevice::ReadWrite | QIODevice::Unbuffered)) {
        restoreMark();
    }
    const auto &segments = m_files.segments();
    if (!segments.empty()) {
        m_acknowledged = std::max(m_acknowledged, segments.front().first);
        m_nextSequence = std::max(m_acknowledged, segments.back().end);
    } else if (m_acknowledged > 0) {
        m_nextSequence = m_acknowledged;
    } else {
        m_nextSequence = m_acknowledged = static_cast<quint64>(now.time_since_epoch().count());
    }
    keepLimits();
    rewind();
}

void MessageQueue::append(const QList<QueuedMessage> &messages)
{
    for (const QueuedMessage &message : messages) {
        m_unsaved.push_back(message);
        m_unsavedBytes += sizeOf(message);
        m_nextSequence = message.sequence + 1;
    }
    save();
    keepLimits();
}

void MessageQueue::save()
{
    const SteadyTime now = SteadyTime::clock::now();
    while (!m_unsaved.empty() && (!m_retryAt || now >= *m_retryAt)) {
        const quint64 first = m_unsaved.front().sequence;
        QByteArray lines;
        std::size_t count = 0;
        while (count < m_unsaved.size() && lines.size() < m_limits.segmentBytes) {
            lines += encodeRecord(m_unsaved[count++]);
        }
        if (!m_files.append(lines, first, first + count)) {
            if (!std::exchange(m_retryAt, now + m_limits.retry)) {
                m_note(
                    JournalKind::Error,
                    tr("MQTT: the queue is not being saved: %1. Readings wait in memory, and it is tried again every "
                       "few seconds.")
                        .arg(m_files.error()));
            }
            return;
        }
        for (; count > 0; --count) {
            m_unsavedBytes -= sizeOf(m_unsaved.front());
            m_unsaved.pop_front();
        }
        if (std::exchange(m_retryAt, std::nullopt)) {
            m_note(JournalKind::Info, tr("MQTT: the queue is being saved again."));
        }
    }
}

/// Whole files go: the oldest readings, never those of now.
void MessageQueue::keepLimits()
{
    while (m_files.bytes() > m_limits.bytes && m_files.segments().size() > 1) {
        const QueueSegment oldest = m_files.segments().front();
        const quint64 begin = std::clamp(m_acknowledged, oldest.first, oldest.end);
        m_files.removeOldest();
        m_acknowledged = std::max(m_acknowledged, oldest.end);
        giveUp(oldest.end - begin);
    }
    while (m_unsavedBytes > m_limits.memoryBytes && !m_unsaved.empty()) {
        m_unsavedBytes -= sizeOf(m_unsaved.front());
        m_unsaved.pop_front();
        giveUp(1);
    }
    m_nextOut = std::max(m_nextOut, m_acknowledged);
}

void MessageQueue::giveUp(quint64 count)
{
    if (count > 0 && m_lostUntold == 0) {
        m_note(
            JournalKind::Error,
            tr("MQTT: the queue is full. The oldest readings are lost until the broker takes them again; QueueLimit in "
               "[MQTT] makes it longer."));
    }
    m_lost += count;
    m_lostUntold += count;
}

std::optional<QueuedMessage> MessageQueue::next()
{
    std::optional<QueuedMessage> message;
    do {
        if (!m_ready.empty()) {
            message = std::move(m_ready.front());
            m_ready.pop_front();
        } else if (!readSome()) {
            message = nextInMemory();
            break;
        }
    } while (!message || message->sequence < m_nextOut);
    if (message) {
        m_nextOut = message->sequence + 1;
    }
    return message;
}

std::optional<QueuedMessage> MessageQueue::nextInMemory() const
{
    const auto found = std::lower_bound(
        m_unsaved.begin(), m_unsaved.end(), m_nextOut,
        [](const QueuedMessage &message, quint64 sequence) { return message.sequence < sequence; });
    return found == m_unsaved.end() ? std::nullopt : std::optional(*found);
}

/// The next piece of the files. False: everything in them was read.
bool MessageQueue::readSome()
{
    const auto &segments = m_files.segments();
    auto segment = std::lower_bound(
        segments.begin(), segments.end(), m_position.segment,
        [](const QueueSegment &one, quint64 first) { return one.first < first; });
    if (segment != segments.end() && segment->first == m_position.segment && m_position.at >= segment->bytes) {
        ++segment;
    }
    if (segment == segments.end()) {
        return false;
    }
    if (segment->first != m_position.segment) {
        m_position = {segment->first, 0};
        m_expected = segment->first;
    }
    if (segment->end <= m_nextOut) {
        m_position.at = segment->bytes; // nothing in it is wanted
        m_expected = segment->end;
        return true;
    }
    const qint64 count = std::min(chunkSize, segment->bytes - m_position.at);
    const QByteArray bytes = m_files.read(*segment, m_position.at, count);
    const qsizetype whole = bytes.lastIndexOf('\n') + 1;
    if (whole == 0) {
        m_position.at = segment->bytes;
        noteDamage(segment->end - std::clamp(std::max(m_expected, m_nextOut), segment->first, segment->end));
    } else {
        m_position.at += whole;
        parseLines(bytes.first(whole));
    }
    return true;
}

void MessageQueue::parseLines(const QByteArray &bytes)
{
    quint64 unreadable = 0;
    quint64 missing = 0;
    for (qsizetype from = 0; from < bytes.size();) {
        const qsizetype lineFeed = bytes.indexOf('\n', from);
        if (auto message = parseRecord(QByteArrayView(bytes).sliced(from, lineFeed - from))) {
            missing += message->sequence - std::min(m_expected, message->sequence);
            m_expected = message->sequence + 1;
            m_ready.push_back(*std::move(message));
        } else {
            ++unreadable;
        }
        from = lineFeed + 1;
    }
    noteDamage(std::max(unreadable, missing));
}

void MessageQueue::noteDamage(quint64 count)
{
    if (count > 0) {
        m_lost += count;
        m_note(
            JournalKind::Error, tr("MQTT: the queue on the disk is damaged, readings in it are lost: %1.").arg(count));
    }
}

void MessageQueue::rewind()
{
    m_ready.clear();
    m_position = {};
    m_nextOut = m_acknowledged;
}

void MessageQueue::acknowledge(quint64 sequence)
{
    m_acknowledged = std::max(m_acknowledged, sequence + 1);
    while (m_files.segments().size() > 1 && m_files.segments().front().end <= m_acknowledged) {
        m_files.removeOldest();
    }
    while (!m_unsaved.empty() && m_unsaved.front().sequence < m_acknowledged) {
        m_unsavedBytes -= sizeOf(m_unsaved.front());
        m_unsaved.pop_front();
    }
    saveMark();
    if (m_lostUntold > 0 && waiting() == 0) {
        m_note(JournalKind::Error, tr("MQTT: lost because the queue was full, readings: %1.").arg(m_lostUntold));
        m_lostUntold = 0;
    }
}

quint64 MessageQueue::waiting() const
{
    quint64 count = m_unsaved.size();
    for (const QueueSegment &segment : m_files.segments()) {
        count += segment.end - std::clamp(m_acknowledged, segment.first, segment.end);
    }
    return count;
}

/// One short write in place: a kill leaves the old number or the new one, and the check sum of a record guards it.
void MessageQueue::saveMark()
{
    if (!m_mark.isOpen() && !m_retryAt) {
        m_mark.open(QIODevice::ReadWrite | QIODevice::Unbuffered);
    }
    if (m_mark.isOpen() && m_mark.seek(0)) {
        const QueuedMessage mark{m_acknowledged, QByteArrayLiteral("acknowledged"), QByteArrayLiteral("below")};
        m_mark.write(encodeRecord(mark));
    }
}

/// Without a mark everything in the files is sent, some of it once more.
void MessageQueue::restoreMark()
{
    const auto mark = parseRecord(m_mark.readLine().trimmed());
    m_acknowledged = mark ? mark->sequence : 0;
}

} // namespace gorizont
