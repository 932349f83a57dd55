#include "core/devices/ind3/ind3protocol.h"
#include "tests/support/fakeline.h"
#include "tests/support/scanning.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::ind3;
using namespace gorizont::test;
using namespace std::chrono_literals;

using MaybeRequest = std::optional<Request>;

/// Vectors of spec/ind3.md, "Protocol 2.11"; what it does not list was assembled by hand.
class TstInd3Protocol : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void exchanges_data();
    void exchanges();
    void values();
    void selfTest();
    void escapedRequests_data();
    void escapedRequests();
    void escapedAnswers();
    void outOfRange();
    void onlyQuestionsAreAsked();
    void echoIsPassedOver_data();
    void echoIsPassedOver();
    void passesOverOthers_data();
    void passesOverOthers();
    void delimiters();
    void damaged();
    void nestedAnswers();
    void endlessNoise();
    void notAFrame_data();
    void notAFrame();
    void badReplies();
};

namespace {

constexpr const char *anglesAnswer = "7E 9B 01 01 6A 77 80 38 C2 00 FC 7E";

} // namespace

void TstInd3Protocol::exchanges_data()
{
    QTest::addColumn<MaybeRequest>("request");
    QTest::addColumn<QByteArray>("sent");
    QTest::addColumn<QByteArray>("received");

    QTest::newRow("read angles") << ask(Packet::ReadAngles, 1) << hex("7E 9B 01 01 9B 7E") << hex(anglesAnswer);
    QTest::newRow("version") << ask(Packet::Version, 1) << hex("7E 9B 0E 01 94 7E")
                             << hex("7E 9B 0E 01 76 32 2E 31 31 FE 7E");
    QTest::newRow("error") << ask(Packet::Version, 1) << hex("7E 9B 0E 01 94 7E") << hex("7E 9B FF 01 10 75 7E");
    QTest::newRow("get baud") << ask(Packet::GetBaud, 1) << hex("7E 9C 01 01 9C 7E") << hex("7E 9C 01 01 04 98 7E");
    QTest::newRow("set 1200") << setBaud(1, 1200) << hex("7E 9C 02 01 01 9E 7E") << hex("7E 9C 02 01 9F 7E");
    QTest::newRow("get name") << ask(Packet::GetName, 1) << hex("7E 9C 03 01 9E 7E")
                              << hex("7E 9C 03 01 4E 4F 20 4E 41 4D 45 B8 7E");
    QTest::newRow("set name") << setName(1, QStringLiteral("Дом 1")) << hex("7E 9C 04 01 C4 EE EC 20 31 4E 7E")
                              << hex("7E 9C 04 01 99 7E");
    QTest::newRow("set address") << setAddress(1, 2) << hex("7E 9C 09 01 02 96 7E") << hex("7E 9C 09 02 97 7E");
    QTest::newRow("revision") << ask(Packet::Revision, 1) << hex("7E 9C 0A 01 97 7E") << hex("7E 9C 0A 01 C7 00 50 7E");
    QTest::newRow("serial number") << ask(Packet::SerialNumber, 1) << hex("7E 9C 0B 01 96 7E")
                                   << hex("7E 9C 0B 01 5F 07 00 00 CE 7E");
    QTest::newRow("get ticks") << ask(Packet::GetTicks, 1) << hex("7E 9C 0C 01 91 7E") << hex("7E 9C 0C 01 05 94 7E");
    QTest::newRow("set ticks") << setTicks(1, 64) << hex("7E 9C 0D 01 06 96 7E") << hex("7E 9C 0D 01 90 7E");
    QTest::newRow("get period") << ask(Packet::GetPeriod, 1) << hex("7E 9C 0E 01 93 7E") << hex("7E 9C 0E 01 02 91 7E");
    QTest::newRow("set period") << setPeriod(1, 10ms) << hex("7E 9C 0F 01 00 92 7E") << hex("7E 9C 0F 01 92 7E");
    QTest::newRow("get offset") << ask(Packet::GetOffset, 1) << hex("7E 9C 05 01 98 7E")
                                << hex("7E 9C 05 01 80 0A 80 20 05 00 B7 7E");
    QTest::newRow("set offset") << setOffset(1, {5.125, -10.5}) << hex("7E 9C 06 01 80 0A 80 20 05 00 B4 7E")
                                << hex("7E 9C 06 01 9B 7E");
}

