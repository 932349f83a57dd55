#include "tests/core/devices/ind3frames.h"

using namespace gorizont;
using namespace gorizont::ind3;
using namespace gorizont::ind3::test;

/// The change of an address of ИН-Д3: whoever may stand at the new one, and whatever is lost on the way.
class TstInd3Address : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void changesAddress();
    void changesAddressModbus();
    void takenAddress_data();
    void takenAddress();
    void lostAnswerOfTheNewAddress();
    void atNeither();
    void stillAtTheOldOne();
    void oldProtocol();
};

void TstInd3Address::changesAddress()
{
    FakeLine line;
    expectThrice(line, askTilt2, silence);
    line.expect(setAddress2, addressSet).expect(askTilt2, tilt2).expect(askTilt1, silence);
    QVERIFY(service.changeAddress(line, 1, 2));
    QVERIFY(isClean(line));
}

/// The answer may come from either address.
void TstInd3Address::changesAddressModbus()
{
    for (const QByteArray &answer : {hex("01 10 00 19 00 01 D0 0E"), hex("02 10 00 19 00 01 D0 3D")}) {
        FakeLine line;
        expectThrice(line, modbusAskTilt2, silence);
        line.expect(hex("01 10 00 19 00 01 02 00 02 25 98"), answer).expect(modbusAskTilt2, modbusTilt2);
        line.expect(hex("01 04 00 00 00 04 F1 C9"), silence);
        QVERIFY(modbusService.changeAddress(line, 1, 2));
        QVERIFY(isClean(line));
    }
}

void TstInd3Address::takenAddress_data()
{
    QTest::addColumn<QByteArrayList>("answers");
    QTest::newRow("by a sensor") << QByteArrayList{tilt2};
    QTest::newRow("by one whose answer was lost") << QByteArrayList{silence, silence, tilt2};
    QTest::newRow("by two at once") << QByteArrayList{broken, broken, broken};
}

void TstInd3Address::takenAddress()
{
    QFETCH(QByteArrayList, answers);
    FakeLine line;
    for (const QByteArray &answer : std::as_const(answers)) {
        line.expect(askTilt2, answer);
    }
    QVERIFY(service.changeAddress(line, 1, 2).fault() == Fault::Refused);
    QVERIFY(isClean(line));
}

void TstInd3Address::lostAnswerOfTheNewAddress()
{
    FakeLine line;
    expectThrice(line, askTilt2, silence);
    line.expect(setAddress2, silence).expect(askTilt2, silence);
    line.expect(setAddress2, silence).expect(askTilt2, tilt2);
    line.expect(askTilt1, tilt1).expect(askTilt1, silence); // a late answer from where it was
    QVERIFY(service.changeAddress(line, 1, 2));
    QVERIFY(isClean(line));
}

void TstInd3Address::atNeither()
{
    FakeLine line;
    expectThrice(line, askTilt2, silence);
    for (int i = 0; i < 3; ++i) {
        line.expect(setAddress2, silence).expect(askTilt2, silence);
    }
    line.expect(askTilt1, silence);
    QVERIFY(service.changeAddress(line, 1, 2).fault() == Fault::Timeout);
    QVERIFY(isClean(line));
    QVERIFY(line.elapsed() <= 2100ms);
}

void TstInd3Address::stillAtTheOldOne()
{
    FakeLine line;
    expectThrice(line, askTilt2, silence);
    for (int i = 0; i < 3; ++i) {
        line.expect(setAddress2, silence).expect(askTilt2, silence);
    }
    expectThrice(line, askTilt1, tilt1);
    QVERIFY(service.changeAddress(line, 1, 2).fault() == Fault::BadReply);
    QVERIFY(isClean(line));
}

/// Protocol 2.10 can be asked for its angles and for nothing else.
void TstInd3Address::oldProtocol()
{
    const Service old(timing(), Dialect::V210);
    FakeLine line;
    line.expect(hex("7E 9A 01 01 FE 7E"), hex("E2 7C 00 72 32 81 7D"));
    line.expect(hex("7E 9A 01 01 FE 7E"), hex("E2 7C 00 72 32 81 7D"));
    QVERIFY(old.probe(line, 1));
    QCOMPARE(*old.readTilt(line, 1), (Tilt{-306.4453125, 124.8828125}));
    QVERIFY(old.read(line, 1).fault() == Fault::Refused);
    QVERIFY(old.write(line, 1, ticksOnly(64)).at(0).written.fault() == Fault::Refused);
    QVERIFY(old.changeAddress(line, 1, 2).fault() == Fault::Refused);
    QVERIFY(isClean(line));
}

QTEST_GUILESS_MAIN(TstInd3Address)
#include "tst_ind3address.moc"
