#include "core/devices/and3/and3answers.h"
#include "core/devices/and3/and3packet.h"
#include "tests/core/devices/and3frames.h"
#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::and3;
using namespace gorizont::test;

class TstAnd3Answers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void complexRead();
    void complexReadAtTheLimits();
    void recordingByModeWord_data();
    void recordingByModeWord();
    void conditions_data();
    void conditions();
    void information();
    void configuration();
    void wrongLengths();
    void packet();
    void startBeforeTheHighPartChanged();
    void severalPackets();
    void packetQuality_data();
    void packetQuality();
};

void TstAnd3Answers::complexRead()
{
    const auto read = parseComplexRead(hex("01 C9 84 8F 04 55 E1 14 50 01 34 00 0F 24 05 CC 02 00 00 CC CF DE"));
    QVERIFY(read);
    QCOMPARE(read->tilt.x, -3599.5);
    QCOMPARE(read->tilt.y, 2720.5);
    QCOMPARE(read->temperature, 21.38);
    QCOMPARE(read->fanFrequency, 42.0);
    QCOMPARE(read->heaterPower, 5.2);
    QCOMPARE(read->rawStatus, quint16(0b0010'0100'0000'1111));
    QCOMPARE(read->samples, quint32(183301));
    QCOMPARE(read->rawMode, quint16(0b1100'1100'0000'0000));
}

void TstAnd3Answers::complexReadAtTheLimits()
{
    const auto read = parseComplexRead(hex("FF C9 00 80 FF 7F 00 80 FF FF E8 03 FF FF FF FF FF FF FF FF 00 00"));
    QVERIFY(read);
    QCOMPARE(read->tilt.x, -4096.0);
    QCOMPARE(read->tilt.y, 4095.875);
    QCOMPARE(read->temperature, -131.072);
    QCOMPARE(read->fanFrequency, 8191.875);
    QCOMPARE(read->heaterPower, 100.0);
    QCOMPARE(read->samples, quint32(0xFFFFFFFF));
}

void TstAnd3Answers::recordingByModeWord_data()
{
    QTest::addColumn<quint16>("mode");
    QTest::addColumn<bool>("isRecording");
    QTest::newRow("healthy") << quint16(0xCC00) << true;
    QTest::newRow("bit 6") << quint16(0xCC40) << false;
    QTest::newRow("all but bit 6") << quint16(0xFFBF) << true;
}

void TstAnd3Answers::recordingByModeWord()
{
    QFETCH(quint16, mode);
    QFETCH(bool, isRecording);
    ComplexRead read;
    read.rawMode = mode;
    QCOMPARE(read.isRecording(), isRecording);
}

void TstAnd3Answers::conditions_data()
{
    QTest::addColumn<quint16>("status");
    QTest::addColumn<Conditions>("expected");
    using C = Condition;
    // the ready bits are set in all rows but their own
    QTest::newRow("nothing wrong") << quint16(0x200F) << Conditions();
    QTest::newRow("healthy without a fan") << quint16(0x240F) << Conditions(C::FanError);
    QTest::newRow("0 rebooted") << quint16(0x200E) << Conditions(C::Rebooted);
    QTest::newRow("1 no angles") << quint16(0x200D) << Conditions(C::TiltNotReady);
    QTest::newRow("2 no temperature") << quint16(0x200B) << Conditions(C::TemperatureNotReady);
    QTest::newRow("3 no fan data") << quint16(0x2007) << Conditions();
    QTest::newRow("4 transducer silent") << quint16(0x201F) << Conditions(C::TransducerSilent);
    QTest::newRow("5 transducer CRC") << quint16(0x202F) << Conditions(C::TransducerCrc);
    QTest::newRow("6 transducer range") << quint16(0x204F) << Conditions(C::TransducerRange);
    QTest::newRow("7 reserved") << quint16(0x208F) << Conditions();
    QTest::newRow("8 temperature read") << quint16(0x210F) << Conditions(C::TemperatureReadError);
    QTest::newRow("9 temperature range") << quint16(0x220F) << Conditions(C::TemperatureRange);
    QTest::newRow("10 fan") << quint16(0x240F) << Conditions(C::FanError);
    QTest::newRow("11 thermostat") << quint16(0x280F) << Conditions(C::ThermostatError);
    QTest::newRow("12 searching") << quint16(0x300F) << Conditions();
    QTest::newRow("13 thermostat off") << quint16(0x000F) << Conditions();
    QTest::newRow("14, 15 reserved") << quint16(0xE00F) << Conditions();
    QTest::newRow("several") << quint16(
        0x0010) << Conditions(C::Rebooted | C::TiltNotReady | C::TemperatureNotReady | C::TransducerSilent);
}

void TstAnd3Answers::conditions()
{
    QFETCH(quint16, status);
    QFETCH(Conditions, expected);
    QCOMPARE(conditionsOf(status), expected);
}

void TstAnd3Answers::information()
{
    const QByteArray answer = hex("01 24 0C 03 02 00 02 BA");
    QVERIFY(parseFirmware(answer) == (Firmware{.version = 2, .subVersion = 3, .build = 12}));
    QCOMPARE(parseInformation(answer), std::optional<quint32>(0x0002030C));
}

void TstAnd3Answers::configuration()
{
    const auto bytes =
        parseConfiguration(hex("01 DD 10 20 30 40 01 07 06 07 08 09 0A 0B 0C 0D 0E 0F 10 11 12 13 14 15 16 "
                               "17 18 19 1A 1B 1C 1D 1E 1F AC C4"));
    QVERIFY(bytes);
    QCOMPARE(bytes->at(0), quint8(0x10));
    QCOMPARE(bytes->at(addressIndex), quint8(1));
    QCOMPARE(bytes->at(5), quint8(7));
    QCOMPARE(bytes->at(31), quint8(0x1F));
}

void TstAnd3Answers::wrongLengths()
{
    for (qsizetype size = 0; size < 400; ++size) {
        const QByteArray answer(size, '\x01');
        QCOMPARE(parseComplexRead(answer).has_value(), size == 22);
        QCOMPARE(parseInformation(answer).has_value(), size == 8);
        QCOMPARE(parseFirmware(answer).has_value(), size == 8);
        QCOMPARE(parseConfiguration(answer).has_value(), size == 36);
        QCOMPARE(parsePackets(answer).has_value(), size == 152 || size == 300);
    }
}

void TstAnd3Answers::packet()
{
    // x counts from 0x0100 up, y is −2 throughout; written byte by byte, not by the test's own builder
    QByteArray data;
    for (int i = 0; i < 32; ++i) {
        data.append(static_cast<char>(i)).append('\x01');
    }
    for (int i = 0; i < 32; ++i) {
        data.append("\xFE\xFF", 2);
    }
    data += hex("00 00 00 10 00 00 00 20 03 00 00 00 05 00 44 01 FE 7F 39 30");
    const auto packets = parsePackets(sealed(hex("01 CB") + data));
    QVERIFY(packets && packets->size() == 1);
    const Packet &packet = packets->first();
    QCOMPARE(packet.x.size(), 32);
    QCOMPARE(packet.x.first(), qint16(256));
    QCOMPARE(packet.x.last(), qint16(287));
    QCOMPARE(packet.y, QList<qint16>(32, -2));
    QCOMPARE(packet.start, Q_UINT64_C(0x3'1000'0000));
    QCOMPARE(packet.stop, Q_UINT64_C(0x3'2000'0000));
    QCOMPARE(packet.errors, quint16(5));
    QCOMPARE(packet.drz, quint16(324));
    QCOMPARE(packet.ax, quint16(32766));
    QCOMPARE(packet.ay, quint16(12345));
}

void TstAnd3Answers::startBeforeTheHighPartChanged()
{
    const QByteArray data = QByteArray(128, '\0') + hex("00 00 00 FF 00 00 00 06 04 00 00 00 00 00 44 01 00 00 00 00");
    const auto packets = parsePackets(sealed(hex("01 CB") + data));
    QVERIFY(packets);
    QCOMPARE(packets->first().start, Q_UINT64_C(0x3'FF00'0000));
    QCOMPARE(packets->first().stop, Q_UINT64_C(0x4'0600'0000));
}

void TstAnd3Answers::severalPackets()
{
    const auto packets = parsePackets(packetsAnswer(33, 3)); // tick 33 · 128e6 is the last below 2^32
    QVERIFY(packets && packets->size() == 3);
    QCOMPARE(packets->at(0).start, 33 * ticksInPacket);
    QCOMPARE(packets->at(1).start, packets->at(0).stop);
    QCOMPARE(packets->at(2).start, packets->at(1).stop);
    QCOMPARE(packets->at(2).stop, 36 * ticksInPacket);
    QCOMPARE(packets->at(2).x.first(), qint16(35 * 32));
}

void TstAnd3Answers::packetQuality_data()
{
    QTest::addColumn<int>("errors");
    QTest::addColumn<int>("drz");
    QTest::addColumn<int>("ax");
    QTest::addColumn<bool>("isValid");
    QTest::newRow("good") << 0 << 324 << 32766 << true;
    QTest::newRow("better") << 0 << 65535 << 0 << true;
    QTest::newRow("errors") << 1 << 324 << 32766 << false;
    QTest::newRow("drz") << 0 << 323 << 32766 << false;
    QTest::newRow("AX") << 0 << 324 << 32767 << false;
    QTest::newRow("AX unsigned") << 0 << 324 << 65535 << false;
    QTest::newRow("never written") << 0 << 0 << 0 << false;
}

void TstAnd3Answers::packetQuality()
{
    QFETCH(int, errors);
    QFETCH(int, drz);
    QFETCH(int, ax);
    QFETCH(bool, isValid);
    PacketText text;
    text.errors = static_cast<quint16>(errors);
    text.drz = static_cast<quint16>(drz);
    text.ax = static_cast<quint16>(ax);
    const auto packets = parsePackets(packetsAnswer(text.toBytes()));
    QVERIFY(packets);
    QCOMPARE(packets->first().isValid(), isValid);
}

QTEST_GUILESS_MAIN(TstAnd3Answers)
#include "tst_and3answers.moc"
