#pragma once
#include "app/opc-da/com/platform.h"
#include "app/opc-da/pure/names.h"

namespace opcda {

static_assert(sizeof(wchar_t) == sizeof(char16_t));

/// Null counts as empty.
inline Text textOf(const wchar_t *string)
{
    return string ? Text(string, string + wcslen(string)) : Text();
}

inline std::wstring wide(TextView text)
{
    return {text.begin(), text.end()};
}

} // namespace opcda
