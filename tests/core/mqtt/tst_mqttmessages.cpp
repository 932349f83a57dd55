#include "core/mqtt/mqttconfig.h"
#include "core/mqtt/mqttinbox.h"
#include "core/mqtt/mqttmessages.h"
#include "core/mqtt/mqtttopics.h"
#include "core/mqtt/publishingpace.h"
#include "core/values/readingjson.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

using namespace gorizont;
using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

namespace {

constexpr UtcTime morning{std::chrono::milliseconds(1767225600250)}; // 2026-01-01T00:00:00.250Z

LineConfig line()
{
    LineConfig config;
    config.index = 2;
    config.com = 4;
    config.name = u"Муха"_s;
    return config;
}

SensorConfig sensor()
{
    SensorConfig config;
    config.number = 3;
    config.address = 11;
    config.model = u"IN-D3"_s;
    config.name = u"ИН-Д3 \"ось 1\""_s;
    config.place = u"Подвал"_s;
    return config;
}

Reading answer(int number, UtcTime time, quint16 status = 0x0300)
{
    Reading reading;
    reading.number = number;
    reading.time = time;
    reading.isAnswer = true;
    reading.status = status;
    reading.tilt = Tilt{-264, -6644.5};
    return reading;
}

} // namespace

class TestMqttMessages : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readingIsThePrintedOneWithItsNumber();
    void stateOfASensor();
    void stateOfAPort_data();
    void stateOfAPort();
    void topics();
    void levelHasNoSeparators_data();
    void levelHasNoSeparators();
    void defaultsOfPrefixAndClient();
    void everyAnswerAndEveryChangeIsSent();
    void intervalThinsAnswersOnly();
    void intervalOfThePeriodKeepsEveryAnswer();
    void pauseGrowsToAMinute();
    void chanceTakesUpToHalfOfThePause();
    void inboxKeepsTheNewest();
};

void TestMqttMessages::readingIsThePrintedOneWithItsNumber()
{
    const QByteArray printed = readingToJson(answer(3, morning), sensor(), line());
    const QByteArray sent = mqttmessage::reading(printed, 1767225600000017);
    QJsonObject object = QJsonDocument::fromJson(sent).object();
    QCOMPARE(object.take(u"seq"_s).toInteger(), 1767225600000017);
    QVERIFY(object == QJsonDocument::fromJson(printed).object());
    QCOMPARE(object.value(u"time"_s).toString(), u"2026-01-01T00:00:00.250Z"_s);
    QCOMPARE(object.value(u"tiltY"_s).toDouble(), -6644.5);
    QVERIFY(!sent.contains('\n'));
}

void TestMqttMessages::stateOfASensor()
{
    const QByteArray json = mqttmessage::sensorState(answer(3, morning, 0x3700), sensor(), line());
    QCOMPARE(
        QString::fromUtf8(json),
        u"{\"address\":11,\"code\":3,\"name\":\"ИН-Д3 \\\"ось "
        u"1\\\"\",\"number\":3,\"place\":\"Подвал\",\"port\":\"COM4\","
        "\"status\":14080,\"time\":\"2026-01-01T00:00:00.250Z\",\"type\":\"IN-D3\"}"_s);
}

void TestMqttMessages::stateOfAPort_data()
{
    QTest::addColumn<LineState>("state");
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("hasError");
    QTest::newRow("off") << LineState::Off << u"off"_s << false;
    QTest::newRow("opening") << LineState::Opening << u"opening"_s << false;
    QTest::newRow("open") << LineState::Open << u"open"_s << false;
    QTest::newRow("open failed") << LineState::OpenFailed << u"openFailed"_s << true;
    QTest::newRow("lost") << LineState::Lost << u"lost"_s << true;
    QTest::newRow("service") << LineState::Service << u"service"_s << false;
}

void TestMqttMessages::stateOfAPort()
{
    QFETCH(const LineState, state);
    QFETCH(const QString, name);
    QFETCH(const bool, hasError);
    LineStatus status;
    status.port = 2;
    status.state = state;
    status.lastError = u"No such file"_s;
    const QString error = hasError ? u"\"error\":\"No such file\","_s : QString();
    QCOMPARE(
        QString::fromUtf8(mqttmessage::portState(morning, status, line())),
        u"{"_s + error + u"\"index\":2,\"name\":\"Муха\",\"port\":\"COM4\",\"state\":\""_s + name
            + u"\",\"time\":\"2026-01-01T00:00:00.250Z\"}"_s);
}

void TestMqttMessages::topics()
{
    QCOMPARE(mqtttopic::status(), "status");
    QCOMPARE(mqtttopic::sensorReading(12), "sensor/12/reading");
    QCOMPARE(mqtttopic::sensorState(12), "sensor/12/state");
    QCOMPARE(mqtttopic::portState(1), "port/1/state");
    QCOMPARE(mqtttopic::under(u"горизонт/a"_s, "status"), "горизонт/a/status");
}

void TestMqttMessages::levelHasNoSeparators_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("level");
    QTest::newRow("plain") << u"tower-1"_s << u"tower-1"_s;
    QTest::newRow("Cyrillic") << u"Башня"_s << u"Башня"_s;
    QTest::newRow("separators") << u"a/b+c#d$e"_s << u"a_b_c_d_e"_s;
    QTest::newRow("blanks") << u" tower 1\t"_s << u"tower_1"_s;
    QTest::newRow("control") << u"a\u0001b"_s << u"a_b"_s;
    QTest::newRow("nothing") << u"  "_s << QString();
}

