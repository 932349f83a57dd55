#include "app/opc-da/com/variants.h"

namespace opcda {

namespace {
constexpr std::int64_t UnixEpoch = 11644473600000; ///< ms from 1601, where FILETIME begins, to 1970
constexpr std::int64_t TicksPerMs = 10000;

VARIANT plain(const Value &value)
{
    VARIANT result;
    VariantInit(&result);
    if (const bool *flag = std::get_if<bool>(&value)) {
        result.vt = VT_BOOL;
        result.boolVal = *flag ? VARIANT_TRUE : VARIANT_FALSE;
    } else if (const double *number = std::get_if<double>(&value)) {
        result.vt = VT_R8;
        result.dblVal = *number;
    }
    return result;
}
} // namespace

HRESULT convert(const Value &value, VARTYPE wanted, LCID locale, VARIANT *target)
{
    VARIANT source = plain(value);
    VariantInit(target);
    if (wanted == VT_EMPTY || source.vt == VT_EMPTY || source.vt == wanted) {
        *target = source;
        return S_OK;
    }
    const HRESULT result = VariantChangeTypeEx(target, &source, locale, VARIANT_ALPHABOOL, wanted);
    if (FAILED(result))
        VariantClear(target);
    return result;
}

VARIANT variantOf(TextView text)
{
    VARIANT value;
    VariantInit(&value);
    value.vt = VT_BSTR;
    value.bstrVal = SysAllocString(wide(text).c_str());
    return value;
}

std::int64_t unixMilliseconds()
{
    FILETIME now;
    GetSystemTimeAsFileTime(&now);
    const std::int64_t ticks = static_cast<std::int64_t>(now.dwHighDateTime) << 32 | now.dwLowDateTime;
    return ticks / TicksPerMs - UnixEpoch;
}

FILETIME fileTime(std::int64_t unixMs)
{
    const auto ticks = static_cast<std::uint64_t>((unixMs + UnixEpoch) * TicksPerMs);
    return {static_cast<DWORD>(ticks), static_cast<DWORD>(ticks >> 32)};
}

} // namespace opcda
