#include "tests/opc/client/cases.h"
#include "tests/opc/client/listener.h"

#include <psapi.h>

namespace opctest {

namespace {

double seconds()
{
    return static_cast<double>(GetTickCount64()) / 1000;
}

/// Private bytes of the gateway in KiB.
double gatewayMemory()
{
    const auto ids = processesOf(L"gorizont-opc-da.exe");
    if (ids.empty())
        return 0;
    const HANDLE process = OpenProcess(PROCESS_QUERY_INFORMATION | PROCESS_VM_READ, FALSE, ids.front());
    PROCESS_MEMORY_COUNTERS counters{};
    GetProcessMemoryInfo(process, &counters, sizeof(counters));
    CloseHandle(process);
    return static_cast<double>(counters.PagefileUsage) / 1024;
}

void benchChanges(IOPCServer *server)
{
    const auto group = addGroup(server, L"changes", 100);
    std::vector<std::wstring> names;
    for (int i = 1; i <= Bulk; ++i)
        names.push_back(bulkName(i));
    addItems(group.items.Get(), names);
    Subscription subscription(group.items.Get());
    Listener *listener = subscription.listener.Get();
    listener->keepsCalls = false;
    happens([&] { return listener->values >= Bulk; });
    constexpr int Rounds = 100;
    const long long before = listener->values;
    const double start = seconds();
    ask("load 0.1 " + std::to_string(Rounds));
    ReadItem item;
    const bool isComplete = happens(
        [&] {
            for (OPCHANDLE i = 0; i < Bulk; ++i) {
                if (!listener->last(i, item) || item.number != Rounds)
                    return false;
            }
            return true;
        },
        120);
    const double took = seconds() - start;
    const auto told = static_cast<double>(listener->values - before);
    check("bench.changes.last", isComplete);
    note(
        "changes: " + std::to_string(told / took) + " a second reached the client, " + std::to_string(told) + " of "
        + std::to_string(Rounds * Bulk) + " steps, the rest was overtaken by a newer step before its turn");
    subscription.unadvise();
}

void benchReads(IOPCServer *server)
{
    const auto group = addGroup(server, L"reads", 100);
    std::vector<std::wstring> names;
    for (int i = 1; i <= Bulk; ++i)
        names.push_back(bulkName(i));
    auto handles = addItems(group.items.Get(), names);
    for (const std::size_t size : {std::size_t{1}, std::size_t{10}, std::size_t{1000}}) {
        const std::vector<OPCHANDLE> some(handles.begin(), handles.begin() + static_cast<std::ptrdiff_t>(size));
        const double start = seconds();
        int reads = 0;
        for (; seconds() < start + 3; ++reads)
            readItems(group.items.Get(), some);
        const double rate = reads / (seconds() - start);
        note(
            "reads of " + std::to_string(size) + " items: " + std::to_string(rate) + " calls a second, "
            + std::to_string(rate * static_cast<double>(size)) + " values a second");
    }
}

/// Each is a group with an item, cloned from one that stays, subscribed, left and removed. Cloned, because Wine 8 keeps the array
/// that every AddItems brings (48 bytes an item), which is told apart; and one of each kind stays, because Wine can wait for ever
/// when the last object of an interface goes in the moment in which a call of that interface ends.
void benchSubscriptions(IOPCServer *server, int count)
{
    const auto standing = addGroup(server, L"standing", 1000);
    const Subscription standingSubscription(standing.items.Get());
    addItems(standing.items.Get(), {And3 + L".DATA.Angl_X"});
    const auto original = as<IOPCGroupStateMgt>(standing.items.Get());
    double begun = 0;
    const int tenth = std::max(count / 10, 1);
    const double start = seconds();
    for (int i = 0; i < count; ++i) {
        if (i % tenth == 0)
            note("memory after " + std::to_string(i) + " subscriptions: " + std::to_string(gatewayMemory()) + " KiB");
        if (i == tenth)
            begun = gatewayMemory();
        ComPtr<IUnknown> clone;
        original->CloneGroup(L"", __uuidof(IOPCItemMgt), clone.GetAddressOf());
        const auto group = as<IOPCItemMgt>(clone.Get());
        const auto state = as<IOPCGroupStateMgt2>(group.Get());
        BOOL isActive = TRUE;
        DWORD rate = 0;
        state->SetState(nullptr, &rate, &isActive, nullptr, nullptr, nullptr, nullptr);
        Subscription subscription(group.Get());
        subscription.unadvise();
        server->RemoveGroup(State(state.Get()).server, TRUE);
    }
    const double end = gatewayMemory();
    note(
        "subscriptions: " + std::to_string(count) + " in " + std::to_string(seconds() - start)
        + " s; memory after a tenth " + std::to_string(begun) + " KiB, at the end " + std::to_string(end) + " KiB");
    check(
        "bench.memory", end <= begun + 2048); // the heap grows by 1 MiB at a time; a leak of 64 bytes would be 5.5 MiB

    OPCITEMDEF unknown = wantedItem(L"[COM9].x");
    std::wstring id = L"[COM9].x";
    unknown.szItemID = id.data();
    const int calls = tenth;
    for (int i = 0; i < calls; ++i) {
        Allocated<OPCITEMRESULT> results;
        Allocated<HRESULT> errors;
        standing.items->AddItems(1, &unknown, &results, &errors);
    }
    note(
        "AddItems that adds nothing: " + std::to_string((gatewayMemory() - end) * 1024 / calls) + " bytes a call stay");
}

} // namespace

void runBench()
{
    const auto server = connected();
    check("bench.server", server != nullptr);
    if (!server)
        return;
    benchChanges(server.Get());
    benchReads(server.Get());
    const wchar_t *wanted = _wgetenv(L"OPC_BENCH_SUBSCRIPTIONS");
    benchSubscriptions(server.Get(), wanted ? _wtoi(wanted) : 100000);
}

} // namespace opctest
