#include "core/opc/opcfeed.h"
#include "tests/core/opc/opcsite.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

namespace {

constexpr int patience = 30000; // ms, of a test that fails
constexpr int tagCount = 32; // of the site of the manual

OpcFeedConfig quickConfig(const ServerConfig &site = opcSite())
{
    OpcFeedConfig config = opcFeedConfig(site, {});
    config.port = 0;
    config.retry = 50ms;
    config.gather = 5ms;
    return config;
}

/// Many sensors: more tags than fit into one line of tags or of values.
ServerConfig largeSite(int sensors)
{
    ServerConfig site;
    LineConfig line;
    line.index = 1;
    line.isOn = true;
    for (int number = 1; number <= sensors; ++number) {
        SensorConfig sensor;
        sensor.port = 1;
        sensor.index = number;
        sensor.number = number;
        sensor.isOn = true;
        sensor.type = SensorType::AnD3;
        sensor.model = u"AN-D3"_s;
        sensor.measuresTilt = true;
        line.sensors.append(sensor);
    }
    site.lines.append(line);
    return site;
}

Reading answer(int number, double x)
{
    Reading reading;
    reading.number = number;
    reading.time = UtcTime(1'700'000'000'123'456us);
    reading.isAnswer = true;
    reading.answeredAt = SteadyTime::clock::now();
    reading.rawStatus = 0x240F;
    reading.tilt = Tilt{x, -1.5};
    return reading;
}

LineStatus openLine(int port = 1)
{
    LineStatus status;
    status.port = port;
    status.state = LineState::Open;
    return status;
}

/// A gateway made of a bare socket; it reads when it is told to.
class Client
{
public:
    explicit Client(quint16 port, qint64 readBuffer = 0)
    {
        m_socket.setReadBufferSize(readBuffer);
        m_socket.connectToHost(QHostAddress::LocalHost, port);
        m_socket.waitForConnected(patience);
    }

    bool isConnected() const { return m_socket.state() == QAbstractSocket::ConnectedState; }
    QTcpSocket &socket() { return m_socket; }
    void say(const QByteArray &bytes)
    {
        m_socket.write(bytes);
        m_socket.flush();
    }

    /// The next line; an empty one, when none comes.
    QByteArray line()
    {
        const QDeadlineTimer end(patience);
        while (!m_socket.canReadLine() && !end.hasExpired() && (isConnected() || m_socket.bytesAvailable() > 0)) {
            QTest::qWait(1);
        }
        return m_socket.readLine();
    }
    QJsonObject object() { return QJsonDocument::fromJson(line()).object(); }

    /// Reads up to and with the line that has \a key.
    QJsonObject until(const QString &key)
    {
        for (QJsonObject next = object(); !next.isEmpty(); next = object()) {
            if (next.contains(key)) {
                return next;
            }
        }
        return {};
    }

    /// The entry of tag \a index in the next lines of values that have it.
    QJsonArray value(int index)
    {
        for (;;) {
            const QJsonArray entries = until(u"v"_s).value(u"v"_s).toArray();
            if (entries.isEmpty()) {
                return {};
            }
            for (const QJsonValue &entry : entries) {
                if (entry.toArray().at(0).toInt() == index) {
                    return entry.toArray();
                }
            }
        }
    }

private:
    QTcpSocket m_socket;
};

struct Listener
{
    explicit Listener(OpcFeed &feed)
    {
        QObject::connect(&feed, &OpcFeed::journal, &feed, [this](const JournalEntry &entry) {
            told.append(entry.text);
        });
        QObject::connect(&feed, &OpcFeed::clientsChanged, &feed, [this](const QList<ClientInfo> &all) {
            clients = all;
        });
    }
    QStringList told;
    QList<ClientInfo> clients;
};

constexpr int anglX = 8; ///< index of DATA.Angl_X of the first sensor

} // namespace

class TestOpcFeed : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void greetsTagsAndSnapshot();
    void longListsComeInPieces();
    void entriesByteForByte();
    void changesFollow();
    void severalAtOnce();
    void aClientThatDoesNotReadGetsTheNewest();
    void aStalledClientIsDropped();
    void pingsInSilence();
    void garbageIsIgnored();
    void aLongLineEndsTheConnection_data();
    void aLongLineEndsTheConnection();
    void greetingsAreRead_data();
    void greetingsAreRead();
    void oldRegistrationIsToldOnce();
    void saysGoodbye();
    void portThatIsTaken();
    void onlyThisComputer();
    void tooManyAreRefused();
    void listedAndDismissed();
};

