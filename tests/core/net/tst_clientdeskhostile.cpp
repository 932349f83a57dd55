#include "core/net/clientdesk.h"
#include "tests/core/net/rawsocket.h"
#include "tests/core/net/testclient.h"
#include "tests/core/net/toyservice.h"
#include "tests/support/cpushare.h"

#include <QRandomGenerator>

#include <memory>
#include <optional>
#include <sys/resource.h>
#include <utility>
#include <vector>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

const QByteArray request = QByteArray(10, 'a'); // the answer has 45 bytes

/// How many whole requests \a client could send until the server, in this thread, reads no more.
qsizetype askUntilNotRead(RawSocket &client)
{
    const QByteArray requests = request.repeated(1000);
    qsizetype sent = 0;
    for (int idleTurns = 0; idleTurns < 20;) {
        const ssize_t taken = client.send(requests.mid(sent % requests.size()));
        if (taken < 0) {
            return -1;
        }
        sent += taken;
        QTest::qWait(taken > 0 ? 0 : 5);
        idleTurns = taken > 0 ? 0 : idleTurns + 1;
    }
    return sent / request.size();
}

/// How many bytes \a client gets, at most \a expected, when it takes \a piece at a time.
qsizetype receiveAll(RawSocket &client, qsizetype expected, qsizetype piece)
{
    qsizetype received = 0;
    QElapsedTimer watch;
    watch.start();
    while (received < expected && watch.elapsed() < 30000) {
        QCoreApplication::processEvents(); // without the pauses of qWaitFor(): the server lives in this thread
        received += client.receive(piece).size();
    }
    return received;
}

/// Puts the soft limit of descriptors back whatever happens.
class DescriptorLimit
{
public:
    DescriptorLimit() { ::getrlimit(RLIMIT_NOFILE, &m_old); }
    ~DescriptorLimit() { ::setrlimit(RLIMIT_NOFILE, &m_old); }
    DescriptorLimit(const DescriptorLimit &) = delete;
    DescriptorLimit &operator=(const DescriptorLimit &) = delete;

    void set(int limit) const
    {
        rlimit lowered = m_old;
        lowered.rlim_cur = static_cast<rlim_t>(limit);
        ::setrlimit(RLIMIT_NOFILE, &lowered);
    }

private:
    rlimit m_old{};
};

} // namespace

