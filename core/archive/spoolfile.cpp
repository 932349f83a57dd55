#include "core/archive/spoolfile.h"

#include "core/archive/archivebytes.h"

#include <QCoreApplication>
#include <QDir>
#include <QRandomGenerator>
#include <QtEndian>

#include <limits>

namespace gorizont {

namespace {

constexpr QByteArrayView magic("GSPL", 4);
constexpr qint64 headBytes = 28;
constexpr qint64 mostBatchBytes = 256 << 20;

template <typename T> void put(QByteArray &bytes, T value)
{
    const T little = qToLittleEndian(value);
    bytes.append(reinterpret_cast<const char *>(&little), sizeof little);
}

quint32 sumOf(QByteArrayView head, QByteArrayView batch)
{
    return crc32(head.sliced(4, 20).toByteArray().append(batch));
}

QByteArray record(const SpoolMark &mark, QByteArrayView batch)
{
    QByteArray bytes = magic.toByteArray();
    bytes.reserve(headBytes + batch.size());
    put(bytes, static_cast<quint32>(batch.size()));
    put(bytes, mark.spool);
    put(bytes, mark.sequence);
    put(bytes, sumOf(bytes, batch));
    bytes.append(batch);
    return bytes;
}

qint64 freshName()
{
    return QRandomGenerator::system()->bounded(qint64{1}, std::numeric_limits<qint64>::max());
}

} // namespace

SpoolFile::SpoolFile(const QString &path, qint64 mostBytes)
    : m_path(path)
    , m_mostBytes(mostBytes)
{
}

bool SpoolFile::open()
{
    m_from = 0;
    m_next = {freshName(), 1};
    if (!m_file.open(m_path, AppendFile::Mode::Continue)) {
        return fail(m_file.error());
    }
    qint64 end = 0;
    while (const auto entry = read(end)) {
        m_next = {entry->mark.spool, entry->mark.sequence + 1};
        end = entry->end;
    }
    // What cannot be read may be whole: only a torn end is cut off.
    if (m_isUnreadable || (end < m_file.size() && !m_file.cut(end))) {
        m_file.close();
        return fail(m_file.error());
    }
    return true;
}

bool SpoolFile::append(QByteArrayView batch)
{
    if (!m_file.isOpen() && !open()) {
        return false;
    }
    const QByteArray bytes = record(m_next, batch);
    if (m_file.size() + bytes.size() > m_mostBytes || batch.size() > mostBatchBytes) {
        return fail(
            QCoreApplication::translate("gorizont::SpoolFile", "%1 is full").arg(QDir::toNativeSeparators(m_path)));
    }
    const qint64 before = m_file.size();
    if (!m_file.append(bytes)) {
        return fail(m_file.error());
    }
    if (!m_file.sync()) {
        const QString reason = m_file.error();
        m_file.cut(before);
        return fail(reason);
    }
    ++m_next.sequence;
    return true;
}

std::optional<SpoolFile::Entry> SpoolFile::read(qint64 at)
{
    bool hasDamage = false;
    m_isUnreadable = false;
    while (at >= 0 && !m_isUnreadable && at + headBytes <= m_file.size()) {
        if (auto entry = readAt(at)) {
            entry->hasDamageBefore = hasDamage;
            return entry;
        }
        hasDamage = true;
        at = nextMagic(at + 1);
    }
    return {};
}

/// Empty: no whole record begins there.
std::optional<SpoolFile::Entry> SpoolFile::readAt(qint64 at)
{
    const QByteArray head = bytesAt(at, headBytes);
    if (head.size() != headBytes || !head.startsWith(magic)) {
        return {};
    }
    const qint64 length = qFromLittleEndian<quint32>(head.constData() + 4);
    if (length > mostBatchBytes || at + headBytes + length > m_file.size()) {
        return {};
    }
    Entry entry;
    entry.mark.spool = qFromLittleEndian<qint64>(head.constData() + 8);
    entry.mark.sequence = qFromLittleEndian<qint64>(head.constData() + 16);
    entry.batch = bytesAt(at + headBytes, length);
    entry.end = at + headBytes + length;
    if (entry.batch.size() != length || qFromLittleEndian<quint32>(head.constData() + 24) != sumOf(head, entry.batch)) {
        return {};
    }
    return entry;
}

/// −1: there is none.
qint64 SpoolFile::nextMagic(qint64 at)
{
    constexpr qint64 window = 1 << 16;
    for (; at + magic.size() <= m_file.size(); at += window - magic.size() + 1) {
        const QByteArray bytes = bytesAt(at, std::min(window, m_file.size() - at));
        if (const qsizetype found = bytes.indexOf(magic); found >= 0) {
            return at + found;
        }
    }
    return -1;
}

/// Shorter than \a count: the disk did not give them.
QByteArray SpoolFile::bytesAt(qint64 at, qint64 count)
{
    const QByteArray bytes = m_file.read(at, count);
    if (bytes.size() != count) {
        m_isUnreadable = true;
        m_error = m_file.error();
    }
    return bytes;
}

void SpoolFile::drop(qint64 end)
{
    m_from = std::max(m_from, end);
    if (isEmpty() && m_file.size() > 0 && m_file.cut(0)) {
        m_from = 0;
    }
}

bool SpoolFile::fail(const QString &reason)
{
    m_error = reason;
    return false;
}

} // namespace gorizont
