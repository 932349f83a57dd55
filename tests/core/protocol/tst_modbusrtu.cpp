#include "core/protocol/modbusrtu.h"
#include "tests/support/fakeline.h"
#include "tests/support/scanning.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;

/// Frames were assembled by another program, with a CRC computed bit by bit.
class TstModbusRtu : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void requests_data();
    void requests();
    void answers_data();
    void answers();
    void countsOutOfRange();
    void echoIsPassedOver_data();
    void echoIsPassedOver();
    void passesOverOthers();
    void noiseThatLooksLikeAHead();
    void damaged();
    void refused();
    void badReplies_data();
    void badReplies();
};

namespace {

const QModbusRequest readAngles = modbusrtu::readInputRegisters(0, 4);
const QModbusRequest readBaud = modbusrtu::readHoldingRegisters(20, 8);
const QModbusRequest writeAddress = modbusrtu::writeRegisters(25, {2});
const QModbusRequest writeOffset = modbusrtu::writeRegisters(30, {0xFFFF, 0xD6FC, 0x0000, 0x1405});

const QByteArray anglesAnswer = hex("01 04 08 FF FE 2D 8A 00 02 F6 AB 4C BB");
const QByteArray addressAnswer = hex("01 10 00 19 00 01 D0 0E");

ScanFunction scanFor(const QModbusRequest &pdu)
{
    return modbusrtu::request(1, pdu).scan;
}

} // namespace

void TstModbusRtu::requests_data()
{
    QTest::addColumn<QModbusRequest>("pdu");
    QTest::addColumn<QByteArray>("bytes");

    QTest::newRow("04") << readAngles << hex("01 04 00 00 00 04 F1 C9");
    QTest::newRow("03") << readBaud << hex("01 03 00 14 00 08 04 08");
    QTest::newRow("16") << writeAddress << hex("01 10 00 19 00 01 02 00 02 25 98");
    QTest::newRow("16, four registers") << writeOffset << hex("01 10 00 1E 00 04 08 FF FF D6 FC 00 00 14 05 52 B8");
}

void TstModbusRtu::requests()
{
    QFETCH(QModbusRequest, pdu);
    QFETCH(QByteArray, bytes);
    QCOMPARE(modbusrtu::request(1, pdu).bytes, bytes);
}

void TstModbusRtu::answers_data()
{
    QTest::addColumn<QModbusRequest>("pdu");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QList<quint16>>("registers");

    QTest::newRow("04") << readAngles << anglesAnswer << QList<quint16>{0xFFFE, 0x2D8A, 0x0002, 0xF6AB};
    QTest::newRow("03") << readBaud << hex("01 03 10 00 04 00 01 00 02 00 05 10 30 00 01 00 00 07 5F 98 F4")
                        << QList<quint16>{4, 1, 2, 5, 4144, 1, 0, 1887};
    QTest::newRow("16") << writeAddress << addressAnswer << QList<quint16>();
    QTest::newRow("16, four registers") << writeOffset << hex("01 10 00 1E 00 04 A1 CC") << QList<quint16>();
    QTest::newRow("exception to 04") << readAngles << hex("01 84 02 C2 C1") << QList<quint16>();
    QTest::newRow("exception to 16") << writeAddress << hex("01 90 03 0C 01") << QList<quint16>();
}

void TstModbusRtu::answers()
{
    QFETCH(QModbusRequest, pdu);
    QFETCH(QByteArray, bytes);
    QFETCH(QList<quint16>, registers);

    QCOMPARE(brokenProperties(scanFor(pdu), bytes, hex("00 55 FF 7E 01 01 04 01 90 00 02")), QStringList());
    QCOMPARE(unguardedBits(scanFor(pdu), bytes), QStringList());

    const bool isException = bytes.at(1) & 0x80;
    const bool isConfirmation = !isException && registers.isEmpty();
    QCOMPARE(bool(modbusrtu::response(bytes)), !isException);
    QCOMPARE(bool(modbusrtu::confirmation(bytes)), isConfirmation);
    const auto read = modbusrtu::registers(bytes);
    QCOMPARE(bool(read), !registers.isEmpty());
    if (read) {
        QCOMPARE(*read, registers);
    }
}

