#include "app/opc-da/pure/commandline.h"

#include <charconv>

namespace opcda {

namespace {

using Action = CommandLine::Action;

/// The value of `/name=value`, when `word` is that.
std::optional<Text> valueOf(TextView word, TextView name)
{
    const bool isIt = word.size() > name.size() && matches(name, word.substr(0, name.size()))
        && (word[name.size()] == u'=' || word[name.size()] == u':');
    return isIt ? std::optional(Text(word.substr(name.size() + 1))) : std::nullopt;
}

std::optional<std::uint16_t> portFrom(const Text &text)
{
    const std::string digits = toUtf8(text);
    std::uint16_t port = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), port);
    const bool isPort = error == std::errc() && end == digits.data() + digits.size() && port > 0;
    return isPort ? std::optional(port) : std::nullopt;
}

bool take(CommandLine &line, TextView word)
{
    if (matches(u"RegServer", word))
        line.action = Action::Register;
    else if (matches(u"UnregServer", word))
        line.action = Action::Unregister;
    else if (matches(u"PerUser", word))
        line.isPerUser = true;
    else if (const auto hash = valueOf(word, u"Hash"))
        line.hash = hash;
    else if (const auto tags = valueOf(word, u"Tags"))
        line.tagsFile = tags;
    else if (const auto port = valueOf(word, u"Port"))
        return (line.port = portFrom(*port)).has_value();
    else
        return matches(u"Embedding", word) || matches(u"Automation", word);
    return true;
}

} // namespace

CommandLine parseCommandLine(const std::vector<Text> &words)
{
    CommandLine line;
    for (const Text &word : words) {
        const bool isOption = word.size() > 1 && (word.front() == u'/' || word.front() == u'-');
        if (!isOption || !take(line, TextView(word).substr(1)))
            return CommandLine{Action::Wrong, false, {}, {}, {}};
    }
    return line;
}

} // namespace opcda
