#pragma once

#include <QtGlobal>

#include <deque>
#include <optional>

namespace gorizont::station {

/// The least and the greatest of the last values, a fixed number of places of which some may be empty. Kept are only values that can
/// still become the answer, so a value costs the same however many places there are (taken over all of them).
class SlidingExtremes
{
public:
    /// \a length: places, 1…
    explicit SlidingExtremes(qsizetype length)
        : m_length(length)
    {
    }

    void push(std::optional<double> value);
    std::optional<double> minimum() const;
    std::optional<double> maximum() const;

private:
    struct Entry
    {
        qint64 number; ///< of the push
        double value;
    };

    qint64 m_length;
    qint64 m_pushes = 0;
    std::deque<Entry> m_rising; ///< the first is the least
    std::deque<Entry> m_falling; ///< the first is the greatest
};

} // namespace gorizont::station
