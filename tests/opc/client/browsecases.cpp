#include "tests/opc/client/cases.h"
#include "tests/opc/client/opcclient.h"

#include <algorithm>

namespace opctest {

namespace {

std::vector<std::wstring> browsed(
    IOPCBrowseServerAddressSpace *space, OPCBROWSETYPE kind, const wchar_t *filter = L"", VARTYPE type = VT_EMPTY,
    DWORD rights = 0, HRESULT *result = nullptr)
{
    ComPtr<IEnumString> names;
    const HRESULT code = space->BrowseOPCItemIDs(kind, filter, type, rights, names.GetAddressOf());
    if (result)
        *result = code;
    return stringsOf(names.Get());
}

using Names = std::vector<std::wstring>;

void testTree(IOPCBrowseServerAddressSpace *space)
{
    OPCNAMESPACETYPE organization{};
    space->QueryOrganization(&organization);
    check("browse.hierarchical", organization == OPC_NS_HIERARCHIAL);
    check(
        "browse.root",
        browsed(space, OPC_BRANCH) == Names{L"OPCGate", L"[COM5]", L"[COM16]", L"[tcp://10.0.0.7:502]", L"[SIM]"});
    check("browse.root.noleaves", browsed(space, OPC_LEAF).empty());
    checkResult("browse.down", S_OK, space->ChangeBrowsePosition(OPC_BROWSE_DOWN, L"[tcp://10.0.0.7:502]"));
    check("browse.dots", browsed(space, OPC_BRANCH) == Names{L"Sensor_003[AND3][Addr:001]"});
    checkResult("browse.down.missing", E_INVALIDARG, space->ChangeBrowsePosition(OPC_BROWSE_DOWN, L"нет"));
    checkResult("browse.to", S_OK, space->ChangeBrowsePosition(OPC_BROWSE_TO, (And3 + L".DATA").c_str()));
    check(
        "browse.leaves",
        browsed(space, OPC_LEAF)
            == Names{L"Angl_X", L"Angl_Y", L"AMax_X", L"AMax_Y", L"ARms_X", L"ARms_Y", L"Temper", L"8_Reserv"});
    check("browse.filter", browsed(space, OPC_LEAF, L"A*_[X]") == Names{L"Angl_X", L"AMax_X", L"ARms_X"});
    HRESULT result = E_FAIL;
    check("browse.type", browsed(space, OPC_LEAF, L"", VT_BOOL, 0, &result).empty());
    checkResult("browse.type.empty", S_FALSE, result);
    check("browse.type.same", browsed(space, OPC_LEAF, L"", VT_R8).size() == 8);
    check("browse.writeable", browsed(space, OPC_LEAF, L"", VT_EMPTY, 2).empty());
    check("browse.readable", browsed(space, OPC_LEAF, L"", VT_EMPTY, 1).size() == 8);
    AllocatedText id;
    wchar_t leaf[] = L"Angl_X";
    checkResult("browse.itemid", S_OK, space->GetItemID(leaf, &id));
    checkText("browse.itemid.text", And3 + L".DATA.Angl_X", id.get());
    wchar_t nothing[] = L"Angl_Z";
    AllocatedText none;
    check("browse.itemid.missing", FAILED(space->GetItemID(nothing, &none)) && !none);
    checkResult("browse.up", S_OK, space->ChangeBrowsePosition(OPC_BROWSE_UP, L""));
    check("browse.up.there", browsed(space, OPC_BRANCH) == Names{L"STATE", L"DATA"});
    checkResult("browse.to.root", S_OK, space->ChangeBrowsePosition(OPC_BROWSE_TO, L""));
    check("browse.up.root", FAILED(space->ChangeBrowsePosition(OPC_BROWSE_UP, L"")));
    const Names flat = browsed(space, OPC_FLAT);
    checkNumber("browse.flat", 2 + 48 + Bulk, static_cast<double>(flat.size()));
    check("browse.flat.names", std::count(flat.begin(), flat.end(), Net + L".STATE.TRangErr") == 1);
    check("browse.flat.bools", browsed(space, OPC_FLAT, L"", VT_BOOL).size() == 2 + 24);
    ComPtr<IEnumString> paths;
    checkResult("browse.paths", E_NOTIMPL, space->BrowseAccessPaths(L"", paths.GetAddressOf()));
}

void testProperties(IOPCItemProperties *item)
{
    std::wstring id = And3 + L".DATA.Angl_X";
    DWORD count = 0;
    Allocated<DWORD> numbers;
    Allocated<LPWSTR> names;
    Allocated<VARTYPE> types;
    checkResult("properties", S_OK, item->QueryAvailableProperties(id.data(), &count, &numbers, &names, &types));
    check("properties.count", count == 11 && numbers[0] == 1 && types[0] == VT_I2 && names[10]);
    for (DWORD i = 0; i < count; ++i)
        CoTaskMemFree(names[i]);
    DWORD wanted[] = {1, 2, 3, 4, 5, 100, 101, 102, 103, 5555};
    Allocated<VARIANT> values;
    Allocated<HRESULT> errors;
    checkResult("properties.values", S_FALSE, item->GetItemProperties(id.data(), 10, wanted, &values, &errors));
    checkNumber("property.type", VT_R8, values[0].iVal);
    checkNumber("property.value", -3599.5, values[1].dblVal);
    checkNumber("property.quality", 192, values[2].iVal);
    // 4 April 2018 12:50:51.330 is 43194 days after 30 December 1899 and 46251.33 s
    check("property.time", values[3].vt == VT_DATE && std::abs(values[3].date - (43194 + 46251.33 / 86400)) < 1e-7);
    checkNumber("property.rights", 1, values[4].lVal);
    checkText("property.unit", L"″", values[5].bstrVal);
    checkText("property.description", L"Angl_X датчика", values[6].bstrVal);
    checkNumber("property.high", 3600, values[7].dblVal);
    checkNumber("property.low", -3600, values[8].dblVal);
    checkResult("property.unknown", static_cast<HRESULT>(0xC0040203), errors[9]);
    Allocated<LPWSTR> ids;
    Allocated<HRESULT> codes;
    checkResult("properties.lookup", S_FALSE, item->LookupItemIDs(id.data(), 1, wanted, &ids, &codes));
    checkResult("properties.lookup.code", static_cast<HRESULT>(0xC0040203), codes[0]);
    std::wstring missing = L"[COM9].x";
    checkResult(
        "properties.missing", static_cast<HRESULT>(0xC0040007),
        item->GetItemProperties(missing.data(), 1, wanted, &values, &errors));
}

void testBrowse3(IOPCBrowse *browse)
{
    std::wstring root;
    std::wstring place = And3 + L".DATA";
    std::wstring filter;
    BOOL isMore = FALSE;
    DWORD count = 0;
    const auto ask = [&](std::wstring &where, LPWSTR *next, DWORD most, OPCBROWSEFILTER kind,
                         Allocated<OPCBROWSEELEMENT> &found) {
        DWORD property = 2;
        return browse->Browse(
            where.data(), next, most, kind, filter.data(), filter.data(), FALSE, TRUE, 1, &property, &isMore, &count,
            &found);
    };
    auto *next = static_cast<wchar_t *>(CoTaskMemAlloc(sizeof(wchar_t)));
    *next = 0;
    Allocated<OPCBROWSEELEMENT> first;
    checkResult("browse3", S_OK, ask(place, &next, 3, OPC_BROWSE_FILTER_ALL, first));
    check("browse3.page", count == 3 && next && *next);
    checkText("browse3.name", L"Angl_X", first[0].szName);
    checkText("browse3.id", place + L".Angl_X", first[0].szItemID);
    checkNumber("browse3.flags", 2, first[0].dwFlagValue);
    check(
        "browse3.property",
        first[0].ItemProperties.dwNumProperties == 1
            && first[0].ItemProperties.pItemProperties[0].vValue.dblVal == -3599.5);
    Allocated<OPCBROWSEELEMENT> rest;
    checkResult("browse3.rest", S_OK, ask(place, &next, 0, OPC_BROWSE_FILTER_ALL, rest));
    check("browse3.rest.count", count == 5 && next && !*next);
    checkText("browse3.rest.name", L"AMax_Y", rest[0].szName);
    Allocated<OPCBROWSEELEMENT> branches;
    checkResult("browse3.root", S_OK, ask(root, &next, 0, OPC_BROWSE_FILTER_BRANCHES, branches));
    check("browse3.root.branches", count == 5 && branches[1].dwFlagValue == 1);
    checkText("browse3.root.id", L"[COM5]", branches[1].szItemID);
    CoTaskMemFree(next);
    next = static_cast<wchar_t *>(CoTaskMemAlloc(sizeof(L"xyz")));
    wcscpy(next, L"xyz");
    Allocated<OPCBROWSEELEMENT> none;
    checkResult(
        "browse3.continuation", static_cast<HRESULT>(0xC0040403), ask(place, &next, 0, OPC_BROWSE_FILTER_ALL, none));
    std::wstring missing = L"[COM9]";
    *next = 0;
    checkResult(
        "browse3.missing", static_cast<HRESULT>(0xC0040007), ask(missing, &next, 0, OPC_BROWSE_FILTER_ALL, none));
    CoTaskMemFree(next);

    std::wstring known = And3 + L".STATE.Restart";
    LPWSTR ids[] = {known.data(), missing.data()};
    Allocated<OPCITEMPROPERTIES> properties;
    DWORD unused = 0;
    checkResult("properties3", S_FALSE, browse->GetProperties(2, ids, TRUE, 0, &unused, &properties));
    check(
        "properties3.known",
        properties[0].dwNumProperties == 8 && properties[0].pItemProperties[1].vValue.vt == VT_BOOL);
    checkResult("properties3.missing", static_cast<HRESULT>(0xC0040007), properties[1].hrErrorID);
}

void testItemIO(IOPCItemIO *io)
{
    const std::wstring good = And3 + L".DATA.Temper";
    const std::wstring alias = And3 + L".STATUS.ReadyTmpr";
    LPCWSTR ids[] = {good.c_str(), alias.c_str(), L"a..b", L"[COM9].x"};
    DWORD ages[] = {0, 0xFFFFFFFF, 0, 0};
    Allocated<VARIANT> values;
    Allocated<WORD> qualities;
    Allocated<FILETIME> times;
    Allocated<HRESULT> errors;
    checkResult("itemio.read", S_FALSE, io->Read(4, ids, ages, &values, &qualities, &times, &errors));
    checkNumber("itemio.value", 26.448, values[0].dblVal);
    check("itemio.alias", values[1].vt == VT_BOOL && values[1].boolVal == VARIANT_TRUE && qualities[1] == 192);
    checkResult("itemio.malformed", static_cast<HRESULT>(0xC0040008), errors[2]);
    checkResult("itemio.unknown", static_cast<HRESULT>(0xC0040007), errors[3]);
    OPCITEMVQT written[2]{};
    Allocated<HRESULT> refused;
    checkResult("itemio.write", S_FALSE, io->WriteVQT(2, ids, written, &refused));
    checkResult("itemio.write.rights", static_cast<HRESULT>(0xC0040006), refused[0]);
}

} // namespace

void testBrowsing()
{
    const auto server = connected();
    check("browsing.server", server != nullptr);
    if (!server)
        return;
    testTree(as<IOPCBrowseServerAddressSpace>(server.Get()).Get());
    testProperties(as<IOPCItemProperties>(server.Get()).Get());
    testBrowse3(as<IOPCBrowse>(server.Get()).Get());
    testItemIO(as<IOPCItemIO>(server.Get()).Get());
}

} // namespace opctest
