#include "core/modbus/modbusanswer.h"
#include "tests/core/modbus/modbussite.h"
#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;

namespace {

UnitImages sampleImages()
{
    UnitImages images(modbusSite());
    images.update(sampleTilt());
    images.update(sampleAcceleration());
    images.updateLine(lineStatus(3, LineState::OpenFailed));
    images.updateLine(lineStatus(5, LineState::Lost));
    return images;
}

QByteArray toBytes(const AnswerBuffer &answers)
{
    return {answers.constData(), answers.size()};
}

} // namespace

/// Requests to answers, as bytes. Frames follow manual 000, sections 10.1 and 10.2; exceptions spec/gorizont.md, 6.
class TestModbusAnswer : public QObject
{
    Q_OBJECT

    const UnitImages m_images = sampleImages();

private Q_SLOTS:
    void answersTheManualsRequests()
    {
        // Ni = 4: (4 × 8 + 4) / 2 = 18 registers, length 7 + 4 × 8 = 39 = 27h, 4 + 4 × 8 = 36 = 24h bytes of data.
        AnswerBuffer answers;
        const auto done = answerRequests(hex("00 01 00 00 00 06 03 04 00 00 00 12"), m_images, answers);
        QCOMPARE(done.consumed, 12);
        QCOMPARE(done.requests, 1U);
        QCOMPARE(done.exceptions, 0U);
        QVERIFY(!done.isBroken);
        QCOMPARE(toBytes(answers).toHex(), (hex("00 01 00 00 00 27 03 04 24") + tiltBlock()).toHex());
        // Na = 2: 12 registers, 7 + 20 = 27 = 1Bh, 24 = 18h bytes of data.
        answers.clear();
        answerRequests(hex("FF FE 00 00 00 06 06 04 00 00 00 0C"), m_images, answers);
        QCOMPARE(toBytes(answers).toHex(), (hex("FF FE 00 00 00 1B 06 04 18") + accelerationBlock()).toHex());
    }

    void answers_data()
    {
        QTest::addColumn<QByteArray>("request");
        QTest::addColumn<QByteArray>("answer");
        const auto row = [](const char *name, const char *request, const char *answer) {
            QTest::newRow(name) << hex(request) << hex(answer);
        };
        row("one register", "0001 0000 0006 03 04 0003 0001", "0001 0000 0005 03 04 02 CAF8");
        row("protocol echoed", "0001 ABCD 0006 03 04 0000 0001", "0001 ABCD 0005 03 04 02 1C02");
        row("last register", "0001 0000 0006 03 04 0011 0001", "0001 0000 0005 03 04 02 0017");
        row("unit 0", "0001 0000 0006 00 04 0000 0001", "0001 0000 0003 00 84 0B");
        row("unit 4", "0001 0000 0006 04 04 0000 0001", "0001 0000 0003 04 84 0B");
        row("unit 255", "0001 0000 0006 FF 04 0000 0001", "0001 0000 0003 FF 84 0B");
        row("unit before function", "0001 0000 0006 02 03 0000 0001", "0001 0000 0003 02 83 0B");
        row("function 3", "0001 0000 0006 03 03 0000 0001", "0001 0000 0003 03 83 01");
        row("function 0", "0001 0000 0006 03 00 0000 0001", "0001 0000 0003 03 80 01");
        row("function 8", "0001 0000 0006 03 08 0000 1234", "0001 0000 0003 03 88 01");
        row("function 16", "0001 0000 0009 06 10 0000 0001 02 0000", "0001 0000 0003 06 90 01");
        row("function 84h", "0001 0000 0006 03 84 0000 0001", "0001 0000 0003 03 84 01");
        row("function before quantity", "0001 0000 0006 03 03 0000 0000", "0001 0000 0003 03 83 01");
        row("quantity 0", "0001 0000 0006 03 04 0000 0000", "0001 0000 0003 03 84 03");
        row("quantity 126", "0001 0000 0006 03 04 0000 007E", "0001 0000 0003 03 84 03");
        row("quantity 65535", "0001 0000 0006 03 04 0000 FFFF", "0001 0000 0003 03 84 03");
        row("quantity before address", "0001 0000 0006 03 04 FFFF 0000", "0001 0000 0003 03 84 03");
        row("quantity 125 of 18", "0001 0000 0006 03 04 0000 007D", "0001 0000 0003 03 84 02");
        row("one too many", "0001 0000 0006 03 04 0000 0013", "0001 0000 0003 03 84 02");
        row("address beyond", "0001 0000 0006 03 04 0012 0001", "0001 0000 0003 03 84 02");
        row("address and quantity wrap", "0001 0000 0006 03 04 FFFF 0002", "0001 0000 0003 03 84 02");
        row("beyond in unit 6", "0001 0000 0006 06 04 000B 0002", "0001 0000 0003 06 84 02");
        row("only a function", "0001 0000 0002 03 04", "0001 0000 0003 03 84 03");
        row("cut short", "0001 0000 0005 03 04 0000 00", "0001 0000 0003 03 84 03");
        row("too long", "0001 0000 0007 03 04 0000 0001 00", "0001 0000 0003 03 84 03");
    }

