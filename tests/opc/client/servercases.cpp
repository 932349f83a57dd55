#include "tests/opc/client/cases.h"
#include "tests/opc/client/listener.h"

#include <algorithm>
#include <comcat.h>

namespace opctest {

namespace {

bool isInCategory(const wchar_t *category, const CLSID &wanted)
{
    ComPtr<ICatInformation> catalog;
    CoCreateInstance(
        CLSID_StdComponentCategoriesMgr, nullptr, CLSCTX_INPROC_SERVER, __uuidof(ICatInformation),
        reinterpret_cast<void **>(catalog.GetAddressOf()));
    CATID id;
    CLSIDFromString(category, &id);
    ComPtr<IEnumCLSID> classes;
    if (!catalog || FAILED(catalog->EnumClassesOfCategories(1, &id, 0, nullptr, classes.GetAddressOf())))
        return false;
    CLSID found;
    for (ULONG fetched = 0; classes->Next(1, &found, &fetched) == S_OK && fetched == 1;) {
        if (IsEqualCLSID(found, wanted))
            return true;
    }
    return false;
}

std::wstring sentence(IOPCServer *server, HRESULT code, LCID locale)
{
    AllocatedText text;
    server->GetErrorString(code, locale, &text);
    return text ? text.get() : L"";
}

void testStatus(IOPCServer *server)
{
    Allocated<OPCSERVERSTATUS> status;
    checkResult("status", S_OK, server->GetStatus(&status));
    check("status.running", status && status[0].dwServerState == OPC_STATUS_RUNNING);
    checkNumber("status.groups", 0, status[0].dwGroupCount);
    checkText("status.vendor", L"Gorizont Server 9.8.7", status[0].szVendorInfo);
    check("status.times", status[0].ftCurrentTime.dwHighDateTime > 0 && status[0].ftStartTime.dwHighDateTime > 0);
    CoTaskMemFree(status[0].szVendorInfo);
}

void testSentences(IOPCServer *server)
{
    const HRESULT unknownItem = static_cast<HRESULT>(0xC0040007);
    checkText("sentence.english", L"There is no item of this name.", sentence(server, unknownItem, 0x0409).c_str());
    checkText("sentence.russian", L"Элемента с таким именем нет.", sentence(server, unknownItem, 0x0419).c_str());
    check("sentence.system", !sentence(server, E_OUTOFMEMORY, 0x0409).empty());
    AllocatedText text;
    checkResult("sentence.locale", E_INVALIDARG, server->GetErrorString(unknownItem, 0x0411, &text));

    const auto common = as<IOPCCommon>(server);
    check("common", common != nullptr);
    Allocated<LCID> locales;
    DWORD count = 0;
    checkResult("locales", S_OK, common->QueryAvailableLocaleIDs(&count, &locales));
    check(
        "locales.both",
        std::count(locales.get(), locales.get() + count, 0x0409u) == 1
            && std::count(locales.get(), locales.get() + count, 0x0419u) == 1);
    checkResult("locale.set", S_OK, common->SetLocaleID(0x0419));
    LCID locale = 0;
    common->GetLocaleID(&locale);
    checkNumber("locale.get", 0x0419, locale);
    AllocatedText russian;
    checkResult("common.sentence", S_OK, common->GetErrorString(unknownItem, &russian));
    checkText("common.sentence.text", L"Элемента с таким именем нет.", russian.get());
    checkResult("locale.unknown", E_INVALIDARG, common->SetLocaleID(0x0411));
    checkResult("clientname", S_OK, common->SetClientName(L"проба"));
}

void testGroupList(IOPCServer *server)
{
    const auto first = addGroup(server, L"Первая", 100);
    checkResult("group.add", S_OK, first.result);
    const auto second = addGroup(server, L"", 130);
    checkResult("group.rate.unsupported", static_cast<HRESULT>(0x0004000D), second.result);
    checkNumber("group.rate.revised", 150, second.rate);
    checkResult("group.duplicate", static_cast<HRESULT>(0xC004000C), addGroup(server, L"Первая").result);
    checkResult("group.deadband.wrong", E_INVALIDARG, addGroup(server, L"x", 100, true, 101).result);
    ComPtr<IUnknown> found;
    checkResult(
        "group.byname", S_OK, server->GetGroupByName(L"Первая", __uuidof(IOPCGroupStateMgt), found.GetAddressOf()));
    check(
        "group.byname.missing",
        FAILED(server->GetGroupByName(L"нет", __uuidof(IUnknown), found.ReleaseAndGetAddressOf())));

    ComPtr<IUnknown> list;
    checkResult(
        "groups.names", S_OK, server->CreateGroupEnumerator(OPC_ENUM_ALL, __uuidof(IEnumString), list.GetAddressOf()));
    const auto names = stringsOf(as<IEnumString>(list.Get()).Get());
    check("groups.names.all", names.size() == 2 && std::count(names.begin(), names.end(), L"Первая") == 1);
    checkResult(
        "groups.objects", S_OK,
        server->CreateGroupEnumerator(OPC_ENUM_PRIVATE, __uuidof(IEnumUnknown), list.ReleaseAndGetAddressOf()));
    const auto objects = as<IEnumUnknown>(list.Get());
    IUnknown *group = nullptr;
    ULONG fetched = 0;
    checkResult("groups.objects.next", S_OK, objects->Next(1, &group, &fetched));
    check("groups.objects.group", fetched == 1 && as<IOPCItemMgt>(group));
    if (group)
        group->Release();
    checkResult("groups.skip", S_OK, objects->Skip(1));
    checkResult("groups.end", S_FALSE, objects->Next(1, &group, &fetched));
    checkResult(
        "groups.public", S_FALSE,
        server->CreateGroupEnumerator(OPC_ENUM_PUBLIC, __uuidof(IEnumUnknown), list.ReleaseAndGetAddressOf()));

    auto released = addGroup(server, L"освобождённая");
    {
        Subscription subscription(released.items.Get());
        subscription.unadvise();
    }
    released.items.Reset();
    checkResult("group.remove.released", S_OK, server->RemoveGroup(released.handle, FALSE));
    checkResult("group.remove.inuse", static_cast<HRESULT>(0x0004000F), server->RemoveGroup(second.handle, FALSE));
    checkResult("group.remove.gone", static_cast<HRESULT>(0xC0040001), server->RemoveGroup(second.handle, FALSE));
    checkResult("group.remove.forced", S_OK, server->RemoveGroup(first.handle, TRUE));
    check("group.removed", FAILED(as<IOPCGroupStateMgt>(first.items.Get())->SetName(L"y")));
}

} // namespace

void testRegistry()
{
    CLSID clsid{};
    checkResult("progid", S_OK, CLSIDFromProgID(L"OPC.DA.GorizontServer", &clsid));
    check("category.2.0", isInCategory(L"{63D5F432-CFE4-11D1-B2C8-0060083BA1FB}", clsid));
    check("category.3.0", isInCategory(L"{CC603642-66D7-48F1-B69A-B625E73652D7}", clsid));
    check("category.1.0.absent", !isInCategory(L"{63D5F430-CFE4-11D1-B2C8-0060083BA1FB}", clsid));
}

void testServer()
{
    HRESULT result = E_FAIL;
    const auto server = connected(&result);
    checkResult("activation", S_OK, result);
    if (!server)
        return;
    check(
        "server.interfaces",
        as<IOPCCommon>(server.Get()) && as<IConnectionPointContainer>(server.Get())
            && as<IOPCBrowseServerAddressSpace>(server.Get()) && as<IOPCItemProperties>(server.Get())
            && as<IOPCBrowse>(server.Get()) && as<IOPCItemIO>(server.Get()));
    testStatus(server.Get());
    testSentences(server.Get());
    testGroupList(server.Get());
}

} // namespace opctest