/// The desk against clients that are broken or mean no good, and against a system out of means.
class TestClientDeskHostile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The socket lives on after we have closed it, and so does what the system says about it.
    void forgetsAClientWhoseSocketIsHeldElsewhere()
    {
        ClientDesk desk(toyService(), {});
        QVERIFY(desk.open(loopback(), 0));
        RawSocket client;
        QVERIFY(client.connect(desk.port()));
        QTRY_COMPARE(desk.clients().size(), 1);
        const int held = holdServerEnd(desk.port());
        QVERIFY(held >= 0);
        client.close();
        QTRY_COMPARE(desk.clients().size(), 0);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        const CpuShare share;
        QTest::qWait(500); // what the socket still says must reach nobody and keep nobody busy
        QVERIFY(!share.spins());
        ::close(held);
        TestClient other(desk.port());
        QCOMPARE(other.ask(request, 45).size(), 45);
    }

    void dropsAClientThatNeverReads()
    {
        DeskConfig config;
        config.stall = 1000ms;
        ClientDesk desk(toyService(), config);
        JournalSpy journal(desk);
        QVERIFY(desk.open(loopback(), 0));
        TestClient other(desk.port());
        RawSocket deaf;
        deaf.setReceiveBuffer(4096);
        QVERIFY(deaf.connect(desk.port()));
        QTRY_COMPARE(desk.clients().size(), 2);

        // It asks until the server takes no more, and long after.
        const QByteArray flood = request.repeated(300);
        quint64 generated = 0;
        QElapsedTimer quiet;
        quiet.start();
        std::optional<CpuShare> sincePause;
        while (desk.clients().size() == 2 && quiet.elapsed() < 20000) {
            const ssize_t taken = deaf.send(flood);
            const quint64 answered = desk.clients().size() == 2 ? desk.clients().at(1).bytesSent : generated;
            if (std::exchange(generated, answered) != answered) {
                sincePause.reset();
            } else if (!sincePause) {
                sincePause.emplace();
            }
            QCOMPARE(other.ask(request, 45).size(), 45); // served all the while
            if (taken <= 0) {
                QTest::qWait(20);
            }
        }
        QVERIFY2(sincePause && !sincePause->spins(), "a paused client costs the CPU");
        QCOMPARE(desk.clients().size(), 1);
        QCOMPARE(desk.clients().first().port, other.socket().localPort());
        QVERIFY(journal.has(JournalKind::Error, "does not read the answers"));
        QTRY_VERIFY(deaf.isGone() || deaf.send(flood) < 0);
        QVERIFY2(generated > static_cast<quint64>(ClientPeer::unsentLimit), "it was paused before the limit");
        // What the system buffers for the connection (4 MiB by default) and one read beyond the limit.
        QVERIFY2(generated < 8'000'000U, "it was not paused");
    }

    void servesAClientThatReadsLate()
    {
        DeskConfig config;
        config.stall = 5000ms;
        ClientDesk desk(toyService(), config);
        QVERIFY(desk.open(loopback(), 0));
        RawSocket slow;
        QVERIFY(slow.connect(desk.port()));
        const qsizetype asked = askUntilNotRead(slow);
        QVERIFY(asked * 45 > 1'000'000);
        // The server has stopped reading and nothing was lost: all answers come when the client reads.
        QCOMPARE(receiveAll(slow, asked * 45, 65536), asked * 45);
        QCOMPARE(desk.clients().size(), 1);
    }

    void answersAClientThatHasClosedItsEnd()
    {
        ClientDesk desk(toyService(), DeskConfig());
        QVERIFY(desk.open(loopback(), 0));
        RawSocket slow;
        QVERIFY(slow.connect(desk.port()));
        const qsizetype asked = askUntilNotRead(slow);
        QVERIFY(asked * 45 > 1'000'000);
        slow.finish();
        // More slowly than the server answers: answers still wait in it when it comes to the end.
        QCOMPARE(receiveAll(slow, asked * 45, 4096), asked * 45);
        QTRY_VERIFY(desk.clients().isEmpty());
        QVERIFY(slow.isGone());
    }

    void survivesWithoutDescriptors()
    {
        DeskConfig config;
        config.acceptPause = 100ms;
        ClientDesk desk(toyService(), config);
        JournalSpy journal(desk);
        QVERIFY(desk.open(loopback(), 0));
        TestClient early(desk.port());
        QCOMPARE(early.ask(request, 45).size(), 45);
        std::vector<std::unique_ptr<RawSocket>> clients;
        int highest = 0;
        for (int i = 0; i < 8; ++i) {
            clients.push_back(std::make_unique<RawSocket>());
            highest = std::max(highest, clients.back()->fd());
        }
        // Note for sanitizer builds: the first virtual call on a type opens a pipe to look at the object, so without
        // descriptors a type that was not used before is reported as an invalid object.
        const DescriptorLimit limit;
        limit.set(highest + 4); // three more, and no descriptor for the others
        for (const auto &client : clients) {
            QVERIFY(client->connect(desk.port()));
        }
        QTRY_VERIFY(journal.has(JournalKind::Error, "cannot be accepted"));
        const qsizetype accepted = desk.clients().size();
        QVERIFY(accepted < 9);
        const CpuShare share;
        QTest::qWait(500);
        QVERIFY2(!share.spins(), "it spins");
        QCOMPARE(early.ask(request, 45).size(), 45); // those connected are served on
        QCOMPARE(journal.count("cannot be accepted"), 1);

        clients.front()->close(); // its number is free again, and the server's with it
        QTRY_VERIFY(desk.clients().size() >= accepted);
        limit.set(highest + 40);
        QTRY_COMPARE(desk.clients().size(), 8); // the early one and the seven left
        clients.back()->send(request);
        QByteArray answer;
        QTRY_COMPARE((answer += clients.back()->receive()).size(), 45);
        QCOMPARE(journal.count("cannot be accepted"), 1);
    }

    void acceptsAStormOfConnections()
    {
        DeskConfig config;
        config.clients = 16;
        ClientDesk desk(toyService(), config);
        JournalSpy journal(desk);
        QVERIFY(desk.open(loopback(), 0));
        std::vector<std::unique_ptr<RawSocket>> clients;
        for (int i = 0; i < 400; ++i) {
            clients.push_back(std::make_unique<RawSocket>());
            QVERIFY(clients.back()->connect(desk.port()));
        }
        QTRY_VERIFY(clients.at(0)->isGone() && clients.at(383)->isGone());
        QCOMPARE(desk.clients().size(), 16);
        QVERIFY(!clients.at(399)->isGone());
        QCOMPARE(journal.entries().size(), 3); // serving, connected, gave way: one line each
    }

    void saysWhatToDo()
    {
        const DeskSentences say(QStringLiteral("Toy TCP"), QStringLiteral("IPPort9"));
        const QString reason = QStringLiteral("reason");
        const QString taken = say.cannotListen(502, QAbstractSocket::AddressInUseError, reason, 5s);
        QVERIFY(taken.contains(QStringLiteral("502")) && taken.contains(QStringLiteral("IPPort9")));
        QVERIFY(taken.contains(QStringLiteral("every 5 s")));
        const QString forbidden = say.cannotListen(502, QAbstractSocket::SocketAccessError, reason, 5s);
        QVERIFY(forbidden.contains(QStringLiteral("setcap cap_net_bind_service=+ep /")));
        QVERIFY(forbidden.contains(QStringLiteral("IPPort9")));
        const QString absent = say.cannotListen(502, QAbstractSocket::SocketAddressNotAvailableError, reason, 5s);
        QVERIFY(absent.contains(QStringLiteral("ModbusBind")));
    }
};

QTEST_GUILESS_MAIN(TestClientDeskHostile)
#include "tst_clientdeskhostile.moc"
