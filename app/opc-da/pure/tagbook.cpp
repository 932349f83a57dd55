#include "app/opc-da/pure/tagbook.h"

namespace opcda {

namespace {

enum OwnTag { Connection, TagsHashGood, OwnTags };

std::vector<Tag> ownTags()
{
    return {
        {u"OPCGate.Connection", TagType::Bool, u"The main program answers", {}, true},
        {u"OPCGate.TagsHashGood",
         TagType::Bool,
         u"The registered list of tags is the one of the main program",
         {},
         true}};
}

} // namespace

TagBook::TagBook(std::string registeredHash, std::int64_t now)
    : m_registeredHash(std::move(registeredHash))
{
    m_names.replace(ownTags(), 0);
    makeRoom(now);
    set(Connection, false, quality::Good, now);
    set(TagsHashGood, false, quality::CommFailure, now);
}

void TagBook::preset(const std::vector<Tag> &tags, std::int64_t now)
{
    m_names.replace(tags, OwnTags);
    makeRoom(now);
}

TagBook::Answer TagBook::accept(const FeedLine &line, std::int64_t now)
{
    if (const auto *values = std::get_if<FeedValues>(&line))
        return take(*values, now);
    if (const auto *greeting = std::get_if<FeedHello>(&line)) {
        m_hello = *greeting;
        m_incoming.clear();
        m_isReady = false;
        return Answer::None;
    }
    if (const auto *more = std::get_if<FeedTags>(&line)) {
        if (m_isReady || m_incoming.size() + more->tags.size() > m_hello.count)
            return refuse("more tags came than were announced");
        m_incoming.insert(m_incoming.end(), more->tags.begin(), more->tags.end());
        return Answer::None;
    }
    if (std::holds_alternative<FeedReady>(line))
        return ready(now);
    if (std::holds_alternative<FeedEnd>(line))
        return Answer::End;
    if (const auto *fault = std::get_if<FeedFault>(&line))
        return refuse(fault->why);
    return Answer::None;
}

TagBook::Answer TagBook::ready(std::int64_t now)
{
    if (m_incoming.size() != m_hello.count)
        return refuse("fewer tags came than were announced");
    m_indices = m_names.replace(m_incoming, OwnTags);
    m_incoming.clear();
    makeRoom(now);
    for (int i = OwnTags; i < m_names.count(); ++i) {
        const TagState &known = state(i);
        if (!m_names.at(i).isListed)
            set(i, known.value, quality::ConfigError, known.time);
        else if (std::holds_alternative<std::monostate>(known.value))
            set(i, known.value, quality::WaitingForInitialData, now);
    }
    m_isReady = true;
    set(Connection, true, quality::Good, now);
    set(TagsHashGood, !m_registeredHash.empty() && m_hello.hash == m_registeredHash, quality::Good, now);
    return Answer::Ready;
}

TagBook::Answer TagBook::take(const FeedValues &values, std::int64_t now)
{
    if (!m_isReady)
        return refuse("values came before the list of tags was complete");
    for (const FeedEntry &entry : values.entries) {
        if (entry.index >= m_indices.size())
            return refuse("a value came for a tag that is not in the list");
        const int index = m_indices[entry.index];
        const bool isFlag = m_names.at(index).type == TagType::Bool;
        if (isFlag ? std::holds_alternative<double>(entry.value) : std::holds_alternative<bool>(entry.value))
            return refuse("a value came that is not of its tag's type");
        set(index, entry.value, entry.quality, entry.time > 0 ? entry.time : now);
    }
    return Answer::None;
}

void TagBook::lose(std::int64_t now)
{
    m_isReady = false;
    m_incoming.clear();
    m_hello = {};
    for (int i = TagsHashGood; i < m_names.count(); ++i)
        set(i, state(i).value, quality::CommFailure, state(i).time);
    set(Connection, false, quality::Good, now);
}

TagBook::Answer TagBook::refuse(std::string why)
{
    m_fault = std::move(why);
    return Answer::HangUp;
}

void TagBook::set(int index, const Value &value, std::uint16_t quality, std::int64_t time)
{
    TagState &state = m_states[static_cast<std::size_t>(index)];
    if (state.value != value || state.quality != quality || state.version == 0)
        state.version = ++m_version;
    state.value = value;
    state.quality = quality;
    state.time = time;
}

void TagBook::makeRoom(std::int64_t now)
{
    while (m_states.size() < static_cast<std::size_t>(m_names.count())) {
        m_states.emplace_back();
        set(static_cast<int>(m_states.size()) - 1, {}, quality::CommFailure, now);
    }
}

} // namespace opcda