void TstInd3Protocol::exchanges()
{
    QFETCH(MaybeRequest, request);
    QFETCH(QByteArray, sent);
    QFETCH(QByteArray, received);

    QVERIFY(request);
    QCOMPARE(request->bytes, sent);
    QCOMPARE(brokenProperties(request->scan, received, hex("00 9B 01 7D FF 7E 9B 01")), QStringList());
    QCOMPARE(unguardedBits(request->scan, received), QStringList());
}

void TstInd3Protocol::values()
{
    QCOMPARE(*decodeAngles(hex(anglesAnswer)), (Tilt{194 + 56 / 256.0, -(119 + 106 / 256.0)}));
    QCOMPARE(*decodeVersion(hex("7E 9B 0E 01 76 32 2E 31 31 FE 7E")), QStringLiteral("v2.11"));
    QCOMPARE(*decodeBaud(hex("7E 9C 01 01 04 98 7E")), 9600);
    QCOMPARE(*decodeNameAnswer(hex("7E 9C 03 01 4E 4F 20 4E 41 4D 45 B8 7E")), QStringLiteral("NO NAME"));
    QCOMPARE(*decodeRevision(hex("7E 9C 0A 01 C7 00 50 7E")), Revision{199});
    QCOMPARE(*decodeSerialNumber(hex("7E 9C 0B 01 5F 07 00 00 CE 7E")), 1887U);
    QCOMPARE(*decodeTicks(hex("7E 9C 0C 01 05 94 7E")), 32);
    QVERIFY(*decodePeriod(hex("7E 9C 0E 01 02 91 7E")) == 50ms);
    QCOMPARE(*decodeOffset(hex("7E 9C 05 01 80 0A 80 20 05 00 B7 7E")), (Tilt{5.125, -10.5}));
}

void TstInd3Protocol::selfTest()
{
    QVERIFY(decodeSelfTest(hex("7E 9B FF 01 10 75 7E")) == SelfTest::ProgramChecksum);
    QVERIFY(decodeSelfTest(hex("7E 9B FF 01 11 74 7E")) == SelfTest::SettingsChecksum);
    QVERIFY(decodeSelfTest(hex("7E 9B FF 01 12 77 7E")) == SelfTest::BothChecksums);
    QVERIFY(!decodeSelfTest(hex("7E 9B FF 01 13 76 7E")));
    QVERIFY(!decodeSelfTest(hex("7E 9B 0E 01 76 32 2E 31 31 FE 7E")));
    QVERIFY(decodeVersion(hex("7E 9B FF 01 10 75 7E")).fault() == Fault::Refused);
    // An error answers nothing but the question for the version.
    QVERIFY(!answerIn(ask(Packet::ReadAngles, 1)->scan, hex("7E 9B FF 01 10 75 7E")));
}

/// 7D and 7E as address, as data and as check sum.
void TstInd3Protocol::escapedRequests_data()
{
    QTest::addColumn<MaybeRequest>("request");
    QTest::addColumn<QByteArray>("sent");

    QTest::newRow("address 7E") << ask(Packet::ReadAngles, 0x7E) << hex("7E 9B 01 7D 5E E4 7E");
    QTest::newRow("address 7D") << ask(Packet::ReadAngles, 0x7D) << hex("7E 9B 01 7D 5D E7 7E");
    QTest::newRow("check sum 7E") << ask(Packet::ReadAngles, 0xE4) << hex("7E 9B 01 E4 7D 5E 7E");
    QTest::newRow("check sum 7D") << ask(Packet::ReadAngles, 0xE7) << hex("7E 9B 01 E7 7D 5D 7E");
    QTest::newRow("new address 7E") << setAddress(1, 0x7E) << hex("7E 9C 09 01 7D 5E EA 7E");
    QTest::newRow("name }~") << setName(1, QStringLiteral("}~")) << hex("7E 9C 04 01 7D 5D 7D 5E 9A 7E");
}

void TstInd3Protocol::escapedRequests()
{
    QFETCH(MaybeRequest, request);
    QFETCH(QByteArray, sent);
    QVERIFY(request);
    QCOMPARE(request->bytes, sent);
}

