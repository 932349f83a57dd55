#include "app/opc-da/com/registration.h"

#include "app/opc-da/com/identity.h"
#include "app/opc-da/com/registrykeys.h"
#include "app/opc-da/com/settings.h"
#include "app/opc-da/com/windowstext.h"

#include <filesystem>

namespace opcda {

namespace {

struct InterfaceName
{
    const IID *id;
    const wchar_t *name;
};

// What the proxy carries.
const InterfaceName Interfaces[] = {
    {&IID_IOPCCommon, L"IOPCCommon"},
    {&IID_IOPCShutdown, L"IOPCShutdown"},
    {&IID_IOPCServer, L"IOPCServer"},
    {&IID_IOPCBrowseServerAddressSpace, L"IOPCBrowseServerAddressSpace"},
    {&IID_IOPCItemProperties, L"IOPCItemProperties"},
    {&IID_IOPCBrowse, L"IOPCBrowse"},
    {&IID_IOPCItemIO, L"IOPCItemIO"},
    {&IID_IOPCGroupStateMgt, L"IOPCGroupStateMgt"},
    {&IID_IOPCGroupStateMgt2, L"IOPCGroupStateMgt2"},
    {&IID_IOPCSyncIO, L"IOPCSyncIO"},
    {&IID_IOPCSyncIO2, L"IOPCSyncIO2"},
    {&IID_IOPCAsyncIO2, L"IOPCAsyncIO2"},
    {&IID_IOPCAsyncIO3, L"IOPCAsyncIO3"},
    {&IID_IOPCItemMgt, L"IOPCItemMgt"},
    {&IID_IOPCItemDeadbandMgt, L"IOPCItemDeadbandMgt"},
    {&IID_IEnumOPCItemAttributes, L"IEnumOPCItemAttributes"},
    {&IID_IOPCDataCallback, L"IOPCDataCallback"},
};

struct Category
{
    const wchar_t *id;
    const wchar_t *name;
};
const Category Categories[] = {
    {L"{63D5F432-CFE4-11D1-B2C8-0060083BA1FB}", L"OPC Data Access Servers Version 2.0"},
    {L"{CC603642-66D7-48F1-B69A-B625E73652D7}", L"OPC Data Access Servers Version 3.0"},
};

const std::wstring Classes = L"Classes\\";
const std::wstring ServerKey = Classes + L"CLSID\\" + ServerClsidText;
const std::wstring SettingsKey = ServerKey + L"\\Settings";
const std::wstring ProxyKey = Classes + L"CLSID\\" + ProxyClsidText;

struct View
{
    REGSAM flag;
    const wchar_t *proxy; ///< file name of the proxy for programs that see this view
};
constexpr View Views[] = {
    {KEY_WOW64_64KEY, L"gorizont-opc-proxy.dll"},
    {KEY_WOW64_32KEY, L"gorizont-opc-proxy32.dll"},
};

HKEY rootOf(Scope scope)
{
    return scope == Scope::Machine ? HKEY_LOCAL_MACHINE : HKEY_CURRENT_USER;
}

std::wstring interfaceKey(const IID &id)
{
    wchar_t text[64] = L"";
    StringFromGUID2(id, text, static_cast<int>(std::size(text)));
    return Classes + L"Interface\\" + text;
}

void writeClass(RegistryKeys &keys)
{
    const std::wstring progId = Classes + ProgId;
    keys.set(progId, nullptr, ServerDescription);
    keys.set(progId + L"\\CLSID", nullptr, ServerClsidText);
    keys.set(progId + L"\\OPC", nullptr, {});
    keys.set(ServerKey, nullptr, ServerDescription);
    keys.set(ServerKey, L"AppID", AppIdText);
    keys.set(ServerKey + L"\\ProgID", nullptr, ProgId);
    keys.set(ServerKey + L"\\VersionIndependentProgID", nullptr, ProgId);
    keys.set(ServerKey + L"\\LocalServer32", nullptr, L"\"" + programPath() + L"\"");
    const std::wstring appIds = Classes + L"AppID\\";
    keys.set(appIds + AppIdText, nullptr, ServerDescription);
    keys.set(appIds + std::filesystem::path(programPath()).filename().wstring(), L"AppID", AppIdText);
    for (const Category &category : Categories) {
        keys.set(ServerKey + L"\\Implemented Categories\\" + category.id, nullptr, {});
        const std::wstring key = Classes + L"Component Categories\\" + category.id;
        if (!keys.exists(key))
            keys.set(key, L"409", category.name);
    }
}

/// A proxy that is there already is left alone: it may be the one of the OPC Core Components. What is registered for a user
/// hides what is registered for the machine, so both are looked at.
void writeProxy(RegistryKeys &keys, const RegistryKeys &machine, const std::wstring &proxy)
{
    if (!std::filesystem::exists(proxy))
        return;
    for (const InterfaceName &entry : Interfaces) {
        const std::wstring key = interfaceKey(*entry.id);
        const std::wstring mine = keys.text(key + L"\\ProxyStubClsid32", nullptr);
        const std::wstring present = mine.empty() ? machine.text(key + L"\\ProxyStubClsid32", nullptr) : mine;
        if (!present.empty() && _wcsicmp(present.c_str(), ProxyClsidText) != 0)
            continue;
        if (!keys.exists(key))
            keys.set(key, nullptr, entry.name);
        keys.set(key + L"\\ProxyStubClsid32", nullptr, ProxyClsidText);
    }
    keys.set(ProxyKey, nullptr, L"Gorizont OPC proxy");
    keys.set(ProxyKey + L"\\InProcServer32", nullptr, proxy);
    keys.set(ProxyKey + L"\\InProcServer32", L"ThreadingModel", L"Both");
}

void writeSettings(RegistryKeys &keys, const CommandLine &line)
{
    if (line.port)
        keys.set(SettingsKey, L"Port", std::to_wstring(*line.port));
    if (line.hash)
        keys.set(SettingsKey, L"Hash", wide(*line.hash));
    if (line.tagsFile)
        keys.set(SettingsKey, L"Tags", wide(*line.tagsFile));
}

/// True for a key of an interface that has another proxy than ours by now.
bool isOfOthers(const RegistryKeys &keys, const std::wstring &key)
{
    constexpr std::wstring_view Start = L"Classes\\Interface\\{";
    if (!key.starts_with(Start))
        return false;
    const std::wstring present =
        keys.text(key.substr(0, key.find(L'\\', Start.size())) + L"\\ProxyStubClsid32", nullptr);
    return !present.empty() && _wcsicmp(present.c_str(), ProxyClsidText) != 0;
}

} // namespace

LONG registerServer(Scope scope, const CommandLine &line)
{
    for (const View &view : Views) {
        RegistryKeys keys(rootOf(scope), view.flag);
        std::vector<std::wstring> noted = keys.list(SettingsKey, L"Created");
        writeClass(keys);
        writeProxy(keys, RegistryKeys(HKEY_LOCAL_MACHINE, view.flag), besideProgram(view.proxy));
        keys.setList(SettingsKey, L"Created", noted); // its own key is to be in the list too
        writeSettings(keys, line);
        noted.insert(noted.end(), keys.created().begin(), keys.created().end());
        keys.setList(SettingsKey, L"Created", noted);
        if (keys.error() != ERROR_SUCCESS)
            return keys.error();
    }
    return ERROR_SUCCESS;
}

LONG unregisterServer(Scope scope)
{
    LONG result = ERROR_SUCCESS;
    for (auto view = std::rbegin(Views); view != std::rend(Views); ++view) {
        RegistryKeys keys(rootOf(scope), view->flag);
        const std::vector<std::wstring> noted = keys.list(SettingsKey, L"Created");
        for (auto key = noted.rbegin(); key != noted.rend(); ++key) {
            if (!isOfOthers(keys, *key))
                keys.remove(*key);
        }
        if (result == ERROR_SUCCESS)
            result = keys.error();
    }
    return result;
}

} // namespace opcda
