#include "core/net/clientdiary.h"

namespace gorizont {

bool ClientDiary::arrives(const QHostAddress &address, SteadyTime now)
{
    const auto found = m_visits.find(address);
    if (found != m_visits.end()) {
        ++found->connections;
        return false;
    }
    if (m_visits.size() >= capacity) {
        return false;
    }
    m_visits.insert(address, {1, now});
    return true;
}

void ClientDiary::leaves(const QHostAddress &address, SteadyTime now)
{
    const auto found = m_visits.find(address);
    if (found != m_visits.end() && found->connections > 0) {
        --found->connections;
        found->left = now;
    }
}

bool ClientDiary::isNews(ClientTrouble trouble, const QHostAddress &address, SteadyTime now)
{
    const auto key = std::pair(address, static_cast<int>(trouble));
    const auto found = m_troubles.find(key);
    if (found != m_troubles.end()) {
        const bool isLongAgo = now - *found >= forgetAfter;
        *found = now;
        return isLongAgo;
    }
    if (m_troubles.size() >= capacity) {
        return false;
    }
    m_troubles.insert(key, now);
    return true;
}

QList<ClientDiary::Departure> ClientDiary::departures(SteadyTime now)
{
    m_troubles.removeIf([now](const auto &entry) { return now - entry.value() >= forgetAfter; });
    QList<Departure> gone;
    m_visits.removeIf([now, &gone](const auto &entry) {
        const Visit &visit = entry.value();
        const bool isGone = visit.connections == 0 && now - visit.left >= forgetAfter;
        if (isGone) {
            gone.append({entry.key(), visit.left});
        }
        return isGone;
    });
    return gone;
}

} // namespace gorizont