void TestOpcFeed::greetsTagsAndSnapshot()
{
    OpcFeedConfig config = quickConfig();
    config.caption = u"Башня \"7\""_s;
    OpcFeed feed(config);
    feed.start();
    feed.updateLine(openLine());
    feed.updateReadings({answer(1, 12.5)});
    Client client(feed.port());
    const QJsonObject hello = client.object();
    QCOMPARE(hello.value(u"hello"_s).toString(), u"GorizontServer"_s);
    QCOMPARE(hello.value(u"protocol"_s).toInt(), 1);
    QCOMPARE(hello.value(u"version"_s).toString(), QStringLiteral(GORIZONT_VERSION));
    QCOMPARE(hello.value(u"caption"_s).toString(), u"Башня \"7\""_s);
    QCOMPARE(hello.value(u"hash"_s).toString().toLatin1(), opcTagsHash(feed.tags()));
    QCOMPARE(hello.value(u"count"_s).toInt(), tagCount);
    const QJsonArray tags = client.object().value(u"tags"_s).toArray();
    QCOMPARE(tags.size(), tagCount);
    const QJsonObject restart{
        {u"name"_s, u"[COM5].Sensor_001[AND3][Addr:002].STATE.Restart"_s},
        {u"type"_s, u"bool"_s},
        {u"description"_s, feed.tags().at(0).description},
        {u"aliases"_s, QJsonArray{u"[COM5].Sensor_001[AND3][Addr:002].STATUS.Restart"_s}}};
    QCOMPARE(tags.at(0).toObject(), restart);
    QCOMPARE(tags.at(anglX).toObject().value(u"type"_s).toString(), u"double"_s);
    QVERIFY(!tags.at(anglX).toObject().contains(u"aliases"_s));
    QCOMPARE(client.line(), QByteArray("{\"ready\":true}\n"));
    const QJsonArray values = client.object().value(u"v"_s).toArray();
    QCOMPARE(values.size(), tagCount);
    for (int i = 0; i < tagCount; ++i) {
        QCOMPARE(values.at(i).toArray().at(0).toInt(), i);
    }
    QCOMPARE(values.at(anglX).toArray(), (QJsonArray{anglX, 12.5, 192, 1700000000123.0}));
    QCOMPARE(values.at(0).toArray(), (QJsonArray{0, true, 192, 1700000000123.0}));
    QCOMPARE(values.at(16).toArray().at(1), QJsonValue(QJsonValue::Null));
    QCOMPARE(values.at(16).toArray().at(2).toInt(), 32);
}

void TestOpcFeed::longListsComeInPieces()
{
    OpcFeed feed(quickConfig(largeSite(100)));
    feed.start();
    Client client(feed.port());
    QCOMPARE(client.object().value(u"count"_s).toInt(), 1600);
    QList<qsizetype> sizes;
    QStringList names;
    QJsonObject line = client.object();
    for (; line.contains(u"tags"_s); line = client.object()) {
        const QJsonArray tags = line.value(u"tags"_s).toArray();
        sizes.append(tags.size());
        for (const QJsonValue &tag : tags) {
            names.append(tag.toObject().value(u"name"_s).toString());
        }
    }
    QCOMPARE(sizes, QList<qsizetype>(8, 200));
    QVERIFY(line.contains(u"ready"_s));
    for (qsizetype i = 0; i < names.size(); ++i) {
        QCOMPARE(names.at(i), feed.tags().at(i).name);
    }
    sizes.clear();
    for (qsizetype got = 0; got < 1600; got += sizes.last()) {
        sizes.append(client.object().value(u"v"_s).toArray().size());
        QVERIFY(sizes.last() > 0);
    }
    QCOMPARE(sizes, (QList<qsizetype>{500, 500, 500, 100}));
}

