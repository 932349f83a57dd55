#include "core/net/clientdesk.h"
#include "tests/core/net/rawsocket.h"
#include "tests/core/net/testclient.h"
#include "tests/core/net/toyservice.h"

#include <QScopeGuard>
#include <QSignalSpy>
#include <QThread>

#include <memory>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

const QByteArray request = QByteArray(10, 'a'); // the answer has 45 bytes

} // namespace

/// The desk over real loopback sockets: what a well-meaning client and an operator see.
class TestClientDesk : public QObject
{
    Q_OBJECT

Q_SIGNALS:
    void dismissWanted(const QHostAddress &address, quint16 port);

private Q_SLOTS:
    void cutsOffIdleClients()
    {
        DeskConfig config;
        config.idle = 1000ms;
        ClientDesk desk(toyService(), config);
        JournalSpy journal(desk);
        QVERIFY(desk.open(loopback(), 0));
        TestClient idle(desk.port());
        TestClient half(desk.port());
        TestClient busy(desk.port());
        half.send(request.first(6));
        QElapsedTimer watch;
        watch.start();
        while ((idle.isConnected() || half.isConnected()) && watch.elapsed() < 10000) {
            QCOMPARE(busy.ask(request, 45).size(), 45);
            QTest::qWait(20);
        }
        QVERIFY(watch.elapsed() >= 900);
        QVERIFY(!idle.isConnected());
        QVERIFY(!half.isConnected());
        QVERIFY(busy.isConnected());
        QCOMPARE(journal.count("ModbusIdle"), 1); // one address, one line
    }

    void neverCutsOffWithIdleZero()
    {
        DeskConfig config;
        config.idle = 0ms;
        ClientDesk desk(toyService(), config);
        QVERIFY(desk.open(loopback(), 0));
        TestClient idle(desk.port());
        QTest::qWait(1500); // more than one round
        QCOMPARE(idle.ask(request, 45).size(), 45);
    }

    void theLongestIdleGivesWay()
    {
        DeskConfig config;
        config.clients = 3;
        ClientDesk desk(toyService(), config);
        JournalSpy journal(desk);
        QVERIFY(desk.open(loopback(), 0));
        TestClient first(desk.port());
        TestClient second(desk.port());
        TestClient third(desk.port());
        QCOMPARE(second.ask(request, 45).size(), 45);
        QCOMPARE(third.ask(request, 45).size(), 45);
        QCOMPARE(first.ask(request, 45).size(), 45); // so the second is the longest idle
        TestClient fourth(desk.port());
        QCOMPARE(fourth.ask(request, 45).size(), 45);
        QVERIFY(second.isClosedByServer());
        QVERIFY(first.isConnected());
        QVERIFY(third.isConnected());
        QCOMPARE(desk.clients().size(), 3);
        QVERIFY(journal.has(JournalKind::Info, "ModbusClients"));
    }

    void refusesWhoIsNotOnTheList()
    {
        DeskConfig config;
        config.allow = QStringList{QStringLiteral("127.0.0.2"), QStringLiteral("nobody")};
        ClientDesk desk(toyService(), config);
        JournalSpy journal(desk);
        QVERIFY(desk.open(QString(), 0));
        QVERIFY(journal.has(JournalKind::Error, "\"nobody\" in ModbusAllow"));
        for (int i = 0; i < 3; ++i) {
            TestClient stranger(desk.port());
            QVERIFY(stranger.isClosedByServer());
        }
        QCOMPARE(journal.count("127.0.0.1 was refused"), 1);
        // A dual-stack socket sees this client as ::ffff:127.0.0.2.
        QTcpSocket friendly;
        QVERIFY(friendly.bind(QHostAddress(QStringLiteral("127.0.0.2"))));
        friendly.connectToHost(QHostAddress(QHostAddress::LocalHost), desk.port());
        QTRY_COMPARE(friendly.state(), QAbstractSocket::ConnectedState);
        friendly.write(request);
        QTRY_COMPARE(friendly.bytesAvailable(), 45);
    }

    void listensOnBothFamiliesByDefault()
    {
        ClientDesk desk(toyService(), DeskConfig());
        QVERIFY(desk.open(QString(), 0));
        TestClient four(desk.port());
        TestClient six(desk.port(), QHostAddress(QHostAddress::LocalHostIPv6));
        QCOMPARE(four.ask(request, 45).size(), 45);
        QCOMPARE(six.ask(request, 45).size(), 45);
        QCOMPARE(desk.clients().at(0).address, QHostAddress(QHostAddress::LocalHost));
        QCOMPARE(desk.clients().at(1).address, QHostAddress(QHostAddress::LocalHostIPv6));
    }