void TstInd3Protocol::escapedAnswers()
{
    // Y = 7E/256 + 7Dh, X = 7D/256; XOR of 9B 01 01 7E 7D 00 7D 00 00 = E5
    const QByteArray inData = hex("7E 9B 01 01 7D 5E 7D 5D 00 7D 5D 00 00 E5 7E");
    // XOR of 9B 01 01 E6 00 00 00 00 00 = 7D; with E5: 7E
    const QByteArray sum7D = hex("7E 9B 01 01 E6 00 00 00 00 00 7D 5D 7E");
    const QByteArray sum7E = hex("7E 9B 01 01 E5 00 00 00 00 00 7D 5E 7E");
    const ScanFunction scan = ask(Packet::ReadAngles, 1)->scan;
    for (const QByteArray &answer : {inData, sum7D, sum7E}) {
        QCOMPARE(brokenProperties(scan, answer, hex("7D 7E 7D 7E")), QStringList());
        QCOMPARE(unguardedBits(scan, answer), QStringList());
    }
    QCOMPARE(*decodeAngles(inData), (Tilt{125 / 256.0, 125 + 126 / 256.0}));
    QCOMPARE(*decodeAngles(sum7D), (Tilt{0, 230 / 256.0}));
    QCOMPARE(*decodeAngles(sum7E), (Tilt{0, 229 / 256.0}));
}

void TstInd3Protocol::outOfRange()
{
    for (const int address : {-1, 0, 256, 257}) {
        QVERIFY(!ask(Packet::ReadAngles, address));
        QVERIFY(!setAddress(1, address));
        QVERIFY(!setAddress(address, 1));
        QVERIFY(!setTicks(address, 1));
    }
    QVERIFY(ask(Packet::ReadAngles, 255));
    QVERIFY(!setBaud(1, 9601));
    QVERIFY(!setTicks(1, 3));
    QVERIFY(!setPeriod(1, 30ms));
    QVERIFY(!setName(1, QStringLiteral("12345678901234567")));
    QVERIFY(!setOffset(1, {1e6, 0}));
}

void TstInd3Protocol::onlyQuestionsAreAsked()
{
    for (const Packet packet :
         {Packet::Error, Packet::SetBaud, Packet::SetName, Packet::SetOffset, Packet::SetAddress, Packet::SetTicks,
          Packet::SetPeriod}) {
        QVERIFY(!ask(packet, 1));
    }
}

void TstInd3Protocol::echoIsPassedOver_data()
{
    exchanges_data();
}

void TstInd3Protocol::echoIsPassedOver()
{
    QFETCH(MaybeRequest, request);
    QFETCH(QByteArray, received);
    for (const qsizetype size : {0, 1, 4}) {
        QVERIFY(!answerIn(request->scan, request->bytes, size));
        QCOMPARE(answerIn(request->scan, request->bytes + received, size), received);
    }
}

void TstInd3Protocol::passesOverOthers_data()
{
    QTest::addColumn<QByteArray>("other");
    QTest::newRow("other address") << hex("7E 9B 01 02 6A 77 80 38 C2 00 FF 7E");
    QTest::newRow("other packet") << hex("7E 9C 05 01 80 0A 80 20 05 00 B7 7E");
    QTest::newRow("other protocol") << hex("7E 9C 01 01 6A 77 80 38 C2 00 FB 7E");
    QTest::newRow("too little data") << hex("7E 9B 01 01 6A F1 7E");
    QTest::newRow("too much data") << hex("7E 9B 01 01 6A 77 80 38 C2 00 00 FC 7E");
}

void TstInd3Protocol::passesOverOthers()
{
    QFETCH(QByteArray, other);
    const ScanFunction scan = ask(Packet::ReadAngles, 1)->scan;
    QCOMPARE(scan(other), Scan::incomplete(other.size() - 1)); // its last delimiter may open the next frame
    QCOMPARE(scan(other + hex(anglesAnswer)), Scan::complete(other.size(), hex(anglesAnswer).size()));
    QCOMPARE(answerIn(scan, other + hex(anglesAnswer), 1), hex(anglesAnswer));
}

