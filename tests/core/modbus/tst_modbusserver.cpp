#include "core/modbus/modbusserver.h"
#include "tests/core/modbus/modbussite.h"
#include "tests/core/net/rawsocket.h"
#include "tests/core/net/testclient.h"
#include "tests/support/fakeline.h"

#include <QRandomGenerator>
#include <QSignalSpy>
#include <QTcpServer>

#include <sys/socket.h>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

const QByteArray request = hex("0001 0000 0006 03 04 0000 0012");

QByteArray expectedAnswer()
{
    return hex("0001 0000 0027 03 04 24") + tiltBlock();
}

void feed(ModbusServer &server)
{
    server.updateReadings({sampleTilt(), sampleAcceleration()});
    server.updateLine(lineStatus(3, LineState::OpenFailed));
    server.updateLine(lineStatus(5, LineState::Lost));
}

} // namespace

/// The server over real loopback sockets: what a well-meaning client and an operator see.
class TestModbusServer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void servesBothUnits()
    {
        ModbusServer server(modbusSite());
        QVERIFY(server.connectDevice());
        QCOMPARE(server.state(), QModbusDevice::ConnectedState);
        feed(server);
        TestClient client(server.serverPort());
        QCOMPARE(client.ask(request, 45).toHex(), expectedAnswer().toHex());
        QCOMPARE(
            client.ask(hex("0002 0000 0006 06 04 0000 000C"), 33).toHex(),
            (hex("0002 0000 001B 06 04 18") + accelerationBlock()).toHex());
    }

    void servesNewValuesAtOnce()
    {
        ModbusServer server(modbusSite());
        QVERIFY(server.connectDevice());
        TestClient client(server.serverPort());
        QCOMPARE(
            client.ask(hex("0001 0000 0006 03 04 0002 0004"), 17), hex("0001 0000 000B 03 04 08 0000000000000007"));
        feed(server);
        QCOMPARE(
            client.ask(hex("0001 0000 0006 03 04 0002 0004"), 17), hex("0001 0000 000B 03 04 08 B7FFCAF800003803"));
    }

    void takesARequestByteByByte()
    {
        ModbusServer server(modbusSite());
        QVERIFY(server.connectDevice());
        feed(server);
        TestClient client(server.serverPort());
        TestClient other(server.serverPort());
        client.socket().setSocketOption(QAbstractSocket::LowDelayOption, 1);
        for (const char byte : request) {
            QCOMPARE(client.socket().bytesAvailable(), 0);
            client.send(QByteArray(1, byte));
            QCOMPARE(other.ask(request, 45), expectedAnswer()); // half a request holds up nobody
        }
        QCOMPARE(client.receive(45), expectedAnswer());
    }

    void answersPipelinedRequestsInOrder()
    {
        ModbusServer server(modbusSite());
        QVERIFY(server.connectDevice());
        feed(server);
        TestClient client(server.serverPort());
        QByteArray requests;
        QByteArray expected;
        for (int i = 0; i < 20000; ++i) {
            QByteArray one = request;
            QByteArray answer = expectedAnswer();
            one[0] = answer[0] = static_cast<char>(i >> 8);
            one[1] = answer[1] = static_cast<char>(i);
            requests += one;
            expected += answer;
        }
        client.send(requests);
        QByteArray received;
        QVERIFY(QTest::qWaitFor(
            [&] {
                received += client.socket().readAll();
                return received.size() >= expected.size();
            },
            20000));
        QVERIFY(received == expected);
    }

    void answersAClientThatEndsRightAfterTheRequest()
    {
        ModbusServer server(modbusSite());
        QVERIFY(server.connectDevice());
        feed(server);
        for (int i = 0; i < 50; ++i) {
            TestClient client(server.serverPort());
            client.socket().write(request);
            client.socket().flush();
            // Half-close: the FIN follows the request, the way back stays open.
            QCOMPARE(::shutdown(static_cast<int>(client.socket().socketDescriptor()), SHUT_WR), 0);
            QCOMPARE(client.receive(45), expectedAnswer());
        }
    }

    void closesOnAWrongLength_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("seven bytes that hang another server") << hex("00 01 00 00 FF FA 03");
        QTest::newRow("0") << hex("00 01 00 00 00 00");
        QTest::newRow("1") << hex("00 01 00 00 00 01 03");
        QTest::newRow("255") << hex("00 01 00 00 00 FF 03");
        QTest::newRow("65535") << hex("00 01 00 00 FF FF 03");
        QTest::newRow("a browser") << QByteArray("GET / HTTP/1.1\r\n\r\n");
    }

    void closesOnAWrongLength()
    {
        QFETCH(const QByteArray, bytes);
        ModbusServer server(modbusSite());
        JournalSpy journal(server.desk());
        QVERIFY(server.connectDevice());
        feed(server);
        for (int i = 0; i < 5; ++i) {
            TestClient client(server.serverPort());
            client.send(request);
            QCOMPARE(client.receive(45), expectedAnswer());
            client.send(bytes);
            QVERIFY(client.isClosedByServer());
        }
        QCOMPARE(journal.count("does not speak Modbus"), 1);
        TestClient client(server.serverPort());
        QCOMPARE(client.ask(request, 45), expectedAnswer());
    }

    void survivesTheShortestAndTheLongestFrame()
    {
        ModbusServer server(modbusSite());
        QVERIFY(server.connectDevice());
        TestClient client(server.serverPort());
        QCOMPARE(client.ask(hex("0001 0000 0002 03 04"), 9), hex("0001 0000 0003 03 84 03"));
        QCOMPARE(client.ask(hex("0001 0000 00FE 03 10") + QByteArray(252, 'x'), 9), hex("0001 0000 0003 03 90 01"));
    }

    void doesNotListenEverywhereInsteadOfSomewhere()
    {
        ModbusConfig config = modbusSite();
        config.desk.bind = QStringLiteral("office");
        ModbusServer server(config);
        JournalSpy journal(server.desk());
        QVERIFY(!server.connectDevice());
        QCOMPARE(server.state(), QModbusDevice::UnconnectedState);
        QCOMPARE(server.error(), QModbusDevice::ConfigurationError);
        QVERIFY(journal.has(JournalKind::Error, "\"office\" in ModbusBind"));
        QCOMPARE(server.serverPort(), 0);
    }

    void waitsForATakenPort()
    {
        QTcpServer holder;
        QVERIFY(holder.listen(QHostAddress(QHostAddress::LocalHost)));
        ModbusConfig config = modbusSite();
        config.port = holder.serverPort();
        config.desk.retry = 50ms;
        ModbusServer server(config);
        JournalSpy journal(server.desk());
        QSignalSpy errors(&server, &QModbusDevice::errorOccurred);
        QVERIFY(server.connectDevice());
        QCOMPARE(server.state(), QModbusDevice::ConnectingState);
        QTest::qWait(300);
        QCOMPARE(journal.entries().size(), 1); // once, not once an attempt
        QVERIFY(journal.has(JournalKind::Error, "choose another IPPort1"));
        QVERIFY(journal.has(JournalKind::Error, qPrintable(QStringLiteral("port %1").arg(config.port))));
        QCOMPARE(errors.size(), 1);
        holder.close();
        QTRY_COMPARE(server.state(), QModbusDevice::ConnectedState);
        QVERIFY(journal.has(JournalKind::On, "serving on port"));
        TestClient client(server.serverPort());
        QCOMPARE(client.ask(request, 45).size(), 45);
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
        QTRY_COMPARE(server.desk().clients().size(), 1);
    }

    void endsWithClientsInTheMiddleOfARequest()
    {
        auto server = std::make_unique<ModbusServer>(modbusSite());
        QVERIFY(server->connectDevice());
        TestClient half(server->serverPort());
        half.send(request.first(9));
        RawSocket asks;
        QVERIFY(asks.connect(server->serverPort()));
        QTRY_COMPARE(server->desk().clients().size(), 2);
        asks.send(request.repeated(50));
        server.reset();
        QVERIFY(half.isClosedByServer());
    }

    void theDoorOfTheBaseClassShowsTheImages()
    {
        ModbusServer server(modbusSite());
        feed(server);
        QModbusDataUnit unit(QModbusDataUnit::InputRegisters, 2, 2);
        QVERIFY(server.data(&unit));
        QCOMPARE(unit.values(), (QList<quint16>{0xB7FF, 0xCAF8}));
        server.setServerAddress(6);
        quint16 maximum = 0;
        QVERIFY(server.data(QModbusDataUnit::InputRegisters, 2, &maximum));
        QCOMPARE(maximum, 0xFF02);
        QVERIFY(!server.data(QModbusDataUnit::HoldingRegisters, 2, &maximum));
        QVERIFY(!server.data(QModbusDataUnit::InputRegisters, 12, &maximum));
        QVERIFY(!server.setData(QModbusDataUnit::InputRegisters, 2, 1));
        QVERIFY(!server.setMap({}));
        server.setServerAddress(2);
        QVERIFY(!server.data(QModbusDataUnit::InputRegisters, 2, &maximum));
    }
};

QTEST_GUILESS_MAIN(TestModbusServer)
#include "tst_modbusserver.moc"
