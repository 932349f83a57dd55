#include "app/opc-da/com/locale.h"

namespace opcda {

namespace {
constexpr bool isDefault(LCID locale)
{
    return locale == 0 || locale == LOCALE_SYSTEM_DEFAULT || locale == LOCALE_USER_DEFAULT;
}

LCID resolved(LCID locale)
{
    if (!isDefault(locale))
        return locale;
    return locale == LOCALE_USER_DEFAULT ? GetUserDefaultLCID() : GetSystemDefaultLCID();
}
} // namespace

bool isKnown(LCID locale)
{
    const WORD primary = PRIMARYLANGID(LANGIDFROMLCID(locale));
    return isDefault(locale) || primary == LANG_ENGLISH || primary == LANG_RUSSIAN;
}

Language languageOf(LCID locale)
{
    return PRIMARYLANGID(LANGIDFROMLCID(resolved(locale))) == LANG_RUSSIAN ? Language::Russian : Language::English;
}

Text sentenceFor(HRESULT code, LCID locale)
{
    if (const auto sentence = errorText(static_cast<std::uint32_t>(code), languageOf(locale)))
        return *sentence;
    wchar_t *found = nullptr;
    const DWORD flags = FORMAT_MESSAGE_ALLOCATE_BUFFER | FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS;
    const auto ask = [&](LANGID language) {
        return FormatMessageW(
            flags, nullptr, static_cast<DWORD>(code), language, reinterpret_cast<wchar_t *>(&found), 0, nullptr);
    };
    // Windows need not have its own messages in the wanted language.
    if (!ask(LANGIDFROMLCID(resolved(locale))) && !ask(0))
        return {};
    Text sentence = textOf(found);
    LocalFree(found);
    while (!sentence.empty() && sentence.back() <= u' ')
        sentence.pop_back();
    return sentence;
}

} // namespace opcda