/// One delimiter between two frames is enough, and two or more do no harm.
void TstInd3Protocol::delimiters()
{
    const ScanFunction scan = ask(Packet::ReadAngles, 1)->scan;
    const QByteArray other = hex("7E 9C 01 01 04 98 7E");
    QCOMPARE(answerIn(scan, other.chopped(1) + hex(anglesAnswer)), hex(anglesAnswer));
    QCOMPARE(scan(hex("7E 7E 7E") + hex(anglesAnswer)), Scan::complete(3, 12));
    QCOMPARE(scan(hex("7E")), Scan::incomplete());
    QCOMPARE(scan(hex("00 01 02")), Scan::incomplete(3));
}

void TstInd3Protocol::damaged()
{
    const ScanFunction scan = ask(Packet::ReadAngles, 1)->scan;
    QCOMPARE(scan(hex("7E 9B 01 01 6B 77 80 38 C2 00 FC 7E")), Scan::damaged(0, 11));
    QCOMPARE(scan(hex("00 7E 9B 01 01 6A 77 80 38 C2 00 FC 7D 7E")), Scan::damaged(1, 12)); // ends within an escape
    QCOMPARE(scan(hex("7E 01 02 03 7E")), Scan::incomplete(4)); // too short to be a frame
}

/// A frame that broke off, and the whole one right behind it: each delimiter may open a frame.
void TstInd3Protocol::nestedAnswers()
{
    const ScanFunction scan = ask(Packet::ReadAngles, 1)->scan;
    const QByteArray answer = hex(anglesAnswer);
    QCOMPARE(scan(answer.left(6) + answer), Scan::damaged(0, 6));
    QCOMPARE(scan(answer.chopped(1) + answer), Scan::complete(0, answer.size()));
    // A frame that claims to hold another: 7E never stands inside, so the inner one is the frame.
    QCOMPARE(answerIn(scan, hex("7E 9C 03 01") + answer + hex("55 7E")), answer);
}

void TstInd3Protocol::endlessNoise()
{
    const ScanFunction scan = ask(Packet::ReadAngles, 1)->scan;
    const QByteArray noise(60000, '\x55');
    QCOMPARE(scan(noise), Scan::incomplete(noise.size()));
    QCOMPARE(scan('\x7E' + noise), Scan::incomplete(noise.size() + 1));
    QCOMPARE(answerIn(scan, '\x7E' + noise + hex(anglesAnswer), 100), hex(anglesAnswer));
}

void TstInd3Protocol::notAFrame_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("delimiter") << hex("7E");
    QTest::newRow("delimiters") << hex("7E 7E");
    QTest::newRow("no check sum") << hex("7E 00 00 00 7E");
    QTest::newRow("no opening delimiter") << hex("9B 01 01 6A 77 80 38 C2 00 FC 7E");
    QTest::newRow("no closing delimiter") << hex("7E 9B 01 01 6A 77 80 38 C2 00 FC");
    QTest::newRow("ends within an escape") << hex("7E 9B 01 01 9B 7D 7E");
    QTest::newRow("wrong check sum") << hex("7E 9B 01 01 9A 7E");
    QTest::newRow("two frames") << hex("7E 9B 01 01 9B 7E 9B 01 01 E5 7E");
}

void TstInd3Protocol::notAFrame()
{
    QFETCH(QByteArray, bytes);
    QVERIFY(!decodeFrame(bytes));
}

void TstInd3Protocol::badReplies()
{
    QVERIFY(decodeAngles(hex("7E 9C 05 01 80 0A 80 20 05 00 B7 7E")).fault() == Fault::BadReply); // another packet
    QVERIFY(decodeAngles(hex("7E 9B 01 01 9B 7E")).fault() == Fault::BadReply); // a question
    QVERIFY(decodeAngles(QByteArray()).fault() == Fault::BadReply);
    QVERIFY(decodeBaud(hex("7E 9C 01 01 00 9C 7E")).fault() == Fault::BadReply); // codes that do not exist
    QVERIFY(decodeBaud(hex("7E 9C 01 01 09 95 7E")).fault() == Fault::BadReply);
    QVERIFY(decodeTicks(hex("7E 9C 0C 01 07 96 7E")).fault() == Fault::BadReply);
    QVERIFY(decodePeriod(hex("7E 9C 0E 01 04 97 7E")).fault() == Fault::BadReply);
}

QTEST_GUILESS_MAIN(TstInd3Protocol)
#include "tst_ind3protocol.moc"
