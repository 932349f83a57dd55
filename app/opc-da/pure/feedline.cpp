#include "app/opc-da/pure/feedline.h"

#include <nlohmann/json.hpp>

namespace opcda {

namespace {

using Json = nlohmann::json;
constexpr int Protocol = 1;

FeedLine hello(const Json &line)
{
    if (line.value("protocol", 0) != Protocol)
        return FeedFault{"the main program speaks another protocol of the feed"};
    return FeedHello{
        line.value("version", std::string()), line.value("caption", std::string()), line.value("hash", std::string()),
        line.at("count").get<std::size_t>()};
}

Tag tagFrom(const Json &entry)
{
    Tag tag;
    tag.id = fromUtf8(entry.at("name").get_ref<const std::string &>());
    const std::string type = entry.at("type").get<std::string>();
    if (!isWellFormed(tag.id) || (type != "bool" && type != "double"))
        throw std::invalid_argument("a tag has a wrong name or type: " + toUtf8(tag.id) + ", " + type);
    tag.type = type == "bool" ? TagType::Bool : TagType::Double;
    tag.description = fromUtf8(entry.value("description", std::string()));
    for (const Json &alias : entry.value("aliases", Json::array()))
        tag.aliases.push_back(fromUtf8(alias.get_ref<const std::string &>()));
    return tag;
}

FeedLine tagList(const Json &entries)
{
    FeedTags list;
    for (const Json &entry : entries)
        list.tags.push_back(tagFrom(entry));
    return list;
}

Value valueFrom(const Json &value)
{
    if (value.is_boolean())
        return value.get<bool>();
    if (value.is_number())
        return value.get<double>();
    if (value.is_null())
        return {};
    throw std::invalid_argument("a value is neither a number nor true, false or null");
}

FeedLine values(const Json &entries)
{
    FeedValues list;
    for (const Json &entry : entries) {
        const Json &time = entry.at(3);
        list.entries.push_back(
            {entry.at(0).get<std::size_t>(), valueFrom(entry.at(1)), entry.at(2).get<std::uint16_t>(),
             time.is_null() ? 0 : time.get<std::int64_t>()});
    }
    return list;
}

FeedLine read(const Json &line)
{
    if (line.contains("v"))
        return values(line["v"]);
    if (line.contains("ping"))
        return FeedPing{};
    if (line.contains("tags"))
        return tagList(line["tags"]);
    if (line.contains("hello"))
        return hello(line);
    if (line.contains("ready"))
        return FeedReady{};
    if (line.contains("end"))
        return FeedEnd{};
    return FeedUnknown{};
}

} // namespace

FeedLine parseFeedLine(std::string_view line)
{
    try {
        const Json parsed = Json::parse(line);
        if (!parsed.is_object())
            return FeedFault{"a line is no JSON object"};
        return read(parsed);
    } catch (const std::exception &error) {
        return FeedFault{error.what()};
    }
}

std::string feedGreeting(std::string_view version, unsigned long processId, std::string_view registeredHash)
{
    const Json line{
        {"client", "gorizont-opc-da"}, {"version", version}, {"pid", processId}, {"registered", registeredHash}};
    return line.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace opcda