    void bindsToIpv6Loopback()
    {
        ClientDesk desk(toyService(), DeskConfig());
        QVERIFY(desk.open(QStringLiteral("::1"), 0));
        TestClient six(desk.port(), QHostAddress(QHostAddress::LocalHostIPv6));
        QCOMPARE(six.ask(request, 45).size(), 45);
        TestClient four(desk.port());
        QVERIFY(!four.isConnected());
    }

    void tellsOnceOfWhatIsNoRequest()
    {
        Service service = toyService();
        service.patience = 100ms;
        ClientDesk desk(service, DeskConfig());
        JournalSpy journal(desk);
        QVERIFY(desk.open(loopback(), 0));
        TestClient client(desk.port());
        client.send(QByteArray(30, '.') + request + QByteArray(10, '.'));
        QCOMPARE(client.receive(45), QByteArray(45, 'a'));
        QTRY_COMPARE(desk.clients().first().errors, 4U);
        QCOMPARE(journal.count("gets no answer"), 1);
        // Three bytes of which nothing comes: the request after them is a whole one again.
        client.send(QByteArray(3, 'b'));
        QTRY_COMPARE(desk.clients().first().errors, 5U);
        QCOMPARE(client.ask(request, 45), QByteArray(45, 'a'));
        QCOMPARE(journal.count("gets no answer"), 1);
    }

    void waitsForTheRestOfARequestWithoutALimit()
    {
        ClientDesk desk(toyService(), DeskConfig());
        QVERIFY(desk.open(loopback(), 0));
        TestClient client(desk.port());
        client.send(request.first(3));
        QTest::qWait(300);
        client.send(request.mid(3));
        QCOMPARE(client.receive(45), QByteArray(45, 'a'));
        QCOMPARE(desk.clients().first().errors, 0U);
    }

    void cutsOffTheOneThatTheOperatorNames()
    {
        ClientDesk desk(toyService(), DeskConfig());
        JournalSpy journal(desk);
        QSignalSpy changes(&desk, &ClientDesk::clientsChanged);
        QVERIFY(desk.open(QString(), 0)); // dual-stack: the socket sees ::ffff:127.0.0.1
        TestClient stays(desk.port());
        TestClient goes(desk.port());
        QTRY_COMPARE(desk.clients().size(), 2);
        const ClientInfo named = desk.clients().at(1);
        desk.dismiss(named.address, static_cast<quint16>(named.port + 1)); // nobody
        desk.dismiss(QHostAddress(QStringLiteral("10.0.0.1")), named.port); // nobody
        QVERIFY(!journal.has(JournalKind::Off, "cut off"));
        desk.dismiss(named.address, named.port);
        QVERIFY(goes.isClosedByServer());
        QCOMPARE(stays.ask(request, 45).size(), 45);
        QCOMPARE(desk.clients().size(), 1);
        QCOMPARE(changes.last().first().value<QList<ClientInfo>>().size(), 1); // shown at once
        QVERIFY(journal.has(JournalKind::Off, "client 127.0.0.1"));
        QVERIFY(journal.has(JournalKind::Off, qPrintable(QString::number(named.port))));
        desk.dismiss(named.address, named.port); // has gone
        QCOMPARE(journal.count("cut off"), 1);
    }

    void cutsOffFromAnotherThread()
    {
        QThread thread;
        auto *desk = new ClientDesk(toyService(), DeskConfig());
        desk->moveToThread(&thread);
        connect(&thread, &QThread::finished, desk, &QObject::deleteLater);
        connect(&thread, &QThread::started, desk, [desk] { desk->open(loopback(), 0); });
        quint16 port = 0;
        QList<ClientInfo> shown;
        connect(desk, &ClientDesk::listening, this, [&port, desk] { port = desk->port(); });
        connect(desk, &ClientDesk::clientsChanged, this, [&shown](const QList<ClientInfo> &now) { shown = now; });
        connect(this, &TestClientDesk::dismissWanted, desk, &ClientDesk::dismiss);
        thread.start();
        const auto end = qScopeGuard([&thread] {
            thread.quit();
            thread.wait(5000);
        });
        QTRY_VERIFY(port != 0);
        TestClient client(port);
        QTRY_COMPARE(shown.size(), 1);
        Q_EMIT dismissWanted(shown.first().address, shown.first().port);
        QVERIFY(client.isClosedByServer());
        QTRY_VERIFY(shown.isEmpty());
    }

