#include "tests/opc/client/cases.h"
#include "tests/opc/client/listener.h"

namespace opctest {

/// Against the program itself on a simulated line: the names, that values come with a good quality and a time of today, and
/// that they move. The tree is the one of figure 11.4.
void testChain()
{
    const auto server = connected();
    const auto group = server ? addGroup(server.Get(), L"chain", 100) : AddedGroup();
    check("chain.group", group.items != nullptr);
    if (!group.items)
        return;
    ComPtr<IEnumString> names;
    as<IOPCBrowseServerAddressSpace>(server.Get())->BrowseOPCItemIDs(OPC_FLAT, L"", VT_EMPTY, 0, names.GetAddressOf());
    std::wstring angle;
    std::wstring flag;
    for (const std::wstring &name : stringsOf(names.Get())) {
        if (angle.empty() && name.ends_with(L"[AND3][Addr:001].DATA.Angl_X"))
            angle = name;
        if (flag.empty() && name.ends_with(L"[AND3][Addr:001].STATE.ReadyAngl"))
            flag = name;
    }
    check("chain.names", angle.find(L"Sensor_001") != std::wstring::npos && !flag.empty());
    addItems(group.items.Get(), {angle, flag, L"OPCGate.Connection", L"OPCGate.TagsHashGood"});
    Subscription subscription(group.items.Get());
    Listener *listener = subscription.listener.Get();
    ReadItem item;
    check("chain.good", happens([&] { return listener->last(0, item) && item.quality == 0xC0; }, 60));
    check("chain.type", item.type == VT_R8);
    FILETIME now{};
    GetSystemTimeAsFileTime(&now);
    const auto ticks = [](const FILETIME &t) {
        return static_cast<double>(t.dwHighDateTime) * 4294967296.0 + t.dwLowDateTime;
    };
    check("chain.time", std::abs(ticks(now) - ticks(item.time)) < 60e7); // a minute in steps of 100 ns
    check("chain.flag", happens([&] {
              return listener->last(1, item) && item.type == VT_BOOL && item.quality == 0xC0;
          }));
    check("chain.connection", happens([&] { return listener->last(2, item) && item.number == 1; }));
    check("chain.hash", happens([&] { return listener->last(3, item) && item.quality == 0xC0; }));
    const auto calls = listener->calls().size();
    check("chain.moves", happens([&] { return listener->calls().size() > calls; }, 60));
    ask("chain stop");
    check("chain.commfailure", happens([&] { return listener->last(0, item) && item.quality == 0x18; }, 60));
}

} // namespace opctest
