#include "app/opc-da/com/gate.h"

#include "app/opc-da/com/group.h"

namespace opcda {

Gate::Gate(std::string registeredHash, const std::vector<Tag> &knownTags)
    : m_book(std::move(registeredHash), unixMilliseconds())
{
    m_book.preset(knownTags, unixMilliseconds());
}

void Gate::enter(const std::shared_ptr<Session> &session)
{
    const std::scoped_lock lock(m_mutex);
    m_sessions.push_back(session);
}

void Gate::lock(bool isLocked)
{
    const std::scoped_lock lock(m_mutex);
    m_locks += isLocked ? 1 : -1;
}

bool Gate::isInUse()
{
    const bool hasSessions = !openSessions().empty();
    const std::scoped_lock lock(m_mutex);
    return hasSessions || m_locks > 0;
}

std::vector<std::shared_ptr<Session>> Gate::openSessions()
{
    std::vector<std::shared_ptr<Session>> open;
    const std::scoped_lock lock(m_mutex);
    std::erase_if(m_sessions, [&open](const std::weak_ptr<Session> &weak) {
        const std::shared_ptr<Session> session = weak.lock();
        if (!session || session->isClosed())
            return true;
        open.push_back(session);
        return false;
    });
    return open;
}

void Gate::closeAbandoned()
{
    for (const auto &session : openSessions()) {
        if (session->isAbandoned())
            session->abandon();
    }
}

void Gate::requestShutdown()
{
    for (const auto &session : openSessions())
        session->post(Session::AskToLeave{});
}

} // namespace opcda
