#include "core/devices/lvims/lvimsprotocol.h"
#include "core/values/vibrationjson.h"
#include "core/values/vibrationkinds.h"

#include <QJsonDocument>
#include <QTest>

#include <bit>
#include <cmath>

using namespace gorizont;
using namespace gorizont::lvims;
using Qt::Literals::StringLiterals::operator""_s;

namespace {

/// CHST with one measurement: M = 0.
Words chst(quint16 status, QList<quint16> measurement, int index = 0)
{
    QList<quint16> registers(88, 0);
    registers[0] = status;
    for (qsizetype i = 0; i < measurement.size(); ++i) {
        registers[8 + 10 * index + i] = measurement.at(i);
    }
    return {0, registers};
}

/// Type 2, flags, 2.5 (40200000h, low word first), 4210, 4000.
VibrationMeasurement measuredWith(quint16 flags)
{
    return channelOf(chst(0, {2, flags, 0x0000, 0x4020, 4210, 4000}), 1, {}).measurements.value(0);
}

} // namespace

/// What registers mean: manual 003, sections 2.1 to 2.3. Numbers were put into words by hand.
class TstLVimsProtocol : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// U32 and float: low word first, each register as Modbus has it.
    void wordOrder()
    {
        const Words words(99, {0x5678, 0x1234});
        QCOMPARE(words.doubleWord(moduleRegister("LAST_CHECK_SETTINGS_ERR")), 0x12345678u);
        const Words real(37124, {0x0000, 0x46C8}); // 46C80000h = 25600.0
        QCOMPARE(real.real(moduleRegister("WF_INFO_FREQ")), 25600.0f);
        QCOMPARE(fromDoubleWord(0x56494253), (QList<quint16>{0x4253, 0x5649}));
        QCOMPARE(fromReal(-264.5f), (QList<quint16>{0x4000, 0xC384}));
    }

    /// The low byte of the first register is the first character.
    void strings()
    {
        const Words words(1, {0x4956, 0x534D, 0x495F, 0x5043, 0x0000, 0x4141});
        QCOMPARE(words.text(moduleRegister("DEVNAME")), u"VIMS_ICP"_s);
        const Words full(49, QList<quint16>(8, 0x4241)); // as long as its registers: no zero
        QCOMPARE(full.text(moduleRegister("BRD_REV")), u"ABABABABABABABAB"_s);
        QCOMPARE(fromText(u"Нс"_s, 3), (QList<quint16>{0x9DD0, 0x81D1, 0x0000})); // D0 9D D1 81
        QCOMPARE(fromText(u"Нс"_s, 1), (QList<quint16>{0x9DD0}));
        QCOMPARE(fromText(u"aНс"_s, 1), (QList<quint16>{0x0061})); // no half of a character
    }

    void ipAddress()
    {
        const Words words(32, {0xA8C0, 0x0A01});
        QCOMPARE(words.ipAddress(settingRegister("IP_ADDR")), u"192.168.1.10"_s);
    }

    void whatLiesOutsideIsZero()
    {
        const Words words(97, {2});
        QCOMPARE(words.word(moduleRegister("DEVMODE")), 2);
        QCOMPARE(words.word(moduleRegister("LAST_WR_ERROR")), 0);
        QCOMPARE(words.doubleWord(moduleRegister("RELE_STATE")), 0u);
        QCOMPARE(words.text(moduleRegister("SERIAL")), QString());
    }

    void ranges()
    {
        QCOMPARE(int(identityRange.first), 1);
        QCOMPARE(identityRange.count, 100);
        QCOMPARE(int(statusRange.first), 1024);
        QCOMPARE(statusRange.count, 30);
        QCOMPARE(int(channelRange(3).first), 1544);
        QCOMPARE(channelRange(3).count, 88);
        QCOMPARE(int(relayRange.first), 1632);
        QCOMPARE(relayRange.count, 2);
    }

    void status()
    {
        QList<quint16> registers;
        for (quint16 i = 0; i < 30; ++i) {
            registers.append(static_cast<quint16>(100 + i));
        }
        const Status status = statusOf(Words(1024, registers));
        QCOMPARE(status.channels[0], (Status::Channel{100, 104, 108, 112, 116, 120, 124}));
        QCOMPARE(status.channels[3], (Status::Channel{103, 107, 111, 115, 119, 123, 127}));
        QCOMPARE(status.settings, 128);
        QCOMPARE(status.relays, 129);
    }

    void aMeasurement()
    {
        const VibrationChannel channel = channelOf(chst(0, {2, 0x0301, 0x0000, 0x4020, 4210, 4000}, 5), 1, {});
        QCOMPARE(channel.channel, 1);
        QCOMPARE(channel.state, ChannelState::Good);
        QCOMPARE(channel.measurements.size(), 1); // type 0: not used
        const VibrationMeasurement &measurement = channel.measurements.constFirst();
        QCOMPARE(measurement.index, 5);
        QCOMPARE(measurement.type, 2);
        QCOMPARE(measurement.value, std::optional(2.5));
        QCOMPARE(measurement.percent, std::optional(4210.0)); // raw: nobody said what 100 % is
        QCOMPARE(measurement.baseline, std::optional(4000.0));
        QVERIFY(measurement.isBaselineExceeded);
    }

    void percentOfAKnownScale()
    {
        const Words words = chst(0, {1, 0x0100, 0, 0, 4210, 4000});
        const VibrationMeasurement measurement = channelOf(words, 0, 10000).measurements.value(0);
        QCOMPARE(measurement.percent, std::optional(42.1));
        QCOMPARE(measurement.baseline, std::optional(40.0));
    }

    /// Two bits: 00 false, 01 true, 10 Z.
    void tribool_data()
    {
        using Flag = std::optional<bool>;
        QTest::addColumn<int>("flags");
        QTest::addColumn<Flag>("fault");
        QTest::addColumn<Flag>("warning");
        QTest::addColumn<Flag>("stop");
        QTest::newRow("all false") << 0x00 << Flag(false) << Flag(false) << Flag(false);
        QTest::newRow("fault") << 0x01 << Flag(true) << Flag(false) << Flag(false);
        QTest::newRow("fault Z") << 0x02 << Flag() << Flag(false) << Flag(false);
        QTest::newRow("warning") << 0x04 << Flag(false) << Flag(true) << Flag(false);
        QTest::newRow("warning Z") << 0x08 << Flag(false) << Flag() << Flag(false);
        QTest::newRow("stop") << 0x10 << Flag(false) << Flag(false) << Flag(true);
        QTest::newRow("stop Z") << 0x20 << Flag(false) << Flag(false) << Flag();
        QTest::newRow("all Z") << 0x2A << Flag() << Flag() << Flag();
        QTest::newRow("not described") << 0x03 << Flag() << Flag(false) << Flag(false);
    }

    void tribool()
    {
        QFETCH(const int, flags);
        const VibrationMeasurement measurement = measuredWith(static_cast<quint16>(flags));
        QTEST(measurement.fault, "fault");
        QTEST(measurement.warning, "warning");
        QTEST(measurement.stop, "stop");
    }

    void baselineOnlyWhenValid()
    {
        QVERIFY(!measuredWith(0x0200).baseline);
        QVERIFY(measuredWith(0x0200).isBaselineExceeded);
        QCOMPARE(measuredWith(0x0100).baseline, std::optional(4000.0));
        QVERIFY(!measuredWith(0x0100).isBaselineExceeded);
    }

    void aChannelThatIsNotGoodHasNoValue_data()
    {
        QTest::addColumn<int>("status");
        QTest::addColumn<ChannelState>("state");
        QTest::newRow("no data") << 0xFFFF << ChannelState::NoData;
        QTest::newRow("short circuit") << 1 << ChannelState::ShortCircuit;
        QTest::newRow("break") << 2 << ChannelState::Break;
    }

    void aChannelThatIsNotGoodHasNoValue()
    {
        QFETCH(const int, status);
        const VibrationChannel channel = channelOf(chst(static_cast<quint16>(status), {2, 1, 0, 0x4020, 4210}), 0, {});
        QTEST(channel.state, "state");
        QVERIFY(!channel.measurements.value(0).value);
        QVERIFY(!channel.measurements.value(0).percent);
        QCOMPARE(channel.measurements.value(0).fault, std::optional(true));
    }

    void whatIsNoNumberIsNoValue()
    {
        QVERIFY(!channelOf(chst(0, {2, 0, 0x0000, 0x7FC0}), 0, {}).measurements.value(0).value);
    }

    /// R logical, 8 + R physical, 16 + R error, 24 + R enabled.
    void relays()
    {
        const QList<Relay> relays = relaysOf(0x80'40'20'01);
        QCOMPARE(relays.size(), 8);
        QCOMPARE(relays.at(0), (Relay{0, true, false, false, false}));
        QCOMPARE(relays.at(5), (Relay{5, false, true, false, false}));
        QCOMPARE(relays.at(6), (Relay{6, false, false, true, false}));
        QCOMPARE(relays.at(7), (Relay{7, false, false, false, true}));
    }

    void everyTypeHasItsNumber()
    {
        for (int type = 0; type <= 16; ++type) {
            QVERIFY(measurementKind(type));
            QCOMPARE(measurementKind(type)->type, type);
        }
        QVERIFY(!measurementKind(17));
        QVERIFY(!measurementKind(-1));
    }

    void json()
    {
        Vibration vibration;
        vibration.channels = {
            channelOf(chst(0, {2, 0x0124, 0, 0x4020, 4210, 4000}, 3), 0, 10000),
            channelOf(chst(1, {1, 0x0028}), 1, {})};
        vibration.relays = {{2, true, false, true, false}};
        QJsonObject object;
        insertVibration(object, vibration);
        const QByteArray expected = R"({
            "channels": [
                {"channel": 0, "state": 0, "measurements": [
                    {"index": 3, "type": 2, "value": 2.5, "percent": 42.1, "fault": false, "warning": true, "stop": null,
                     "baselineValid": true, "baselineExceeded": false}]},
                {"channel": 1, "state": 1, "measurements": [
                    {"index": 0, "type": 1, "value": null, "percent": null, "fault": false, "warning": null,
                     "stop": null, "baselineValid": false, "baselineExceeded": false}]}],
            "relays": [{"index": 2, "logical": true, "physical": false, "error": true, "enabled": false}]})";
        QCOMPARE(QJsonDocument(object), QJsonDocument::fromJson(expected));
    }
};

QTEST_APPLESS_MAIN(TstLVimsProtocol)
#include "tst_lvimsprotocol.moc"