    void answers()
    {
        QFETCH(const QByteArray, request);
        AnswerBuffer answers;
        const auto done = answerRequests(request, m_images, answers);
        QCOMPARE(done.consumed, request.size());
        QCOMPARE(done.requests, 1U);
        QTEST(toBytes(answers), "answer");
    }

    void readsTheLargestQuantity()
    {
        ModbusConfig config = modbusSite(ModbusPacking::ByNumber);
        config.lines[0].sensors[0].number = 40; // 2 + 4 × 40 = 162 registers
        const UnitImages images(config);
        AnswerBuffer answers;
        answerRequests(hex("0001 0000 0006 03 04 0025 007D"), images, answers);
        QCOMPARE(answers.size(), 9 + 250);
        QCOMPARE(toBytes(answers).first(9), hex("0001 0000 00FD 03 04 FA"));
    }

    void answersPipelinedRequestsInOrder()
    {
        QByteArray requests;
        QByteArray expected;
        for (int i = 0; i < 100; ++i) {
            QByteArray request = hex("0000 0000 0006 03 04 0002 0001");
            QByteArray answer = hex("0000 0000 0005 03 04 02 B7FF");
            request[1] = answer[1] = static_cast<char>(i);
            if (i % 3 == 0) {
                request[6] = answer[6] = 9;
                answer = answer.first(6) + hex("09 84 0B");
                answer[5] = 3;
            }
            requests += request;
            expected += answer;
        }
        AnswerBuffer answers;
        const auto done = answerRequests(requests + hex("0001 0000 0006"), m_images, answers);
        QCOMPARE(done.consumed, requests.size());
        QCOMPARE(done.requests, 100U);
        QCOMPARE(done.exceptions, 34U);
        QVERIFY(!done.isBroken);
        QCOMPARE(toBytes(answers).toHex(), expected.toHex());
    }

    void answersWhatCameBeforeAWrongLength()
    {
        AnswerBuffer answers;
        const auto done = answerRequests(hex("0001 0000 0006 03 04 0002 0001  0001 0000 FFFA 03"), m_images, answers);
        QVERIFY(done.isBroken);
        QCOMPARE(done.requests, 1U);
        QCOMPARE(toBytes(answers), hex("0001 0000 0005 03 04 02 B7FF"));
    }

    void nothingIsAnsweredBeforeTheLastByte()
    {
        const QByteArray request = hex("0001 0000 0006 03 04 0002 0001");
        for (qsizetype size = 0; size < request.size(); ++size) {
            AnswerBuffer answers;
            const auto done = answerRequests(request.first(size), m_images, answers);
            QCOMPARE(done.consumed, 0);
            QVERIFY(answers.isEmpty());
            QVERIFY(!done.isBroken);
        }
    }
};

QTEST_APPLESS_MAIN(TestModbusAnswer)
#include "tst_modbusanswer.moc"
