#include "tests/opc/client/cases.h"
#include "tests/opc/client/listener.h"

namespace opctest {

namespace {

/// Against a group that was set to 50 ms, a bias of -180 and the client handle 99.
void testClone(IOPCItemMgt *group)
{
    const auto state = as<IOPCGroupStateMgt>(group);
    DWORD revised = 0;
    const auto handles = addItems(group, {And3 + L".DATA.Angl_Y", And3 + L".STATE.Restart"}, VT_R4);
    ComPtr<IUnknown> unknown;
    checkResult(
        "clone.taken", static_cast<HRESULT>(0xC004000C),
        state->CloneGroup(L"другая", __uuidof(IOPCItemMgt), unknown.GetAddressOf()));
    checkResult("clone", S_OK, state->CloneGroup(L"клон", __uuidof(IOPCItemMgt), unknown.ReleaseAndGetAddressOf()));
    const auto clone = as<IOPCItemMgt>(unknown.Get());
    const State copied(as<IOPCGroupStateMgt>(clone.Get()).Get());
    checkText("clone.name", L"клон", copied.name.get());
    check("clone.state", copied.rate == 50 && !copied.isActive && copied.client == 99 && copied.bias == -180);
    ComPtr<IUnknown> list;
    clone->CreateEnumerator(__uuidof(IEnumOPCItemAttributes), list.GetAddressOf());
    Allocated<OPCITEMATTRIBUTES> items;
    ULONG fetched = 0;
    as<IEnumOPCItemAttributes>(list.Get())->Next(10, &items, &fetched);
    check("clone.items", fetched == 2 && items[0].vtRequestedDataType == VT_R4 && items[0].hServer != handles[0]);
    checkNumber("clone.inactive", 0x1C, readItems(clone.Get(), {items[0].hServer})[0].quality);
    BOOL isActive = TRUE;
    as<IOPCGroupStateMgt>(clone.Get())->SetState(nullptr, &revised, &isActive, nullptr, nullptr, nullptr, nullptr);
    const ReadItem value = readItems(clone.Get(), {items[0].hServer})[0];
    check("clone.active", value.quality == 0xC0 && value.type == VT_R4 && value.number == 12.25);
}

} // namespace

void testState()
{
    const auto server = connected();
    const auto group = server ? addGroup(server.Get(), L"Состояние", 250, true, 5) : AddedGroup();
    check("state.group", group.items != nullptr);
    if (!group.items)
        return;
    const auto state = as<IOPCGroupStateMgt>(group.items.Get());
    const State before(state.Get());
    checkText("state.name", L"Состояние", before.name.get());
    check(
        "state.values",
        before.rate == 250 && before.isActive && before.deadband == 5 && before.locale == 0x0409 && before.client == 77
            && before.server == group.handle);

    DWORD rate = 7;
    DWORD revised = 0;
    LONG bias = -180;
    FLOAT deadband = 200;
    OPCHANDLE client = 99;
    checkResult(
        "state.deadband.wrong", E_INVALIDARG,
        state->SetState(nullptr, &revised, nullptr, nullptr, &deadband, nullptr, nullptr));
    checkResult(
        "state.set", static_cast<HRESULT>(0x0004000D),
        state->SetState(&rate, &revised, nullptr, &bias, nullptr, nullptr, &client));
    checkNumber("state.revised", 50, revised);
    const State after(state.Get());
    check("state.changed", after.rate == 50 && after.bias == -180 && after.client == 99 && after.deadband == 5);

    const auto other = addGroup(server.Get(), L"другая");
    checkResult("state.name.taken", static_cast<HRESULT>(0xC004000C), state->SetName(L"другая"));
    checkResult("state.name.same", S_OK, state->SetName(L"Состояние"));
    checkResult("state.rename", S_OK, state->SetName(L"Новое имя"));
    checkText("state.renamed", L"Новое имя", State(state.Get()).name.get());

    testClone(group.items.Get());
}

} // namespace opctest
