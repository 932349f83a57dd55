#include "core/adc24/samplering.h"

#include <QtEndian>

#include <algorithm>

namespace gorizont {

SampleRing::SampleRing(quint64 capacity)
    : m_capacity(std::max<quint64>(capacity, 1))
{
}

void SampleRing::append(const QList<qint16> &samples, qsizetype count)
{
    m_samples.insert(m_samples.end(), samples.begin(), samples.begin() + std::min(count, samples.size()));
    if (size() > m_capacity) {
        m_samples.erase(m_samples.begin(), m_samples.begin() + static_cast<std::ptrdiff_t>(size() - m_capacity));
    }
}

void SampleRing::copy(quint64 first, quint64 count, char *to) const
{
    auto sample = m_samples.begin() + static_cast<std::ptrdiff_t>(first);
    for (quint64 i = 0; i < count; ++i, ++sample, to += sizeof(qint16)) {
        qToLittleEndian(*sample, to);
    }
}

} // namespace gorizont
