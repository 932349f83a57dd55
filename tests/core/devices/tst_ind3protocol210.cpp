#include "core/devices/ind3/ind3protocol210.h"
#include "tests/support/fakeline.h"
#include "tests/support/scanning.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::ind3;
using namespace gorizont::test;

/// Vectors of spec/ind3.md, "Protocol 2.10 (old)".
class TstInd3Protocol210 : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void requests();
    void addressOutOfRange();
    void angles();
    void anglesAfterEcho();
    void damagedAngles();
    void badReplies();
    void ping();
    void pingWithItsAnswerInTheEcho_data();
    void pingWithItsAnswerInTheEcho();
};

namespace {

const QByteArray anglesAnswer = hex("E2 7C 00 72 32 81 7D");

} // namespace

void TstInd3Protocol210::requests()
{
    QCOMPARE(v210::readAngles(1)->bytes, hex("7E 9A 01 01 FE 7E"));
    QCOMPARE(v210::ping(1)->bytes, hex("7E 9A 03 01 FC 7E"));
    QCOMPARE(v210::readAngles(255)->bytes, hex("7E 9A 01 FF 00 7E")); // the sum wraps around
}

void TstInd3Protocol210::addressOutOfRange()
{
    for (const int address : {-1, 0, 256}) {
        QVERIFY(!v210::readAngles(address));
        QVERIFY(!v210::ping(address));
    }
}

void TstInd3Protocol210::angles()
{
    const ScanFunction scan = v210::readAngles(1)->scan;
    QCOMPARE(brokenProperties(scan, anglesAnswer, hex("00 7E 9A 01 55")), QStringList());
    QCOMPARE(unguardedBits(scan, anglesAnswer), QStringList());
    QCOMPARE(*v210::decodeAngles(anglesAnswer), (Tilt{-(306 + 114 / 256.0), 124 + 226 / 256.0}));
}

void TstInd3Protocol210::anglesAfterEcho()
{
    const Request request = *v210::readAngles(1);
    for (const qsizetype size : {0, 1, 4}) {
        QVERIFY(!answerIn(request.scan, request.bytes, size));
        QCOMPARE(answerIn(request.scan, request.bytes + anglesAnswer, size), anglesAnswer);
        QCOMPARE(answerIn(request.scan, hex("00 FF") + request.bytes + anglesAnswer, size), anglesAnswer);
        // 9A 01 01 FE 7E E8 00, across the seam, has a good check sum too.
        const QByteArray treacherous = hex("E8 00 00 00 00 00 18");
        QCOMPARE(answerIn(request.scan, request.bytes + treacherous, size), treacherous);
    }
    QCOMPARE(request.scan(request.bytes + anglesAnswer.left(3)), Scan::incomplete(6)); // an echo is no damage
}

void TstInd3Protocol210::damagedAngles()
{
    const ScanFunction scan = v210::readAngles(1)->scan;
    QCOMPARE(scan(hex("E2 7C 00 72 32 81 7C")), Scan::damaged(0, 1));
    QCOMPARE(scan(anglesAnswer.mid(1)), Scan::incomplete());
}

void TstInd3Protocol210::badReplies()
{
    QVERIFY(v210::decodeAngles(hex("E2 7C 00 72 32 81 7C")).fault() == Fault::BadReply);
    QVERIFY(v210::decodeAngles(hex("E2 7C 00 72 32 81")).fault() == Fault::BadReply);
    QVERIFY(v210::decodeAngles(hex("00 00 00 00 00 00 00 00")).fault() == Fault::BadReply);
    QVERIFY(v210::decodeAngles(QByteArray()).fault() == Fault::BadReply);
}

/// A single byte without a check sum: nothing can guard it.
void TstInd3Protocol210::ping()
{
    const Request request = *v210::ping(1);
    QCOMPARE(request.scan({}), Scan::incomplete());
    QCOMPARE(request.scan(hex("35")), Scan::complete(0, 1));
    QCOMPARE(request.scan(hex("00 FF 35")), Scan::complete(2, 1));
    QCOMPARE(request.scan(hex("34 36")), Scan::incomplete(2));
}

/// 35h as address and as check sum of the question.
void TstInd3Protocol210::pingWithItsAnswerInTheEcho_data()
{
    QTest::addColumn<int>("address");
    QTest::addColumn<QByteArray>("echo");
    QTest::newRow("address") << 0x35 << hex("7E 9A 03 35 C8 7E");
    QTest::newRow("check sum") << 0xC8 << hex("7E 9A 03 C8 35 7E");
}

void TstInd3Protocol210::pingWithItsAnswerInTheEcho()
{
    QFETCH(int, address);
    QFETCH(QByteArray, echo);
    const Request request = *v210::ping(address);
    QCOMPARE(request.bytes, echo);
    for (qsizetype size = 1; size < echo.size(); ++size) {
        QCOMPARE(request.scan(echo.left(size)), Scan::incomplete());
    }
    QCOMPARE(request.scan(echo), Scan::incomplete(6));
    QCOMPARE(request.scan(echo + hex("35")), Scan::complete(6, 1));
}

QTEST_GUILESS_MAIN(TstInd3Protocol210)
#include "tst_ind3protocol210.moc"
