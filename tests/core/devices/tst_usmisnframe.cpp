#include "core/devices/usmisn/usmisnprotocol.h"
#include "tests/support/scanning.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::usmisn;
using namespace gorizont::test;

/// How the answer is found among what a line brings.
class TstUsmisnFrame : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void properties_data();
    void properties();
    void missingSlash();
    void flips();
    void notTheAnswer_data();
    void notTheAnswer();
    void afterOthers_data();
    void afterOthers();
    void addressForms();
    void longestMessage_data();
    void longestMessage();
    void manyAnswersInOne();
    void transactions();
};

namespace {

const QByteArray serial = "%/R/123/001/GetSerial/01234567/%";
const QByteArray value = "%/R/123/001/GetValue/0,00123456701,0,-0002.48289,0000.00860,26.33,A,Grad,Angle_X,001,5/%";
const QByteArray noise("\x00\xFF%\r\n/%%R%/Q/7/%", 15);

ScanFunction scanFor(Instruction instruction, int address = 123)
{
    return [question = Question{address, "001", instruction}](QByteArrayView bytes) {
        return scanAnswer(bytes, question);
    };
}

} // namespace

void TstUsmisnFrame::properties_data()
{
    QTest::addColumn<int>("instruction");
    QTest::addColumn<QByteArray>("answer");
    QTest::newRow("serial") << int(Instruction::GetSerial) << serial;
    QTest::newRow("value") << int(Instruction::GetValue) << value;
    QTest::newRow("no data") << int(Instruction::StopCycle) << QByteArray("%/R/123/001/StopCycle//%");
}

/// Prefixes, noise, broken off answers, any pieces.
void TstUsmisnFrame::properties()
{
    QFETCH(int, instruction);
    QFETCH(QByteArray, answer);
    QCOMPARE(brokenProperties(scanFor(static_cast<Instruction>(instruction)), answer, noise), QStringList());
}

/// Only the CR tells that the message is over.
void TstUsmisnFrame::missingSlash()
{
    const QByteArray answer = "%/R/123/001/GetInfo/0280002801,A,Grad,Angle_X%";
    const ScanFunction scan = scanFor(Instruction::GetInfo);
    QVERIFY(scan(answer) == Scan::incomplete());
    QVERIFY(scan("\n" + answer) == Scan::incomplete(1));
    QVERIFY(scan("\n" + answer + "\r") == Scan::complete(1, answer.size()));
    QVERIFY(scan(answer + "x") == Scan::incomplete());
    for (const int size : {0, 1, 2, 3}) {
        QCOMPARE(answerIn(scan, noise + answer + "\r\n", size), std::optional(answer));
    }
}

/// There is no check sum: a flip in the envelope hides the answer, one in the data is refused by the form of its fields or
/// gives another good number.
void TstUsmisnFrame::flips()
{
    const Question question{123, "001", Instruction::GetSerial};
    const qsizetype dataAt = serial.indexOf("01234567");
    for (qsizetype byte = 0; byte < serial.size(); ++byte) {
        for (int bit = 0; bit < 8; ++bit) {
            QByteArray damaged = serial;
            damaged[byte] = static_cast<char>(damaged.at(byte) ^ (1 << bit));
            const auto answer = answerIn(scanFor(Instruction::GetSerial), damaged);
            const bool isData = byte >= dataAt && byte < dataAt + 8;
            if (!isData) {
                const bool isStillData = byte == dataAt + 8; // the slash before the last %, and no CR after it
                QVERIFY2(!answer || isStillData, qPrintable(QStringLiteral("%1.%2").arg(byte).arg(bit)));
            }
            if (answer && isData) {
                const char c = damaged.at(byte);
                const auto number = decodeSerial(*answer, question);
                const bool isBlankInFront = byte == dataAt && c == ' '; // a leading zero less
                QCOMPARE(static_cast<bool>(number), isBlankInFront || (c >= '0' && c <= '9'));
                QVERIFY(!isBlankInFront || *number == 1234567U);
            }
        }
    }
}

void TstUsmisnFrame::notTheAnswer_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("another transaction") << QByteArray("\n%/R/123/002/GetSerial/01234567/%\r\n");
    QTest::newRow("another address") << QByteArray("\n%/R/124/001/GetSerial/01234567/%\r\n");
    QTest::newRow("another instruction") << QByteArray("\n%/R/123/001/GetType/028/%\r\n");
    QTest::newRow("beginning of the name") << QByteArray("\n%/R/123/001/GetSer/01234567/%\r\n");
    QTest::newRow("echo of the request") << QByteArray("%/Q/123/001/GetSerial//%");
    QTest::newRow("no data part") << QByteArray("\n%/R/123/001/GetSerial/%\r\n");
    QTest::newRow("a part too many") << QByteArray("\n%/R/123/001/GetSerial/0123/4567/%\r\n");
    QTest::newRow("address of four digits") << QByteArray("\n%/R/0123/001/GetSerial/01234567/%\r\n");
    QTest::newRow("no address") << QByteArray("\n%/R//001/GetSerial/01234567/%\r\n");
    QTest::newRow("lower case") << QByteArray("\n%/r/123/001/getserial/01234567/%\r\n");
    QTest::newRow("no beginning") << QByteArray("\n/R/123/001/GetSerial/01234567/%\r\n");
    QTest::newRow("no end") << QByteArray("\n%/R/123/001/GetSerial/01234567/\r\n");
    QTest::newRow("only markers") << QByteArray("%/%/%/%/%%%%/");
}

