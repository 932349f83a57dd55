#include "app/opc-da/pure/names.h"

namespace opcda {

namespace {

constexpr char32_t Replacement = 0xFFFD;

void append(Text &text, char32_t point)
{
    if (point < 0x10000) {
        text += static_cast<char16_t>(point);
        return;
    }
    point -= 0x10000;
    text += static_cast<char16_t>(0xD800 + (point >> 10));
    text += static_cast<char16_t>(0xDC00 + (point & 0x3FF));
}

/// Takes one code point off the front of `bytes`.
char32_t taken(std::string_view &bytes)
{
    const auto lead = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    if (lead < 0x80)
        return lead;
    const int more = lead >= 0xF0 && lead < 0xF5 ? 3
        : lead >= 0xE0 && lead < 0xF0            ? 2
        : lead >= 0xC2 && lead < 0xE0            ? 1
                                                 : 0;
    if (more == 0)
        return Replacement;
    char32_t point = lead & (0x3Fu >> more);
    for (int i = 0; i < more; ++i) {
        if (bytes.empty() || (static_cast<unsigned char>(bytes.front()) & 0xC0) != 0x80)
            return Replacement;
        point = point << 6 | (static_cast<unsigned char>(bytes.front()) & 0x3F);
        bytes.remove_prefix(1);
    }
    constexpr char32_t Least[] = {0, 0x80, 0x800, 0x10000};
    const bool isSurrogate = point >= 0xD800 && point < 0xE000;
    return point < Least[more] || point > 0x10FFFF || isSurrogate ? Replacement : point;
}

void append(std::string &bytes, char32_t point)
{
    const auto tail = [&bytes, point](int shift) { bytes += static_cast<char>(0x80 | (point >> shift & 0x3F)); };
    if (point < 0x80) {
        bytes += static_cast<char>(point);
    } else if (point < 0x800) {
        bytes += static_cast<char>(0xC0 | point >> 6);
        tail(0);
    } else if (point < 0x10000) {
        bytes += static_cast<char>(0xE0 | point >> 12);
        tail(6), tail(0);
    } else {
        bytes += static_cast<char>(0xF0 | point >> 18);
        tail(12), tail(6), tail(0);
    }
}

/// Lower case of Latin and Russian letters: names of tags have no others.
char16_t folded(char16_t c)
{
    if ((c >= u'A' && c <= u'Z') || (c >= u'А' && c <= u'Я'))
        return static_cast<char16_t>(c + 0x20);
    return c == u'Ё' ? u'ё' : c;
}

/// One character against the set between the brackets, without them.
bool isInSet(TextView set, char16_t c)
{
    const bool isWanted = set.empty() || set.front() != u'!';
    if (!isWanted)
        set.remove_prefix(1);
    for (std::size_t i = 0; i < set.size(); ++i) {
        const bool isRange = i + 2 < set.size() && set[i + 1] == u'-';
        if (isRange ? folded(set[i]) <= c && c <= folded(set[i + 2]) : folded(set[i]) == c)
            return isWanted;
        if (isRange)
            i += 2;
    }
    return !isWanted;
}

/// How many characters of the pattern stand for one character of the text; 0 when they do not stand for `c`.
std::size_t stepOver(TextView pattern, char16_t c)
{
    c = folded(c);
    switch (pattern.front()) {
    case u'?': return 1;
    case u'#': return c >= u'0' && c <= u'9' ? 1 : 0;
    case u'[':
        if (const auto end = pattern.find(u']', 2); end != TextView::npos)
            return isInSet(pattern.substr(1, end - 1), c) ? end + 1 : 0;
        break;
    default: break;
    }
    return folded(pattern.front()) == c ? 1 : 0;
}

} // namespace

Text fromUtf8(std::string_view bytes)
{
    Text text;
    text.reserve(bytes.size());
    while (!bytes.empty())
        append(text, taken(bytes));
    return text;
}

std::string toUtf8(TextView text)
{
    std::string bytes;
    for (std::size_t i = 0; i < text.size(); ++i) {
        char32_t point = text[i];
        const bool isHigh = point >= 0xD800 && point < 0xDC00;
        if (isHigh && i + 1 < text.size() && text[i + 1] >= 0xDC00 && text[i + 1] < 0xE000)
            point = 0x10000 + ((point - 0xD800) << 10) + (text[++i] - 0xDC00u);
        else if (point >= 0xD800 && point < 0xE000)
            point = Replacement;
        append(bytes, point);
    }
    return bytes;
}

std::vector<Text> splitName(TextView name)
{
    std::vector<Text> parts(1);
    int depth = 0;
    for (const char16_t c : name) {
        depth += c == u'[' ? 1 : c == u']' && depth > 0 ? -1 : 0;
        if (c == u'.' && depth == 0)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

bool isWellFormed(TextView name)
{
    int depth = 0;
    for (const char16_t c : name) {
        depth += c == u'[' ? 1 : c == u']' ? -1 : 0;
        if (depth < 0 || depth > 1)
            return false;
    }
    if (depth != 0)
        return false;
    for (const Text &part : splitName(name)) {
        if (part.empty())
            return false;
    }
    return true;
}

Text joined(TextView branch, TextView leaf)
{
    Text name(branch);
    if (!name.empty())
        name += u'.';
    return name.append(leaf);
}

bool matches(TextView pattern, TextView text)
{
    if (pattern.empty())
        return true;
    std::size_t p = 0;
    std::size_t t = 0;
    std::size_t star = TextView::npos; // where to go on when the rest does not fit: the last star takes one more
    std::size_t starText = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == u'*') {
            star = ++p;
            starText = t;
            continue;
        }
        const std::size_t step = p < pattern.size() ? stepOver(pattern.substr(p), text[t]) : 0;
        if (step > 0) {
            p += step;
            ++t;
        } else if (star != TextView::npos) {
            p = star;
            t = ++starText;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == u'*')
        ++p;
    return p == pattern.size();
}

} // namespace opcda
