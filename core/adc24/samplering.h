#pragma once

#include <QList>

#include <deque>

namespace gorizont {

/// The newest raw samples of one axis without a gap among them, oldest first. Pure.
class SampleRing
{
public:
    /// \a capacity: samples, 1…
    explicit SampleRing(quint64 capacity);

    /// What does not fit pushes out the oldest.
    void append(const QList<qint16> &samples, qsizetype count);
    void clear() { m_samples.clear(); }

    quint64 size() const { return m_samples.size(); } ///< samples
    /// Writes \a count samples from number \a first on as int16, little-endian; all of them must be there.
    void copy(quint64 first, quint64 count, char *to) const;

private:
    const quint64 m_capacity;
    std::deque<qint16> m_samples;
};

} // namespace gorizont
