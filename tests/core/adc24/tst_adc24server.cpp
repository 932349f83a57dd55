#include "core/adc24/adc24server.h"
#include "tests/core/adc24/adc24site.h"
#include "tests/core/net/rawsocket.h"
#include "tests/core/net/testclient.h"
#include "tests/support/fakeline.h"

#include <QRandomGenerator>
#include <QTcpServer>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

const QByteArray countRequest = hex("01 01 00 00 00 00000000 00000000");
const QByteArray sixAvailable = hex("01 01 06000000");
const QByteArray fourRequest = hex("01 03 00 00 00 00000000 04000000");
const QByteArray fourSamples =
    hex("01 03 02 00 04000000 000000000000C03F 0000000000002440 0100 FFFF 0001 FEFF"); // 32 bytes

void feed(Adc24Server &server)
{
    server.updateReadings({statusReading(0x3704, 3), statusReading(0x0018)});
    server.appendBlock(sixSamples());
}

} // namespace

/// The server over real loopback sockets.
class TestAdc24Server : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void servesSamplesAsTheyCome()
    {
        Adc24Server server(adc24Site());
        server.start();
        TestClient client(server.desk().port());
        QCOMPARE(client.ask(countRequest, 6), hex("01 01 00000000"));
        QCOMPARE(client.ask(fourRequest, 8), hex("01 03 000F 00000000"));
        feed(server);
        QCOMPARE(client.ask(countRequest, 6), sixAvailable);
        QCOMPARE(client.ask(fourRequest, 32).toHex(' '), fourSamples.toHex(' '));
        server.appendBlock(sampleBlock({1, 2}));
        QCOMPARE(client.ask(countRequest, 6), hex("01 01 08000000"));
        server.appendBlock(sampleBlock({1, 2}, false)); // the sensor was restarted
        QCOMPARE(client.ask(countRequest, 6), hex("01 01 02000000"));
    }

    void takesARequestByteByByteWhileAnotherIsServed()
    {
        Adc24Server server(adc24Site());
        server.start();
        feed(server);
        TestClient client(server.desk().port());
        TestClient other(server.desk().port());
        client.socket().setSocketOption(QAbstractSocket::LowDelayOption, 1);
        for (const char byte : fourRequest) {
            QCOMPARE(client.socket().bytesAvailable(), 0);
            client.send(QByteArray(1, byte));
            QCOMPARE(other.ask(countRequest, 6), sixAvailable);
        }
        QCOMPARE(client.receive(32), fourSamples);
        QCOMPARE(server.desk().clients().first().errors, 0U);
    }

    void answersPipelinedRequestsInOrder()
    {
        Adc24Server server(adc24Site());
        server.start();
        feed(server);
        TestClient client(server.desk().port());
        client.send((countRequest + fourRequest).repeated(5000));
        const QByteArray expected = (sixAvailable + fourSamples).repeated(5000);
        QByteArray received;
        QElapsedTimer watch;
        watch.start();
        while (received.size() < expected.size() && watch.elapsed() < 30000) {
            QCoreApplication::processEvents(); // without the pauses of qWaitFor(): the server lives in this thread
            received += client.socket().readAll();
        }
        QVERIFY(received == expected);
    }

    void saysNothingToOtherLengthsAndCommands()
    {
        Adc24Config config = adc24Site();
        config.patience = 200ms;
        Adc24Server server(config);
        JournalSpy journal(server.desk());
        server.start();
        feed(server);
        TestClient client(server.desk().port());
        client.send(countRequest.first(12));
        QTRY_COMPARE(server.desk().clients().first().errors, 1U);
        QVERIFY(journal.has(JournalKind::Error, "ADC24 TCP: client 127.0.0.1 sends what is no request"));
        // The twelve bytes are forgotten: the next request is understood.
        QCOMPARE(client.ask(countRequest, 6), sixAvailable);
        client.send(hex("01 02 00 00 00 00000000 00000000"));
        client.send(hex("02 01 00 00 00 00000000 00000000"));
        QCOMPARE(client.ask(countRequest, 6), sixAvailable);
        QCOMPARE(server.desk().clients().first().errors, 3U);
        QCOMPARE(journal.count("no request"), 1);
        QCOMPARE(client.socket().bytesAvailable(), 0);
    }

    void survivesGarbage()
    {
        Adc24Config config = adc24Site();
        config.patience = 50ms;
        Adc24Server server(config);
        JournalSpy journal(server.desk());
        server.start();
        feed(server);
        TestClient other(server.desk().port());
        QRandomGenerator random(20180207);
        for (int i = 0; i < 300; ++i) {
            RawSocket client;
            QVERIFY(client.connect(server.desk().port()));
            QByteArray bytes(random.bounded(1, 600), '\0');
            for (char &byte : bytes) {
                byte = static_cast<char>(random.generate());
            }
            if (i % 2 == 0) {
                bytes.replace(0, 5, hex("01 03 00 00 00"));
            }
            client.send(bytes);
            if (i % 3 == 0) {
                QTest::qWait(1);
            }
        }
        QCOMPARE(other.ask(countRequest, 6), sixAvailable);
        QTRY_COMPARE(server.desk().clients().size(), 1);
        QVERIFY(journal.entries().size() <= 3); // serving, connected, no request
    }

    void aFloodOfTheLargestRequestsIsBounded()
    {
        Adc24Config config = adc24Site();
        config.ringPackets = 256;
        config.desk.stall = 1000ms;
        Adc24Server server(config);
        JournalSpy journal(server.desk());
        server.start();
        server.appendBlock(sampleBlock(QList<qint16>(8192, 1)));
        TestClient other(server.desk().port());
        RawSocket deaf;
        deaf.setReceiveBuffer(4096);
        QVERIFY(deaf.connect(server.desk().port()));
        QTRY_COMPARE(server.desk().clients().size(), 2);
        const QByteArray flood = hex("01 03 00 00 00 00000000 00200000").repeated(300);
        quint64 generated = 0;
        QElapsedTimer watch;
        watch.start();
        while (server.desk().clients().size() == 2 && watch.elapsed() < 20000) {
            const ssize_t taken = deaf.send(flood);
            if (server.desk().clients().size() == 2) {
                generated = server.desk().clients().at(1).bytesSent;
            }
            QCOMPARE(other.ask(countRequest, 6), hex("01 01 00200000")); // served all the while
            if (taken <= 0) {
                QTest::qWait(20);
            }
        }
        QCOMPARE(server.desk().clients().size(), 1);
        QCOMPARE(server.desk().clients().first().port, other.socket().localPort());
        QVERIFY(journal.has(JournalKind::Error, "does not read the answers"));
        // What the system buffers for the connection (4 MiB by default), 256 KiB, and the answers of one turn.
        QVERIFY2(generated < 8'000'000U, "it was not paused");
    }

    void aGreedyClientThatReadsGetsEverything()
    {
        Adc24Config config = adc24Site();
        config.ringPackets = 256;
        Adc24Server server(config);
        server.start();
        server.appendBlock(sampleBlock(QList<qint16>(8192, 1)));
        TestClient greedy(server.desk().port());
        constexpr qsizetype requests = 500;
        greedy.send(hex("01 03 00 00 00 00000000 00200000").repeated(requests));
        qsizetype received = 0;
        QVERIFY(QTest::qWaitFor(
            [&] {
                received += greedy.socket().readAll().size();
                return received >= requests * (24 + 16384);
            },
            30000));
        QCOMPARE(received, requests * (24 + 16384));
        QCOMPARE(server.desk().clients().first().requests, 500U);
    }

    void cutsOffIdleClientsAndThoseWhoOnlySendNonsense()
    {
        Adc24Config config = adc24Site();
        config.desk.idle = 1000ms;
        Adc24Server server(config);
        server.start();
        feed(server);
        TestClient idle(server.desk().port());
        TestClient nonsense(server.desk().port());
        TestClient busy(server.desk().port());
        QElapsedTimer watch;
        watch.start();
        while ((idle.isConnected() || nonsense.isConnected()) && watch.elapsed() < 10000) {
            nonsense.send(QByteArray(13, '\0'));
            QCOMPARE(busy.ask(countRequest, 6), sixAvailable);
            QTest::qWait(20);
        }
        QVERIFY(!idle.isConnected());
        QVERIFY(!nonsense.isConnected());
        QVERIFY(busy.isConnected());
    }

    void saysWhichPortIsTaken()
    {
        QTcpServer holder;
        QVERIFY(holder.listen(QHostAddress(QHostAddress::LocalHost)));
        Adc24Config config = adc24Site();
        config.port = holder.serverPort();
        config.desk.retry = 50ms;
        Adc24Server server(config);
        JournalSpy journal(server.desk());
        server.start();
        QTest::qWait(300);
        QCOMPARE(journal.entries().size(), 1); // once, not once an attempt
        QVERIFY(journal.has(
            JournalKind::Error,
            qPrintable(QStringLiteral("ADC24 TCP: cannot serve on port %1").arg(holder.serverPort()))));
        QVERIFY(journal.has(JournalKind::Error, "choose another IPPort2"));
        holder.close();
        QTRY_VERIFY(journal.has(JournalKind::On, "ADC24 TCP: serving on port"));
        TestClient client(server.desk().port());
        QCOMPARE(client.ask(countRequest, 6), hex("01 01 00000000"));
        server.stop();
        QVERIFY(client.isClosedByServer());
        QVERIFY(journal.has(JournalKind::Off, "ADC24 TCP: stopped."));
    }
};

QTEST_GUILESS_MAIN(TestAdc24Server)
#include "tst_adc24server.moc"