void TstUsmisnFrame::notTheAnswer()
{
    QFETCH(QByteArray, bytes);
    const ScanFunction scan = scanFor(Instruction::GetSerial);
    QVERIFY(!answerIn(scan, bytes) && !answerIn(scan, bytes, 1));
    for (const int size : {0, 1, 5}) { // and it does not take the answer along
        QCOMPARE(answerIn(scan, bytes + '\n' + serial, size), std::optional(serial));
    }
}

void TstUsmisnFrame::afterOthers_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::newRow("echo") << QByteArray("%/Q/123/001/GetSerial//%");
    QTest::newRow("late value") << "\n" + value + "\r\n";
    QTest::newRow("inside another") << QByteArray("\n%/R/7/001/GetValue/0,001,0,-00");
    QTest::newRow("two late ones") << QByteArray("\n%/R/7/044/GetType/028/%\r\n\n%/R/8/045/GetType/028/%\r\n");
    QTest::newRow("end without slash") << QByteArray("\n%/R/7/044/GetInfo/0280002801,A,Grad,Angle_X%\r\n");
    QTest::newRow("slash of a broken one") << QByteArray("\n%/R/123/001/GetSerial/");
}

void TstUsmisnFrame::afterOthers()
{
    QFETCH(QByteArray, before);
    for (const int size : {0, 1, 3, 7}) {
        QCOMPARE(answerIn(scanFor(Instruction::GetSerial), before + serial, size), std::optional(serial));
    }
}

void TstUsmisnFrame::addressForms()
{
    const auto isHeard = [](const char *address, int asked) {
        const QByteArray answer = QByteArray("%/R/") + address + "/001/GetType/028/%";
        return answerIn(scanFor(Instruction::GetType, asked), answer).has_value();
    };
    QVERIFY(isHeard("7", 7) && isHeard("07", 7) && isHeard("007", 7));
    QVERIFY(!isHeard("70", 7) && !isHeard("0", 7));
    QVERIFY(isHeard("0", 0) && isHeard("000", 0) && isHeard("123", 0) && isHeard("255", 0));
    QVERIFY(!isHeard("256", 0) && !isHeard("999", 0) && !isHeard("-1", 0) && !isHeard("1 ", 1));
}

void TstUsmisnFrame::longestMessage_data()
{
    QTest::addColumn<int>("length");
    QTest::addColumn<bool>("isHeard");
    QTest::newRow("2047") << 2047 << true;
    QTest::newRow("2048") << 2048 << true;
    QTest::newRow("2049") << 2049 << false;
    QTest::newRow("5000") << 5000 << false;
}

void TstUsmisnFrame::longestMessage()
{
    QFETCH(int, length);
    QFETCH(bool, isHeard);
    const QByteArray head = "%/R/123/001/GetSerial/";
    const QByteArray answer = head + QByteArray(length - head.size() - 2, '0') + "/%";
    QCOMPARE(answer.size(), qsizetype(length));
    const ScanFunction scan = scanFor(Instruction::GetSerial);
    for (const int size : {0, 1, 64}) {
        QCOMPARE(answerIn(scan, answer, size).has_value(), isHeard);
        QCOMPARE(answerIn(scan, answer + "\r\n\n" + serial, size), std::optional(isHeard ? answer : serial));
    }
    // What can never become a message is not kept.
    const QByteArray endless = head + QByteArray(4000, '0');
    QVERIFY(scan(endless) == Scan::incomplete(endless.size()));
}

void TstUsmisnFrame::manyAnswersInOne()
{
    const QByteArray first = "%/R/123/001/GetInfo/0280002801,A,Grad,Angle_X%";
    const QByteArray second = "%/R/123/001/GetInfo/0280002802,A,Grad,Angle_Y%";
    QByteArray bytes = "\n" + first + "\r\n\n" + second + "\r\n\n%/R/123/001/GetInfo/End/%\r\n";
    QByteArrayList answers;
    for (;;) {
        const Scan scan = scanFor(Instruction::GetInfo)(bytes);
        if (scan.state != Scan::State::Complete) {
            break;
        }
        answers.append(bytes.mid(scan.skip, scan.length));
        bytes.remove(0, scan.skip + scan.length);
    }
    QCOMPARE(answers, (QByteArrayList{first, second, "%/R/123/001/GetInfo/End/%"}));
}

void TstUsmisnFrame::transactions()
{
    Transactions all;
    QCOMPARE(all.next(), QByteArray("001"));
    QCOMPARE(all.next(), QByteArray("002"));
    Transactions few(998, 999);
    QCOMPARE(few.next(), QByteArray("998"));
    QCOMPARE(few.next(), QByteArray("999"));
    QCOMPARE(few.next(), QByteArray("998"));
}

QTEST_GUILESS_MAIN(TstUsmisnFrame)
#include "tst_usmisnframe.moc"
