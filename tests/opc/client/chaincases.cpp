#include "tests/opc/client/cases.h"
#include "tests/opc/client/listener.h"

#include <cstdio>

namespace opctest {

namespace {

constexpr auto Sensor = L"[COM10].Sensor_001[AND3][Addr:001]"; // the first one of the manual's annex

/// Milliseconds since 1970, of whole steps.
long long unixTime(const FILETIME &time)
{
    const auto ticks = static_cast<long long>(time.dwHighDateTime) << 32 | time.dwLowDateTime;
    return ticks / 10000 - 11644473600000;
}

std::string told(const ReadItem &item)
{
    char text[80];
    std::snprintf(text, sizeof(text), "told %.17g %lld", item.number, unixTime(item.time));
    return text;
}

} // namespace

/// Against the program itself on simulated lines: the tree, that values come and move, and what happens when it goes.
void testChain()
{
    const auto server = connected();
    const auto group = server ? addGroup(server.Get(), L"chain", 100) : AddedGroup();
    check("chain.group", group.items != nullptr);
    if (!group.items)
        return;
    ComPtr<IEnumString> names;
    const auto space = as<IOPCBrowseServerAddressSpace>(server.Get());
    space->ChangeBrowsePosition(OPC_BROWSE_TO, (std::wstring(Sensor) + L".DATA").c_str());
    space->BrowseOPCItemIDs(OPC_LEAF, L"", VT_EMPTY, 0, names.GetAddressOf());
    check(
        "chain.tree",
        stringsOf(names.Get())
            == std::vector<std::wstring>{
                L"Angl_X", L"Angl_Y", L"AMax_X", L"AMax_Y", L"ARms_X", L"ARms_Y", L"Temper", L"8_Reserv"});
    addItems(
        group.items.Get(),
        {std::wstring(Sensor) + L".DATA.Angl_X", std::wstring(Sensor) + L".STATUS.ReadyAngl", L"OPCGate.Connection",
         L"OPCGate.TagsHashGood"});
    Subscription subscription(group.items.Get());
    Listener *listener = subscription.listener.Get();
    ReadItem item;
    const auto hasQuality = [&](OPCHANDLE client, WORD quality) {
        return listener->last(client, item) && item.quality == quality;
    };
    check("chain.flag", happens([&] { return hasQuality(1, 0xC0) && item.type == VT_BOOL; }, 60));
    check("chain.connection", happens([&] { return listener->last(2, item) && item.number == 1; }));
    check("chain.hash", happens([&] { return listener->last(3, item) && item.number == 1 && item.quality == 0xC0; }));
    check("chain.good", happens([&] { return hasQuality(0, 0xC0) && item.type == VT_R8; }, 60));
    for (int i = 0; i < 3; ++i) {
        const double before = item.number;
        check("chain.moves", happens([&] { return listener->last(0, item) && item.number != before; }, 60));
        ask(told(item));
    }
    ask("program kill");
    check("chain.gone", happens([&] { return hasQuality(0, 0x18); }, 60));
    check("chain.connection.gone", happens([&] { return listener->last(2, item) && item.number == 0; }));
    ask("program start");
    check("chain.back", happens([&] { return hasQuality(0, 0xC0); }, 120));
    ask("program end");
    check("chain.end", happens([] { return processesOf(L"gorizont-opc-da.exe").empty(); }, 60));
}

/// The program does not run, but its list of tags was registered.
void testListAlone()
{
    const auto server = connected();
    const auto group = server ? addGroup(server.Get(), L"alone", 100) : AddedGroup();
    check("alone.group", group.items != nullptr);
    if (!group.items)
        return;
    std::vector<HRESULT> errors;
    const auto handles =
        addItems(group.items.Get(), {std::wstring(Sensor) + L".DATA.Angl_X", L"OPCGate.Connection"}, VT_EMPTY, &errors);
    check("alone.added", errors == std::vector<HRESULT>{S_OK, S_OK});
    const auto items = readItems(group.items.Get(), handles);
    check("alone.quality", items[0].quality == 0x18 && items[0].type == VT_EMPTY);
    check("alone.connection", items[1].quality == 0xC0 && items[1].number == 0);
}

} // namespace opctest
