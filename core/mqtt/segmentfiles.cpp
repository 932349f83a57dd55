#include "core/mqtt/segmentfiles.h"

#include "core/mqtt/queuerecord.h"

#include <QDir>
#include <QRegularExpression>

#include <algorithm>

namespace gorizont {

namespace {

/// Names and sizes; where a segment ends the next one begins.
std::deque<QueueSegment> segmentsIn(const QString &folder)
{
    static const QRegularExpression pattern(QStringLiteral(R"(^queue-(\d{20})\.txt$)"));
    std::deque<QueueSegment> segments;
    for (const QFileInfo &file : QDir(folder).entryInfoList(QDir::Files, QDir::Name)) {
        const QRegularExpressionMatch match = pattern.match(file.fileName());
        if (!match.hasMatch()) {
            continue;
        }
        const quint64 first = match.captured(1).toULongLong();
        if (!segments.empty()) {
            segments.back().end = first;
        }
        segments.push_back({first, first, file.size()});
    }
    return segments;
}

/// What of \a bytes is whole records, and the number that follows the last of them.
struct WholeRecords
{
    qint64 bytes = 0;
    quint64 end = 0;
};

WholeRecords wholeRecords(const QByteArray &bytes, quint64 first)
{
    WholeRecords whole{0, first};
    for (qsizetype from = 0; from < bytes.size();) {
        const qsizetype lineFeed = bytes.indexOf('\n', from);
        if (lineFeed < 0) {
            break;
        }
        const auto record = parseRecord(QByteArrayView(bytes).sliced(from, lineFeed - from));
        from = lineFeed + 1;
        if (record) {
            whole = {from, record->sequence + 1};
        }
    }
    return whole;
}

} // namespace

SegmentFiles::SegmentFiles(const QString &folder, qint64 segmentBytes)
    : m_folder(folder)
    , m_segmentBytes(segmentBytes)
{
}

QString SegmentFiles::pathOf(quint64 first) const
{
    return m_folder + QStringLiteral("/queue-%1.txt").arg(first, 20, 10, QChar(u'0'));
}

bool SegmentFiles::open()
{
    m_segments = segmentsIn(m_folder);
    bool wasTorn = false;
    while (!m_segments.empty()) {
        wasTorn = repairTail() || wasTorn;
        if (m_segments.back().bytes > 0) {
            break;
        }
        m_tail.remove(); // nothing is in it
        m_segments.pop_back();
    }
    for (const QueueSegment &segment : m_segments) {
        m_bytes += segment.bytes;
    }
    return wasTorn;
}

bool SegmentFiles::repairTail()
{
    QueueSegment &tail = m_segments.back();
    if (!m_tail.open(pathOf(tail.first), AppendFile::Mode::Continue)) { // it is read all the same, and written no more
        const WholeRecords whole = wholeRecords(read(tail, 0, tail.bytes), tail.first);
        tail.end = std::max(whole.end, tail.first + 1); // the next file needs another name
        return false;
    }
    const WholeRecords whole = wholeRecords(m_tail.read(0, m_tail.size()), tail.first);
    tail.end = whole.end;
    tail.bytes = m_tail.size();
    if (whole.bytes == tail.bytes) {
        return false;
    }
    if (m_tail.cut(whole.bytes)) {
        tail.bytes = whole.bytes;
    } else {
        m_tail.close();
    }
    return true;
}

bool SegmentFiles::append(const QByteArray &lines, quint64 first, quint64 end)
{
    const bool fits = m_tail.isOpen() && !m_segments.empty() && m_segments.back().end == first
        && m_segments.back().bytes < m_segmentBytes && m_tail.isInPlace();
    if (!fits && !beginSegment(first)) {
        return false;
    }
    if (!m_tail.append(lines)) {
        m_tail.close(); // the next attempt begins another file
        if (m_segments.back().bytes == 0) {
            QFile::remove(pathOf(first));
            m_segments.pop_back();
        }
        return false;
    }
    m_segments.back().end = end;
    m_segments.back().bytes += lines.size();
    m_bytes += lines.size();
    return true;
}

bool SegmentFiles::beginSegment(quint64 first)
{
    if (!m_tail.open(pathOf(first), AppendFile::Mode::Continue) || !m_tail.cut(0)) {
        m_tail.close();
        return false;
    }
    m_segments.push_back({first, first, 0});
    return true;
}

QByteArray SegmentFiles::read(const QueueSegment &segment, qint64 at, qint64 count) const
{
    QFile file(pathOf(segment.first));
    return file.open(QIODevice::ReadOnly | QIODevice::Unbuffered) && file.seek(at) ? file.read(count) : QByteArray();
}

void SegmentFiles::removeOldest()
{
    const QueueSegment oldest = m_segments.front();
    if (m_segments.size() == 1) {
        m_tail.close();
    }
    QFile::remove(pathOf(oldest.first));
    m_bytes -= oldest.bytes;
    m_segments.pop_front();
}

} // namespace gorizont
