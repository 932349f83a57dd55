#include "core/mqtt/mqttpublisher.h"
#include "tests/core/history/failingwrite.h"
#include "tests/core/mqtt/toybroker.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

using namespace gorizont;
using namespace gorizont::test;
using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

namespace {

constexpr UtcTime morning{std::chrono::milliseconds(1767225600000)};
constexpr int patience = 60000; // ms, of a test that fails

/// Sensors 1 and 2 on [Port1].
QList<LineConfig> site()
{
    LineConfig line;
    line.index = 1;
    line.com = 4;
    line.isOn = true;
    for (const int number : {1, 2}) {
        SensorConfig sensor;
        sensor.number = number;
        sensor.isOn = true;
        sensor.type = SensorType::InD;
        sensor.measuresTilt = true;
        line.sensors.append(sensor);
    }
    return {line};
}

/// The publisher in a thread of its own, as in the program.
class Bench
{
public:
    Bench()
    {
        broker.listen();
        config.lines = site();
        config.folder = folder.filePath(u"Mqtt"_s);
        config.settings.host = u"127.0.0.1"_s;
        config.settings.port = broker.port();
        config.settings.prefix = u"p"_s;
        config.settings.clientId = u"me"_s;
    }
    ~Bench() { stop(); }

    void start()
    {
        publisher = std::make_unique<MqttPublisher>(config);
        QObject::connect(publisher.get(), &MqttPublisher::journal, &broker, [this](const JournalEntry &entry) {
            told.append(entry.text);
        });
        QObject::connect(publisher.get(), &MqttPublisher::statusChanged, &broker, [this](const MqttStatus &now) {
            status = now;
        });
        thread = std::make_unique<QThread>();
        publisher->moveToThread(thread.get());
        QObject::connect(thread.get(), &QThread::started, publisher.get(), &MqttPublisher::start);
        QObject::connect(thread.get(), &QThread::finished, publisher.get(), &MqttPublisher::stop, Qt::DirectConnection);
        thread->start();
    }

    void stop()
    {
        if (thread) {
            thread->quit();
            thread->wait();
            publisher.reset();
            thread.reset();
        }
    }

    /// \a count answers of sensor 1, one a second.
    void measure(int count)
    {
        for (int i = 0; i < count; ++i) {
            Reading reading;
            reading.number = 1;
            reading.time = morning + measured * 1s;
            reading.isAnswer = true;
            reading.status = 0x0300;
            reading.tilt = Tilt{static_cast<double>(measured), 0};
            publisher->updateReadings({reading});
            ++measured;
        }
    }

    /// tiltX of what came, which is the number of the measurement.
    QList<int> received() const
    {
        QList<int> numbers;
        for (const QByteArray &payload : broker.payloads("p/sensor/1/reading")) {
            numbers.append(QJsonDocument::fromJson(payload).object().value(u"tiltX"_s).toInt(-1));
        }
        return numbers;
    }

    QList<qint64> sequences() const
    {
        QList<qint64> numbers;
        for (const QByteArray &payload : broker.payloads("p/sensor/1/reading")) {
            numbers.append(QJsonDocument::fromJson(payload).object().value(u"seq"_s).toInteger());
        }
        return numbers;
    }

    qsizetype timesTold(const QString &part) const
    {
        return std::count_if(told.begin(), told.end(), [&part](const QString &text) { return text.contains(part); });
    }

    QTemporaryDir folder;
    ToyBroker broker;
    MqttConfig config;
    std::unique_ptr<MqttPublisher> publisher;
    std::unique_ptr<QThread> thread;
    QStringList told;
    MqttStatus status;
    int measured = 0;
};

QList<int> upTo(int count)
{
    QList<int> numbers;
    for (int i = 0; i < count; ++i) {
        numbers.append(i);
    }
    return numbers;
}

/// Each once, in the order of their first arrival: what a receiver makes of messages that may come twice.
template <typename T> QList<T> once(const QList<T> &numbers)
{
    QList<T> result;
    for (const T number : numbers) {
        if (result.isEmpty() || number > result.last()) {
            result.append(number);
        }
    }
    return result;
}

} // namespace

