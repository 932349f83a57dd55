#include "core/net/allowlist.h"

#include <algorithm>

namespace gorizont {

QHostAddress plainAddress(const QHostAddress &address)
{
    bool isIpv4 = false;
    const quint32 ipv4 = address.toIPv4Address(&isIpv4);
    return isIpv4 ? QHostAddress(ipv4) : address;
}

AllowList::AllowList(const QStringList &entries)
{
    for (const QString &entry : entries) {
        const QString text = entry.trimmed();
        if (text.isEmpty()) {
            continue;
        }
        const QPair<QHostAddress, int> subnet = QHostAddress::parseSubnet(text);
        if (subnet.second < 0) {
            m_unreadable.append(text);
        } else {
            m_subnets.append(subnet);
        }
    }
}

bool AllowList::admits(const QHostAddress &address) const
{
    if (m_subnets.isEmpty()) {
        return m_unreadable.isEmpty();
    }
    return std::any_of(m_subnets.begin(), m_subnets.end(), [&address](const QPair<QHostAddress, int> &subnet) {
        return address.isInSubnet(subnet);
    });
}

} // namespace gorizont
