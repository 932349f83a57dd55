#pragma once
#include "app/opc-da/pure/feedline.h"

namespace opcda {

/// All that the gateway knows: the names, and the last value of each. Fed by the lines of the main program; without locks,
/// the owner guards it.
class TagBook
{
public:
    /// What a line asks the owner to do.
    enum class Answer { None, Ready, End, HangUp };

    /// `registeredHash`: of the tag list that was registered, empty when none was. `now`: ms UTC since 1970.
    TagBook(std::string registeredHash, std::int64_t now);

    /// Names that are known before the main program answers; their values are bad until then.
    void preset(const std::vector<Tag> &tags, std::int64_t now);
    Answer accept(const FeedLine &line, std::int64_t now);
    /// The main program is gone: every value keeps, every quality becomes «communication failure».
    void lose(std::int64_t now);

    bool isConnected() const { return m_isReady; }
    /// Why the last line was refused.
    const std::string &fault() const { return m_fault; }
    const std::string &version() const { return m_hello.version; }
    const AddressSpace &names() const { return m_names; }
    const TagState &state(int index) const { return m_states[static_cast<std::size_t>(index)]; }
    /// Grows with every change of any tag.
    std::uint64_t lastChange() const { return m_version; }

private:
    Answer ready(std::int64_t now);
    Answer take(const FeedValues &values, std::int64_t now);
    Answer refuse(std::string why);
    void set(int index, const Value &value, std::uint16_t quality, std::int64_t time);
    void makeRoom(std::int64_t now);

    std::string m_registeredHash;
    std::string m_fault;
    FeedHello m_hello;
    std::vector<Tag> m_incoming;
    std::vector<int> m_indices; ///< of the feed's tags in m_names
    bool m_isReady = false;
    AddressSpace m_names;
    std::vector<TagState> m_states;
    std::uint64_t m_version = 0;
};

} // namespace opcda
