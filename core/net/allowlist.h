#pragma once

#include <QHostAddress>
#include <QList>
#include <QStringList>

namespace gorizont {

/// An IPv4 client of a dual-stack socket shows up as `::ffff:a.b.c.d`; here it is IPv4 again.
QHostAddress plainAddress(const QHostAddress &address);

/// Who may connect (ModbusAllow): addresses and CIDR blocks, IPv4 and IPv6. Pure.
/// An empty list admits everybody; a list whose every entry is unreadable admits nobody, since somebody wanted a limit.
class AllowList
{
public:
    explicit AllowList(const QStringList &entries);

    /// \a address is a plainAddress().
    bool admits(const QHostAddress &address) const;
    /// Entries that are neither an address nor a block.
    const QStringList &unreadable() const { return m_unreadable; }

private:
    QList<QPair<QHostAddress, int>> m_subnets;
    QStringList m_unreadable;
};

} // namespace gorizont
