#pragma once
#include "app/opc-da/pure/addressspace.h"
#include "app/opc-da/pure/values.h"

#include <string>
#include <variant>
#include <vector>

namespace opcda {

/// What the main program says first.
struct FeedHello
{
    std::string version;
    std::string caption;
    std::string hash; ///< SHA-256 of its tag list, 64 hex digits
    std::size_t count = 0;
};
struct FeedTags
{
    std::vector<Tag> tags;
};
struct FeedReady
{
};
struct FeedEntry
{
    std::size_t index = 0; ///< into the tag list
    Value value;
    std::uint16_t quality = quality::CommFailure;
    std::int64_t time = 0; ///< ms UTC since 1970
};
struct FeedValues
{
    std::vector<FeedEntry> entries;
};
struct FeedPing
{
};
struct FeedEnd
{
};
/// A line that says nothing this program knows: it is passed over.
struct FeedUnknown
{
};
/// A line that is no line of the feed: why.
struct FeedFault
{
    std::string why;
};

using FeedLine = std::variant<FeedUnknown, FeedHello, FeedTags, FeedReady, FeedValues, FeedPing, FeedEnd, FeedFault>;

/// Reads one line (without its line feed) of the main program's feed, protocol 1.
FeedLine parseFeedLine(std::string_view line);

/// The one line the gateway says after connecting, with its line feed.
std::string feedGreeting(std::string_view version, unsigned long processId, std::string_view registeredHash);

} // namespace opcda
