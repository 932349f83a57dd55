#pragma once
#include "app/opc-da/com/gate.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <variant>

namespace opcda {

class Group;
class Server;

using Clock = std::chrono::steady_clock;

/// One client of the server: its groups, its wishes, and the thread that calls it. A client that does not come back from a
/// call holds up nobody but itself. Public members are guarded by the lock of the gate unless they say otherwise.
class Session : public std::enable_shared_from_this<Session>
{
public:
    /// A reading to be given by callback: OnReadComplete, or OnDataChange for a refresh.
    struct Reading
    {
        ComPtr<Group> group;
        DWORD transaction;
        DWORD cancelId;
        bool isRefresh;
        std::vector<OPCHANDLE> items;
    };
    struct Cancelled
    {
        ComPtr<Group> group;
        DWORD transaction;
    };
    struct AskToLeave
    {
    };
    using Task = std::variant<Reading, Cancelled, AskToLeave>;

    explicit Session(Gate &gate);
    ~Session();

    Gate &gate() { return m_gate; }
    bool isClosed() const { return m_isClosed; }

    std::map<OPCHANDLE, ComPtr<Group>> groups; ///< by server handle
    LCID locale = LOCALE_SYSTEM_DEFAULT;
    Text browsePosition;
    std::function<ComPtr<IOPCShutdown>()> shutdownSink = [] { return ComPtr<IOPCShutdown>(); };
    std::function<ComPtr<IUnknown>()> serverObject = [] { return ComPtr<IUnknown>(); };
    FILETIME lastUpdate{};

    Group *groupByName(TextView name) const;
    Text freeName() const;
    /// Adds to what the thread is to do, and wakes it; E_OUTOFMEMORY when a client that does not listen has asked too much.
    HRESULT enqueue(Task task);
    /// Takes a reading that has not begun out of the queue. Under the lock.
    bool cancel(const Group *group, DWORD cancelId);
    /// Something about the groups has changed: the thread looks again. Under the lock.
    void wake();

    // Each takes the lock itself.
    void post(Task task);
    /// Drops the groups and all that the client left behind; calls of it fail from now on.
    void close();
    /// The same for a client whose process has ended: what it still holds of this process is let go, too.
    void abandon();
    /// Remembers the process of the client whose call runs now.
    void noteCaller();
    bool knowsCaller() const { return m_knowsCaller; }
    /// True when processes are known and all of them have ended.
    bool isAbandoned();

private:
    void run();
    void serve(std::unique_lock<std::mutex> &lock, Task task);
    /// Calls the client for one group that is due; false when none is. `next`: when to look again.
    bool serveGroup(std::unique_lock<std::mutex> &lock, Clock::time_point &next);
    void askToLeave(std::unique_lock<std::mutex> &lock);

    Gate &m_gate;
    std::condition_variable m_changed;
    std::deque<Task> m_tasks;
    std::map<DWORD, HANDLE> m_clients; ///< processes by id
    std::atomic<bool> m_knowsCaller = false;
    std::atomic<bool> m_isClosed = false;
    bool m_isRunning = false;
};

} // namespace opcda
