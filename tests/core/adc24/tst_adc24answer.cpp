#include "core/adc24/adc24answer.h"
#include "tests/core/adc24/adc24site.h"
#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;

namespace {

// Status 3704h. Scale 1/8 = 2^−3: 3FC0000000000000h; rate 10 = 1.25 × 2^3: 4024000000000000h; low bytes first.
const QByteArray scaleAndRate = hex("000000000000C03F 0000000000002440");

Adc24Image sixImage()
{
    Adc24Image image(adc24Site());
    image.update(statusReading(0x3704));
    image.append(sixSamples());
    return image;
}

QByteArray answersTo(const QByteArray &received, const Adc24Image &image)
{
    AnswerBuffer answers;
    answerAdc24(received, image, answers);
    return QByteArray(answers.constData(), answers.size());
}

} // namespace

/// Requests and answers by hand from spec/gorizont.md, section 7.
class TestAdc24Answer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void answers_data()
    {
        QTest::addColumn<QByteArray>("request");
        QTest::addColumn<QByteArray>("answer");
        const auto row = [](const char *name, const char *request, const QByteArray &answer) {
            QTest::newRow(name) << hex(request) << answer;
        };
        row("how many", "01 01 00 00 00 00000000 00000000", hex("01 01 06000000"));
        row("how many, the rest is not looked at", "01 01 FF FF FF FFFFFFFF FFFFFFFF", hex("01 01 06000000"));
        row("first block of four", "01 03 00 00 00 00000000 04000000",
            hex("01 03 02 37 04000000") + scaleAndRate + hex("0100 FFFF 0001 FEFF"));
        row("sm and type are not looked at", "01 03 7F 08 FF 00000000 04000000",
            hex("01 03 02 37 04000000") + scaleAndRate + hex("0100 FFFF 0001 FEFF"));
        row("half a block is none", "01 03 00 00 00 01000000 04000000", hex("01 03 0437 00000000"));
        row("second block of two", "01 03 00 00 00 01000000 02000000",
            hex("01 03 02 37 02000000") + scaleAndRate + hex("0001 FEFF"));
        row("last block of two", "01 03 00 00 00 02000000 02000000",
            hex("01 03 02 37 02000000") + scaleAndRate + hex("FF7F 0080"));
        row("one beyond the last", "01 03 00 00 00 03000000 02000000", hex("01 03 0437 00000000"));
        row("size 0 is 1", "01 03 00 00 00 05000000 00000000",
            hex("01 03 02 37 01000000") + scaleAndRate + hex("0080"));
        row("size 0, beyond", "01 03 00 00 00 06000000 00000000", hex("01 03 0437 00000000"));
        row("all six", "01 03 00 00 00 00000000 06000000",
            hex("01 03 02 37 06000000") + scaleAndRate + hex("0100 FFFF 0001 FEFF FF7F 0080"));
        row("seven of six", "01 03 00 00 00 00000000 07000000", hex("01 03 0437 00000000"));
        row("largest block", "01 03 00 00 00 FFFFFFFF 01000000", hex("01 03 0437 00000000"));
        row("largest size", "01 03 00 00 00 00000000 FFFFFFFF", hex("01 03 0437 00000000"));
        row("largest block and size", "01 03 00 00 00 FFFFFFFF FFFFFFFF", hex("01 03 0437 00000000"));
        // 2^31 × 2 is 0 in 32 bits.
        row("a product that wraps", "01 03 00 00 00 00000080 02000000", hex("01 03 0437 00000000"));
        row("address 0", "00 03 00 00 00 00000000 01000000", {});
        row("address 2", "02 01 00 00 00 00000000 01000000", {});
        row("command 0", "01 00 00 00 00 00000000 01000000", {});
        row("command 2", "01 02 00 00 00 00000000 01000000", {});
        row("command 131", "01 83 00 00 00 00000000 01000000", {});
        row("nothing", "", {});
        row("one byte less", "01 01 00 00 00 00000000 000000", {});
        row("one byte more", "01 01 00 00 00 00000000 00000000 01", hex("01 01 06000000"));
    }

    void answers()
    {
        QFETCH(const QByteArray, request);
        QFETCH(const QByteArray, answer);
        QCOMPARE(answersTo(request, sixImage()).toHex(' '), answer.toHex(' '));
    }

    void answersInOrderAndCounts()
    {
        const QByteArray count = hex("01 01 00 00 00 00000000 00000000");
        const QByteArray wrong = hex("01 07 00 00 00 00000000 00000000");
        const QByteArray beyond = hex("01 03 00 00 00 09000000 01000000");
        AnswerBuffer answers;
        const AnsweredRequests done = answerAdc24(beyond + wrong + count + count.first(12), sixImage(), answers);
        QCOMPARE(
            QByteArray(answers.constData(), answers.size()).toHex(' '),
            hex("01 03 0437 00000000  01 01 06000000").toHex(' '));
        QCOMPARE(done.consumed, 39);
        QCOMPARE(done.requests, 2U);
        QCOMPARE(done.exceptions, 0U);
        QCOMPARE(done.unanswered, 1U);
        QVERIFY(!done.isBroken);
    }

    void givesAtMost8192Samples()
    {
        Adc24Config config = adc24Site();
        config.ringPackets = 1000;
        Adc24Image image(config);
        QList<qint16> samples(8192, 5);
        samples[8191] = 0x1234;
        image.append(sampleBlock(samples));
        const QByteArray all = answersTo(hex("01 03 00 00 00 00000000 FFFFFFFF"), image);
        QCOMPARE(all.size(), 24 + 16384);
        QCOMPARE(all.first(8), hex("01 03 02 0F 00200000"));
        QCOMPARE(all.last(4), hex("0500 3412"));
        QCOMPARE(answersTo(hex("01 03 00 00 00 00000000 01200000"), image), all); // 8193
        // The second block of 8192 is there only when all of it is.
        image.append(sampleBlock(QList<qint16>(8191, 6)));
        QCOMPARE(answersTo(hex("01 03 00 00 00 01000000 00200000"), image), hex("01 03 000F 00000000"));
        image.append(sampleBlock({7}));
        const QByteArray second = answersTo(hex("01 03 00 00 00 01000000 00200000"), image);
        QCOMPARE(second.size(), 24 + 16384);
        QCOMPARE(second.last(4), hex("0600 0700"));
    }
};

QTEST_APPLESS_MAIN(TestAdc24Answer)
#include "tst_adc24answer.moc"
