#include "core/adc24/adc24image.h"
#include "tests/core/adc24/adc24site.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;

namespace {

QByteArray allOf(const SampleRing &ring)
{
    QByteArray bytes(static_cast<qsizetype>(2 * ring.size()), '\0');
    ring.copy(0, ring.size(), bytes.data());
    return bytes.toHex();
}

SensorConfig accelerometer(int port, int number, bool isOn = true)
{
    SensorConfig sensor;
    sensor.port = port;
    sensor.number = number;
    sensor.isOn = isOn;
    sensor.measuresAcceleration = true;
    return sensor;
}

LineConfig lineWith(int port, bool isOn, const QList<SensorConfig> &sensors)
{
    LineConfig line;
    line.index = port;
    line.isOn = isOn;
    line.sensors = sensors;
    return line;
}

} // namespace

/// What ADC24 shows, and of which sensor.
class TestAdc24Image : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keepsTheNewestSamples()
    {
        Adc24Image image(adc24Site()); // 128 samples
        QCOMPARE(image.ring().size(), 0U);
        for (int packet = 0; packet < 5; ++packet) {
            image.append(sampleBlock(QList<qint16>(32, static_cast<qint16>(packet))));
        }
        QCOMPARE(image.ring().size(), 128U);
        QCOMPARE(
            allOf(image.ring()),
            QByteArray("0100").repeated(32) + QByteArray("0200").repeated(32) + QByteArray("0300").repeated(32)
                + QByteArray("0400").repeated(32));
        image.append(sampleBlock({9}));
        QCOMPARE(image.ring().size(), 128U);
        QCOMPARE(allOf(image.ring()).last(8), QByteArray("04000900"));
        QList<qint16> many(1000, 1);
        many.append(2);
        image.append(sampleBlock(many)); // more than there is room for
        QCOMPARE(image.ring().size(), 128U);
        QCOMPARE(allOf(image.ring()), QByteArray("0100").repeated(127) + "0200");
    }

    void beginsAnewAfterAGap()
    {
        Adc24Image image(adc24Site());
        image.append(sampleBlock({1, 2, 3}, false));
        image.append(sampleBlock({4}));
        QCOMPARE(image.ring().size(), 4U);
        image.append(sampleBlock({5, 6}, false));
        QCOMPARE(allOf(image.ring()), QByteArray("05000600"));
    }

    void beginsAnewWithAnotherRate()
    {
        Adc24Image image(adc24Site());
        image.append(sampleBlock({1, 2, 3}));
        QCOMPARE(image.rate(), 10.0);
        SampleBlock faster = sampleBlock({4});
        faster.rate = 20;
        image.append(faster);
        QCOMPARE(allOf(image.ring()), QByteArray("0400"));
        QCOMPARE(image.rate(), 20.0);
    }

    void takesItsOwnAxisOfItsOwnSensor()
    {
        Adc24Config config = adc24Site();
        config.axis = Adc24Axis::Y;
        Adc24Image image(config);
        SampleBlock other = sampleBlock({1, 2});
        other.number = 8;
        image.append(other);
        QCOMPARE(image.ring().size(), 0U);
        SampleBlock own = sampleBlock({1, 2, 3});
        own.y = {10, 11}; // a pair of samples has both
        image.append(own);
        QCOMPARE(allOf(image.ring()), QByteArray("0a000b00"));
        QCOMPARE(image.status(), 0x0F00);
        image.update(statusReading(0x1234, 8));
        QCOMPARE(image.status(), 0x0F00);
        image.update(statusReading(0x1234));
        QCOMPARE(image.status(), 0x1234);
    }

    void servesTheFirstAccelerometerThatIsPolled()
    {
        ServerConfig config;
        QVERIFY(!adc24Config(config));
        SensorConfig tiltOnly;
        tiltOnly.number = 1;
        tiltOnly.isOn = true;
        tiltOnly.measuresTilt = true;
        config.lines = {lineWith(1, true, {tiltOnly})};
        QVERIFY(!adc24Config(config)); // no accelerometer, nothing to serve
        config.lines.append(lineWith(2, false, {accelerometer(2, 3)}));
        QCOMPARE(adc24Config(config)->number, 3);
        QCOMPARE(adc24Config(config)->initialWord, 0x1700); // its port is off
        config.lines.append(lineWith(3, true, {accelerometer(3, 9), accelerometer(3, 4, false), accelerometer(3, 8)}));
        QCOMPARE(adc24Config(config)->number, 8);
        QCOMPARE(adc24Config(config)->initialWord, 0x0700);
        config.adc24Sensor = 4;
        QCOMPARE(adc24Config(config)->number, 4);
        QCOMPARE(adc24Config(config)->initialWord, 0x0F00);
        config.servesAdc24 = false;
        QVERIFY(!adc24Config(config));
    }

    void takesItsOrdersFromTheServerConfig()
    {
        ServerConfig config;
        config.lines = {lineWith(1, true, {accelerometer(1, 2)})};
        config.adc24Port = 1503;
        config.adc24Axis = Adc24Axis::Y;
        config.ringPackets = 99;
        config.modbusClients = 7;
        config.modbusIdle = std::chrono::seconds(30);
        config.modbusBind = QStringLiteral("::1");
        config.modbusAllow = QStringList{QStringLiteral("10.0.0.0/8")};
        Adc24Config expected;
        expected.port = 1503;
        expected.number = 2;
        expected.axis = Adc24Axis::Y;
        expected.ringPackets = 99;
        expected.initialWord = 0x0700;
        expected.desk.clients = 7;
        expected.desk.idle = std::chrono::milliseconds(30000);
        expected.desk.bind = QStringLiteral("::1");
        expected.desk.allow = QStringList{QStringLiteral("10.0.0.0/8")};
        QVERIFY(adc24Config(config) == expected);
    }
};

QTEST_APPLESS_MAIN(TestAdc24Image)
#include "tst_adc24image.moc"
