#include "core/protocol/mbap.h"
#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using gorizont::test::hex;

/// The framing of Modbus TCP. The good frame is the request of manual 000, section 10.1, for one inclinometer:
/// (1 × 8 + 4) / 2 = 6 registers.
class TestMbap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheRequestOfTheManual()
    {
        const QByteArray frame = hex("12 34 00 00 00 06 03 04 00 00 00 06");
        QCOMPARE(scanMbap(frame), Scan::complete(0, 12));
        const MbapFrame request = readMbap(frame);
        QCOMPARE(request.transaction, 0x1234);
        QCOMPARE(request.protocol, 0);
        QCOMPARE(request.unit, 3);
        QCOMPARE(request.pdu.toByteArray(), hex("04 00 00 00 06"));
    }

    void keepsAnyProtocolId() { QCOMPARE(readMbap(hex("00 00 AB CD 00 02 06 04")).protocol, 0xABCD); }

    void everyPrefixIsIncomplete()
    {
        const QByteArray frame = hex("12 34 00 00 00 06 03 04 00 00 00 06");
        for (qsizetype size = 0; size < frame.size(); ++size) {
            QCOMPARE(scanMbap(frame.first(size)), Scan::incomplete());
        }
    }

    void leavesTheNextRequestAlone()
    {
        QCOMPARE(scanMbap(hex("00 01 00 00 00 02 03 04 00 02 00 00 00 06")), Scan::complete(0, 8));
    }

    void judgesTheLength_data()
    {
        QTest::addColumn<int>("length");
        QTest::addColumn<bool>("isGood");
        QTest::newRow("0") << 0 << false;
        QTest::newRow("1") << 1 << false;
        QTest::newRow("2") << 2 << true;
        QTest::newRow("254") << 254 << true;
        QTest::newRow("255") << 255 << false;
        QTest::newRow("256") << 256 << false;
        QTest::newRow("65530 wraps in 16 bits") << 65530 << false;
        QTest::newRow("65535") << 65535 << false;
    }

    void judgesTheLength()
    {
        QFETCH(const int, length);
        QFETCH(const bool, isGood);
        QByteArray bytes = hex("00 01 00 00");
        bytes.append(static_cast<char>(length >> 8)).append(static_cast<char>(length & 0xFF));
        QCOMPARE(scanMbap(bytes).state, isGood ? Scan::State::Incomplete : Scan::State::Damaged);
        bytes.append(QByteArray(length, '\x04'));
        QCOMPARE(scanMbap(bytes), isGood ? Scan::complete(0, 6 + length) : Scan::damaged(0, 6));
    }

    void theFrameThatHangsAnotherServerIsDamaged()
    {
        QCOMPARE(scanMbap(hex("00 01 00 00 FF FA 03")), Scan::damaged(0, 6));
    }
};

QTEST_APPLESS_MAIN(TestMbap)
#include "tst_mbap.moc"
