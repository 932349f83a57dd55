#include "core/devices/ind3/ind3modbus.h"
#include "core/protocol/modbusrtu.h"
#include "tests/support/fakeline.h"
#include "tests/support/scanning.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::ind3;
using namespace gorizont::test;
using namespace std::chrono_literals;

using MaybeRequest = std::optional<Request>;

/// The register map of spec/ind3.md, "Modbus RTU"; frames assembled by another program.
class TstInd3Modbus : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void exchanges_data();
    void exchanges();
    void angles();
    void settings();
    void settingsThatDoNotExist_data();
    void settingsThatDoNotExist();
    void offsets();
    void outOfRange();
    void bootLoaderIsNeverWritten();
    void faults();
};

namespace {

const QByteArray anglesAnswer = hex("01 04 08 FF FE 2D 8A 00 02 F6 AB 4C BB");
const QByteArray settingsAnswer = hex("01 03 10 00 04 00 01 00 02 00 05 10 30 00 01 00 00 07 5F 98 F4");
const QByteArray offsetsAnswer = hex("01 03 10 FF FF D6 FC 00 00 14 05 00 03 0D 40 FF FB 6C 20 FD 7D");
const QByteArray ownOffsetAnswer = hex("01 03 08 FF FF D6 FC 00 00 14 05 59 3D");

} // namespace

void TstInd3Modbus::exchanges_data()
{
    QTest::addColumn<MaybeRequest>("request");
    QTest::addColumn<QByteArray>("sent");
    QTest::addColumn<QByteArray>("received");

    QTest::newRow("angles") << modbus::readAngles(1) << hex("01 04 00 00 00 04 F1 C9") << anglesAnswer;
    QTest::newRow("settings") << modbus::readSettings(1) << hex("01 03 00 14 00 08 04 08") << settingsAnswer;
    QTest::newRow("offsets") << modbus::readOffsets(1) << hex("01 03 00 1E 00 08 24 0A") << offsetsAnswer;
    QTest::newRow("own offset") << modbus::readOwnOffset(1) << hex("01 03 00 1E 00 04 24 0F") << ownOffsetAnswer;
    QTest::newRow("baud") << modbus::setBaud(1, 115200) << hex("01 10 00 14 00 01 02 00 08 A4 82")
                          << hex("01 10 00 14 00 01 41 CD");
    QTest::newRow("protocol") << modbus::setProtocol(1, false) << hex("01 10 00 15 00 01 02 00 00 A4 95")
                              << hex("01 10 00 15 00 01 10 0D");
    QTest::newRow("period") << modbus::setPeriod(1, 10ms) << hex("01 10 00 16 00 01 02 00 00 A4 A6")
                            << hex("01 10 00 16 00 01 E0 0D");
    QTest::newRow("ticks") << modbus::setTicks(1, 64) << hex("01 10 00 17 00 01 02 00 06 25 75")
                           << hex("01 10 00 17 00 01 B1 CD");
    QTest::newRow("address") << modbus::setAddress(1, 2) << hex("01 10 00 19 00 01 02 00 02 25 98")
                             << hex("01 10 00 19 00 01 D0 0E");
    QTest::newRow("offset") << modbus::setOffset(1, {5.125, -10.5})
                            << hex("01 10 00 1E 00 04 08 FF FF D6 FC 00 00 14 05 52 B8")
                            << hex("01 10 00 1E 00 04 A1 CC");
}

void TstInd3Modbus::exchanges()
{
    QFETCH(MaybeRequest, request);
    QFETCH(QByteArray, sent);
    QFETCH(QByteArray, received);

    QVERIFY(request);
    QCOMPARE(request->bytes, sent);
    QCOMPARE(answerIn(request->scan, received), received);
}