class TestMqttPublisher : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysWhoItIsAndLeavesAWill();
    void sendsReadingsAndStates_data();
    void sendsReadingsAndStates();
    void statesAreSentOnChangeOnly();
    void saysGoodBye();
    void whatCameWhileTheBrokerWasAwayIsSentInOrder();
    void nothingLeavesTheQueueUnconfirmed();
    void connectionCutInTheMiddleLosesNothing();
    void noMoreThanTheWindowIsUnderway();
    void brokerThatNeverReadsHoldsUpNobody();
    void troubles_data();
    void troubles();
    void troubleIsToldOnce();
    void nameIsLookedUp();
    void fullDiskDoesNotStopSending();
    void passwordComesFromTheFile();
};

void TestMqttPublisher::saysWhoItIsAndLeavesAWill()
{
    Bench bench;
    bench.config.settings.user = u"site"_s;
    bench.config.settings.password = u"пароль"_s;
    bench.start();
    QTRY_COMPARE_WITH_TIMEOUT(bench.broker.connects.size(), 1, patience);
    const ToyBroker::Connect connect = bench.broker.connects.first();
    QCOMPARE(connect.client, "me");
    QCOMPARE(connect.user, "site");
    QCOMPARE(connect.password, QByteArray("пароль"));
    QCOMPARE(connect.willTopic, "p/status");
    QCOMPARE(connect.will, "offline");
    QVERIFY(connect.isWillRetained);
    QTRY_COMPARE_WITH_TIMEOUT(bench.broker.payloads("p/status"), QByteArrayList{"online"}, patience);
    QTRY_VERIFY_WITH_TIMEOUT(bench.status.isConnected, patience);
}

void TestMqttPublisher::sendsReadingsAndStates_data()
{
    QTest::addColumn<int>("qos");
    QTest::newRow("QoS 0") << 0;
    QTest::newRow("QoS 1") << 1;
}

void TestMqttPublisher::sendsReadingsAndStates()
{
    QFETCH(const int, qos);
    Bench bench;
    bench.config.settings.qos = qos;
    bench.start();
    LineStatus line;
    line.port = 1;
    line.state = LineState::Open;
    bench.publisher->updateLine(line);
    bench.measure(5);
    QTRY_COMPARE_WITH_TIMEOUT(bench.received(), upTo(5), patience);
    QTRY_COMPARE_WITH_TIMEOUT(bench.status.published, 5U, patience);
    QCOMPARE(bench.status.waiting, 0U);
    QTRY_COMPARE_WITH_TIMEOUT(bench.broker.payloads("p/sensor/1/state").size(), 1, patience);
    QTRY_COMPARE_WITH_TIMEOUT(bench.broker.payloads("p/port/1/state").size(), 1, patience);
    for (const ToyBroker::Publish &publish : std::as_const(bench.broker.publishes)) {
        QCOMPARE(publish.qos, qos);
        QCOMPARE(publish.isRetained, !publish.topic.endsWith("/reading"));
    }
    const QList<qint64> sequences = bench.sequences();
    for (qsizetype i = 1; i < sequences.size(); ++i) {
        QCOMPARE(sequences.at(i), sequences.at(0) + i);
    }
}

void TestMqttPublisher::statesAreSentOnChangeOnly()
{
    Bench bench;
    bench.start();
    bench.measure(20);
    QTRY_COMPARE_WITH_TIMEOUT(bench.received(), upTo(20), patience);
    QCOMPARE(bench.broker.payloads("p/sensor/1/state").size(), 1);
    Reading silent;
    silent.number = 1;
    silent.time = morning + 100s;
    silent.status = 0x3700;
    bench.publisher->updateReadings({silent, silent});
    QTRY_COMPARE_WITH_TIMEOUT(bench.broker.payloads("p/sensor/1/state").size(), 2, patience);
    QTRY_COMPARE_WITH_TIMEOUT(bench.broker.payloads("p/sensor/1/reading").size(), 21, patience); // the change
    QVERIFY(bench.broker.payloads("p/sensor/1/state").last().contains("\"code\":3"));
    bench.broker.disconnectAll();
    QTRY_COMPARE_WITH_TIMEOUT(bench.broker.payloads("p/sensor/1/state").size(), 3, patience); // for a new broker
}

