#include "tests/opc/client/cases.h"
#include "tests/opc/client/opcclient.h"

namespace opctest {

namespace {

constexpr auto InvalidHandle = static_cast<HRESULT>(0xC0040001);
constexpr auto BadType = static_cast<HRESULT>(0xC0040004);
constexpr auto BadRights = static_cast<HRESULT>(0xC0040006);

void testAdding(IOPCItemMgt *group)
{
    std::vector<HRESULT> errors;
    const auto handles = addItems(
        group,
        {And3 + L".DATA.Angl_X", And3 + L".DATA.Arms_Y", L"[COM9].x", std::wstring(), L"a..b", L"[COM5",
         And3 + L".DATA"},
        VT_EMPTY, &errors);
    check("items.number", errors.size() == 7);
    checkResult("items.add", S_OK, errors[0]);
    checkResult("items.add.alias", S_OK, errors[1]);
    checkResult("items.add.unknown", static_cast<HRESULT>(0xC0040007), errors[2]);
    checkResult("items.add.empty", static_cast<HRESULT>(0xC0040008), errors[3]);
    checkResult("items.add.malformed", static_cast<HRESULT>(0xC0040008), errors[4]);
    checkResult("items.add.bracket", static_cast<HRESULT>(0xC0040008), errors[5]);
    checkResult("items.add.branch", static_cast<HRESULT>(0xC0040007), errors[6]);

    OPCITEMDEF wanted[3] = {
        wantedItem(And3 + L".STATE.Restart"), wantedItem(And3 + L".STATE.Restart", 0, VT_UNKNOWN),
        wantedItem(And3 + L".STATE.Restart")};
    const std::wstring ids[3] = {And3 + L".STATE.Restart", And3 + L".STATE.Restart", And3 + L".STATE.Restart"};
    wchar_t path[] = L"COM5";
    for (int i = 0; i < 3; ++i)
        wanted[i].szItemID = const_cast<wchar_t *>(ids[i].c_str());
    wanted[2].szAccessPath = path;
    Allocated<OPCITEMRESULT> results;
    Allocated<HRESULT> codes;
    checkResult("items.validate", S_FALSE, group->ValidateItems(3, wanted, FALSE, &results, &codes));
    check(
        "items.validate.result",
        codes[0] == S_OK && results[0].vtCanonicalDataType == VT_BOOL && results[0].dwAccessRights == 1
            && results[0].hServer == 0);
    checkResult("items.validate.type", BadType, codes[1]);
    checkResult("items.validate.path", static_cast<HRESULT>(0xC004000A), codes[2]);

    OPCHANDLE removed[2] = {handles[1], 0xABCDEF};
    Allocated<HRESULT> gone;
    checkResult("items.remove", S_FALSE, group->RemoveItems(2, removed, &gone));
    check("items.remove.codes", gone[0] == S_OK && gone[1] == InvalidHandle);
    HRESULT result = E_FAIL;
    const auto left = readItems(group, {handles[0], handles[1]}, OPC_DS_CACHE, &result);
    checkResult("items.removed.read", S_FALSE, result);
    check("items.removed.codes", left[0].error == S_OK && left[1].error == InvalidHandle);
}

void testTypes(IOPCItemMgt *group)
{
    const auto typed = [group](const wchar_t *leaf, VARTYPE type) {
        const auto handles = addItems(group, {And3 + leaf}, type);
        return readItems(group, handles)[0];
    };
    const ReadItem natural = typed(L".DATA.Angl_X", VT_EMPTY);
    check("type.canonical", natural.type == VT_R8 && natural.number == -3599.5);
    const ReadItem single = typed(L".DATA.Angl_Y", VT_R4);
    check("type.r4", single.type == VT_R4 && single.number == 12.25);
    const ReadItem whole = typed(L".DATA.ARms_Y", VT_I4);
    check("type.i4", whole.type == VT_I4 && whole.number == 70000);
    const ReadItem flag = typed(L".STATE.Restart", VT_I2);
    check("type.bool.i2", flag.type == VT_I2 && flag.number == -1);
    const ReadItem text = typed(L".DATA.Angl_Y", VT_BSTR);
    checkText("type.bstr", L"12.25", text.text.c_str()); // the group's locale is English
    const ReadItem word = typed(L".STATE.ReadErr", VT_BSTR);
    checkText("type.bool.bstr", L"False", word.text.c_str());
    const ReadItem overflow = typed(L".DATA.ARms_Y", VT_I2);
    check("type.overflow", FAILED(overflow.error) && overflow.type == VT_EMPTY && overflow.quality == 0);
    std::vector<HRESULT> errors;
    addItems(group, {And3 + L".DATA.Angl_X"}, VT_ARRAY | VT_R8, &errors);
    checkResult("type.array", BadType, errors[0]);

    auto handles = addItems(group, {And3 + L".DATA.Angl_Y", And3 + L".DATA.Angl_Y"});
    VARTYPE types[2] = {VT_I4, VT_DISPATCH};
    Allocated<HRESULT> codes;
    checkResult("type.set", S_FALSE, group->SetDatatypes(2, handles.data(), types, &codes));
    check("type.set.codes", codes[0] == S_OK && codes[1] == BadType);
    check("type.set.read", readItems(group, handles)[0].type == VT_I4);
}

void testHandles(IOPCItemMgt *group)
{
    auto handles = addItems(group, {And3 + L".DATA.Angl_Y"});
    OPCHANDLE clients[] = {4711};
    Allocated<HRESULT> codes;
    checkResult("handles.set", S_OK, group->SetClientHandles(1, handles.data(), clients, &codes));
    checkNumber("handles.client", 4711, readItems(group, handles)[0].client);
    Allocated<HRESULT> inactive;
    checkResult("active.set", S_OK, group->SetActiveState(1, handles.data(), FALSE, &inactive));
    checkNumber("active.cache", 0x1C, readItems(group, handles)[0].quality);
    checkNumber("active.device", 0xC0, readItems(group, handles, OPC_DS_DEVICE)[0].quality);
    ComPtr<IUnknown> list;
    checkResult("attributes", S_OK, group->CreateEnumerator(__uuidof(IEnumOPCItemAttributes), list.GetAddressOf()));
    const auto items = as<IEnumOPCItemAttributes>(list.Get());
    Allocated<OPCITEMATTRIBUTES> attributes;
    ULONG fetched = 0;
    checkResult("attributes.next", S_FALSE, items->Next(100, &attributes, &fetched));
    check("attributes.number", fetched > 5);
    const OPCITEMATTRIBUTES &last = attributes[fetched - 1];
    checkText("attributes.id", And3 + L".DATA.Angl_Y", last.szItemID);
    check(
        "attributes.values",
        last.hClient == 4711 && last.hServer == handles[0] && !last.bActive && last.dwAccessRights == 1
            && last.vtCanonicalDataType == VT_R8);
    check("attributes.range", last.dwEUType == OPC_ANALOG && last.vEUInfo.vt == (VT_ARRAY | VT_R8));
    ComPtr<IEnumOPCItemAttributes> copy;
    checkResult("attributes.clone", S_OK, items->Clone(copy.GetAddressOf()));
    Allocated<OPCITEMATTRIBUTES> none;
    checkResult("attributes.end", S_FALSE, copy->Next(1, &none, &fetched));
    checkResult("attributes.reset", S_OK, copy->Reset());
    checkResult("attributes.skip", S_OK, copy->Skip(2));
    checkResult("attributes.skip.far", S_FALSE, copy->Skip(1000));
}

void testDeadbandMethods(IOPCItemMgt *group)
{
    const auto deadbands = as<IOPCItemDeadbandMgt>(group);
    check("deadband.interface", deadbands != nullptr);
    auto handles = addItems(group, {And3 + L".DATA.Angl_X", And3 + L".STATE.Restart"});
    FLOAT percents[2] = {10, 10};
    Allocated<HRESULT> set;
    checkResult("deadband.set", S_FALSE, deadbands->SetItemDeadband(2, handles.data(), percents, &set));
    check("deadband.set.codes", set[0] == S_OK && set[1] == static_cast<HRESULT>(0xC0040401));
    Allocated<FLOAT> got;
    Allocated<HRESULT> codes;
    checkResult("deadband.get", S_OK, deadbands->GetItemDeadband(1, handles.data(), &got, &codes));
    checkNumber("deadband.percent", 10, static_cast<double>(got[0]));
    Allocated<HRESULT> cleared;
    checkResult("deadband.clear", S_OK, deadbands->ClearItemDeadband(1, handles.data(), &cleared));
    Allocated<HRESULT> again;
    deadbands->ClearItemDeadband(1, handles.data(), &again);
    checkResult("deadband.notset", static_cast<HRESULT>(0xC0040400), again[0]);
}

void testArguments(IOPCItemMgt *group)
{
    OPCITEMDEF item = wantedItem(And3 + L".DATA.Angl_X");
    Allocated<OPCITEMRESULT> results;
    Allocated<HRESULT> codes;
    checkResult("arguments.none", E_INVALIDARG, group->AddItems(0, &item, &results, &codes));
    const auto io = as<IOPCSyncIO>(group);
    auto handles = addItems(group, {And3 + L".DATA.Angl_X"});
    VARIANT value{};
    value.vt = VT_R8;
    Allocated<HRESULT> refused;
    checkResult("write", S_FALSE, io->Write(1, handles.data(), &value, &refused));
    checkResult("write.rights", BadRights, refused[0]);
    OPCHANDLE wrong = 0xABCDEF;
    Allocated<HRESULT> unknown;
    checkResult("write.handle", S_FALSE, io->Write(1, &wrong, &value, &unknown));
    checkResult("write.handle.code", InvalidHandle, unknown[0]);
}

} // namespace

void testItems()
{
    const auto server = connected();
    const auto group = server ? addGroup(server.Get(), L"items") : AddedGroup();
    check("items.group", group.items != nullptr);
    if (!group.items)
        return;
    testAdding(group.items.Get());
    testTypes(group.items.Get());
    testHandles(group.items.Get());
    testDeadbandMethods(group.items.Get());
    testArguments(group.items.Get());
}

void testReading()
{
    const auto server = connected();
    const auto group = server ? addGroup(server.Get(), L"reading") : AddedGroup();
    check("reading.group", group.items != nullptr);
    if (!group.items)
        return;
    const auto handles = addItems(
        group.items.Get(),
        {And3 + L".DATA.Angl_Y", And3 + L".STATE.Restart", Ind3 + L".DATA.Angl_X", Net + L".DATA.Angl_Y",
         Net + L".DATA.Temper", Net + L".DATA.8_Reserv", L"OPCGate.Connection", L"OPCGate.TagsHashGood"});
    const auto items = readItems(group.items.Get(), handles);
    SYSTEMTIME moment{2018, 4, 0, 4, 12, 50, 51, 330};
    FILETIME time{};
    SystemTimeToFileTime(&moment, &time);
    check("read.value", items[0].error == S_OK && items[0].number == 12.25 && items[0].quality == 192);
    check("read.time", CompareFileTime(&items[0].time, &time) == 0);
    check("read.bool", items[1].type == VT_BOOL && items[1].number == 1);
    check("read.notconnected", items[2].type == VT_EMPTY && items[2].quality == 0x08);
    check("read.lastknown", items[3].number == 12.25 && items[3].quality == 0x14);
    check("read.outofservice", items[4].quality == 0x1C);
    check("read.waiting", items[5].quality == 0x20);
    check("read.connection", items[6].number == 1 && items[6].quality == 192);
    check("read.hash", items[7].number == 1 && items[7].quality == 192);
    const auto io = as<IOPCSyncIO2>(group.items.Get());
    check("reading.syncio2", io != nullptr);
    std::vector<OPCHANDLE> two{handles[0], 0xABCDEF};
    DWORD ages[2] = {0, 0};
    Allocated<VARIANT> values;
    Allocated<WORD> qualities;
    Allocated<FILETIME> times;
    Allocated<HRESULT> errors;
    checkResult("maxage", S_FALSE, io->ReadMaxAge(2, two.data(), ages, &values, &qualities, &times, &errors));
    check("maxage.value", values[0].dblVal == 12.25 && qualities[0] == 192 && CompareFileTime(times.get(), &time) == 0);
    checkResult("maxage.handle", static_cast<HRESULT>(0xC0040001), errors[1]);
    OPCITEMVQT written{};
    Allocated<HRESULT> refused;
    checkResult("writevqt", S_FALSE, io->WriteVQT(1, two.data(), &written, &refused));
    checkResult("writevqt.rights", static_cast<HRESULT>(0xC0040006), refused[0]);
}

} // namespace opctest