/// By the agreed protocol, written by hand.
void TestOpcFeed::entriesByteForByte()
{
    QByteArray line = opclines::beginValues();
    opclines::appendValue(line, 0, {true, OpcQuality::Good, UtcTime(1'700'000'000'999'999us)});
    opclines::appendValue(line, 1, {false, OpcQuality::LastKnown, UtcTime(1s)});
    opclines::appendValue(line, 2, {0.1, OpcQuality::SensorFailure, UtcTime(0s)});
    opclines::appendValue(line, 3, {-1e-300, OpcQuality::NotConnected, UtcTime(0s)});
    opclines::appendValue(line, 4, {{}, OpcQuality::CommFailure, UtcTime(0s)});
    opclines::appendValue(line, 5, {3600.0, OpcQuality::OutOfService, UtcTime(0s)});
    opclines::endValues(line);
    QCOMPARE(
        line,
        QByteArray("{\"v\":[[0,true,192,1700000000999],[1,false,20,1000],[2,0.1,16,0],[3,-1e-300,8,0],[4,null,24,0],"
                   "[5,3600,28,0]]}\n"));
    QCOMPARE(opclines::ready(), QByteArray("{\"ready\":true}\n"));
    QCOMPARE(opclines::ping(), QByteArray("{\"ping\":true}\n"));
    QCOMPARE(opclines::end(), QByteArray("{\"end\":true}\n"));
}

void TestOpcFeed::changesFollow()
{
    OpcFeed feed(quickConfig());
    feed.start();
    feed.updateLine(openLine());
    Client client(feed.port());
    client.until(u"v"_s);
    feed.updateReadings({answer(1, 77)});
    QCOMPARE(client.value(anglX), (QJsonArray{anglX, 77, 192, 1700000000123.0}));
    LineStatus lost = openLine();
    lost.state = LineState::Lost;
    feed.updateLine(lost);
    const QJsonArray gone = client.value(anglX);
    QCOMPARE(gone.at(1).toDouble(), 77.0);
    QCOMPARE(gone.at(2).toInt(), 8);
}

void TestOpcFeed::severalAtOnce()
{
    OpcFeed feed(quickConfig());
    feed.start();
    feed.updateLine(openLine());
    Client first(feed.port());
    first.until(u"v"_s);
    Client second(feed.port());
    second.until(u"v"_s);
    feed.updateReadings({answer(1, 5)});
    QCOMPARE(first.value(anglX).at(1).toDouble(), 5.0);
    QCOMPARE(second.value(anglX).at(1).toDouble(), 5.0);
    first.socket().abort();
    feed.updateReadings({answer(1, 6)});
    QCOMPARE(second.value(anglX).at(1).toDouble(), 6.0);
}

/// What it has missed is not kept: the last value it reads is the last one there was, after far fewer bytes.
void TestOpcFeed::aClientThatDoesNotReadGetsTheNewest()
{
    constexpr int sensors = 100;
    constexpr int rounds = 300;
    OpcFeed feed(quickConfig(largeSite(sensors)));
    Listener listener(feed);
    feed.start();
    feed.updateLine(openLine());
    Client client(feed.port(), 1000);
    for (int round = 1; round <= rounds; ++round) {
        Readings batch;
        for (int number = 1; number <= sensors; ++number) {
            batch.append(answer(number, round));
            batch.last().time += std::chrono::seconds(round); // every tag changes
        }
        feed.updateReadings(batch);
        QTest::qWait(round % 10 == 0 ? 6 : 0);
    }
    client.socket().setReadBufferSize(0);
    qint64 bytes = 0;
    double last = 0;
    while (last < rounds) {
        const QByteArray line = client.line();
        QVERIFY(!line.isEmpty());
        bytes += line.size();
        for (const QJsonValue &entry : QJsonDocument::fromJson(line).object().value(u"v"_s).toArray()) {
            if (entry.toArray().at(0).toInt() == 16 * (sensors - 1) + anglX) {
                last = entry.toArray().at(1).toDouble();
            }
        }
    }
    QCOMPARE(last, double(rounds));
    // a round changes 1600 tags, more than 40,000 bytes: those of all rounds would be 12 MB
    QVERIFY2(bytes < 6'000'000, QByteArray::number(bytes));
}

void TestOpcFeed::aStalledClientIsDropped()
{
    OpcFeedConfig config = quickConfig(largeSite(400));
    config.pace.ping = 20ms;
    config.pace.stall = 300ms;
    OpcFeed feed(config);
    Listener listener(feed);
    feed.start();
    feed.updateLine(openLine());
    Client client(feed.port(), 1000);
    QTRY_VERIFY_WITH_TIMEOUT(listener.told.last().contains(u"takes nothing any more"), patience);
    Client other(feed.port()); // and the others are served
    QVERIFY(!other.until(u"ready"_s).isEmpty());
}

void TestOpcFeed::pingsInSilence()
{
    OpcFeedConfig config = quickConfig();
    config.pace.ping = 100ms;
    OpcFeed feed(config);
    feed.start();
    Client client(feed.port());
    client.until(u"v"_s);
    QElapsedTimer clock;
    clock.start();
    QCOMPARE(client.line(), QByteArray("{\"ping\":true}\n"));
    QCOMPARE(client.line(), QByteArray("{\"ping\":true}\n"));
    QVERIFY2(clock.elapsed() >= 150, QByteArray::number(clock.elapsed()));
    QCOMPARE(OpcGateway::Pace().ping, 2000ms);
}

void TestOpcFeed::garbageIsIgnored()
{
    OpcFeed feed(quickConfig());
    Listener listener(feed);
    feed.start();
    feed.updateLine(openLine());
    Client client(feed.port());
    client.until(u"v"_s);
    client.say(
        "GET / HTTP/1.1\r\n\r\n{\"client\":7}\n[1,2]\n\xff\xfe\n{\"write\":[1,2]}\n" + QByteArray(4000, 'x') + "\n");
    client.say("{\"client\":\"gorizont-opc-da\",\"version\":\"0.1.0\",\"pid\":1,\"registered\":\"\"}\n");
    client.say("{\"client\":\"again\"}\n");
    QTRY_COMPARE_WITH_TIMEOUT(listener.clients.value(0).requests, quint64{1}, patience);
    QTRY_COMPARE_WITH_TIMEOUT(listener.clients.value(0).errors, quint64{8}, patience);
    feed.updateReadings({answer(1, 9)});
    QCOMPARE(client.value(anglX).at(1).toDouble(), 9.0);
}

void TestOpcFeed::aLongLineEndsTheConnection_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("without an end") << QByteArray(4097, 'x');
    QTest::newRow("with an end") << QByteArray(4097, 'x') + '\n';
    QTest::newRow("behind a short one") << "{}\n" + QByteArray(5000, 'x') + '\n';
    QTest::newRow("very long") << QByteArray(1'000'000, 'x');
}

void TestOpcFeed::aLongLineEndsTheConnection()
{
    QFETCH(const QByteArray, bytes);
    OpcFeed feed(quickConfig());
    Listener listener(feed);
    feed.start();
    Client client(feed.port());
    client.until(u"ready"_s);
    client.say(bytes);
    QTRY_VERIFY_WITH_TIMEOUT(!client.isConnected(), patience);
    QTRY_VERIFY_WITH_TIMEOUT(listener.told.last().contains(u"is no gateway of this program"), patience);
    Client other(feed.port());
    QVERIFY(!other.until(u"ready"_s).isEmpty());
}

void TestOpcFeed::greetingsAreRead_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<bool>("isGreeting");
    QTest::newRow("agreed") << QByteArray(
        R"({"client":"gorizont-opc-da","version":"0.1.0","pid":1234,"registered":"abc"})")
                            << true;
    QTest::newRow("bare") << QByteArray(R"({"client":""})") << true;
    QTest::newRow("other") << QByteArray(R"({"hello":"x"})") << false;
    QTest::newRow("number") << QByteArray(R"({"client":1})") << false;
    QTest::newRow("list") << QByteArray(R"([{"client":"x"}])") << false;
    QTest::newRow("nothing") << QByteArray() << false;
}

void TestOpcFeed::greetingsAreRead()
{
    QFETCH(const QByteArray, line);
    QFETCH(const bool, isGreeting);
    const auto greeting = opclines::greeting(line);
    QCOMPARE(greeting.has_value(), isGreeting);
    if (line.contains("1234")) {
        QVERIFY((*greeting == opclines::Greeting{u"gorizont-opc-da"_s, u"0.1.0"_s, 1234, "abc"}));
    }
}

void TestOpcFeed::oldRegistrationIsToldOnce()
{
    OpcFeed feed(quickConfig());
    Listener listener(feed);
    feed.start();
    const auto greet = [&feed, &listener](const QByteArray &hash) {
        Client client(feed.port());
        client.until(u"ready"_s);
        client.say("{\"client\":\"gorizont-opc-da\",\"registered\":\"" + hash + "\"}\n");
        QTRY_COMPARE_WITH_TIMEOUT(listener.clients.value(0).requests, quint64{1}, patience);
        client.socket().abort();
        QTRY_VERIFY_WITH_TIMEOUT(listener.clients.isEmpty(), patience);
    };
    int others = 0;
    connect(&feed, &OpcFeed::otherListRegistered, this, [&others] { ++others; });
    const auto count = [&listener] { return listener.told.filter(u"another list of tags"_s).size(); };
    greet(opcTagsHash(feed.tags()));
    greet("");
    QCOMPARE(count(), 0);
    QCOMPARE(others, 1); // none is another one
    greet(QByteArray(64, 'a'));
    greet(QByteArray(64, 'a'));
    QCOMPARE(count(), 1);
    greet(QByteArray(64, 'b'));
    QCOMPARE(count(), 2);
    QCOMPARE(others, 4);
}

void TestOpcFeed::saysGoodbye()
{
    OpcFeed feed(quickConfig());
    Listener listener(feed);
    feed.start();
    Client client(feed.port());
    client.until(u"v"_s);
    const quint16 port = feed.port();
    feed.stop();
    QCOMPARE(client.line(), QByteArray("{\"end\":true}\n"));
    QTRY_VERIFY_WITH_TIMEOUT(!client.isConnected(), patience);
    QCOMPARE(listener.told.last(), u"OPC DA: stopped."_s);
    Client late(port);
    QVERIFY(!late.isConnected());
}

void TestOpcFeed::portThatIsTaken()
{
    QTcpServer other;
    QVERIFY(other.listen(QHostAddress::LocalHost));
    OpcFeedConfig config = quickConfig();
    config.port = other.serverPort();
    OpcFeed feed(config);
    Listener listener(feed);
    feed.start();
    QCOMPARE(feed.port(), 0);
    QTest::qWait(300); // several attempts
    QCOMPARE(listener.told.size(), 1);
    QVERIFY2(
        listener.told.first().startsWith(u"OPC DA: cannot serve on port %1 ("_s.arg(config.port)),
        qPrintable(listener.told.first()));
    QVERIFY2(
        listener.told.first().contains(
            u"Another program uses this port. Stop that program or choose another [OPC] Port."_s),
        qPrintable(listener.told.first()));
    other.close();
    QTRY_COMPARE_WITH_TIMEOUT(int{feed.port()}, config.port, patience);
    QCOMPARE(listener.told.size(), 2);
#ifndef Q_OS_WIN
    QCOMPARE(
        listener.told.last(),
        u"OPC DA needs Windows; here only the feed for a gateway gorizont-opc-da works, on port %1 of this computer."_s
            .arg(config.port));
#endif
}

void TestOpcFeed::onlyThisComputer()
{
    OpcFeed feed(quickConfig());
    feed.start();
    QTcpSocket socket;
    socket.connectToHost(QHostAddress(u"127.0.0.2"_s), feed.port());
    QTRY_COMPARE_WITH_TIMEOUT(socket.error(), QAbstractSocket::ConnectionRefusedError, patience);
}

void TestOpcFeed::tooManyAreRefused()
{
    OpcFeedConfig config = quickConfig();
    config.gateways = 2;
    OpcFeed feed(config);
    Listener listener(feed);
    feed.start();
    Client first(feed.port());
    Client second(feed.port());
    QVERIFY(!first.until(u"ready"_s).isEmpty());
    QVERIFY(!second.until(u"ready"_s).isEmpty());
    Client third(feed.port());
    QTRY_VERIFY_WITH_TIMEOUT(listener.told.last().contains(u"a gateway was refused, 2 are connected"), patience);
    QTRY_VERIFY_WITH_TIMEOUT(!third.isConnected(), patience);
    first.socket().abort();
    QTRY_COMPARE_WITH_TIMEOUT(listener.clients.size(), 1, patience);
    Client fourth(feed.port());
    QVERIFY(!fourth.until(u"ready"_s).isEmpty());
}

void TestOpcFeed::listedAndDismissed()
{
    OpcFeed feed(quickConfig());
    Listener listener(feed);
    feed.start();
    Client client(feed.port());
    client.until(u"v"_s);
    QTRY_COMPARE_WITH_TIMEOUT(listener.clients.size(), 1, patience);
    const ClientInfo info = listener.clients.first();
    QCOMPARE(info.address, QHostAddress(QHostAddress::LocalHost));
    QCOMPARE(info.port, client.socket().localPort());
    QVERIFY(info.bytesSent > 1000);
    QCOMPARE(listener.told.last(), u"OPC DA: client 127.0.0.1 connected."_s);
    feed.dismiss(info.address, static_cast<quint16>(info.port + 1)); // somebody else
    QVERIFY(client.isConnected());
    feed.dismiss(info.address, info.port);
    QTRY_VERIFY_WITH_TIMEOUT(!client.isConnected(), patience);
    QVERIFY2(listener.told.last().contains(u"was cut off by the operator"), qPrintable(listener.told.last()));
    QVERIFY(listener.clients.isEmpty());
}

QTEST_GUILESS_MAIN(TestOpcFeed)
#include "tst_opcfeed.moc"
