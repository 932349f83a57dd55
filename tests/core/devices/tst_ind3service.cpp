#include "tests/core/devices/ind3frames.h"

using namespace gorizont;
using namespace gorizont::ind3;
using namespace gorizont::ind3::test;

/// What the service reads from ИН-Д3 and writes into it.
class TstInd3Service : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void reads211();
    void readsInPieces();
    void oldFirmwareHasNoOffset();
    void selfTest();
    void readsAgain();
    void nobodyThere();
    void readsModbus();
    void modbusWithoutOffset();
    void probes_data();
    void probes();
    void writes();
    void writesModbus();
    void lostConfirmation();
    void lateOldValue();
    void anotherValueIsHeld();
    void oldFirmwareGoesOn();
    void vanishesBetween();
    void outOfRange_data();
    void outOfRange();
    void exceptionIsFinal();
};

void TstInd3Service::reads211()
{
    FakeLine line;
    line.expect(askVersion, version);
    expectMiddle(line);
    line.expect(askOffset, offset);
    const auto settings = service.read(line, 1);
    QVERIFY(settings);
    QVERIFY(*settings == settingsOfTheSpec());
    QVERIFY(isClean(line));
}

void TstInd3Service::readsInPieces()
{
    FakeLine line;
    line.expectInPieces(askVersion, hex("00 FF 7E") + version);
    expectMiddle(line, 2);
    line.expectInPieces(askOffset, offset, 3);
    const auto settings = service.read(line, 1);
    QVERIFY(settings);
    QVERIFY(*settings == settingsOfTheSpec());
}

void TstInd3Service::oldFirmwareHasNoOffset()
{
    FakeLine line;
    line.expect(askVersion, version);
    expectMiddle(line);
    expectThrice(line, askOffset, silence);
    const auto settings = service.read(line, 1);
    QVERIFY(settings);
    Settings expected = settingsOfTheSpec();
    expected.offset.reset();
    QVERIFY(*settings == expected);
    QVERIFY(isClean(line));
    QVERIFY(line.elapsed() <= 620ms);
}

void TstInd3Service::selfTest()
{
    FakeLine line;
    line.expect(askVersion, hex("7E 9B FF 01 10 75 7E"));
    expectMiddle(line);
    line.expect(askOffset, offset);
    const auto settings = service.read(line, 1);
    QVERIFY(settings);
    QVERIFY(settings->selfTest == SelfTest::ProgramChecksum);
    QCOMPARE(settings->version, QString());
    QCOMPARE(settings->serialNumber, 1887U);
}

/// Lost, damaged, then good.
void TstInd3Service::readsAgain()
{
    FakeLine line;
    line.expect(askVersion, silence).expect(askVersion, hex("7E 9B 0E 01 76 32 2E 31 31 FF 7E"));
    line.expect(askVersion, version);
    expectMiddle(line);
    line.expect(askOffset, offset);
    const auto settings = service.read(line, 1);
    QVERIFY(settings);
    QVERIFY(*settings == settingsOfTheSpec());
    QVERIFY(isClean(line));
}

void TstInd3Service::nobodyThere()
{
    FakeLine line;
    expectThrice(line, askVersion, silence);
    QVERIFY(service.read(line, 1).fault() == Fault::Timeout);
    expectThrice(line, askTilt1, silence);
    QVERIFY(service.readTilt(line, 1).fault() == Fault::Timeout);
    QVERIFY(isClean(line));
    QVERIFY(line.elapsed() <= 1250ms);
}

void TstInd3Service::readsModbus()
{
    FakeLine line;
    line.expect(modbusAskSettings, modbusSettings).expect(modbusAskOffset, modbusOffset);
    const auto settings = modbusService.read(line, 1);
    QVERIFY(settings);
    Settings expected = settingsOfTheSpec();
    expected.version.clear();
    expected.name.reset();
    expected.revision.number = 4144;
    QVERIFY(*settings == expected);
    QVERIFY(line.requestTimes().at(1) - line.requestTimes().at(0) >= 4ms);
}

