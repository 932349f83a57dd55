#include "app/opc-da/com/registrykeys.h"

namespace opcda {

namespace {

const std::wstring Software = L"Software\\";

/// Closed at the end of its scope.
class OpenKey
{
public:
    ~OpenKey()
    {
        if (m_key)
            RegCloseKey(m_key);
    }
    OpenKey() = default;
    OpenKey(const OpenKey &) = delete;
    OpenKey &operator=(const OpenKey &) = delete;

    HKEY *target() { return &m_key; }
    HKEY get() const { return m_key; }

private:
    HKEY m_key = nullptr;
};

/// Bytes of a value; empty when there is none.
std::wstring content(HKEY root, const std::wstring &key, const wchar_t *name, REGSAM view, DWORD type)
{
    OpenKey open;
    if (RegOpenKeyExW(root, (Software + key).c_str(), 0, KEY_READ | view, open.target()) != ERROR_SUCCESS)
        return {};
    DWORD size = 0;
    if (RegGetValueW(open.get(), nullptr, name, type, nullptr, nullptr, &size) != ERROR_SUCCESS)
        return {};
    std::wstring data(size / sizeof(wchar_t), L'\0');
    RegGetValueW(open.get(), nullptr, name, type, nullptr, data.data(), &size);
    return data;
}

} // namespace

bool RegistryKeys::exists(const std::wstring &key) const
{
    OpenKey open;
    return RegOpenKeyExW(m_root, (Software + key).c_str(), 0, KEY_READ | m_view, open.target()) == ERROR_SUCCESS;
}

std::wstring RegistryKeys::text(const std::wstring &key, const wchar_t *name) const
{
    return content(m_root, key, name, m_view, RRF_RT_REG_SZ).c_str(); // ends at the first zero
}

std::vector<std::wstring> RegistryKeys::list(const std::wstring &key, const wchar_t *name) const
{
    const std::wstring data = content(m_root, key, name, m_view, RRF_RT_REG_MULTI_SZ);
    std::vector<std::wstring> values;
    for (std::size_t begin = 0; begin < data.size() && data[begin];) {
        values.emplace_back(data.c_str() + begin);
        begin += values.back().size() + 1;
    }
    return values;
}

void RegistryKeys::make(const std::wstring &key)
{
    for (std::size_t end = 0; m_error == ERROR_SUCCESS && end != std::wstring::npos;) {
        end = key.find(L'\\', end + 1);
        const std::wstring part = key.substr(0, end);
        OpenKey open;
        DWORD disposition = 0;
        m_error = RegCreateKeyExW(
            m_root, (Software + part).c_str(), 0, nullptr, 0, KEY_READ | KEY_WRITE | m_view, nullptr, open.target(),
            &disposition);
        if (m_error == ERROR_SUCCESS && disposition == REG_CREATED_NEW_KEY)
            m_created.push_back(part);
    }
}

void RegistryKeys::write(const std::wstring &key, const wchar_t *name, DWORD type, const std::wstring &data)
{
    make(key);
    if (m_error != ERROR_SUCCESS)
        return;
    OpenKey open;
    m_error = RegOpenKeyExW(m_root, (Software + key).c_str(), 0, KEY_WRITE | m_view, open.target());
    if (m_error == ERROR_SUCCESS)
        m_error = RegSetValueExW(
            open.get(), name, 0, type, reinterpret_cast<const BYTE *>(data.c_str()), // with its final zero
            static_cast<DWORD>((data.size() + 1) * sizeof(wchar_t)));
}

void RegistryKeys::set(const std::wstring &key, const wchar_t *name, const std::wstring &value)
{
    write(key, name, REG_SZ, value);
}

void RegistryKeys::setList(const std::wstring &key, const wchar_t *name, const std::vector<std::wstring> &values)
{
    std::wstring data;
    for (const std::wstring &value : values)
        data += value + L'\0';
    write(key, name, REG_MULTI_SZ, data);
}

bool RegistryKeys::isBare(const std::wstring &key) const
{
    OpenKey open;
    DWORD keys = 0;
    return RegOpenKeyExW(m_root, (Software + key).c_str(), 0, KEY_READ | m_view, open.target()) == ERROR_SUCCESS
        && RegQueryInfoKeyW(
               open.get(), nullptr, nullptr, nullptr, &keys, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr,
               nullptr)
        == ERROR_SUCCESS
        && keys == 0;
}

void RegistryKeys::remove(const std::wstring &key)
{
    if (!isBare(key))
        return;
    const LONG result = RegDeleteKeyExW(m_root, (Software + key).c_str(), m_view, 0);
    if (m_error == ERROR_SUCCESS)
        m_error = result;
}

} // namespace opcda
