#include "tests/opc/client/opcclient.h"

#include <tlhelp32.h>

namespace opctest {

std::wstring bulkName(int number)
{
    wchar_t name[64];
    swprintf(name, std::size(name), L"[SIM].Sensor_%04d[AND3][Addr:001].DATA.Angl_X", number);
    return name;
}

ComPtr<IOPCServer> connected(HRESULT *result)
{
    ComPtr<IOPCServer> server;
    CLSID clsid;
    HRESULT code = CLSIDFromProgID(L"OPC.DA.GorizontServer", &clsid);
    if (SUCCEEDED(code)) {
        code = CoCreateInstance(
            clsid, nullptr, CLSCTX_LOCAL_SERVER, __uuidof(IOPCServer),
            reinterpret_cast<void **>(server.GetAddressOf()));
    }
    if (result)
        *result = code;
    return server;
}

AddedGroup addGroup(IOPCServer *server, const wchar_t *name, DWORD rate, bool isActive, float deadband)
{
    AddedGroup added;
    ComPtr<IUnknown> group;
    added.result = server->AddGroup(
        name, isActive, rate, 77, nullptr, &deadband, 0x0409, &added.handle, &added.rate, __uuidof(IOPCItemMgt),
        group.GetAddressOf());
    added.items = as<IOPCItemMgt>(group.Get());
    return added;
}

OPCITEMDEF wantedItem(const std::wstring &id, OPCHANDLE client, VARTYPE type)
{
    static wchar_t noPath[] = L"";
    OPCITEMDEF item{};
    item.szAccessPath = noPath;
    item.szItemID = const_cast<wchar_t *>(id.c_str());
    item.bActive = TRUE;
    item.hClient = client;
    item.vtRequestedDataType = type;
    return item;
}

std::vector<OPCHANDLE> addItems(
    IOPCItemMgt *group, const std::vector<std::wstring> &ids, VARTYPE type, std::vector<HRESULT> *errors)
{
    std::vector<OPCITEMDEF> wanted;
    for (const std::wstring &id : ids)
        wanted.push_back(wantedItem(id, static_cast<OPCHANDLE>(wanted.size()), type));
    Allocated<OPCITEMRESULT> results;
    Allocated<HRESULT> codes;
    std::vector<OPCHANDLE> handles(ids.size());
    if (FAILED(group->AddItems(static_cast<DWORD>(wanted.size()), wanted.data(), &results, &codes)) || !results
        || !codes)
        return handles;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        handles[i] = results[i].hServer;
        if (errors)
            errors->push_back(codes[i]);
    }
    return handles;
}

ReadItem readItem(const VARIANT &value)
{
    ReadItem item;
    item.type = value.vt;
    switch (value.vt) {
    case VT_R8: item.number = value.dblVal; break;
    case VT_R4: item.number = static_cast<double>(value.fltVal); break;
    case VT_BOOL: item.number = value.boolVal == VARIANT_TRUE ? 1 : value.boolVal == VARIANT_FALSE ? 0 : -99; break;
    case VT_I2: item.number = value.iVal; break;
    case VT_I4: item.number = value.lVal; break;
    case VT_UI1: item.number = value.bVal; break;
    case VT_BSTR: item.text = value.bstrVal ? value.bstrVal : L""; break;
    default: break;
    }
    return item;
}

std::vector<ReadItem> readItems(
    IOPCItemMgt *group, std::vector<OPCHANDLE> handles, OPCDATASOURCE source, HRESULT *result)
{
    const auto reader = as<IOPCSyncIO>(group);
    Allocated<OPCITEMSTATE> states;
    Allocated<HRESULT> errors;
    const HRESULT code = reader
        ? reader->Read(source, static_cast<DWORD>(handles.size()), handles.data(), &states, &errors)
        : E_NOINTERFACE;
    if (result)
        *result = code;
    std::vector<ReadItem> items(handles.size());
    for (std::size_t i = 0; states && i < items.size(); ++i) {
        items[i] = readItem(states[i].vDataValue);
        items[i].error = errors[i];
        items[i].quality = states[i].wQuality;
        items[i].client = states[i].hClient;
        items[i].time = states[i].ftTimeStamp;
        VariantClear(&states.get()[i].vDataValue);
    }
    return items;
}

std::vector<std::wstring> stringsOf(IEnumString *enumerator)
{
    std::vector<std::wstring> strings;
    LPOLESTR next[50];
    for (ULONG fetched = 1; enumerator && fetched > 0;) {
        fetched = 0;
        enumerator->Next(static_cast<ULONG>(std::size(next)), next, &fetched);
        for (ULONG i = 0; i < fetched; ++i) {
            strings.emplace_back(next[i]);
            CoTaskMemFree(next[i]);
        }
    }
    return strings;
}

std::vector<DWORD> processesOf(const wchar_t *file)
{
    std::vector<DWORD> found;
    const HANDLE all = CreateToolhelp32Snapshot(TH32CS_SNAPPROCESS, 0);
    PROCESSENTRY32W entry{};
    entry.dwSize = sizeof(entry);
    for (BOOL more = Process32FirstW(all, &entry); more; more = Process32NextW(all, &entry)) {
        if (_wcsicmp(entry.szExeFile, file) == 0)
            found.push_back(entry.th32ProcessID);
    }
    CloseHandle(all);
    return found;
}

namespace {

void killAll(const wchar_t *file)
{
    for (const DWORD id : processesOf(file)) {
        const HANDLE process = OpenProcess(PROCESS_TERMINATE | SYNCHRONIZE, FALSE, id);
        TerminateProcess(process, 1);
        WaitForSingleObject(process, 5000);
        CloseHandle(process);
    }
}

} // namespace

void killGateways()
{
    killAll(L"gorizont-opc-da.exe");
    // Wine's service of COM never forgets the classes of a program that was killed; that of Windows does.
    if (GetProcAddress(GetModuleHandleW(L"ntdll.dll"), "wine_get_version"))
        killAll(L"rpcss.exe");
}

} // namespace opctest
