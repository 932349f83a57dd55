#include "core/export/seedpacker.h"

#include <cmath>

#include <libmseed.h>

namespace gorizont {

namespace {

constexpr int recordLength = 4096; ///< bytes
constexpr flag bigEndian = 1;

UtcTime sampleTime(UtcTime start, qsizetype index, double rate)
{
    return start + std::chrono::microseconds(std::llround(double(index) * 1'000'000 / rate));
}

void keep(char *record, int length, void *records)
{
    static_cast<QByteArray *>(records)->append(record, length);
}

/// The samples belong to the packer.
void release(MSRecord *record)
{
    record->datasamples = nullptr;
    msr_free(&record);
}

MSRecord *newRecord()
{
    MSRecord *record = msr_init(nullptr);
    Q_CHECK_PTR(record);
    return record;
}

template <std::size_t size> void put(char (&field)[size], const QString &code)
{
    qstrncpy(field, code.toLatin1().constData(), size);
}

} // namespace

SeedPacker::SeedPacker(const SeedCodes &codes, const QString &location, Axis axis)
    : m_record(newRecord(), release)
    , m_axis(axis)
{
    put(m_record->network, codes.network);
    put(m_record->station, codes.station);
    put(m_record->location, location);
    put(m_record->channel, axis == Axis::X ? codes.channelX : codes.channelY);
    m_record->dataquality = 'D';
    m_record->reclen = recordLength;
    m_record->encoding = DE_STEIM2;
    m_record->byteorder = bigEndian;
    m_record->sampletype = 'i';
    m_record->sequence_number = 1;
}

SeedPacker::~SeedPacker() = default;

QByteArray SeedPacker::add(const SampleBlock &block, qsizetype first, qsizetype count)
{
    if (count <= 0) {
        return {};
    }
    QByteArray records;
    const UtcTime start = sampleTime(block.start, first, block.rate);
    const bool isFirst = m_samples.isEmpty();
    const auto halfSample = std::chrono::microseconds(std::llround(500'000 / block.rate));
    const bool follows = !isFirst && m_rate == block.rate && (first > 0 || block.followsPrevious)
        && std::chrono::abs(start - sampleTime(m_start, m_samples.size(), m_rate)) <= halfSample;
    if (!follows) {
        records = flush();
        m_start = start;
        m_rate = block.rate;
    }
    const QList<qint16> &axis = m_axis == Axis::X ? block.x : block.y;
    for (qsizetype i = first; i < first + count; ++i) {
        m_samples << axis.at(i);
    }
    return records + pack(false);
}

QByteArray SeedPacker::flush()
{
    return m_samples.isEmpty() ? QByteArray() : pack(true);
}

QByteArray SeedPacker::pack(bool isEnd)
{
    QByteArray records;
    int64_t packed = 0;
    m_record->starttime = m_start.time_since_epoch().count();
    m_record->samprate = m_rate;
    m_record->datasamples = m_samples.data();
    m_record->numsamples = m_samples.size();
    m_record->samplecnt = m_samples.size();
    msr_pack(m_record.get(), keep, &records, &packed, isEnd ? 1 : 0, 0);
    m_record->datasamples = nullptr;
    m_start = sampleTime(m_start, packed, m_rate);
    m_samples.remove(0, packed);
    return records;
}

} // namespace gorizont