void TestMqttPublisher::saysGoodBye()
{
    Bench bench;
    bench.start();
    QTRY_COMPARE_WITH_TIMEOUT(bench.broker.payloads("p/status").size(), 1, patience);
    bench.stop();
    QTRY_COMPARE_WITH_TIMEOUT(bench.broker.payloads("p/status"), (QByteArrayList{"online", "offline"}), patience);
    QVERIFY(bench.broker.publishes.last().isRetained);
}

void TestMqttPublisher::whatCameWhileTheBrokerWasAwayIsSentInOrder()
{
    Bench bench;
    bench.broker.stop();
    bench.start();
    bench.measure(1000);
    QTRY_COMPARE_WITH_TIMEOUT(bench.status.waiting, 1000U, patience);
    bench.stop(); // and started again
    bench.start();
    bench.measure(500);
    QTRY_COMPARE_WITH_TIMEOUT(bench.status.waiting, 1500U, patience);
    QVERIFY(bench.broker.listen());
    QTRY_COMPARE_WITH_TIMEOUT(bench.received().size(), 1500, patience);
    bench.measure(10);
    QTRY_COMPARE_WITH_TIMEOUT(bench.received(), upTo(1510), patience);
    const QByteArray last = bench.broker.payloads("p/sensor/1/reading").at(1499);
    QVERIFY2(last.contains("\"time\":\"2026-01-01T00:24:59.000Z\""), last);
    QCOMPARE(bench.timesTold(u"Readings that wait and are sent first: 1500."_s), 1);
    QCOMPARE(once(bench.sequences()).size(), 1510);
}

void TestMqttPublisher::nothingLeavesTheQueueUnconfirmed()
{
    Bench bench;
    bench.broker.acknowledges = false;
    bench.start();
    bench.measure(10);
    QTRY_COMPARE_WITH_TIMEOUT(bench.received(), upTo(10), patience);
    QTRY_COMPARE_WITH_TIMEOUT(bench.status.waiting, 10U, patience);
    bench.stop();
    bench.broker.acknowledges = true;
    bench.broker.publishes.clear();
    bench.start();
    QTRY_COMPARE_WITH_TIMEOUT(bench.received(), upTo(10), patience);
    QTRY_COMPARE_WITH_TIMEOUT(bench.status.waiting, 0U, patience);
    bench.stop();
    bench.broker.publishes.clear();
    bench.start();
    bench.measure(1);
    QTRY_COMPARE_WITH_TIMEOUT(bench.received(), QList<int>{10}, patience);
}

void TestMqttPublisher::connectionCutInTheMiddleLosesNothing()
{
    Bench bench;
    bench.broker.stop();
    bench.start();
    bench.measure(600);
    bench.broker.endsAfter = 150;
    QVERIFY(bench.broker.listen());
    QTRY_COMPARE_WITH_TIMEOUT(bench.broker.endsAfter, -1, patience);
    bench.broker.endsAfter = 150;
    QTRY_VERIFY_WITH_TIMEOUT(!bench.received().isEmpty() && bench.received().last() == 599, patience);
    const QList<int> received = bench.received();
    QCOMPARE(once(received), upTo(600)); // the first arrival of each is in order
    QVERIFY2(received.size() <= 600 + 2 * bench.config.window, "more came twice than was underway");
    QTRY_COMPARE_WITH_TIMEOUT(bench.status.waiting, 0U, patience);
    QCOMPARE(bench.status.lost, 0U);
}

void TestMqttPublisher::noMoreThanTheWindowIsUnderway()
{
    Bench bench;
    bench.config.window = 7;
    bench.broker.acknowledges = false;
    bench.start();
    bench.measure(1000);
    QTRY_COMPARE_WITH_TIMEOUT(bench.status.waiting, 1000U, patience);
    QTRY_COMPARE_WITH_TIMEOUT(bench.broker.unacknowledged, 7, patience);
    bench.measure(10);
    QTRY_COMPARE_WITH_TIMEOUT(bench.status.waiting, 1010U, patience);
    QCOMPARE(bench.broker.unacknowledged, 7);
}

