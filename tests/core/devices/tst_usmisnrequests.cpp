#include "core/devices/usmisn/usmisnprotocol.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::usmisn;

/// Every request that manual 002 prints in section 3, and those that are not sent. The addresses are printed in one and in
/// three digits.
class TstUsmisnRequests : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void requests_data();
    void requests();
    void badRequests_data();
    void badRequests();
    void refusesToAsk();
};

namespace {

using Q = Instruction;

Asking to(int address = 123)
{
    return {address, "001"};
}

} // namespace

void TstUsmisnRequests::requests_data()
{
    QTest::addColumn<QByteArray>("built");
    QTest::addColumn<QByteArray>("printed");
    const auto row = [](const char *printed, const std::optional<Ask> &ask) {
        QTest::newRow(printed) << (ask ? ask->bytes() : QByteArray()) << QByteArray(printed);
    };
    row("%/Q/123/001/GetSerial//%", to().plain(Q::GetSerial));
    row("%/Q/123/001/GetType//%", to().plain(Q::GetType));
    row("%/Q/123/001/GetProgVersion//%", to().plain(Q::GetProgVersion));
    row("%/Q/123/001/GetDateCalibration//%", to().plain(Q::GetDateCalibration));
    row("%/Q/123/001/GetCountCalibration//%", to().plain(Q::GetCountCalibration));
    row("%/Q/123/001/GetInfo//%", to().plain(Q::GetInfo));
    row("%/Q/123/001/GetAddress//%", to().plain(Q::GetAddress));
    row("%/Q/000/001/GetAddress//%", to(0).plain(Q::GetAddress));
    row("%/Q/123/001/SetAddress/32/%", to().setAddress(32));
    row("%/Q/000/001/SetAddress/32/%", to(0).setAddress(32));
    row("%/Q/123/001/SetPortSettings/19200,N,1/%", to().setPortSettings({19200, Parity::None, StopBits::One}));
    row("%/Q/000/001/SetPortSettings/19200,N,1/%", to(0).setPortSettings({19200, Parity::None, StopBits::One}));
    row("%/Q/123/001/ResetPortSettings//%", to().plain(Q::ResetPortSettings));
    row("%/Q/000/001/ResetPortSettings//%", to(0).plain(Q::ResetPortSettings));
    row("%/Q/123/001/GetValue/0,1/%", to().getValue(1));
    row("%/Q/123/001/GetValue/0,3/%", to().getValue(3));
    row("%/Q/0/001/GetValue/0,123456701/%", to(0).getValue(123456701));
    row("%/Q/123/001/GetValue/1483267255,1/%", to().getValue(1, 1483267255));
    row("%/Q/123/001/GetRecord/1,ALL,1/%", to().getRecord(1, RecordMask::All, 1));
    row("%/Q/123/001/GetRecord/3,ALL,1/%", to().getRecord(3, RecordMask::All, 1));
    row("%/Q/123/001/GetRecord/1,NEW,1/%", to().getRecord(1, RecordMask::New, 1));
    row("%/Q/0/001/GetRecord/1,ALL,1/%", to(0).getRecord(1, RecordMask::All, 1));
    const Recording hourly{1483267255, 1483267265, std::chrono::seconds(3600), std::chrono::seconds(30)};
    row("%/Q/123/001/StartCycle/1483267255,1483267265,3600,30/%", to().startCycle(hourly));
    row("%/Q/0/001/StartCycle/1483267255,1483267265,3600,30/%", to(0).startCycle(hourly));
    row("%/Q/123/001/StopCycle//%", to().plain(Q::StopCycle));
    row("%/Q/0/001/StopCycle//%", to(0).plain(Q::StopCycle));
    row("%/Q/123/001/GetCRC//%", to().plain(Q::GetCrc));
}

void TstUsmisnRequests::requests()
{
    QFETCH(QByteArray, built);
    QFETCH(QByteArray, printed);
    QCOMPARE(built, printed);
}

/// The requests that the manual prints as wrong, and the data that no answer repeats.
void TstUsmisnRequests::badRequests_data()
{
    QTest::addColumn<QByteArray>("built");
    QTest::addColumn<QByteArray>("printed");
    const auto row = [](const char *printed, Instruction instruction, const char *data) {
        QTest::newRow(printed) << encodeRequest({123, "001", instruction}, data) << QByteArray(printed);
    };
    row("%/Q/123/001/SetAddress/ABC/%", Q::SetAddress, "ABC");
    row("%/Q/123/001/SetPortSettings/0,0,0/%", Q::SetPortSettings, "0,0,0");
    row("%/Q/123/001/GetValue/1/%", Q::GetValue, "1");
    row("%/Q/123/001/GetRecord/1/%", Q::GetRecord, "1");
    row("%/Q/123/001/StartCycle/1483267255,1483267265,0,30/%", Q::StartCycle, "1483267255,1483267265,0,30");
    row("%/Q/123/001/StartCycle/1/%", Q::StartCycle, "1");
}

void TstUsmisnRequests::badRequests()
{
    QFETCH(QByteArray, built);
    QFETCH(QByteArray, printed);
    QCOMPARE(built, printed);
}

void TstUsmisnRequests::refusesToAsk()
{
    QVERIFY(!to().setAddress(0) && !to().setAddress(256) && !to().setAddress(-1));
    QVERIFY(to().setAddress(1) && to().setAddress(255));
    QVERIFY(!to().setPortSettings({109, Parity::None, StopBits::One}));
    QVERIFY(!to().setPortSettings({115201, Parity::None, StopBits::One}));
    QVERIFY(!to().setPortSettings({9600, Parity::Mark, StopBits::One}));
    QCOMPARE(to().setPortSettings({110, Parity::Even, StopBits::OneAndHalf})->data, QByteArray("110,E,1_5"));
    QCOMPARE(to().setPortSettings({115200, Parity::Odd, StopBits::Two})->data, QByteArray("115200,O,2"));
    QVERIFY(!to().getValue(0) && !to().getValue(1, -1) && !to().getValue(1, 4294967296));
    QVERIFY(!to().getRecord(-1, RecordMask::All, 1) && !to().getRecord(1000, RecordMask::All, 1));
    QVERIFY(to().getRecord(0, RecordMask::All, 1) && to().getRecord(999, RecordMask::New, 2));

    using std::chrono::seconds;
    const auto isSent = [](qint64 start, int period, int delay) {
        return to().startCycle({1000, start, seconds(period), seconds(delay)}).has_value();
    };
    QVERIFY(isSent(1001, 900, 0) && isSent(1001, 43200, 600));
    QVERIFY(!isSent(1001, 899, 0) && !isSent(1001, 43201, 0) && !isSent(1001, 900, -1) && !isSent(1001, 900, 601));
    QVERIFY(!isSent(1000, 900, 0)); // the first measurement would be in the past
}

QTEST_GUILESS_MAIN(TstUsmisnRequests)
#include "tst_usmisnrequests.moc"
