#include "tests/core/config/configreading.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

/// [MQTT], [Metrics] and [OPC].
class TestFeedSettings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void absentSectionsSwitchBothOff();
    void readsEveryKey();
    void tlsHasAPortOfItsOwn();
    void complainsOfEveryMistake_data();
    void complainsOfEveryMistake();
    void passwordFileWins();
    void slashesAtTheEndOfThePrefixGo();
    void opcNeedsAPortOfItsOwn_data();
    void opcNeedsAPortOfItsOwn();
    void opcAllowsOneCopy();
};

void TestFeedSettings::absentSectionsSwitchBothOff()
{
    const ServerConfig config = read("[Common]\n").config;
    QVERIFY(!config.mqtt.isOn());
    QVERIFY(!config.metrics.isOn());
    QCOMPARE(config.mqtt.port, 1883);
    QCOMPARE(config.mqtt.qos, 1);
    QCOMPARE(config.mqtt.interval, 0ms);
    QCOMPARE(config.mqtt.queueLimit, 64);
    QCOMPARE(config.metrics.bind, u"127.0.0.1"_s);
    QCOMPARE(config.opc.port, 43212);
}

void TestFeedSettings::readsEveryKey()
{
    const ConfigReading reading = read(
        "[Common]\n[MQTT]\nHost=centre.example\nPort=8884\nTLS=1\nCAFile=ca.pem\nCertFile=own.pem\nKeyFile=own.key\n"
        "User=site; 7\nPasswordFile=secret.txt\nClientId=tower\nPrefix=Москва/башня 1\nQoS=2\nInterval=5000\n"
        "QueueLimit=200\n[Metrics]\nPort=9100\nBind=::1\n[OPC]\nPort=50001\n");
    QCOMPARE(complaintTexts(reading), QStringList());
    MqttSettings mqtt;
    mqtt.host = u"centre.example"_s;
    mqtt.port = 8884;
    mqtt.usesTls = true;
    mqtt.caFile = u"ca.pem"_s;
    mqtt.certFile = u"own.pem"_s;
    mqtt.keyFile = u"own.key"_s;
    mqtt.user = u"site; 7"_s;
    mqtt.passwordFile = u"secret.txt"_s;
    mqtt.clientId = u"tower"_s;
    mqtt.prefix = u"Москва/башня 1"_s;
    mqtt.qos = 2;
    mqtt.interval = 5000ms;
    mqtt.queueLimit = 200;
    QVERIFY(reading.config.mqtt == mqtt);
    QVERIFY(reading.config.mqtt.isOn());
    QVERIFY((reading.config.metrics == MetricsSettings{9100, u"::1"_s}));
    QVERIFY(reading.config.metrics.isOn());
    QCOMPARE(reading.config.opc.port, 50001);
}

void TestFeedSettings::tlsHasAPortOfItsOwn()
{
    QCOMPARE(read("[Common]\n[MQTT]\nHost=h\nTLS=1\n").config.mqtt.port, 8883);
    QCOMPARE(read("[Common]\n[MQTT]\nHost=h\nTLS=1\nPort=1883\n").config.mqtt.port, 1883);
    QCOMPARE(read("[Common]\n[MQTT]\nHost=h\nTLS=0\n").config.mqtt.port, 1883);
}

void TestFeedSettings::complainsOfEveryMistake_data()
{
    QTest::addColumn<QByteArray>("lines");
    QTest::addColumn<QStringList>("complaints");
    const auto row = [](const QByteArray &lines, const QStringList &complaints) {
        QTest::newRow(lines.constData()) << lines << complaints;
    };
    row("[MQTT]\nPort=0", {u"[MQTT] Port, line 3: “0” is outside 1…65535. The default 1883 is used."_s});
    row("[MQTT]\nTLS=1\nPort=x", {u"[MQTT] Port, line 4: “x” is not a whole number. The default 8883 is used."_s});
    row("[MQTT]\nTLS=yes", {u"[MQTT] TLS, line 3: “yes” is none of 0, 1. The default 0 is used."_s});
    row("[MQTT]\nQoS=3", {u"[MQTT] QoS, line 3: “3” is outside 0…2. The default 1 is used."_s});
    row("[MQTT]\nInterval=-1", {u"[MQTT] Interval, line 3: “-1” is less than 0. The default 0 is used."_s});
    row("[MQTT]\nQueueLimit=0", {u"[MQTT] QueueLimit, line 3: “0” is outside 1…1048576. The default 64 is used."_s});
    row("[MQTT]\nPrefix=a/#",
        {u"[MQTT] Prefix, line 3: “a/#” has a # or a +, which topics must not have. The default is used."_s});
    row("[MQTT]\nCAFile=a.pem", {u"[MQTT] CAFile, line 3: TLS=0 needs no certificates. It is not used."_s});
    row("[MQTT]\nTLS=1\nKeyFile=a.key",
        {u"[MQTT] KeyFile, line 4: CertFile and KeyFile belong together, one of them is missing. It is not used."_s});
    row("[MQTT]\nPassword=a\nPasswordFile=b",
        {u"[MQTT] Password, line 3: PasswordFile gives the password already. It is not used."_s});
    row("[OPC]\nPort=0", {u"[OPC] Port, line 3: “0” is outside 1…65535. The default 43212 is used."_s});
    row("[OPC]\nPort=COM5", {u"[OPC] Port, line 3: “COM5” is not a whole number. The default 43212 is used."_s});
    row("[Metrics]\nPort=65536", {u"[Metrics] Port, line 3: “65536” is outside 0…65535. The default 0 is used."_s});
}

