#pragma once
#include "app/opc-da/pure/names.h"

#include <map>
#include <optional>
#include <unordered_map>

namespace opcda {

enum class TagType { Bool, Double };

/// One item that clients may ask for.
struct Tag
{
    Text id; ///< the name of figure 11.4
    TagType type = TagType::Double;
    Text description;
    std::vector<Text> aliases; ///< other full names by which it is found (table 11.1)
    bool isListed = true; ///< false when the main program no longer has it: kept for clients that hold it
};

/// The names of all tags as a tree, in the order they were given. Indices of tags never change.
class AddressSpace
{
public:
    struct Branch
    {
        Text id; ///< full name, empty for the root
        std::vector<Text> branches;
        std::vector<std::pair<Text, int>> leaves; ///< short name, index of the tag
    };

    AddressSpace();

    /// Replaces the list after the first `kept` tags; a tag of a known name keeps its index. Returns the index of each.
    std::vector<int> replace(const std::vector<Tag> &tags, int kept);

    /// By name or alias, listed or not.
    std::optional<int> find(TextView id) const;
    const Tag &at(int index) const { return m_tags[static_cast<std::size_t>(index)]; }
    int count() const { return static_cast<int>(m_tags.size()); }

    /// Null when there is no such branch. The root has the empty name.
    const Branch *branch(TextView id) const;
    /// The branch above; the root is above itself.
    Text above(TextView id) const;
    /// Indices of all listed tags in and below a branch, in order.
    std::vector<int> below(TextView id) const;

private:
    int place(const Tag &tag);
    void grow(int index);

    std::vector<Tag> m_tags;
    std::unordered_map<Text, int> m_byName;
    std::map<Text, Branch, std::less<>> m_branches;
};

} // namespace opcda
