#include "app/opc-da/pure/addressspace.h"

#include <algorithm>

namespace opcda {

AddressSpace::AddressSpace()
{
    m_branches.emplace(Text(), Branch{});
}

std::vector<int> AddressSpace::replace(const std::vector<Tag> &tags, int kept)
{
    for (std::size_t i = static_cast<std::size_t>(kept); i < m_tags.size(); ++i)
        m_tags[i].isListed = false;
    std::vector<int> indices;
    indices.reserve(tags.size());
    for (const Tag &tag : tags)
        indices.push_back(place(tag));
    m_branches.clear();
    m_branches.emplace(Text(), Branch{});
    for (int i = 0; i < kept && i < count(); ++i)
        grow(i);
    std::vector<bool> isGrown(m_tags.size());
    for (const int index : indices) {
        if (index >= kept && !isGrown[static_cast<std::size_t>(index)])
            grow(index);
        isGrown[static_cast<std::size_t>(index)] = true;
    }
    return indices;
}

int AddressSpace::place(const Tag &tag)
{
    int index = count();
    if (const auto known = m_byName.find(tag.id); known != m_byName.end() && at(known->second).id == tag.id) {
        index = known->second;
        m_tags[static_cast<std::size_t>(index)] = tag;
    } else {
        m_tags.push_back(tag);
        m_byName[tag.id] = index;
    }
    for (const Text &alias : tag.aliases)
        m_byName.try_emplace(alias, index);
    m_tags[static_cast<std::size_t>(index)].isListed = true;
    return index;
}

void AddressSpace::grow(int index)
{
    const std::vector<Text> parts = splitName(at(index).id);
    Text id;
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
        const Text next = joined(id, parts[i]);
        if (m_branches.try_emplace(next, Branch{next, {}, {}}).second)
            m_branches.find(id)->second.branches.push_back(parts[i]);
        id = next;
    }
    m_branches.find(id)->second.leaves.emplace_back(parts.back(), index);
}

std::optional<int> AddressSpace::find(TextView id) const
{
    const auto found = m_byName.find(Text(id));
    return found == m_byName.end() ? std::nullopt : std::optional(found->second);
}

const AddressSpace::Branch *AddressSpace::branch(TextView id) const
{
    const auto found = m_branches.find(id);
    return found == m_branches.end() ? nullptr : &found->second;
}

Text AddressSpace::above(TextView id) const
{
    const std::vector<Text> parts = splitName(id);
    Text parent;
    for (std::size_t i = 0; i + 1 < parts.size(); ++i)
        parent = joined(parent, parts[i]);
    return parent;
}

std::vector<int> AddressSpace::below(TextView id) const
{
    std::vector<int> found;
    const Branch *top = branch(id);
    if (!top)
        return found;
    for (const auto &leaf : top->leaves)
        found.push_back(leaf.second);
    for (const Text &child : top->branches) {
        const std::vector<int> more = below(joined(id, child));
        found.insert(found.end(), more.begin(), more.end());
    }
    return found;
}

} // namespace opcda
