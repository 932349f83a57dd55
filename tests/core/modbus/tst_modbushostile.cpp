#include "core/modbus/modbussentences.h"
#include "tests/core/modbus/modbussite.h"
#include "tests/core/modbus/rawsocket.h"
#include "tests/core/modbus/testclient.h"
#include "tests/support/cpushare.h"
#include "tests/support/fakeline.h"

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

const QByteArray request = hex("0001 0000 0006 03 04 0000 0012");

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

/// The server against clients that are broken or mean no good, and against a system out of means.
class TestModbusHostile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void dropsAClientThatNeverReads()
    {
        ModbusConfig config = modbusSite();
        config.stall = 1000ms;
        ModbusServer server(config);
        JournalSpy journal(server);
        QVERIFY(server.connectDevice());
        TestClient other(server.serverPort());
        RawSocket deaf;
        deaf.setReceiveBuffer(4096);
        QVERIFY(deaf.connect(server.serverPort()));
        QTRY_COMPARE(server.clients().size(), 2);

        // It asks until the server takes no more, and long after.
        const QByteArray flood = request.repeated(300);
        quint64 generated = 0;
        QElapsedTimer quiet;
        quiet.start();
        std::optional<CpuShare> sincePause;
        while (server.clients().size() == 2 && quiet.elapsed() < 20000) {
            const ssize_t taken = deaf.send(flood);
            const quint64 answered = server.clients().size() == 2 ? server.clients().at(1).bytesSent : generated;
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
        QCOMPARE(server.clients().size(), 1);
        QCOMPARE(server.clients().first().port, other.socket().localPort());
        QVERIFY(journal.has(JournalKind::Error, "does not read the answers"));
        QTRY_VERIFY(deaf.isGone() || deaf.send(flood) < 0);
        QVERIFY2(generated > static_cast<quint64>(ModbusPeer::unsentLimit), "it was paused before the limit");
        // What the system buffers for the connection (4 MiB by default) and one read beyond the limit.
        QVERIFY2(generated < 8'000'000U, "it was not paused");
    }

    void servesAClientThatReadsLate()
    {
        ModbusConfig config = modbusSite();
        config.stall = 5000ms;
        ModbusServer server(config);
        QVERIFY(server.connectDevice());
        RawSocket slow;
        QVERIFY(slow.connect(server.serverPort()));
        QTRY_COMPARE(server.clients().size(), 1);
        const QByteArray requests = request.repeated(1000);
        qsizetype sent = 0;
        for (int idleTurns = 0; idleTurns < 20;) {
            const ssize_t taken = slow.send(requests.mid(sent % requests.size()));
            QVERIFY(taken >= 0);
            sent += taken;
            QTest::qWait(taken > 0 ? 0 : 5);
            idleTurns = taken > 0 ? 0 : idleTurns + 1;
        }
        const qsizetype asked = sent / request.size();
        QVERIFY(asked * 45 > 1'000'000);
        // The server has stopped reading and nothing was lost: all answers come when the client reads.
        qsizetype received = 0;
        QElapsedTimer watch;
        watch.start();
        while (received < asked * 45 && watch.elapsed() < 30000) {
            QCoreApplication::processEvents(); // without the pauses of qWaitFor(): the server lives in this thread
            for (QByteArray piece = slow.receive(); !piece.isEmpty(); piece = slow.receive()) {
                received += piece.size();
            }
        }
        QCOMPARE(received, asked * 45);
        QCOMPARE(server.clients().size(), 1);
    }

    void survivesWithoutDescriptors()
    {
        ModbusConfig config = modbusSite();
        config.acceptPause = 100ms;
        ModbusServer server(config);
        JournalSpy journal(server);
        QVERIFY(server.connectDevice());
        TestClient early(server.serverPort());
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
            QVERIFY(client->connect(server.serverPort()));
        }
        QTRY_VERIFY(journal.has(JournalKind::Error, "cannot be accepted"));
        const qsizetype accepted = server.clients().size();
        QVERIFY(accepted < 9);
        const CpuShare share;
        QTest::qWait(500);
        QVERIFY2(!share.spins(), "it spins");
        QCOMPARE(early.ask(request, 45).size(), 45); // those connected are served on
        QCOMPARE(journal.count("cannot be accepted"), 1);

        clients.front()->close(); // its number is free again, and the server's with it
        QTRY_VERIFY(server.clients().size() >= accepted);
        limit.set(highest + 40);
        QTRY_COMPARE(server.clients().size(), 8); // the early one and the seven left
        clients.back()->send(request);
        QByteArray answer;
        QTRY_COMPARE((answer += clients.back()->receive()).size(), 45);
        QCOMPARE(journal.count("cannot be accepted"), 1);
    }

    void acceptsAStormOfConnections()
    {
        ModbusConfig config = modbusSite();
        config.clients = 16;
        ModbusServer server(config);
        JournalSpy journal(server);
        QVERIFY(server.connectDevice());
        std::vector<std::unique_ptr<RawSocket>> clients;
        for (int i = 0; i < 400; ++i) {
            clients.push_back(std::make_unique<RawSocket>());
            QVERIFY(clients.back()->connect(server.serverPort()));
        }
        QTRY_VERIFY(clients.at(0)->isGone() && clients.at(383)->isGone());
        QCOMPARE(server.clients().size(), 16);
        QVERIFY(!clients.at(399)->isGone());
        QCOMPARE(journal.entries().size(), 3); // serving, connected, gave way: one line each
    }

    void survivesGarbage()
    {
        ModbusServer server(modbusSite());
        QVERIFY(server.connectDevice());
        TestClient other(server.serverPort());
        QRandomGenerator random(20180207);
        for (int i = 0; i < 300; ++i) {
            RawSocket client;
            QVERIFY(client.connect(server.serverPort()));
            QByteArray bytes(random.bounded(1, 600), '\0');
            for (char &byte : bytes) {
                byte = static_cast<char>(random.generate());
            }
            if (i % 2 == 0) {
                bytes.replace(2, 4, hex("0000 0006"));
            }
            client.send(bytes);
            if (i % 3 == 0) {
                QTest::qWait(1);
            }
        }
        QCOMPARE(other.ask(request, 45).size(), 45);
        QTRY_COMPARE(server.clients().size(), 1);
    }

    void endsWithClientsInTheMiddleOfARequest()
    {
        auto server = std::make_unique<ModbusServer>(modbusSite());
        QVERIFY(server->connectDevice());
        TestClient half(server->serverPort());
        half.send(request.first(9));
        RawSocket asks;
        QVERIFY(asks.connect(server->serverPort()));
        QTRY_COMPARE(server->clients().size(), 2);
        asks.send(request.repeated(50));
        server.reset();
        QVERIFY(half.isClosedByServer());
    }

    void saysWhatToDo()
    {
        using namespace modbussentence;
        const QString reason = QStringLiteral("reason");
        const QString taken = cannotListen(502, QAbstractSocket::AddressInUseError, reason, 5s);
        QVERIFY(taken.contains(QStringLiteral("502")) && taken.contains(QStringLiteral("IPPort1")));
        QVERIFY(taken.contains(QStringLiteral("every 5 s")));
        const QString forbidden = cannotListen(502, QAbstractSocket::SocketAccessError, reason, 5s);
        QVERIFY(forbidden.contains(QStringLiteral("setcap cap_net_bind_service=+ep /")));
        QVERIFY(forbidden.contains(QStringLiteral("IPPort1")));
        const QString absent = cannotListen(502, QAbstractSocket::SocketAddressNotAvailableError, reason, 5s);
        QVERIFY(absent.contains(QStringLiteral("ModbusBind")));
    }
};

QTEST_GUILESS_MAIN(TestModbusHostile)
#include "tst_modbushostile.moc"
