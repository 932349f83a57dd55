#include "core/station/slidingextremes.h"

namespace gorizont::station {

void SlidingExtremes::push(std::optional<double> value)
{
    const qint64 number = m_pushes++;
    for (auto *entries : {&m_rising, &m_falling}) {
        if (!entries->empty() && entries->front().number <= number - m_length) {
            entries->pop_front();
        }
    }
    if (!value) {
        return;
    }
    while (!m_rising.empty() && m_rising.back().value >= *value) {
        m_rising.pop_back();
    }
    m_rising.push_back({number, *value});
    while (!m_falling.empty() && m_falling.back().value <= *value) {
        m_falling.pop_back();
    }
    m_falling.push_back({number, *value});
}

std::optional<double> SlidingExtremes::minimum() const
{
    return m_rising.empty() ? std::nullopt : std::optional(m_rising.front().value);
}

std::optional<double> SlidingExtremes::maximum() const
{
    return m_falling.empty() ? std::nullopt : std::optional(m_falling.front().value);
}

} // namespace gorizont::station
