#pragma once
#include "app/opc-da/com/variants.h"
#include "app/opc-da/pure/tagbook.h"

#include <memory>
#include <mutex>

namespace opcda {

class Session;

/// What all clients share: the tags, and who is there. One lock guards this, the sessions and their groups; nobody calls out
/// of the process while holding it.
class Gate
{
public:
    Gate(std::string registeredHash, const std::vector<Tag> &knownTags);

    /// Runs `work` under the lock; lack of memory becomes a result code.
    template <class Work> HRESULT locked(Work work)
    try {
        const std::scoped_lock lock(m_mutex);
        return work();
    } catch (const std::bad_alloc &) {
        return E_OUTOFMEMORY;
    }

    std::mutex &mutex() { return m_mutex; }
    TagBook &book() { return m_book; }
    FILETIME startTime() const { return m_startTime; }
    DWORD nextHandle() { return ++m_lastHandle; }

    // Each takes the lock itself.
    void enter(const std::shared_ptr<Session> &session);
    void lock(bool isLocked);
    bool isInUse();
    /// Closes the sessions whose client processes have all ended.
    void closeAbandoned();
    /// Asks every client to leave.
    void requestShutdown();

private:
    std::vector<std::shared_ptr<Session>> openSessions();

    std::mutex m_mutex;
    TagBook m_book;
    const FILETIME m_startTime = fileTime(unixMilliseconds());
    std::vector<std::weak_ptr<Session>> m_sessions;
    DWORD m_lastHandle = 0;
    long m_locks = 0;
};

} // namespace opcda