void TstModbusRtu::countsOutOfRange()
{
    QVERIFY(modbusrtu::readHoldingRegisters(0, 125).isValid());
    QVERIFY(!modbusrtu::readHoldingRegisters(0, 126).isValid());
    QVERIFY(!modbusrtu::readHoldingRegisters(0, 0).isValid());
    QVERIFY(!modbusrtu::readInputRegisters(0, 126).isValid());
    QVERIFY(!modbusrtu::readInputRegisters(0, -1).isValid());
    QVERIFY(modbusrtu::writeRegisters(0, QList<quint16>(123)).isValid());
    QVERIFY(!modbusrtu::writeRegisters(0, QList<quint16>(124)).isValid());
    QVERIFY(!modbusrtu::writeRegisters(0, {}).isValid());
}

void TstModbusRtu::echoIsPassedOver_data()
{
    answers_data();
}

void TstModbusRtu::echoIsPassedOver()
{
    QFETCH(QModbusRequest, pdu);
    QFETCH(QByteArray, bytes);

    const Request request = modbusrtu::request(1, pdu);
    for (const qsizetype size : {0, 1, 3, 8}) {
        QCOMPARE(answerIn(request.scan, request.bytes + bytes, size), bytes);
        QCOMPARE(answerIn(request.scan, hex("00 01") + request.bytes + bytes, size), bytes);
        QVERIFY(!answerIn(request.scan, request.bytes, size));
    }
    for (qsizetype size = 0; size < request.bytes.size(); ++size) {
        QCOMPARE(request.scan(request.bytes.left(size)), Scan::incomplete());
    }
}

void TstModbusRtu::passesOverOthers()
{
    const QByteArray ofAnotherAddress = hex("02 04 08 00 00 00 00 00 00 00 00 2B 49");
    const QByteArray ofAnotherFunction = hex("01 03 10 00 04 00 01 00 02 00 05 10 30 00 01 00 00 07 5F 98 F4");
    const QByteArray ofAnotherRegister = hex("01 10 00 14 00 01 41 CD");
    QCOMPARE(answerIn(scanFor(readAngles), ofAnotherAddress + ofAnotherFunction + anglesAnswer), anglesAnswer);
    QCOMPARE(answerIn(scanFor(writeAddress), ofAnotherRegister + addressAnswer), addressAnswer);
    QVERIFY(!answerIn(scanFor(readAngles), ofAnotherAddress + ofAnotherFunction + ofAnotherRegister));
}

/// The head of an answer in front of the answer: giving up more than its first byte would lose the good one.
void TstModbusRtu::noiseThatLooksLikeAHead()
{
    const QByteArray head = hex("01 04 08");
    QCOMPARE(scanFor(readAngles)(head + anglesAnswer), Scan::damaged(0, 1));
    QCOMPARE(answerIn(scanFor(readAngles), head + anglesAnswer), anglesAnswer);
    QCOMPARE(answerIn(scanFor(readAngles), head + head + anglesAnswer, 1), anglesAnswer);
}

void TstModbusRtu::damaged()
{
    QByteArray answer = anglesAnswer;
    answer[5] = static_cast<char>(answer.at(5) ^ 1);
    QCOMPARE(scanFor(readAngles)(answer), Scan::damaged(0, 1));
    QCOMPARE(modbusrtu::registers(answer).fault(), Fault::BadReply);
}

void TstModbusRtu::refused()
{
    const QByteArray exception = hex("01 84 02 C2 C1");
    QCOMPARE(modbusrtu::response(exception).fault(), Fault::Refused);
    QCOMPARE(modbusrtu::registers(exception).fault(), Fault::Refused);
    QCOMPARE(modbusrtu::confirmation(exception).fault(), Fault::Refused);
}

void TstModbusRtu::badReplies_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("too short") << hex("01 04 00 FF");
    QTest::newRow("wrong check sum") << hex("01 04 08 FF FE 2D 8A 00 02 F6 AB 4C BA");
    QTest::newRow("a question") << hex("01 04 00 00 00 04 F1 C9");
    QTest::newRow("confirmation of function 05") << hex("01 05 00 00 FF 00 8C 3A");
}

void TstModbusRtu::badReplies()
{
    QFETCH(QByteArray, bytes);
    QCOMPARE(modbusrtu::registers(bytes).fault(), Fault::BadReply);
    QCOMPARE(modbusrtu::confirmation(bytes).fault(), Fault::BadReply);
}

QTEST_GUILESS_MAIN(TstModbusRtu)
#include "tst_modbusrtu.moc"