void TstInd3Modbus::angles()
{
    QCOMPARE(*modbus::decodeAngles(anglesAnswer), (Tilt{194.219, -119.414}));
    QCOMPARE(*modbus::decodeAngles(hex("01 04 08 00 00 10 9A FF FF F4 48 38 53")), (Tilt{-3, 4.25}));
}

void TstInd3Modbus::settings()
{
    const modbus::Settings expected{9600, true, 50ms, 32, {4144}, 1, 1887};
    QVERIFY(*modbus::decodeSettings(settingsAnswer) == expected);
}

void TstInd3Modbus::settingsThatDoNotExist_data()
{
    QTest::addColumn<int>("index");
    QTest::addColumn<int>("value");
    QTest::newRow("speed 0") << 0 << 0;
    QTest::newRow("speed 9") << 0 << 9;
    QTest::newRow("protocol 2") << 1 << 2;
    QTest::newRow("period 4") << 2 << 4;
    QTest::newRow("ticks 7") << 3 << 7;
}

void TstInd3Modbus::settingsThatDoNotExist()
{
    QFETCH(int, index);
    QFETCH(int, value);
    QByteArray data = settingsAnswer.sliced(2, 17);
    data[1 + 2 * index + 1] = static_cast<char>(value);
    const QByteArray answer = modbusrtu::frame(1, QModbusResponse(QModbusPdu::ReadHoldingRegisters, data));
    QVERIFY(modbus::decodeSettings(answer).fault() == Fault::BadReply);
}

void TstInd3Modbus::offsets()
{
    const modbus::Offsets expected{{5.125, -10.5}, {-300, 200}};
    QVERIFY(*modbus::decodeOffsets(offsetsAnswer) == expected);
    QCOMPARE(*modbus::decodeOwnOffset(ownOffsetAnswer), expected.own);
    QVERIFY(modbus::decodeOwnOffset(offsetsAnswer).fault() == Fault::BadReply);
}

void TstInd3Modbus::outOfRange()
{
    for (const int address : {-1, 0, 256}) {
        QVERIFY(!modbus::readAngles(address));
        QVERIFY(!modbus::setBaud(address, 9600));
        QVERIFY(!modbus::setAddress(1, address));
    }
    QVERIFY(!modbus::setBaud(1, 9601));
    QVERIFY(!modbus::setTicks(1, 3));
    QVERIFY(!modbus::setPeriod(1, 30ms));
    QVERIFY(!modbus::setOffset(1, {2147483.7, 0}));
    QVERIFY(!modbus::setOffset(1, {0, std::nan("")}));
    QVERIFY(modbus::setOffset(1, {2147483.6, -2147483.6}));
}

/// Register 38 starts the boot loader. No request of the codec touches it.
void TstInd3Modbus::bootLoaderIsNeverWritten()
{
    for (const auto &request :
         {modbus::setBaud(1, 9600), modbus::setProtocol(1, true), modbus::setPeriod(1, 50ms), modbus::setTicks(1, 32),
          modbus::setAddress(1, 2), modbus::setOffset(1, {1, 1})}) {
        const int first = static_cast<quint8>(request->bytes.at(3));
        const int count = static_cast<quint8>(request->bytes.at(5));
        QVERIFY(first + count <= modbus::reg::BootLoader);
    }
}

void TstInd3Modbus::faults()
{
    QVERIFY(modbus::decodeAngles(hex("01 84 02 C2 C1")).fault() == Fault::Refused);
    QVERIFY(modbus::decodeSettings(hex("01 83 02 C0 F1")).fault() == Fault::Refused);
    QVERIFY(modbus::decodeAngles(settingsAnswer).fault() == Fault::BadReply); // eight registers, not four
    QVERIFY(modbus::decodeSettings(anglesAnswer).fault() == Fault::BadReply);
    QVERIFY(modbus::decodeOffsets(QByteArray()).fault() == Fault::BadReply);
}

QTEST_GUILESS_MAIN(TstInd3Modbus)
#include "tst_ind3modbus.moc"
