#pragma once

#include "core/net/clientdesk.h"

#include <QTcpSocket>
#include <QTest>

namespace gorizont::test {

/// A client that speaks in bytes, in the thread of the server.
class TestClient
{
public:
    explicit TestClient(quint16 port, const QHostAddress &address = QHostAddress(QHostAddress::LocalHost))
    {
        m_socket.connectToHost(address, port);
        // The event loop runs meanwhile, for the server lives in the same thread.
        m_isDecided = QTest::qWaitFor(
            [this] {
                return m_socket.state() == QAbstractSocket::ConnectedState
                    || m_socket.state() == QAbstractSocket::UnconnectedState;
            },
            5000);
    }

    bool isConnected() const { return m_isDecided && m_socket.state() == QAbstractSocket::ConnectedState; }
    QTcpSocket &socket() { return m_socket; }

    void send(const QByteArray &bytes)
    {
        m_socket.write(bytes);
        m_socket.flush();
    }

    /// What arrives until there are \a size bytes, the connection ends or five seconds are over.
    QByteArray receive(qsizetype size)
    {
        const bool isThere = QTest::qWaitFor(
            [this, size] {
                return m_socket.bytesAvailable() >= size || m_socket.state() != QAbstractSocket::ConnectedState;
            },
            5000);
        return isThere ? m_socket.readAll() : m_socket.readAll() + "(timeout)";
    }

    QByteArray ask(const QByteArray &request, qsizetype size)
    {
        send(request);
        return receive(size);
    }

    bool isClosedByServer(int within = 5000)
    {
        return QTest::qWaitFor([this] { return m_socket.state() == QAbstractSocket::UnconnectedState; }, within);
    }

private:
    QTcpSocket m_socket;
    bool m_isDecided = false;
};

/// What a desk tells the journal.
class JournalSpy
{
public:
    explicit JournalSpy(const ClientDesk &desk)
    {
        QObject::connect(&desk, &ClientDesk::journal, &desk, [this](const JournalEntry &entry) {
            m_entries.append(entry);
        });
    }

    const QList<JournalEntry> &entries() const { return m_entries; }

    int count(const char *fragment) const
    {
        int found = 0;
        for (const JournalEntry &entry : m_entries) {
            found += entry.text.contains(QString::fromUtf8(fragment)) ? 1 : 0;
        }
        return found;
    }

    bool has(JournalKind kind, const char *fragment) const
    {
        for (const JournalEntry &entry : m_entries) {
            if (entry.kind == kind && entry.text.contains(QString::fromUtf8(fragment))) {
                return true;
            }
        }
        return false;
    }

private:
    QList<JournalEntry> m_entries;
};

} // namespace gorizont::test
