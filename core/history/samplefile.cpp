#include "core/history/samplefile.h"

#include "core/history/historyformat.h"

#include <QtEndian>

#include <algorithm>

namespace gorizont {

namespace {

QByteArray littleEndian(const QList<qint16> &samples, qsizetype from, qsizetype count)
{
    QByteArray bytes(count * 2, Qt::Uninitialized);
    qToLittleEndian<qint16>(samples.constData() + from, count, bytes.data());
    return bytes;
}

UtcTime timeOfSample(const SampleBlock &block, qsizetype index)
{
    const std::chrono::duration<double> offset(block.rate > 0 ? static_cast<double>(index) / block.rate : 0);
    return block.start + std::chrono::round<std::chrono::microseconds>(offset);
}

} // namespace

SampleFile::SampleFile(const QString &folder, int number, qint64 samplesPerFile, const QTimeZone &zone)
    : m_folder(folder)
    , m_number(number)
    , m_samplesPerFile(std::max<qint64>(1, samplesPerFile))
    , m_zone(zone)
{
}

bool SampleFile::append(const SampleBlock &block)
{
    if (!block.followsPrevious || (m_x.isOpen() && !(m_x.isInPlace() && m_y.isInPlace()))) {
        close();
    }
    const qsizetype size = std::min(block.x.size(), block.y.size());
    for (qsizetype from = 0; from < size;) {
        if (!m_x.isOpen() && !openPair(timeOfSample(block, from))) {
            return false;
        }
        const qsizetype count = std::min(size - from, m_samplesPerFile - m_samplesInPair);
        if (!write(block, from, count)) {
            close();
            return false;
        }
        from += count;
        if (m_samplesInPair == m_samplesPerFile) {
            close();
        }
    }
    return true;
}

/// A pair without a sample has no first sample to be named after: it goes.
void SampleFile::close()
{
    if (m_x.isOpen() && m_samplesInPair == 0) {
        m_x.remove();
        m_y.remove();
    }
    m_x.close();
    m_y.close();
    m_samplesInPair = 0;
}

/// Two starts in one second, or a clock that was set back, must not overwrite anything: the name is that of the next
/// free second.
bool SampleFile::openPair(UtcTime start)
{
    constexpr int mostTries = 3600;
    for (int i = 0; i < mostTries; ++i) {
        const QDateTime local = localTime(start + std::chrono::seconds(i), m_zone);
        const QString pathX = m_folder + u'/' + sampleFileName(local, m_number, u'X');
        const QString pathY = m_folder + u'/' + sampleFileName(local, m_number, u'Y');
        if (!QFile::exists(pathX) && !QFile::exists(pathY)) {
            return createPair(pathX, pathY);
        }
        m_error = pathX;
    }
    return false;
}

bool SampleFile::createPair(const QString &pathX, const QString &pathY)
{
    if (!m_x.open(pathX, AppendFile::Mode::New)) {
        m_error = m_x.error();
        return false;
    }
    if (!m_y.open(pathY, AppendFile::Mode::New)) {
        m_error = m_y.error();
        m_x.remove();
        return false;
    }
    return true;
}

bool SampleFile::write(const SampleBlock &block, qsizetype from, qsizetype count)
{
    if (!m_x.append(littleEndian(block.x, from, count))) {
        m_error = m_x.error();
        return false;
    }
    if (!m_y.append(littleEndian(block.y, from, count))) {
        m_error = m_y.error();
        m_x.cut(m_samplesInPair * 2);
        return false;
    }
    m_samplesInPair += count;
    m_samplesSaved += static_cast<quint64>(count);
    return true;
}

} // namespace gorizont