void TestFeedSettings::complainsOfEveryMistake()
{
    QFETCH(const QByteArray, lines);
    QFETCH(const QStringList, complaints);
    QCOMPARE(complaintTexts(read("[Common]\n" + lines + "\n")), complaints);
}

void TestFeedSettings::passwordFileWins()
{
    const ServerConfig config = read("[Common]\n[MQTT]\nPassword=a\nPasswordFile=b\n").config;
    QCOMPARE(config.mqtt.password, QString());
    QCOMPARE(config.mqtt.passwordFile, u"b"_s);
    QCOMPARE(config.replaced.value(u"mqtt/password"_s), u"a"_s);
}

void TestFeedSettings::slashesAtTheEndOfThePrefixGo()
{
    QCOMPARE(read("[Common]\n[MQTT]\nPrefix=a/b//\n").config.mqtt.prefix, u"a/b"_s);
    QCOMPARE(read("[Common]\n[MQTT]\nPrefix=/\n").config.mqtt.prefix, QString());
}

void TestFeedSettings::opcNeedsAPortOfItsOwn_data()
{
    QTest::addColumn<QByteArray>("lines");
    QTest::addColumn<QString>("complaint");
    const QString action = u" OPC DA is not served until another port is given."_s;
    QTest::newRow("Modbus") << QByteArray("CanOPCDA=1\n[OPC]\nPort=502\n")
                            << u"[OPC] Port, line 4: 502 is the port of Modbus TCP already."_s + action;
    QTest::newRow("ADC24") << QByteArray("CanOPCDA=1\nIPPort2=43212\n")
                           << u"[OPC]: 43212 is the port of ADC24 TCP already."_s + action;
    QTest::newRow("metrics") << QByteArray("CanOPCDA=1\n[Metrics]\nPort=9100\n[OPC]\nPort=9100\n")
                             << u"[OPC] Port, line 6: 9100 is the port of [Metrics] already."_s + action;
    QTest::newRow("no OPC") << QByteArray("[OPC]\nPort=502\n") << QString();
    QTest::newRow("no Modbus") << QByteArray("CanOPCDA=1\nCanModbus=0\n[OPC]\nPort=502\n") << QString();
}

void TestFeedSettings::opcNeedsAPortOfItsOwn()
{
    QFETCH(const QByteArray, lines);
    QFETCH(const QString, complaint);
    const ConfigReading reading = read("[Common]\n" + lines);
    QCOMPARE(complaintTexts(reading), complaint.isEmpty() ? QStringList() : QStringList{complaint});
    QCOMPARE(reading.config.servesOpc, lines.contains("CanOPCDA") && complaint.isEmpty());
    QCOMPARE(reading.config.replaced.value(u"common/canopcda"_s), complaint.isEmpty() ? QString() : u"1"_s);
}

/// Manual 000, 11.3.
void TestFeedSettings::opcAllowsOneCopy()
{
    const ConfigReading reading = read("[Common]\nCanCopy=1\nCanOPCDA=1\n");
    QVERIFY(!reading.config.allowsCopy);
    QVERIFY(reading.config.servesOpc);
    QCOMPARE(
        complaintTexts(reading),
        QStringList{u"[Common] CanCopy, line 2: CanOPCDA=1 allows one copy of the program only. CanCopy=0 is used."_s});
    QVERIFY(read("[Common]\nCanCopy=1\nCanOPCDA=0\n").config.allowsCopy);
}

QTEST_GUILESS_MAIN(TestFeedSettings)

#include "tst_feedsettings.moc"
