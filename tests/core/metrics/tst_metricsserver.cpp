#include "core/metrics/metricsserver.h"

#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>

using namespace gorizont;
using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

namespace {

constexpr int patience = 30000; // ms, of a test that fails

MetricsServer::Settings anyPort()
{
    MetricsServer::Settings settings;
    settings.metrics = {0, u"127.0.0.1"_s};
    settings.retry = 50ms;
    return settings;
}

/// Everything that \a request brings until the server closes.
QByteArray exchange(quint16 port, const QByteArray &request)
{
    QTcpSocket socket;
    socket.connectToHost(QHostAddress::LocalHost, port);
    if (!socket.waitForConnected(patience)) {
        return "not connected";
    }
    socket.write(request);
    while (socket.state() == QAbstractSocket::ConnectedState && socket.waitForReadyRead(patience)) {
    }
    return socket.readAll();
}

QByteArray request(const QByteArray &line)
{
    return line + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n";
}

} // namespace

class TestMetricsServer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void servesTheBoard();
    void answersOthers_data();
    void answersOthers();
    void survivesBadClients();
    void goesOnTryingWhileThePortIsTaken();
    void refusesABadAddress();
    void servesIPv6();
};

void TestMetricsServer::servesTheBoard()
{
    LineConfig line;
    line.index = 1;
    MetricsServer server(anyPort(), {line});
    QStringList told;
    connect(&server, &MetricsServer::journal, this, [&told](const JournalEntry &entry) { told.append(entry.text); });
    server.start();
    QVERIFY(server.port() > 0);
    QCOMPARE(told, QStringList{u"Metrics: serving http://127.0.0.1:%1/metrics."_s.arg(server.port())});
    LineStatus status;
    status.port = 1;
    status.bytesSent = 12345;
    server.board().put(status);
    const QByteArray answer = exchange(server.port(), request("GET /metrics"));
    QVERIFY2(answer.startsWith("HTTP/1.1 200 "), answer);
    QVERIFY2(answer.toLower().contains("\r\ncontent-type: text/plain; version=0.0.4; charset=utf-8\r\n"), answer);
    QVERIFY2(answer.contains("\ngorizont_port_sent_bytes_total{port=\"COM1\",index=\"1\"} 12345\n"), answer);
    const quint16 port = server.port();
    server.stop();
    QCOMPARE(exchange(port, request("GET /metrics")), "not connected");
}

void TestMetricsServer::answersOthers_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("status");
    QTest::newRow("other page") << QByteArray("GET /") << QByteArray("404");
    QTest::newRow("longer name") << QByteArray("GET /metrics/x") << QByteArray("404");
    QTest::newRow("with a query") << QByteArray("GET /metrics?a=b") << QByteArray("200");
    QTest::newRow("HEAD") << QByteArray("HEAD /metrics") << QByteArray("200");
    QTest::newRow("DELETE") << QByteArray("DELETE /metrics") << QByteArray("405");
    QTest::newRow("POST elsewhere") << QByteArray("POST /x") << QByteArray("404");
}

void TestMetricsServer::answersOthers()
{
    QFETCH(const QByteArray, line);
    QFETCH(const QByteArray, status);
    MetricsServer server(anyPort(), {});
    server.start();
    const QByteArray answer = exchange(server.port(), request(line));
    QVERIFY2(answer.startsWith("HTTP/1.1 " + status + ' '), answer);
    QCOMPARE(answer.contains("gorizont_uptime_seconds"), status == "200" && !line.startsWith("HEAD"));
    QCOMPARE(answer.toLower().contains("\r\nallow: get, head\r\n"), status == "405");
}

void TestMetricsServer::survivesBadClients()
{
    MetricsServer::Settings settings = anyPort();
    settings.idle = 1s;
    settings.clients = 4;
    MetricsServer server(settings, {});
    server.start();
    const QByteArray body(100'000, 'x');
    const QByteArray post =
        "POST /metrics HTTP/1.1\r\nHost: x\r\nConnection: close\r\nContent-Length: 100000\r\n\r\n" + body;
    const QByteArray posted = exchange(server.port(), post);
    QVERIFY2(posted.startsWith("HTTP/1.1 405 "), posted);
    exchange(server.port(), QByteArray(200'000, 'a')); // no end of a line
    exchange(server.port(), QByteArray(1000, '\0') + "\r\n\r\n");
    std::vector<std::unique_ptr<QTcpSocket>> dawdlers;
    for (int i = 0; i < 10; ++i) { // more than there are places, and none ever asks
        dawdlers.push_back(std::make_unique<QTcpSocket>());
        dawdlers.back()->connectToHost(QHostAddress::LocalHost, server.port());
        dawdlers.back()->waitForConnected(patience);
        dawdlers.back()->write("GET /met");
        dawdlers.back()->flush();
    }
    QTRY_VERIFY_WITH_TIMEOUT(exchange(server.port(), request("GET /metrics")).startsWith("HTTP/1.1 200 "), patience);
}

void TestMetricsServer::goesOnTryingWhileThePortIsTaken()
{
    QTcpServer other;
    QVERIFY(other.listen(QHostAddress::LocalHost));
    MetricsServer::Settings settings = anyPort();
    settings.metrics.port = other.serverPort();
    MetricsServer server(settings, {});
    QStringList told;
    connect(&server, &MetricsServer::journal, this, [&told](const JournalEntry &entry) { told.append(entry.text); });
    server.start();
    QCOMPARE(server.port(), 0);
    QTest::qWait(300); // several attempts
    QCOMPARE(told.size(), 1);
    QVERIFY2(told.first().contains(u"Another program uses this port."_s), qPrintable(told.first()));
    other.close();
    QTRY_COMPARE_WITH_TIMEOUT(int{server.port()}, settings.metrics.port, patience);
    QCOMPARE(told.size(), 2);
    QVERIFY(exchange(server.port(), request("GET /metrics")).startsWith("HTTP/1.1 200 "));
}

void TestMetricsServer::refusesABadAddress()
{
    MetricsServer::Settings settings = anyPort();
    settings.metrics.bind = u"everywhere"_s;
    MetricsServer server(settings, {});
    QStringList told;
    connect(&server, &MetricsServer::journal, this, [&told](const JournalEntry &entry) { told.append(entry.text); });
    server.start();
    QCOMPARE(server.port(), 0);
    QCOMPARE(told.size(), 1);
    QVERIFY2(told.first().contains(u"\"everywhere\""_s), qPrintable(told.first()));
}

void TestMetricsServer::servesIPv6()
{
    MetricsServer::Settings settings = anyPort();
    settings.metrics.bind = u"::1"_s;
    MetricsServer server(settings, {});
    server.start();
    if (server.port() == 0) {
        QSKIP("this machine has no IPv6");
    }
    QTcpSocket socket;
    socket.connectToHost(QHostAddress::LocalHostIPv6, server.port());
    QVERIFY(socket.waitForConnected(patience));
    socket.write(request("GET /metrics"));
    QVERIFY(socket.waitForReadyRead(patience));
    QVERIFY(socket.readAll().startsWith("HTTP/1.1 200 "));
}

QTEST_GUILESS_MAIN(TestMetricsServer)
#include "tst_metricsserver.moc"
