#include "core/protocol/modbustcp.h"
#include "tests/support/fakeline.h"
#include "tests/support/scanning.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::modbustcp;
using namespace gorizont::test;

namespace {

constexpr Envelope envelope{0x1501, 0x11};

const QByteArray read3 = readRegisters(ReadFunction::HoldingRegisters, 0x006B, 3);
const QByteArray write2 = writeRegisters(0x0001, {0x000A, 0x0102});
const QByteArray writeAndRead6 = writeAndReadRegisters(0x0003, 6, 0x000E, {0x00FF, 0x00FF, 0x00FF});

const QByteArray read3Answer = hex("15 01 00 00 00 09 11 03 06 02 2B 00 00 00 64");

ScanFunction scanFor(const QByteArray &pdu)
{
    return request(envelope, pdu).scan;
}

} // namespace

/// Questions and answers are the examples of the standard (sections 6.3, 6.12 and 6.17 of 1.1b3), with its envelope.
class TstModbusTcp : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void requests_data()
    {
        QTest::addColumn<QByteArray>("pdu");
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("03") << read3 << hex("15 01 00 00 00 06 11 03 00 6B 00 03");
        QTest::newRow("04") << readRegisters(ReadFunction::InputRegisters, 8, 1)
                            << hex("15 01 00 00 00 06 11 04 00 08 00 01");
        QTest::newRow("16") << write2 << hex("15 01 00 00 00 0B 11 10 00 01 00 02 04 00 0A 01 02");
        QTest::newRow("23") << writeAndRead6
                            << hex("15 01 00 00 00 11 11 17 00 03 00 06 00 0E 00 03 06 00 FF 00 FF 00 FF");
    }

    void requests()
    {
        QFETCH(const QByteArray, pdu);
        QTEST(request(envelope, pdu).bytes, "bytes");
    }

    void answers_data()
    {
        QTest::addColumn<QByteArray>("pdu");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("count");
        QTest::addColumn<QList<quint16>>("registers");
        QTest::addColumn<int>("exception");
        using Registers = QList<quint16>;
        QTest::newRow("03") << read3 << read3Answer << 3 << Registers{555, 0, 100} << -1;
        QTest::newRow("16") << write2 << hex("15 01 00 00 00 06 11 10 00 01 00 02") << 2 << Registers() << -1;
        QTest::newRow("23") << writeAndRead6 << hex("15 01 00 00 00 0F 11 17 0C 00 FE 0A CD 00 01 00 03 00 0D 00 FF")
                            << 6 << Registers{254, 2765, 1, 3, 13, 255} << -1;
        QTest::newRow("exception to 03") << read3 << hex("15 01 00 00 00 03 11 83 02") << 3 << Registers() << 2;
        QTest::newRow("exception to 16") << write2 << hex("15 01 00 00 00 03 11 90 03") << 2 << Registers() << 3;
        QTest::newRow("exception to 23") << writeAndRead6 << hex("15 01 00 00 00 03 11 97 04") << 6 << Registers() << 4;
    }

    void answers()
    {
        QFETCH(const QByteArray, pdu);
        QFETCH(const QByteArray, bytes);
        QFETCH(const int, count);
        QFETCH(const QList<quint16>, registers);
        QFETCH(const int, exception);
        const ScanFunction scan = scanFor(pdu);
        for (qsizetype size = 0; size < bytes.size(); ++size) {
            QCOMPARE(scan(bytes.first(size)), Scan::incomplete());
        }
        const QByteArray next = hex("15 02 00 00 00 03 11 83 02");
        QCOMPARE(scan(bytes + next), Scan::complete(0, bytes.size()));
        const auto read = modbustcp::registers(bytes, count);
        QCOMPARE(bool(read), !registers.isEmpty());
        QCOMPARE(read ? *read : QList<quint16>(), registers);
        QCOMPARE(int(exceptionCode(bytes).value_or(255)), exception < 0 ? 255 : exception);
        const auto confirmed = confirmation(bytes, pdu);
        QCOMPARE(bool(confirmed), exception < 0 && registers.isEmpty());
        if (exception >= 0) {
            QCOMPARE(read.fault(), Fault::Refused);
            QCOMPARE(confirmed.fault(), Fault::Refused);
        }
    }

    /// The tail of an answer that came too late, answers to others, garbage: whatever is in front, in any pieces.
    void passesOverWhatIsNotTheAnswer_data()
    {
        QTest::addColumn<QByteArray>("before");
        QTest::newRow("nothing") << QByteArray();
        QTest::newRow("garbage") << hex("00 55 FF 15 01 FF 15 15 01 00");
        QTest::newRow("the tail of a late answer") << hex("00 09 11 03 06 02 2B 00 00 00 64");
        QTest::newRow("another transaction") << hex("15 00 00 00 00 09 11 03 06 02 2B 00 00 00 65");
        QTest::newRow("another protocol") << hex("15 01 00 01 00 09 11 03 06 02 2B 00 00 00 65");
        QTest::newRow("another unit") << hex("15 01 00 00 00 09 12 03 06 02 2B 00 00 00 65");
        QTest::newRow("another function") << hex("15 01 00 00 00 09 11 04 06 02 2B 00 00 00 65");
        QTest::newRow("a length of 0") << hex("15 01 00 00 00 00");
        QTest::newRow("a length of 2") << hex("15 01 00 00 00 02 11 03");
        QTest::newRow("a length of 255") << hex("15 01 00 00 00 FF 11 03");
        QTest::newRow("a length that wraps") << hex("15 01 00 00 FF FA 11 03");
    }

    void passesOverWhatIsNotTheAnswer()
    {
        QFETCH(const QByteArray, before);
        for (const qsizetype size : {0, 1, 2, 3, 5, 7}) {
            QCOMPARE(answerIn(scanFor(read3), before + read3Answer, size), read3Answer);
            QVERIFY(!answerIn(scanFor(read3), before, size));
        }
    }

    void countsOutOfRange()
    {
        const auto holding = ReadFunction::HoldingRegisters;
        QCOMPARE(readRegisters(holding, 0, 125).size(), 5);
        QCOMPARE(readRegisters(holding, 0, 126), QByteArray());
        QCOMPARE(readRegisters(holding, 0, 0), QByteArray());
        QCOMPARE(readRegisters(holding, 0, -1), QByteArray());
        QCOMPARE(writeRegisters(0, QList<quint16>(123)).size(), 6 + 246);
        QCOMPARE(writeRegisters(0, QList<quint16>(124)), QByteArray());
        QCOMPARE(writeRegisters(0, {}), QByteArray());
        QCOMPARE(writeAndReadRegisters(0, 125, 0, QList<quint16>(121)).size(), 10 + 242);
        QCOMPARE(writeAndReadRegisters(0, 126, 0, {1}), QByteArray());
        QCOMPARE(writeAndReadRegisters(0, 1, 0, QList<quint16>(122)), QByteArray());
        QCOMPARE(writeAndReadRegisters(0, 1, 0, {}), QByteArray());
    }

    /// 124 registers of function 23, which Qt's own types do not hold: 248 = F8h bytes, a frame of 251 = FBh from the unit on.
    void manyRegistersOfFunction23()
    {
        const QByteArray pdu = writeAndReadRegisters(0x9100, 124, 0x9000, {2, 7});
        QCOMPARE(request(envelope, pdu).bytes, hex("15 01 00 00 00 0F 11 17 91 00 00 7C 90 00 00 02 04 00 02 00 07"));
        const QByteArray answer = hex("15 01 00 00 00 FB 11 17 F8") + QByteArray(246, '\x7F') + hex("12 34");
        QCOMPARE(answerIn(scanFor(pdu), answer, 1), answer);
        const auto values = registers(answer, 124);
        QVERIFY(values);
        QCOMPARE(values->size(), 124);
        QCOMPARE(values->at(0), 0x7F7F);
        QCOMPARE(values->at(123), 0x1234);
    }

    void badReplies_data()
    {
        QTest::addColumn<QByteArray>("frame");
        QTest::newRow("nothing") << QByteArray();
        QTest::newRow("too short") << hex("15 01 00 00 00 09 11 03 06 02 2B");
        QTest::newRow("too long") << read3Answer + hex("00");
        QTest::newRow("fewer registers") << hex("15 01 00 00 00 07 11 03 04 02 2B 00 00");
        QTest::newRow("more registers") << hex("15 01 00 00 00 0B 11 03 08 02 2B 00 00 00 64 00 00");
        QTest::newRow("another count of bytes") << hex("15 01 00 00 00 09 11 03 05 02 2B 00 00 00 64");
        QTest::newRow("confirms another place") << hex("15 01 00 00 00 06 11 10 00 02 00 02");
        QTest::newRow("confirms another count") << hex("15 01 00 00 00 06 11 10 00 01 00 01");
        QTest::newRow("confirms another function") << hex("15 01 00 00 00 06 11 06 00 01 00 02");
    }

    void badReplies()
    {
        QFETCH(const QByteArray, frame);
        QCOMPARE(registers(frame, 3).fault(), Fault::BadReply);
        QCOMPARE(confirmation(frame, write2).fault(), Fault::BadReply);
        QVERIFY(!exceptionCode(frame));
    }
};

QTEST_APPLESS_MAIN(TstModbusTcp)
#include "tst_modbustcp.moc"
