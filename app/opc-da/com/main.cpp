// The OPC DA gateway: started by COM for a client, or by hand with /RegServer and /UnregServer.
#include "app/opc-da/com/factory.h"
#include "app/opc-da/com/feedclient.h"
#include "app/opc-da/com/identity.h"
#include "app/opc-da/com/registration.h"
#include "app/opc-da/pure/commandline.h"

#include <thread>

using namespace opcda;

namespace {

constexpr DWORD Tick = 1000; ///< ms between two looks at who is still there
constexpr DWORD FirstList = 2000; ///< ms that a client waits at most for the first list of tags
constexpr auto Leaving = std::chrono::seconds(5); ///< for clients that were asked to leave

/// Waits until nobody needs the program or the main program ends.
void serve(Gate &gate, HANDLE ended, std::chrono::seconds linger)
{
    auto lastUse = std::chrono::steady_clock::now();
    while (WaitForSingleObject(ended, Tick) == WAIT_TIMEOUT) {
        gate.closeAbandoned();
        const auto now = std::chrono::steady_clock::now();
        if (gate.isInUse())
            lastUse = now;
        if (now - lastUse < linger)
            continue;
        CoSuspendClassObjects(); // a client that comes from now on starts another gateway
        if (!gate.isInUse())
            return;
        CoResumeClassObjects();
    }
}

void askToLeave(Gate &gate)
{
    gate.requestShutdown();
    const auto end = std::chrono::steady_clock::now() + Leaving;
    while (gate.isInUse() && std::chrono::steady_clock::now() < end) {
        gate.closeAbandoned();
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
}

int runGateway()
{
    const HRESULT initialized = CoInitializeEx(nullptr, COINIT_MULTITHREADED);
    if (FAILED(initialized))
        return static_cast<int>(initialized);
    const Settings settings = readSettings();
    Gate gate(settings.hash, tagsOf(settings.tagsFile));
    HANDLE ready = CreateEventW(nullptr, TRUE, FALSE, nullptr);
    HANDLE ended = CreateEventW(nullptr, TRUE, FALSE, nullptr);
    FeedClient feed(gate, settings, ready, ended);
    std::thread([&feed] { feed.run(); }).detach();
    WaitForSingleObject(ready, FirstList);

    const ComPtr<Factory> factory = made<Factory>(gate);
    DWORD cookie = 0;
    const HRESULT registered =
        CoRegisterClassObject(ServerClsid, factory.Get(), CLSCTX_LOCAL_SERVER, REGCLS_MULTIPLEUSE, &cookie);
    if (SUCCEEDED(registered)) {
        serve(gate, ended, settings.linger);
        CoRevokeClassObject(cookie);
        askToLeave(gate);
    }
    // Threads that are in a call to a client cannot be waited for: the process ends with them.
    ExitProcess(static_cast<UINT>(registered));
}

} // namespace

int WINAPI wWinMain(HINSTANCE, HINSTANCE, LPWSTR, int)
{
    int count = 0;
    LPWSTR *arguments = CommandLineToArgvW(GetCommandLineW(), &count);
    std::vector<Text> words;
    for (int i = 1; i < count; ++i)
        words.push_back(textOf(arguments[i]));
    LocalFree(arguments);
    const CommandLine line = parseCommandLine(words);
    const Scope scope = line.isPerUser ? Scope::User : Scope::Machine;
    switch (line.action) {
    case CommandLine::Action::Serve: return runGateway();
    case CommandLine::Action::Register: return static_cast<int>(registerServer(scope, line));
    case CommandLine::Action::Unregister: return static_cast<int>(unregisterServer(scope));
    case CommandLine::Action::Wrong: break;
    }
    return ERROR_BAD_ARGUMENTS;
}
