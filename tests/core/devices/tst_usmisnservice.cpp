#include "core/devices/usmisn/usmisnservice.h"
#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::usmisn;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// The service against conversations in the words of manual 002.
class TstUsmisnService : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void probes();
    void reads();
    void readsAnotherDevice();
    void findsBySerial();
    void measuresAgainUnlessStored();
    void changesAddress();
    void takenAddress();
    void stillAtTheOldAddress();
    void startsTheRecorder();
    void recordsArriveOneByOne();
    void brokenRecords();
    void stopsWhenAsked();
    void tellsEverybody();
    void portOnALineThatCannotFollow();
};

namespace {

Timing timing()
{
    Timing timing;
    timing.readCommand = 200ms;
    timing.readData = 4000ms;
    return timing;
}

/// `%/Q/7/500/GetType//%`
QByteArray asks(int transaction, const char *rest, const char *address = "7")
{
    return QByteArray("%/Q/") + address + '/' + QByteArray::number(transaction) + '/' + rest + "/%";
}

QByteArray says(int transaction, const char *rest, const char *address = "7")
{
    return QByteArray("\n%/R/") + address + '/' + QByteArray::number(transaction) + '/' + rest + "/%\r\n";
}

const char record10[] =
    "GetRecord/1483267232,00123456701,00000000010,-0002.48356,0000.00870,26.30,A,Grad,Angle_X,001,5";
const char record11[] =
    "GetRecord/1483267240,00123456701,00000000011,-0002.48124,0000.00865,26.35,A,Grad,Angle_X,001,5";

bool isClean(const FakeLine &line)
{
    return line.isDone() && line.complaints().isEmpty();
}

} // namespace

void TstUsmisnService::probes()
{
    const Service service(timing());
    FakeLine line;
    line.expectInPieces(asks(500, "GetType/"), says(500, "GetType/028"), 2);
    QCOMPARE(*service.probe(line, 7), 28);
    line.expect(asks(501, "GetType/"), {});
    QVERIFY(service.probe(line, 7).fault() == Fault::Timeout);
    line.expect(asks(502, "GetType/"), says(502, "GetType/O28"))
        .expect(asks(503, "GetType/"), says(503, "GetType/028"));
    QCOMPARE(*service.probe(line, 7), 28);
    QVERIFY(service.probe(line, 0).fault() == Fault::Refused && service.probe(line, 256).fault() == Fault::Refused);
    QVERIFY(isClean(line));
}

void TstUsmisnService::reads()
{
    const Service service(timing());
    FakeLine line;
    line.expect(asks(500, "GetType/"), says(500, "GetType/028"));
    line.expect(asks(501, "GetSerial/"), {}); // lost
    line.expectInPieces(asks(502, "GetSerial/"), says(502, "GetSerial/00028000"), 3);
    line.expect(asks(503, "GetProgVersion/"), says(503, "GetProgVersion/14.04.17"));
    line.expect(asks(504, "GetDateCalibration/"), says(504, "GetDateCalibration/00000042839"));
    line.expect(asks(505, "GetCountCalibration/"), says(505, "GetCountCalibration/00000000002"));
    line.expectInPieces(
        asks(506, "GetInfo/"),
        "\n%/R/7/506/GetInfo/0002800001,A,Grad,Angle_X%\r\n\n%/R/7/506/GetInfo/0002800002,A,Grad,Angle_Y%\r\n"
            + says(506, "GetInfo/End"));
    const auto identity = service.read(line, 7);
    QVERIFY(identity);
    Identity expected;
    expected.address = 7;
    expected.type = 28;
    expected.serial = 28000;
    expected.program = QDate(2017, 4, 14);
    expected.calibratedOn = QDate(2017, 4, 14);
    expected.calibrations = 2;
    const QString units = QStringLiteral("Grad");
    expected.channels = {
        {{2800001}, QStringLiteral("A"), units, QStringLiteral("Angle_X")},
        {{2800002}, QStringLiteral("A"), units, QStringLiteral("Angle_Y")}};
    QVERIFY(*identity == expected);
    QVERIFY(isClean(line));
}

void TstUsmisnService::readsAnotherDevice()
{
    const Service service(timing());
    FakeLine line;
    line.expect(asks(500, "GetType/"), says(500, "GetType/017"));
    line.expect(asks(501, "GetSerial/"), says(501, "GetSerial/00028000"));
    const auto identity = service.read(line, 7);
    QVERIFY(identity && !identity->isInclinometer());
    QCOMPARE(identity->type, 17);
    QCOMPARE(identity->serial, 28000U);
    QVERIFY(isClean(line));
}