void TestMqttMessages::levelHasNoSeparators()
{
    QFETCH(const QString, name);
    QTEST(mqtttopic::level(name), "level");
}

void TestMqttMessages::defaultsOfPrefixAndClient()
{
    ServerConfig config;
    config.name = u"Башня 1"_s;
    const MqttConfig first = mqttConfig(config, u"/data/a"_s);
    QCOMPARE(first.settings.prefix, u"gorizont/Башня_1"_s);
    QCOMPARE(first.folder, u"/data/a/Mqtt"_s);
    QCOMPARE(first.queue.bytes, 64 * 1024 * 1024);
    static const QRegularExpression safe(u"^[0-9a-zA-Z]{1,23}$"_s); // MQTT 3.1.1, section 3.1.3.1
    QVERIFY2(safe.match(first.settings.clientId).hasMatch(), qPrintable(first.settings.clientId));
    QCOMPARE(mqttConfig(config, u"/data/a"_s).settings.clientId, first.settings.clientId);
    QVERIFY(mqttConfig(config, u"/data/b"_s).settings.clientId != first.settings.clientId);
    config.name.clear();
    QVERIFY(mqttConfig(config, u"/data/a"_s).settings.prefix.size() > u"gorizont/"_s.size());
    config.mqtt.prefix = u"p"_s;
    config.mqtt.clientId = u"c"_s;
    QCOMPARE(mqttConfig(config, u"/data/a"_s).settings.prefix, u"p"_s);
    QCOMPARE(mqttConfig(config, u"/data/a"_s).settings.clientId, u"c"_s);
}

void TestMqttMessages::everyAnswerAndEveryChangeIsSent()
{
    PublishingPace pace(0ms);
    pace.begin(3, 0x0700);
    Reading silent = answer(3, morning, 0x0700);
    silent.isAnswer = false;
    QVERIFY(!pace.judge(silent).isSent);
    QVERIFY(pace.judge(answer(3, morning, 0x0300)).isNewState);
    for (int i = 1; i < 5; ++i) {
        const auto verdict = pace.judge(answer(3, morning + i * 1ms, 0x0300));
        QVERIFY(verdict.isSent && !verdict.isNewState);
    }
    silent.status = 0x3700;
    const auto verdict = pace.judge(silent);
    QVERIFY(verdict.isSent && verdict.isNewState);
    QVERIFY(!pace.judge(silent).isSent);
}

void TestMqttMessages::intervalThinsAnswersOnly()
{
    PublishingPace pace(5s);
    pace.begin(3, 0x0300);
    pace.begin(4, 0x0300);
    int sent = 0;
    for (int second = 0; second < 60; ++second) {
        sent += pace.judge(answer(3, morning + second * 1s)).isSent ? 1 : 0;
    }
    QCOMPARE(sent, 12);
    QVERIFY(pace.judge(answer(4, morning + 59s)).isSent); // its own interval
    QVERIFY(pace.judge(answer(4, morning + 60s, 0x3700)).isSent); // a change
    QVERIFY(!pace.judge(answer(4, morning + 61s, 0x3700)).isSent);
    QVERIFY(pace.judge(answer(4, morning - 1h, 0x3700)).isSent); // the clock was set back
}

void TestMqttMessages::intervalOfThePeriodKeepsEveryAnswer()
{
    PublishingPace pace(1s);
    pace.begin(3, 0x0300);
    for (int second = 0; second < 60; ++second) {
        const auto jitter = second % 2 == 0 ? 40ms : -40ms;
        QVERIFY(pace.judge(answer(3, morning + second * 1s + jitter)).isSent);
    }
}

void TestMqttMessages::pauseGrowsToAMinute()
{
    ReconnectPause pause;
    QList<int> seconds;
    for (int i = 0; i < 9; ++i) {
        seconds.append(static_cast<int>(pause.next(0).count() / 1000));
    }
    QCOMPARE(seconds, (QList<int>{1, 2, 4, 8, 16, 32, 60, 60, 60}));
    pause.reset();
    QCOMPARE(pause.next(0), 1000ms);
}

void TestMqttMessages::chanceTakesUpToHalfOfThePause()
{
    ReconnectPause pause;
    QCOMPARE(pause.next(0.5), 750ms);
    QCOMPARE(pause.next(0.999), 1001ms);
}

void TestMqttMessages::inboxKeepsTheNewest()
{
    MqttInbox inbox(3);
    QVERIFY(inbox.put(Readings{answer(1, morning), answer(2, morning)}));
    QVERIFY(!inbox.put(Readings{answer(3, morning), answer(4, morning), answer(5, morning)}));
    LineStatus status;
    status.port = 1;
    QVERIFY(!inbox.put(status));
    status.state = LineState::Open;
    QVERIFY(!inbox.put(status));
    const MqttInbox::Contents contents = inbox.take();
    QList<int> kept;
    for (const Reading &reading : contents.readings) {
        kept.append(reading.number);
    }
    QCOMPARE(kept, (QList<int>{3, 4, 5}));
    QCOMPARE(contents.readingsDropped, 2U);
    QCOMPARE(contents.lines.size(), 1);
    QVERIFY(contents.lines.value(1).state == LineState::Open);
    QVERIFY(inbox.take().readings.isEmpty());
    QVERIFY(inbox.put(status)); // to be woken again
}

QTEST_APPLESS_MAIN(TestMqttMessages)
#include "tst_mqttmessages.moc"
