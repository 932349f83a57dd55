#include "app/opc-da/com/settings.h"

#include "app/opc-da/com/identity.h"
#include "app/opc-da/com/windowstext.h"
#include "app/opc-da/pure/feedline.h"

#include <filesystem>
#include <fstream>

namespace opcda {

namespace {

constexpr unsigned MostLinger = 3600;

/// A value of the registered settings, empty when there is none.
std::wstring registered(const wchar_t *name)
{
    const std::wstring key = std::wstring(L"CLSID\\") + ServerClsidText + L"\\Settings";
    wchar_t text[1024] = L"";
    DWORD size = sizeof(text);
    RegGetValueW(HKEY_CLASSES_ROOT, key.c_str(), name, RRF_RT_REG_SZ, nullptr, text, &size);
    return text;
}

std::wstring setting(const wchar_t *name)
{
    wchar_t text[1024] = L"";
    const std::wstring file = besideProgram(L"gorizont-opc-da.ini");
    GetPrivateProfileStringW(L"OPC", name, L"", text, static_cast<DWORD>(std::size(text)), file.c_str());
    return *text ? std::wstring(text) : registered(name);
}

} // namespace

std::wstring programPath()
{
    wchar_t path[MAX_PATH * 4] = L"";
    GetModuleFileNameW(nullptr, path, static_cast<DWORD>(std::size(path)));
    return path;
}

std::wstring besideProgram(const wchar_t *name)
{
    return (std::filesystem::path(programPath()).parent_path() / name).wstring();
}

Settings readSettings()
{
    Settings settings;
    const unsigned long port = wcstoul(setting(L"Port").c_str(), nullptr, 10);
    if (port > 0 && port < 65536)
        settings.port = static_cast<unsigned short>(port);
    settings.hash = toUtf8(textOf(setting(L"Hash").c_str()));
    settings.tagsFile = setting(L"Tags");
    const unsigned long linger = wcstoul(setting(L"Linger").c_str(), nullptr, 10);
    if (linger > 0 && linger <= MostLinger)
        settings.linger = std::chrono::seconds(linger);
    return settings;
}

std::vector<Tag> tagsOf(const std::wstring &file)
{
    std::vector<Tag> tags;
    std::ifstream stream{std::filesystem::path(file)};
    for (std::string line; std::getline(stream, line);) {
        const FeedLine parsed = parseFeedLine(line);
        if (const auto *list = std::get_if<FeedTags>(&parsed))
            tags.insert(tags.end(), list->tags.begin(), list->tags.end());
    }
    return tags;
}

} // namespace opcda
