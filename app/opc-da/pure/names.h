#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace opcda {

/// Text as COM carries it: UTF-16.
using Text = std::u16string;
using TextView = std::u16string_view;

/// UTF-8 to UTF-16; what is no UTF-8 becomes U+FFFD.
Text fromUtf8(std::string_view bytes);
/// UTF-16 to UTF-8; a lone surrogate becomes U+FFFD.
std::string toUtf8(TextView text);

/// The parts of an item name: a dot separates, except inside `[…]` (figure 11.4 and network ports).
std::vector<Text> splitName(TextView name);
/// False for an empty name, an empty part, a bracket that is not closed or was not opened.
bool isWellFormed(TextView name);
/// `branch` and `leaf` with a dot between, or `leaf` alone at the root.
Text joined(TextView branch, TextView leaf);

/// Whether `text` matches a filter of a client: `*`, `?`, `#` (a digit), `[abc]`, `[a-z]`, `[!abc]`; letters of either case.
/// An empty pattern matches everything. A `[` that is never closed stands for itself.
bool matches(TextView pattern, TextView text);

} // namespace opcda
