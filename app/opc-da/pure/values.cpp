#include "app/opc-da/pure/values.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace opcda {

namespace {
constexpr std::uint32_t RateStep = 50;
constexpr std::uint32_t LeastKeepAlive = 100;
} // namespace

bool isNews(const TagState &sent, const TagState &now, double percent, double low, double high)
{
    if (sent.quality != now.quality)
        return true;
    const double *before = std::get_if<double>(&sent.value);
    const double *after = std::get_if<double>(&now.value);
    if (!before || !after || percent <= 0 || high <= low)
        return sent.value != now.value;
    return std::abs(*after - *before) > percent / 100 * (high - low);
}

std::uint32_t revisedRate(std::uint32_t asked)
{
    constexpr std::uint32_t Most = std::numeric_limits<std::uint32_t>::max() / RateStep * RateStep;
    if (asked >= Most)
        return Most;
    return std::max(RateStep, asked / RateStep * RateStep + (asked % RateStep > 0 ? RateStep : 0));
}

std::uint32_t revisedKeepAlive(std::uint32_t asked)
{
    return asked == 0 ? 0 : std::max(asked, LeastKeepAlive);
}

} // namespace opcda