/// The manual prints the answer to such a GetValue with address 0, the one to GetRecord with that of the device.
void TstUsmisnService::findsBySerial()
{
    const Service service(timing());
    FakeLine line;
    const char value[] =
        "GetValue/0000000000,00123456701,00000000000,-0002.48289,0000.00860,26.33,A,Grad,Angle_X,001,5";
    line.expectPieces(asks(500, "GetValue/0,123456701", "0"), {{says(500, value, "0"), 1200ms}});
    line.expect(asks(501, "GetRecord/1,ALL,123456701", "0"), says(501, "GetRecord/End", "123"));
    QCOMPARE(*service.find(line, 1234567), 123);
    line.expect(asks(502, "GetValue/0,123456701", "0"), says(502, value, "123")); // a device that says who it is
    QCOMPARE(*service.find(line, 1234567), 123);
    line.expect(asks(503, "GetValue/0,123456701", "0"), {});
    QVERIFY(service.find(line, 1234567).fault() == Fault::Timeout);
    QVERIFY(isClean(line));
}

void TstUsmisnService::measuresAgainUnlessStored()
{
    const Service service(timing());
    FakeLine line;
    const char now[] = "GetValue/0,00123456702,0,0001.50000,0000.00860,26.33,A,Grad,Angle_Y,001,5";
    line.expect(asks(500, "GetValue/0,2"), {}).expectPieces(asks(501, "GetValue/0,2"), {{says(501, now), 1400ms}});
    const auto value = service.measure(line, 7, channelY);
    QVERIFY(value && value->value == 1.5);
    line.expect(asks(502, "GetValue/1483267255,2"), {});
    QVERIFY(service.measure(line, 7, channelY, 1483267255).fault() == Fault::Timeout);
    line.expect(asks(503, "GetValue/0,3"), says(503, "GetValue/ErrorCH"));
    QVERIFY(service.measure(line, 7, 3)->state == ValueState::ErrorChannel);
    QVERIFY(isClean(line));
}

void TstUsmisnService::changesAddress()
{
    const Service service(timing());
    FakeLine line;
    for (int i = 0; i < 3; ++i) {
        line.expect(asks(500 + i, "GetType/", "32"), {}); // nobody is there
    }
    line.expect(asks(503, "SetAddress/32"), {}); // its answer is lost
    line.expect(asks(504, "GetType/", "32"), says(504, "GetType/028", "32"));
    QVERIFY(service.changeAddress(line, 7, 32));
    QVERIFY(isClean(line));
    QVERIFY(service.changeAddress(line, 7, 0).fault() == Fault::Refused);
    QVERIFY(service.changeAddress(line, 7, 256).fault() == Fault::Refused);
}

void TstUsmisnService::takenAddress()
{
    const Service service(timing());
    FakeLine line;
    line.expect(asks(500, "GetType/", "32"), {}).expect(asks(501, "GetType/", "32"), says(501, "GetType/017", "32"));
    QVERIFY(service.changeAddress(line, 7, 32).fault() == Fault::Refused);
    QVERIFY(isClean(line));
}

void TstUsmisnService::stillAtTheOldAddress()
{
    const Service service(timing());
    FakeLine line;
    for (int i = 0; i < 3; ++i) {
        line.expect(asks(500 + i, "GetType/", "32"), {});
    }
    int transaction = 503;
    for (int i = 0; i < 3; ++i) {
        line.expect(asks(transaction++, "SetAddress/32"), {});
        for (int probe = 0; probe < 3; ++probe) {
            line.expect(asks(transaction++, "GetType/", "32"), {});
        }
    }
    line.expect(asks(transaction, "GetType/"), says(transaction, "GetType/028"));
    QVERIFY(service.changeAddress(line, 7, 32).fault() == Fault::BadReply);
    QVERIFY(isClean(line));
}

void TstUsmisnService::startsTheRecorder()
{
    const Service service(timing());
    const Recording hourly{1483267255, 1483267265, 3600s, 30s};
    const char start[] = "StartCycle/1483267255,1483267265,3600,30";
    FakeLine line;
    line.expect(asks(500, "GetType/"), says(500, "GetType/028")).expect(asks(501, start), says(501, start));
    QVERIFY(service.startCycle(line, 7, hourly));
    line.expect(asks(502, "GetType/"), says(502, "GetType/028")).expect(asks(503, start), {}); // lost, and it sleeps
    line.expect(asks(504, "GetType/"), {}).expect(asks(505, "GetType/"), {}).expect(asks(506, "GetType/"), {});
    QVERIFY(service.startCycle(line, 7, hourly));
    line.expect(asks(507, "GetType/"), {}).expect(asks(508, "GetType/"), {}).expect(asks(509, "GetType/"), {});
    QVERIFY(service.startCycle(line, 7, hourly).fault() == Fault::Timeout); // it was never there
    QVERIFY(service.startCycle(line, 7, {1483267255, 1483267265, 899s, 0s}).fault() == Fault::Refused);
    QVERIFY(isClean(line));
}