void TstInd3Service::modbusWithoutOffset()
{
    FakeLine line;
    line.expect(modbusAskSettings, modbusSettings).expect(modbusAskOffset, hex("01 83 02 C0 F1"));
    const auto settings = modbusService.read(line, 1);
    QVERIFY(settings);
    QVERIFY(!settings->offset);
    QVERIFY(isClean(line));
}

void TstInd3Service::probes_data()
{
    QTest::addColumn<QByteArrayList>("answers");
    QTest::addColumn<bool>("isThere");
    QTest::addColumn<Fault>("fault");
    QTest::newRow("there") << QByteArrayList{tilt2} << true << Fault::Timeout;
    QTest::newRow("nobody") << QByteArrayList{silence} << false << Fault::Timeout;
    QTest::newRow("another one's late answer") << QByteArrayList{tilt1} << false << Fault::Timeout;
    QTest::newRow("damaged once") << QByteArrayList{broken, tilt2} << true << Fault::Timeout;
    QTest::newRow("two with one address") << QByteArrayList{broken, broken, broken} << false << Fault::Checksum;
}

void TstInd3Service::probes()
{
    QFETCH(QByteArrayList, answers);
    QFETCH(bool, isThere);
    QFETCH(Fault, fault);
    FakeLine line;
    for (const QByteArray &answer : std::as_const(answers)) {
        line.expect(askTilt2, answer);
    }
    const auto probed = service.probe(line, 2);
    QCOMPARE(static_cast<bool>(probed), isThere);
    QVERIFY(isThere || probed.fault() == fault);
    QVERIFY(isClean(line));
}

/// Each is read back; an offset counts as the sensor keeps it, in 1/256″.
void TstInd3Service::writes()
{
    FakeLine line;
    line.expect(hex("7E 9C 04 01 C4 EE EC 20 31 4E 7E"), hex("7E 9C 04 01 99 7E"));
    line.expect(hex("7E 9C 03 01 9E 7E"), hex("7E 9C 03 01 C4 EE EC 20 31 49 7E"));
    line.expect(hex("7E 9C 06 01 80 0A 80 20 05 00 B4 7E"), hex("7E 9C 06 01 9B 7E"));
    line.expect(askOffset, offset);
    line.expect(setTicks64, ticksSet).expect(askTicks, ticks64);
    line.expect(hex("7E 9C 0F 01 03 91 7E"), hex("7E 9C 0F 01 92 7E"));
    line.expect(hex("7E 9C 0E 01 93 7E"), hex("7E 9C 0E 01 03 90 7E"));
    const Changes changes{QStringLiteral("Дом 1"), Tilt{5.126, -10.499}, 64, 100ms};
    const auto outcomes = service.write(line, 1, changes);
    QCOMPARE(outcomes.size(), 4);
    QVERIFY(outcomes.at(0).setting == Setting::Name && outcomes.at(3).setting == Setting::Period);
    for (const Outcome &outcome : outcomes) {
        QVERIFY(outcome.written);
    }
    QVERIFY(isClean(line));
}

void TstInd3Service::writesModbus()
{
    FakeLine line;
    line.expect(hex("01 10 00 1E 00 04 08 FF FF D6 FC 00 00 14 05 52 B8"), hex("01 10 00 1E 00 04 A1 CC"));
    line.expect(modbusAskOffset, modbusOffset);
    line.expect(modbusSetTicks, hex("01 10 00 17 00 01 B1 CD")).expect(modbusAskSettings, modbusSettings64);
    const auto outcomes = modbusService.write(line, 1, {QStringLiteral("Tower"), Tilt{5.125, -10.5}, 64, {}});
    QCOMPARE(outcomes.size(), 3);
    QVERIFY(!outcomes.at(0).written && outcomes.at(0).written.fault() == Fault::Refused); // no name in Modbus
    QVERIFY(outcomes.at(1).written);
    QVERIFY(outcomes.at(2).written);
    QVERIFY(isClean(line));
}

/// The sensor has taken it over, whoever did not hear it say so.
void TstInd3Service::lostConfirmation()
{
    FakeLine line;
    expectThrice(line, setTicks64, silence);
    line.expect(askTicks, silence).expect(askTicks, ticks64);
    const auto outcomes = service.write(line, 1, ticksOnly(64));
    QVERIFY(outcomes.at(0).written);
    QVERIFY(isClean(line));
    QVERIFY(line.elapsed() <= 820ms);
}

