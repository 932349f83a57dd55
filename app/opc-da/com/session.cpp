#include "app/opc-da/com/session.h"

#include "app/opc-da/com/clientprocess.h"
#include "app/opc-da/com/group.h"
#include "app/opc-da/com/locale.h"

#include <thread>

namespace opcda {

namespace {

template <class... F> struct Cases : F...
{
    using F::operator()...;
};
template <class... F> Cases(F...) -> Cases<F...>;

constexpr std::size_t MostTasks = 1000;

} // namespace

Session::Session(Gate &gate)
    : m_gate(gate)
{
}

Session::~Session()
{
    for (const auto &[id, process] : m_clients)
        CloseHandle(process);
}

Group *Session::groupByName(TextView name) const
{
    for (const auto &[handle, group] : groups) {
        if (group->name() == name)
            return group.Get();
    }
    return nullptr;
}

Text Session::freeName() const
{
    for (std::size_t number = groups.size() + 1;; ++number) {
        const std::string digits = std::to_string(number);
        const Text name = u"Group" + Text(digits.begin(), digits.end());
        if (!groupByName(name))
            return name;
    }
}

HRESULT Session::enqueue(Task task)
{
    if (m_tasks.size() >= MostTasks)
        return E_OUTOFMEMORY;
    m_tasks.push_back(std::move(task));
    wake();
    return S_OK;
}

bool Session::cancel(const Group *group, DWORD cancelId)
{
    for (Task &task : m_tasks) {
        const auto *reading = std::get_if<Reading>(&task);
        if (!reading || reading->cancelId != cancelId || reading->group.Get() != group)
            continue;
        task = Task(Cancelled{reading->group, reading->transaction});
        return true;
    }
    return false;
}

void Session::wake()
{
    if (m_isClosed)
        return;
    if (!m_isRunning) {
        std::thread([self = shared_from_this()] { self->run(); }).detach();
        m_isRunning = true;
    }
    m_changed.notify_all();
}

void Session::post(Task task)
{
    const std::scoped_lock lock(m_gate.mutex());
    enqueue(std::move(task));
}

void Session::close()
{
    // Released after the lock: the last references to objects of the client's process are among them.
    std::map<OPCHANDLE, ComPtr<Group>> left;
    std::deque<Task> undone;
    std::vector<ComPtr<IOPCDataCallback>> sinks;
    const std::scoped_lock lock(m_gate.mutex());
    m_isClosed = true;
    left.swap(groups);
    undone.swap(m_tasks);
    for (const auto &[handle, group] : left)
        sinks.push_back(group->remove());
    shutdownSink = [] { return ComPtr<IOPCShutdown>(); };
    serverObject = [] { return ComPtr<IUnknown>(); };
    m_changed.notify_all();
}

void Session::abandon()
{
    std::vector<ComPtr<IUnknown>> left;
    {
        const std::scoped_lock lock(m_gate.mutex());
        left.push_back(serverObject());
        for (const auto &[handle, group] : groups)
            left.emplace_back(static_cast<IOPCItemMgt *>(group.Get()));
    }
    close();
    for (const ComPtr<IUnknown> &object : left) {
        if (object)
            CoDisconnectObject(object.Get(), 0);
    }
}

void Session::noteCaller()
{
    const DWORD process = callingProcess();
    const std::scoped_lock lock(m_gate.mutex());
    if (process == 0 || m_clients.contains(process))
        return;
    if (HANDLE handle = OpenProcess(SYNCHRONIZE, FALSE, process)) {
        m_clients.emplace(process, handle);
        m_knowsCaller = true;
    }
}

bool Session::isAbandoned()
{
    const std::scoped_lock lock(m_gate.mutex());
    for (const auto &[id, process] : m_clients) {
        if (WaitForSingleObject(process, 0) != WAIT_OBJECT_0)
            return false;
    }
    return !m_clients.empty();
}

void Session::run()
{
    CoInitializeEx(nullptr, COINIT_MULTITHREADED);
    {
        std::unique_lock lock(m_gate.mutex());
        while (!m_isClosed) {
            if (!m_tasks.empty()) {
                Task task = std::move(m_tasks.front());
                m_tasks.pop_front();
                serve(lock, std::move(task));
                continue;
            }
            Clock::time_point next = Clock::time_point::max();
            if (serveGroup(lock, next))
                continue;
            if (next == Clock::time_point::max())
                m_changed.wait(lock);
            else
                m_changed.wait_until(lock, next);
        }
    }
    CoUninitialize();
}

void Session::serve(std::unique_lock<std::mutex> &lock, Task task)
{
    std::visit(
        Cases{
            [this, &lock](Reading &reading) { reading.group->answer(lock, reading); },
            [this, &lock](Cancelled &cancelled) { cancelled.group->tellCancelled(lock, cancelled.transaction); },
            [this, &lock](AskToLeave &) { askToLeave(lock); }},
        task);
    lock.unlock();
    task = AskToLeave{}; // a group may go with its task, and that must not happen under the lock
    lock.lock();
}

bool Session::serveGroup(std::unique_lock<std::mutex> &lock, Clock::time_point &next)
{
    const Clock::time_point now = Clock::now();
    for (const auto &[handle, group] : groups) {
        const Clock::time_point due = group->due();
        if (due > now) {
            next = std::min(next, due);
            continue;
        }
        ComPtr<Group> held = group;
        held->publish(lock, now);
        lock.unlock();
        held.Reset();
        lock.lock();
        return true;
    }
    return false;
}

void Session::askToLeave(std::unique_lock<std::mutex> &lock)
{
    ComPtr<IOPCShutdown> sink = shutdownSink();
    const std::wstring reason = wide(shutdownReason(languageOf(locale)));
    lock.unlock();
    if (sink)
        sink->ShutdownRequest(reason.c_str());
    sink.Reset();
    lock.lock();
}

} // namespace opcda
