#pragma once
#include <cstdint>
#include <variant>

namespace opcda {

/// Quality byte of OPC Data Access, 6.8 of the specification.
namespace quality {
constexpr std::uint16_t ConfigError = 0x04;
constexpr std::uint16_t NotConnected = 0x08;
constexpr std::uint16_t CommFailure = 0x18;
constexpr std::uint16_t OutOfService = 0x1C;
constexpr std::uint16_t WaitingForInitialData = 0x20;
constexpr std::uint16_t Good = 0xC0;

constexpr bool isGood(std::uint16_t value)
{
    return (value & 0xC0) == Good;
}
} // namespace quality

/// What a tag says; monostate: it never had a value.
using Value = std::variant<std::monostate, bool, double>;

/// Value, quality and time of a tag as they are known now.
struct TagState
{
    Value value;
    std::uint16_t quality = quality::CommFailure;
    std::int64_t time = 0; ///< ms UTC since 1970, of the reading
    std::uint64_t version = 0; ///< grows whenever value or quality changes
};

/// Whether a client that has `sent` is to be told `now`: another quality, or a value that moved by more than `percent` of the
/// range `low`…`high`. A deadband needs a number before and now and a range; without them every change counts.
bool isNews(const TagState &sent, const TagState &now, double percent, double low, double high);

/// Whether a value read at `time` is at most `maxAge` ms old at `now` (both ms UTC since 1970).
constexpr bool isYoung(std::int64_t time, std::int64_t now, std::uint32_t maxAge)
{
    return now - time <= static_cast<std::int64_t>(maxAge);
}

/// The update rate a group gets for the one it asked for, ms: a multiple of 50 (the feed's own step), at least 50.
std::uint32_t revisedRate(std::uint32_t asked);
/// The keep-alive time a group gets, ms: 0 switches it off, else at least 100.
std::uint32_t revisedKeepAlive(std::uint32_t asked);

} // namespace opcda
