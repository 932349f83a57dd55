#pragma once
#include "app/opc-da/com/windowstext.h"
#include "app/opc-da/pure/addressspace.h"
#include "app/opc-da/pure/values.h"

#include <chrono>

namespace opcda {

/// A VARIANT that is cleared at the end of its scope.
class Variant
{
public:
    Variant() { VariantInit(&m_value); }
    ~Variant() { VariantClear(&m_value); }
    Variant(Variant &&other) noexcept
        : m_value(other.m_value)
    {
        VariantInit(&other.m_value);
    }
    Variant(const Variant &) = delete;
    Variant &operator=(const Variant &) = delete;
    Variant &operator=(Variant &&) = delete;

    VARIANT *operator&() { return &m_value; }
    VARIANT give()
    {
        const VARIANT value = m_value;
        VariantInit(&m_value);
        return value;
    }

private:
    VARIANT m_value;
};

/// A value as the VARTYPE a client asked for (0: as it is). An empty value stays empty. DISP_E_OVERFLOW and
/// DISP_E_TYPEMISMATCH when it cannot be said so; then `target` is empty.
HRESULT convert(const Value &value, VARTYPE wanted, LCID locale, VARIANT *target);

VARIANT variantOf(TextView text);

std::int64_t unixMilliseconds();
FILETIME fileTime(std::int64_t unixMs);

} // namespace opcda