void TstUsmisnService::recordsArriveOneByOne()
{
    const Service service(timing());
    FakeLine line;
    // More than four seconds in all, but never between two.
    line.expectPieces(
        asks(500, "GetRecord/0,NEW,1"),
        {{says(500, record10), 3000ms}, {says(500, record11), 3000ms}, {says(500, "GetRecord/End"), 3000ms}});
    QList<quint32> measurements;
    const auto done = service.records(line, 7, 0, RecordMask::New, channelX, [&](const Value &record) {
        measurements.append(record.measurement);
        return true;
    });
    QVERIFY(done);
    QCOMPARE(measurements, (QList<quint32>{10, 11}));
    QVERIFY(isClean(line));
}

void TstUsmisnService::brokenRecords()
{
    const Service service(timing());
    FakeLine line;
    int count = 0;
    const auto take = [&count](const Value &) { return ++count > 0; };
    line.expect(asks(500, "GetRecord/0,ALL,1"), says(500, record10)); // and no End
    QVERIFY(service.records(line, 7, 0, RecordMask::All, channelX, take).fault() == Fault::Timeout);
    QCOMPARE(std::exchange(count, 0), 1);
    QByteArray damaged = says(501, record10);
    damaged.replace("2.48", "2.4x");
    line.expect(asks(501, "GetRecord/0,ALL,1"), damaged + says(501, record11) + says(501, "GetRecord/End"));
    QVERIFY(service.records(line, 7, 0, RecordMask::All, channelX, take).fault() == Fault::BadReply);
    QCOMPARE(std::exchange(count, 0), 1); // the good one is taken all the same
    line.expect(asks(502, "GetRecord/0,ALL,3"), says(502, "GetRecord/ErrorCH"));
    QVERIFY(service.records(line, 7, 0, RecordMask::All, 3, take).fault() == Fault::Refused);
    line.vanishAfter(asks(503, "GetRecord/0,ALL,1"));
    QVERIFY(service.records(line, 7, 0, RecordMask::All, channelX, take).fault() == Fault::Closed);
    QVERIFY(isClean(line));
    QCOMPARE(count, 0);
}

void TstUsmisnService::stopsWhenAsked()
{
    const Service service(timing());
    FakeLine line;
    line.expect(asks(500, "GetRecord/0,ALL,1"), says(500, record10) + says(500, record11) + says(500, "GetRecord/End"));
    int count = 0;
    const auto done =
        service.records(line, 7, 0, RecordMask::All, channelX, [&](const Value &) { return ++count < 1; });
    QVERIFY(done.fault() == Fault::Cancelled);
    QCOMPARE(count, 1);
}

/// Nobody answers, and nobody is waited for.
void TstUsmisnService::tellsEverybody()
{
    const Service service(timing());
    FakeLine line;
    line.expect(asks(500, "SetAddress/32", "000"), {}).expect(asks(501, "SetPortSettings/19200,N,1", "000"), {});
    line.expect(asks(502, "ResetPortSettings/", "000"), {}).expect(asks(503, "StopCycle/", "0"), {});
    QVERIFY(service.setEveryAddress(line, 32));
    QVERIFY(service.setEveryPort(line, {19200, Parity::None, StopBits::One}));
    QVERIFY(service.resetEveryPort(line));
    QVERIFY(service.stopEveryCycle(line));
    QVERIFY(isClean(line));
    QVERIFY(line.elapsed() < 200ms);
    QVERIFY(service.setEveryAddress(line, 0).fault() == Fault::Refused);
    QVERIFY(service.startEveryCycle(line, {2, 1, 900s, 0s}).fault() == Fault::Refused);
}

void TstUsmisnService::portOnALineThatCannotFollow()
{
    const Service service(timing());
    FakeLine line;
    line.expect(asks(500, "SetPortSettings/19200,N,1"), says(500, "SetPortSettings/19200,N,1"));
    const PortChange changed = service.changePort(line, 7, {19200, Parity::None, StopBits::One});
    QVERIFY(changed.result && !changed.isProbed);
    line.expect(asks(501, "SetPortSettings/19200,N,1"), says(501, "SetPortSettings/ErrorData"));
    QVERIFY(service.changePort(line, 7, {19200, Parity::None, StopBits::One}).result.fault() == Fault::Refused);
    QVERIFY(isClean(line));
}

QTEST_GUILESS_MAIN(TstUsmisnService)
#include "tst_usmisnservice.moc"