void TstInd3Service::lateOldValue()
{
    FakeLine line;
    line.expect(setTicks64, ticksSet).expect(askTicks, ticks32).expect(askTicks, ticks64);
    QVERIFY(service.write(line, 1, ticksOnly(64)).at(0).written);
    QVERIFY(isClean(line));
}

void TstInd3Service::anotherValueIsHeld()
{
    FakeLine line;
    line.expect(setTicks64, ticksSet);
    line.expect(askTicks, ticks32).expect(askTicks, ticks32).expect(askTicks, silence);
    const auto outcomes = service.write(line, 1, ticksOnly(64));
    QVERIFY(!outcomes.at(0).written);
    QVERIFY(outcomes.at(0).written.fault() == Fault::BadReply);
    QVERIFY(isClean(line));
}

void TstInd3Service::oldFirmwareGoesOn()
{
    FakeLine line;
    expectThrice(line, hex("7E 9C 06 01 80 0A 80 20 05 00 B4 7E"), silence);
    expectThrice(line, askOffset, silence);
    line.expect(setTicks64, ticksSet).expect(askTicks, ticks64);
    Changes changes = ticksOnly(64);
    changes.offset = Tilt{5.125, -10.5};
    const auto outcomes = service.write(line, 1, changes);
    QCOMPARE(outcomes.size(), 2);
    QVERIFY(!outcomes.at(0).written && outcomes.at(0).written.fault() == Fault::Timeout);
    QVERIFY(outcomes.at(1).written);
    QVERIFY(isClean(line));
    QVERIFY(line.elapsed() <= 1250ms);
}

void TstInd3Service::vanishesBetween()
{
    FakeLine line;
    line.expect(setTicks64, ticksSet).vanishAfter(askTicks);
    Changes changes = ticksOnly(64);
    changes.period = 100ms;
    const auto outcomes = service.write(line, 1, changes);
    QCOMPARE(outcomes.size(), 1);
    QVERIFY(!outcomes.at(0).written && outcomes.at(0).written.fault() == Fault::Closed);
    QVERIFY(service.read(line, 1).fault() == Fault::Closed);
    QVERIFY(service.changeAddress(line, 1, 2).fault() == Fault::Closed);
    QVERIFY(isClean(line));
}

void TstInd3Service::outOfRange_data()
{
    QTest::addColumn<Changes>("changes");
    const auto name = [](const QString &text) { return Changes{text, {}, {}, {}}; };
    QTest::newRow("seventeen characters") << name(QStringLiteral("12345678901234567"));
    QTest::newRow("no character") << name(QString());
    QTest::newRow("not in Windows-1251") << name(QStringLiteral("山"));
    QTest::newRow("offset") << Changes{{}, Tilt{1e7, 0}, {}, {}};
    QTest::newRow("no number") << Changes{{}, Tilt{0, qQNaN()}, {}, {}};
    QTest::newRow("ticks") << ticksOnly(3);
    QTest::newRow("period") << Changes{{}, {}, {}, 30ms};
}

void TstInd3Service::outOfRange()
{
    QFETCH(Changes, changes);
    FakeLine line;
    const auto outcomes = service.write(line, 1, changes);
    QCOMPARE(outcomes.size(), 1);
    QVERIFY(!outcomes.at(0).written && outcomes.at(0).written.fault() == Fault::Refused);
    QVERIFY(line.requestTimes().isEmpty());
}

void TstInd3Service::exceptionIsFinal()
{
    FakeLine line;
    line.expect(modbusSetTicks, hex("01 90 03 0C 01"));
    const auto outcomes = modbusService.write(line, 1, ticksOnly(64));
    QVERIFY(!outcomes.at(0).written && outcomes.at(0).written.fault() == Fault::Refused);
    QVERIFY(isClean(line));
}

QTEST_GUILESS_MAIN(TstInd3Service)
#include "tst_ind3service.moc"
