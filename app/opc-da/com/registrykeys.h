#pragma once
#include "app/opc-da/com/platform.h"

#include <string>
#include <vector>

namespace opcda {

/// A part of the registry under Software, as 64-bit or as 32-bit programs see it, with a list of what was made in it.
class RegistryKeys
{
public:
    RegistryKeys(HKEY root, REGSAM view)
        : m_root(root)
        , m_view(view)
    {
    }

    bool exists(const std::wstring &key) const;
    /// A text value, empty when there is none. A null name is the default value.
    std::wstring text(const std::wstring &key, const wchar_t *name) const;
    std::vector<std::wstring> list(const std::wstring &key, const wchar_t *name) const;

    /// Make the key and its parents when they are missing, and note those. After the first error nothing more is done.
    void set(const std::wstring &key, const wchar_t *name, const std::wstring &value);
    void setList(const std::wstring &key, const wchar_t *name, const std::vector<std::wstring> &values);
    void remove(const std::wstring &key);

    const std::vector<std::wstring> &created() const { return m_created; }
    LONG error() const { return m_error; }

private:
    void make(const std::wstring &key);
    void write(const std::wstring &key, const wchar_t *name, DWORD type, const std::wstring &data);
    bool isBare(const std::wstring &key) const;

    HKEY m_root;
    REGSAM m_view;
    std::vector<std::wstring> m_created;
    LONG m_error = ERROR_SUCCESS;
};

} // namespace opcda
