#include "tests/opc/client/cases.h"
#include "tests/opc/client/listener.h"

#include <algorithm>

namespace opctest {

namespace {

constexpr wchar_t Gateway[] = L"gorizont-opc-da.exe";

class ShutdownListener final : public Object<IOPCShutdown>
{
public:
    STDMETHODIMP ShutdownRequest(LPCWSTR said) override
    {
        const std::scoped_lock lock(m_mutex);
        m_reason = said;
        return S_OK;
    }
    std::wstring reason()
    {
        const std::scoped_lock lock(m_mutex);
        return m_reason;
    }

private:
    std::mutex m_mutex;
    std::wstring m_reason;
};

std::vector<std::wstring> bulkNames()
{
    std::vector<std::wstring> names;
    for (int i = 1; i <= Bulk; ++i)
        names.push_back(bulkName(i));
    return names;
}

bool isGatewayGone()
{
    return processesOf(Gateway).empty();
}

} // namespace

void testThousand()
{
    const auto server = connected();
    const auto group = server ? addGroup(server.Get(), L"thousand", 100) : AddedGroup();
    std::vector<HRESULT> errors;
    const auto handles =
        group.items ? addItems(group.items.Get(), bulkNames(), VT_EMPTY, &errors) : std::vector<OPCHANDLE>();
    check("thousand.added", handles.size() == Bulk && std::count(errors.begin(), errors.end(), S_OK) == Bulk);
    if (!group.items)
        return;
    Subscription subscription(group.items.Get());
    Listener *listener = subscription.listener.Get();
    ReadItem item;
    check("thousand.first", happens([&] { return listener->last(Bulk - 1, item); }));
    ask("load 0.02 150");
    const auto isAtEnd = [&](OPCHANDLE client) { return listener->last(client, item) && item.number == 150; };
    bool isOrdered = true;
    OPCHANDLE arrived = 0;
    while (arrived < Bulk && happens([&] { return isAtEnd(arrived); }))
        ++arrived;
    checkNumber("thousand.last", Bulk, arrived);
    std::vector<double> last(Bulk, -1);
    for (const Listener::Call &call : listener->calls()) {
        for (const auto &[client, value] : call.items) {
            isOrdered = isOrdered && value.number > last[client];
            last[client] = value.number;
        }
    }
    check("thousand.ordered", isOrdered);
    check("thousand.gathered", listener->calls().size() < 150, "more calls than the rate allows");
    const auto items = readItems(group.items.Get(), handles);
    check("thousand.read", std::all_of(items.begin(), items.end(), [](const ReadItem &i) { return i.number == 150; }));
}

void testOutage()
{
    const auto server = connected();
    const auto group = server ? addGroup(server.Get(), L"outage", 100) : AddedGroup();
    check("outage.group", group.items != nullptr);
    if (!group.items)
        return;
    addItems(group.items.Get(), {And3 + L".DATA.Angl_X", And3 + L".STATE.Restart", L"OPCGate.Connection"});
    Subscription subscription(group.items.Get());
    Listener *listener = subscription.listener.Get();
    ReadItem item;
    const auto hasQuality = [&](OPCHANDLE client, WORD quality) {
        return listener->last(client, item) && item.quality == quality;
    };
    check("outage.before", happens([&] { return hasQuality(0, 0xC0); }));
    ask("feed stop");
    check("outage.quality", happens([&] { return hasQuality(0, 0x18); }));
    checkNumber("outage.value.kept", -3599.5, item.number);
    check("outage.flag", happens([&] { return hasQuality(1, 0x18); }));
    check("outage.connection", happens([&] {
              return listener->last(2, item) && item.number == 0 && item.quality == 0xC0;
          }));
    ComPtr<IUnknown> unknown;
    const auto late = addGroup(server.Get(), L"late");
    std::vector<HRESULT> errors;
    addItems(late.items.Get(), {And3 + L".DATA.Angl_Y"}, VT_EMPTY, &errors);
    checkResult("outage.add", S_OK, errors[0]);
    ask("feed start");
    check("outage.back", happens([&] { return hasQuality(0, 0xC0); }));
    check("outage.connection.back", happens([&] { return listener->last(2, item) && item.number == 1; }));
}

void testDeath()
{
    auto server = connected();
    const auto group = server ? addGroup(server.Get(), L"death", 100) : AddedGroup();
    check("death.group", group.items != nullptr);
    if (!group.items)
        return;
    const auto handles = addItems(group.items.Get(), {And3 + L".DATA.Angl_X"});
    killGateways();
    check("death.gone", isGatewayGone());
    HRESULT result = S_OK;
    readItems(group.items.Get(), handles, OPC_DS_CACHE, &result);
    check("death.error", FAILED(result));
    HRESULT activated = E_FAIL;
    const auto again = connected(&activated);
    checkResult("death.again", S_OK, activated);
    const auto fresh = again ? addGroup(again.Get(), L"death", 100) : AddedGroup();
    check(
        "death.value",
        fresh.items
            && readItems(fresh.items.Get(), addItems(fresh.items.Get(), {And3 + L".DATA.Angl_X"}))[0].number
                == -3599.5);
}

void testShutdown()
{
    const auto server = connected();
    check("shutdown.server", server != nullptr);
    if (!server)
        return;
    as<IOPCCommon>(server.Get())->SetLocaleID(0x0409);
    ComPtr<IConnectionPoint> point;
    const auto container = as<IConnectionPointContainer>(server.Get());
    checkResult("shutdown.point", S_OK, container->FindConnectionPoint(__uuidof(IOPCShutdown), point.GetAddressOf()));
    ComPtr<IEnumConnectionPoints> points;
    checkResult("points", S_OK, container->EnumConnectionPoints(points.GetAddressOf()));
    IConnectionPoint *only = nullptr;
    ULONG fetched = 0;
    check("points.one", points->Next(1, &only, &fetched) == S_OK && fetched == 1);
    IID id{};
    check(
        "points.interface",
        only && only->GetConnectionInterface(&id) == S_OK && IsEqualIID(id, __uuidof(IOPCShutdown)));
    if (only)
        only->Release();
    const auto listener = made<ShutdownListener>();
    DWORD cookie = 0;
    checkResult("shutdown.advise", S_OK, point->Advise(listener.Get(), &cookie));
    ComPtr<IEnumConnections> connections;
    point->EnumConnections(connections.GetAddressOf());
    CONNECTDATA data{};
    check(
        "shutdown.connections",
        connections && connections->Next(1, &data, &fetched) == S_OK && data.dwCookie == cookie);
    if (data.pUnk)
        data.pUnk->Release();
    ask("feed end");
    check("shutdown.asked", happens([&] { return !listener->reason().empty(); }));
    checkText("shutdown.reason", L"Gorizont Server is ending", listener->reason().c_str());
    check("shutdown.ended", happens(isGatewayGone)); // though this client has not left
}

void testHold()
{
    const auto server = connected();
    const auto group = server ? addGroup(server.Get(), L"hold", 50) : AddedGroup();
    check("hold.group", group.items != nullptr);
    if (!group.items)
        return;
    addItems(group.items.Get(), bulkNames());
    Subscription subscription(group.items.Get());
    check("hold.told", happens([&] { return subscription.listener->values >= Bulk; }));
    ask("kill me");
    Sleep(60000);
    check("hold.killed", false, "nobody came");
}

void testSurvivor()
{
    checkNumber("survivor.one", 1, static_cast<double>(processesOf(Gateway).size()));
    const auto server = connected();
    const auto group = server ? addGroup(server.Get(), L"survivor", 50) : AddedGroup();
    check("survivor.group", group.items != nullptr);
    if (!group.items)
        return;
    addItems(group.items.Get(), bulkNames());
    Subscription subscription(group.items.Get());
    check("survivor.told", happens([&] { return subscription.listener->values >= Bulk; }));
    ask("set " + toUtf8(textOf(bulkName(1).c_str())) + " 5555");
    ReadItem item;
    check("survivor.change", happens([&] { return subscription.listener->last(0, item) && item.number == 5555; }));
    checkNumber("survivor.still.one", 1, static_cast<double>(processesOf(Gateway).size()));
}

void testEnding()
{
    check("ending", happens(isGatewayGone, 40), "the gateway stays after its last client");
}

} // namespace opctest
