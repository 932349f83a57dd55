#include "core/values/clockwatch.h"

namespace gorizont {

std::optional<std::chrono::microseconds> ClockWatch::step(UtcTime wall, SteadyTime steady)
{
    using std::chrono::microseconds;
    const microseconds offset =
        wall.time_since_epoch() - std::chrono::duration_cast<microseconds>(steady.time_since_epoch());
    const microseconds change = offset - m_offset.value_or(offset);
    m_offset = offset;
    return std::chrono::abs(change) > tolerance ? std::optional(change) : std::nullopt;
}

} // namespace gorizont