void TestMqttPublisher::brokerThatNeverReadsHoldsUpNobody()
{
    Bench bench;
    bench.broker.reads = false;
    bench.config.connectLimit = 300ms;
    bench.start();
    bench.measure(50000); // returns, whatever the broker does
    QTRY_COMPARE_WITH_TIMEOUT(bench.status.waiting + bench.status.lost, 50000U, patience);
    QTRY_COMPARE_WITH_TIMEOUT(bench.timesTold(u"does not answer"_s), 1, patience);
}

void TestMqttPublisher::troubles_data()
{
    QTest::addColumn<int>("connack");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("password") << 4 << u"does not accept user and password"_s;
    QTest::newRow("not authorised") << 5 << u"lets nobody in as this user"_s;
    QTest::newRow("client id") << 2 << u"rejects the connection"_s;
    QTest::newRow("unavailable") << 3 << u"rejects the connection"_s;
}

void TestMqttPublisher::troubles()
{
    QFETCH(const int, connack);
    QFETCH(const QString, sentence);
    Bench bench;
    bench.broker.connackCode = connack;
    bench.start();
    QTRY_COMPARE_WITH_TIMEOUT(bench.timesTold(sentence), 1, patience);
    QVERIFY(!bench.status.isConnected);
    bench.measure(3);
    bench.broker.connackCode = 0;
    QTRY_COMPARE_WITH_TIMEOUT(bench.received(), upTo(3), patience);
    QCOMPARE(bench.timesTold(u"connected to the broker 127.0.0.1:"_s), 1);
}

void TestMqttPublisher::troubleIsToldOnce()
{
    Bench bench;
    bench.start();
    QTRY_COMPARE_WITH_TIMEOUT(bench.timesTold(u"connected to the broker"_s), 1, patience);
    bench.broker.connackCode = 4;
    bench.broker.disconnectAll();
    QTRY_COMPARE_WITH_TIMEOUT(bench.broker.connects.size(), 4, patience); // three attempts
    bench.broker.stop();
    QTRY_VERIFY_WITH_TIMEOUT(bench.timesTold(u"cannot be reached"_s) == 1, patience);
    QCOMPARE(bench.timesTold(u"is lost"_s), 1);
    QCOMPARE(bench.timesTold(u"does not accept user and password"_s), 1);
    QCOMPARE(bench.told.size(), 4);
}

void TestMqttPublisher::nameIsLookedUp()
{
    Bench bench;
    bench.config.settings.host = u"no-such-host.invalid"_s; // RFC 2606
    bench.start();
    QTRY_COMPARE_WITH_TIMEOUT(bench.timesTold(u"no address is known for no-such-host.invalid"_s), 1, patience);
    bench.stop();
    bench.config.settings.host = u"localhost"_s; // the toy listens to IPv4 only, the name may mean IPv6 too
    bench.start();
    QTRY_COMPARE_WITH_TIMEOUT(bench.broker.connects.size(), 1, patience);
}

void TestMqttPublisher::fullDiskDoesNotStopSending()
{
    Bench bench;
    bench.start();
    const FailingWrite full(u".txt"_s, 0);
    bench.measure(10);
    QTRY_COMPARE_WITH_TIMEOUT(bench.received(), upTo(10), patience);
    QTRY_COMPARE_WITH_TIMEOUT(bench.timesTold(u"the queue is not being saved"_s), 1, patience);
    QTRY_COMPARE_WITH_TIMEOUT(bench.status.waiting, 0U, patience);
}

void TestMqttPublisher::passwordComesFromTheFile()
{
    Bench bench;
    bench.config.settings.user = u"site"_s;
    bench.config.settings.passwordFile = bench.folder.filePath(u"secret"_s);
    bench.start();
    QTRY_COMPARE_WITH_TIMEOUT(bench.timesTold(u"cannot be read: "_s + bench.config.settings.passwordFile), 1, patience);
    QCOMPARE(bench.broker.connects.size(), 0);
    QFile file(bench.config.settings.passwordFile);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("se cret\r\nsecond line\n");
    file.close();
    QTRY_COMPARE_WITH_TIMEOUT(bench.broker.connects.size(), 1, patience);
    QCOMPARE(bench.broker.connects.first().password, "se cret");
}

QTEST_GUILESS_MAIN(TestMqttPublisher)
#include "tst_mqttpublisher.moc"
