#include "tests/opc/client/cases.h"
#include "tests/opc/client/listener.h"

#include <algorithm>

namespace opctest {

namespace {

using Call = Listener::Call;

const std::wstring Moved = And3 + L".DATA.Angl_X";
const std::wstring Flag = And3 + L".STATE.Restart";

bool hasNumber(Listener *listener, OPCHANDLE client, double number)
{
    ReadItem item;
    return listener->last(client, item) && item.number == number;
}

void testSubscription(IOPCServer *server)
{
    const auto group = addGroup(server, L"subscription", 50);
    auto handles = addItems(group.items.Get(), {Moved, Flag, Net + L".DATA.Angl_Y"});
    Subscription subscription(group.items.Get());
    Listener *listener = subscription.listener.Get();
    checkResult("advise", S_OK, subscription.result);
    check("change.first", happens([&] { return listener->count(Call::Change) > 0; }));
    const Call first = listener->calls().front();
    check("change.all", first.items.size() == 3 && first.transaction == 0 && first.group == 77);
    check("change.quality", first.quality == S_FALSE && first.error == S_OK);
    check("change.value", first.items.at(0).number == -3599.5 && first.items.at(1).type == VT_BOOL);
    listener->clear();
    Sleep(300);
    check("change.quiet", listener->count(Call::Change) == 0);
    ask("set " + toUtf8(textOf(Moved.c_str())) + " 1.5");
    check("change.one", happens([&] { return hasNumber(listener, 0, 1.5); }));
    check("change.only", listener->calls().back().items.size() == 1 && listener->calls().back().quality == S_OK);

    Allocated<HRESULT> codes;
    group.items->SetActiveState(1, handles.data(), FALSE, &codes);
    ask("set " + toUtf8(textOf(Moved.c_str())) + " 2.5");
    ask("set " + toUtf8(textOf(Flag.c_str())) + " false");
    check("inactive.other", happens([&] { return hasNumber(listener, 1, 0); }));
    check("inactive.silent", hasNumber(listener, 0, 1.5));
    Allocated<HRESULT> back;
    group.items->SetActiveState(1, handles.data(), TRUE, &back);
    check("active.again", happens([&] { return hasNumber(listener, 0, 2.5); }));

    Subscription second(group.items.Get());
    checkResult("advise.second", CONNECT_E_ADVISELIMIT, second.result);
    checkResult("unadvise.wrong", CONNECT_E_NOCONNECTION, subscription.point->Unadvise(12345));
    checkResult("unadvise", S_OK, subscription.unadvise());
    ask("set " + toUtf8(textOf(Moved.c_str())) + " 3.5");
    Sleep(500);
    check("unadvise.silent", hasNumber(listener, 0, 2.5));
    ask("set " + toUtf8(textOf(Flag.c_str())) + " true");
}

void testDeadband(IOPCServer *server)
{
    // 10 % of the scale −3600…3600 is 720: a step of 700 is not told, one of 21 more is
    const auto group = addGroup(server, L"deadband", 50, true, 10);
    addItems(group.items.Get(), {Moved, Flag});
    ask("set " + toUtf8(textOf(Moved.c_str())) + " 100");
    check("deadband.begun", happens([&] {
              return readItems(group.items.Get(), addItems(group.items.Get(), {Moved}))[0].number == 100;
          }));
    Subscription subscription(group.items.Get());
    Listener *listener = subscription.listener.Get();
    check("deadband.first", happens([&] { return hasNumber(listener, 0, 100); }));
    ask("set " + toUtf8(textOf(Moved.c_str())) + " 800");
    ask("set " + toUtf8(textOf(Flag.c_str())) + " false");
    check("deadband.flag", happens([&] { return hasNumber(listener, 1, 0); }));
    check("deadband.inside", hasNumber(listener, 0, 100));
    ask("set " + toUtf8(textOf(Moved.c_str())) + " 821");
    check("deadband.outside", happens([&] { return hasNumber(listener, 0, 821); }));
    ask("set " + toUtf8(textOf(Moved.c_str())) + " 822 20");
    check("deadband.quality", happens([&] { return hasNumber(listener, 0, 822); }));
    ask("set " + toUtf8(textOf(Flag.c_str())) + " true");
    ask("set " + toUtf8(textOf(Moved.c_str())) + " -3599.5");
    check("deadband.end", happens([&] { return hasNumber(listener, 0, -3599.5); }));
}

void testAsynchronous(IOPCServer *server)
{
    const auto group = addGroup(server, L"asynchronous", 200);
    auto handles = addItems(group.items.Get(), {Moved, Flag});
    const auto io = as<IOPCAsyncIO3>(group.items.Get());
    check("async.interface", io && as<IOPCAsyncIO2>(group.items.Get()));
    DWORD cancel = 0;
    Allocated<HRESULT> codes;
    checkResult("async.unheard", CONNECT_E_NOCONNECTION, io->Read(2, handles.data(), 1, &cancel, &codes));
    Subscription subscription(group.items.Get());
    Listener *listener = subscription.listener.Get();
    handles.push_back(0xABCDEF);
    Allocated<HRESULT> some;
    checkResult("async.read", S_FALSE, io->Read(3, handles.data(), 42, &cancel, &some));
    check("async.read.codes", some[0] == S_OK && some[2] == static_cast<HRESULT>(0xC0040001));
    check("async.read.complete", happens([&] { return listener->count(Call::ReadComplete) == 1; }));
    for (const Call &call : listener->calls()) {
        if (call.kind == Call::ReadComplete)
            check(
                "async.read.values",
                call.transaction == 42 && call.items.size() == 2 && call.items.at(0).quality == 192);
    }
    DWORD ages[3] = {0, 0, 0};
    Allocated<HRESULT> aged;
    io->ReadMaxAge(2, handles.data(), ages, 43, &cancel, &aged);
    check("async.maxage", happens([&] { return listener->count(Call::ReadComplete) == 2; }));
    // What the subscription itself tells has the transaction 0 and comes when it comes.
    const auto isTold = [&](DWORD transaction) {
        return std::ranges::count_if(listener->calls(), [&](const Call &call) {
                   return call.kind == Call::Change && call.transaction == transaction;
               }) == 1;
    };
    checkResult("async.refresh", S_OK, io->Refresh2(OPC_DS_CACHE, 44, &cancel));
    check("async.refresh.change", happens([&] { return isTold(44); }));
    checkResult("async.refreshmaxage", S_OK, io->RefreshMaxAge(0, 45, &cancel));
    check("async.refreshmaxage.change", happens([&] { return isTold(45); }));

    VARIANT values[2]{};
    Allocated<HRESULT> refused;
    checkResult("async.write", S_FALSE, io->Write(2, handles.data(), values, 46, &cancel, &refused));
    checkResult("async.write.rights", static_cast<HRESULT>(0xC0040006), refused[0]);
}

/// While the client is busy with one answer, the next one waits and can be cancelled.
void testCancelling(IOPCServer *server)
{
    const auto group = addGroup(server, L"cancelling", 200);
    auto handles = addItems(group.items.Get(), {Moved, Flag});
    const auto io = as<IOPCAsyncIO3>(group.items.Get());
    Subscription subscription(group.items.Get());
    Listener *listener = subscription.listener.Get();
    check("cancel.begun", happens([&] { return listener->count(Call::Change) == 1; }));
    listener->clear();
    listener->slowness = 700;
    DWORD busy = 0;
    DWORD cancel = 0;
    Allocated<HRESULT> one;
    Allocated<HRESULT> two;
    io->Read(2, handles.data(), 47, &busy, &one);
    Sleep(200);
    io->Read(2, handles.data(), 48, &cancel, &two);
    checkResult("async.cancel", S_OK, io->Cancel2(cancel));
    check("async.cancel.complete", happens([&] { return listener->count(Call::CancelComplete) == 1; }));
    check(
        "async.cancel.transaction",
        listener->calls().back().transaction == 48 && listener->count(Call::ReadComplete) == 1);
    checkResult("async.cancel.late", E_FAIL, io->Cancel2(cancel));
    listener->slowness = 0;
}

void testEnabling(IOPCServer *server)
{
    const auto group = addGroup(server, L"enabling", 200);
    addItems(group.items.Get(), {Moved});
    const auto io = as<IOPCAsyncIO3>(group.items.Get());
    BOOL isEnabled = FALSE;
    checkResult("enable.unheard", CONNECT_E_NOCONNECTION, io->SetEnable(TRUE));
    Subscription subscription(group.items.Get());
    Listener *listener = subscription.listener.Get();
    check("enable.begun", happens([&] { return listener->count(Call::Change) == 1; }));
    DWORD cancel = 0;
    check("enable.default", io->GetEnable(&isEnabled) == S_OK && isEnabled);
    checkResult("enable.off", S_OK, io->SetEnable(FALSE));
    ask("set " + toUtf8(textOf(Moved.c_str())) + " 7");
    Sleep(600);
    check("enable.silent", !hasNumber(listener, 0, 7));
    io->Refresh2(OPC_DS_DEVICE, 49, &cancel);
    check("enable.refresh", happens([&] { return hasNumber(listener, 0, 7); }));
    checkResult("enable.on", S_OK, io->SetEnable(TRUE));
    ask("set " + toUtf8(textOf(Moved.c_str())) + " -3599.5");
    check("enable.change", happens([&] { return hasNumber(listener, 0, -3599.5); }));
}

/// A client that does not come back from a call holds up nobody but itself.
void testSlowNeighbour(IOPCServer *server)
{
    const auto slow = addGroup(server, L"slow", 50);
    addItems(slow.items.Get(), {Flag});
    Subscription sleeper(slow.items.Get());
    sleeper.listener->slowness = 4000;
    ask("set " + toUtf8(textOf(Flag.c_str())) + " false");
    const auto other = connected();
    const auto group = addGroup(other.Get(), L"quick", 50);
    addItems(group.items.Get(), {Moved});
    Subscription quick(group.items.Get());
    ask("set " + toUtf8(textOf(Moved.c_str())) + " 9.5");
    check("neighbour.quick", happens([&] { return hasNumber(quick.listener.Get(), 0, 9.5); }, 3));
    check("neighbour.slow", happens([&] { return hasNumber(sleeper.listener.Get(), 0, 0); }));
    sleeper.listener->slowness = 0;
    ask("set " + toUtf8(textOf(Flag.c_str())) + " true");
    ask("set " + toUtf8(textOf(Moved.c_str())) + " -3599.5");
}

void testKeepAlive(IOPCServer *server)
{
    const auto group = addGroup(server, L"keepalive", 100);
    addItems(group.items.Get(), {Moved});
    const auto state = as<IOPCGroupStateMgt2>(group.items.Get());
    DWORD revised = 0;
    checkResult("keepalive.set", S_OK, state->SetKeepAlive(200, &revised));
    checkNumber("keepalive.revised", 200, revised);
    Subscription subscription(group.items.Get());
    check("keepalive.calls", happens([&] { return subscription.listener->count(Call::Change) >= 4; }));
    check("keepalive.empty", subscription.listener->calls().back().items.empty());
    DWORD time = 0;
    state->GetKeepAlive(&time);
    checkNumber("keepalive.get", 200, time);
    checkResult("keepalive.off", S_OK, state->SetKeepAlive(0, &revised));
}

} // namespace

void testCallbacks()
{
    const auto server = connected();
    check("callbacks.server", server != nullptr);
    if (!server)
        return;
    testSubscription(server.Get());
    testDeadband(server.Get());
    testAsynchronous(server.Get());
    testCancelling(server.Get());
    testEnabling(server.Get());
    testSlowNeighbour(server.Get());
    testKeepAlive(server.Get());
}

} // namespace opctest