    void saysNothingOfWhoHasGoneAlready()
    {
        ClientDesk desk(toyService(), DeskConfig());
        JournalSpy journal(desk);
        QVERIFY(desk.open(loopback(), 0));
        for (int i = 0; i < 20; ++i) {
            RawSocket scanner;
            QVERIFY(scanner.connect(desk.port()));
            scanner.resetOnClose();
        }
        TestClient client(desk.port());
        QCOMPARE(client.ask(request, 45).size(), 45);
        QCOMPARE(journal.entries().size(), 2); // serving, and the client with its address
        QVERIFY(journal.has(JournalKind::Info, "client 127.0.0.1 connected"));
        QTRY_COMPARE(desk.clients().size(), 1);
    }

    void noticesADeadPeerWithinMinutes()
    {
        TcpListener listener(1000ms, 1000ms);
        int accepted = -1;
        connect(&listener, &TcpListener::connected, this, [&accepted](const Arrival &who) {
            accepted = who.descriptor;
        });
        const auto end = qScopeGuard([&accepted] { ::close(accepted); });
        listener.start(QHostAddress(QHostAddress::LocalHost), 0);
        TestClient client(listener.port());
        QTRY_VERIFY(accepted >= 0);
        const auto option = [accepted](int level, int name) {
            int value = -1;
            socklen_t size = sizeof value;
            ::getsockopt(accepted, level, name, &value, &size);
            return value;
        };
        QCOMPARE(option(SOL_SOCKET, SO_KEEPALIVE), 1);
        QCOMPARE(option(IPPROTO_TCP, TCP_NODELAY), 1);
        QVERIFY(
            option(IPPROTO_TCP, TCP_KEEPIDLE) + option(IPPROTO_TCP, TCP_KEEPCNT) * option(IPPROTO_TCP, TCP_KEEPINTVL)
            <= 180); // seconds
    }

    void endsAndStartsAgain()
    {
        ClientDesk desk(toyService(), DeskConfig());
        JournalSpy journal(desk);
        QVERIFY(desk.open(loopback(), 0));
        const quint16 port = desk.port();
        TestClient client(port);
        QCOMPARE(client.ask(request, 45).size(), 45);
        desk.close();
        QVERIFY(!desk.isListening());
        QVERIFY(client.isClosedByServer());
        QVERIFY(journal.has(JournalKind::Off, "stopped"));
        TestClient late(port);
        QVERIFY(!late.isConnected());
        QVERIFY(desk.open(loopback(), port));
        QCOMPARE(desk.port(), port); // although old connections are in TIME_WAIT
    }

    void tellsTheJournalOfAnAddressOnce()
    {
        ClientDesk desk(toyService(), DeskConfig());
        JournalSpy journal(desk);
        QVERIFY(desk.open(loopback(), 0));
        for (int i = 0; i < 20; ++i) {
            TestClient client(desk.port());
            QCOMPARE(client.ask(request, 45).size(), 45);
        }
        QCOMPARE(journal.count("127.0.0.1 connected"), 1);
        QCOMPARE(journal.entries().size(), 2); // and that it serves
    }

    void tellsWhoIsThere()
    {
        ClientDesk desk(toyService(), DeskConfig());
        QSignalSpy changes(&desk, &ClientDesk::clientsChanged);
        QVERIFY(desk.open(loopback(), 0));
        const UtcTime before = utcNow();
        {
            TestClient client(desk.port());
            QCOMPARE(client.ask(request, 45), QByteArray(45, 'a'));
            QCOMPARE(client.ask(QByteArray(10, '?'), 1), QByteArray("n"));
            client.send(QByteArray(10, '.') + request.first(3));
            QTRY_COMPARE(desk.clients().first().bytesReceived, 33U);
            QCOMPARE(desk.clients().size(), 1);
            const ClientInfo info = desk.clients().first();
            QCOMPARE(info.address, QHostAddress(QHostAddress::LocalHost));
            QCOMPARE(info.port, client.socket().localPort());
            QCOMPARE(info.requests, 2U);
            QCOMPARE(info.errors, 2U);
            QCOMPARE(info.bytesSent, 46U);
            QVERIFY(info.since >= before && info.since <= utcNow());
            QVERIFY(info.lastRequest && *info.lastRequest >= info.since - 1ms && *info.lastRequest <= utcNow());
            QTRY_VERIFY(!changes.isEmpty());
            QCOMPARE(changes.last().first().value<QList<ClientInfo>>().size(), 1);
        }
        QTRY_VERIFY(changes.last().first().value<QList<ClientInfo>>().isEmpty());
        QVERIFY(desk.clients().isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestClientDesk)
#include "tst_clientdesk.moc"
