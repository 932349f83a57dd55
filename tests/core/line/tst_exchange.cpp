#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

/// A toy protocol: `[` one byte of address, one byte of data, their sum, `]`.
Scan scanToy(QByteArrayView bytes)
{
    const qsizetype start = bytes.indexOf('[');
    if (start < 0) {
        return Scan::incomplete(bytes.size());
    }
    if (bytes.size() - start < 5) {
        return Scan::incomplete(start);
    }
    const char sum = static_cast<char>(bytes[start + 1] + bytes[start + 2]);
    return bytes[start + 3] == sum ? Scan::complete(start, 5) : Scan::damaged(start, 5);
}

const QByteArray request = hex("41");
const QByteArray good = hex("5B 01 02 03 5D");
const QByteArray bad = hex("5B 01 02 04 5D");

Exchange toyExchange()
{
    return {request, scanToy, 100ms, 1000ms, 0us};
}

} // namespace

class TestExchange : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void returnsTheAnswer()
    {
        FakeLine line;
        line.expect(request, good);
        const auto answer = line.exchange(toyExchange());
        QVERIFY(answer);
        QCOMPARE(*answer, good);
        QCOMPARE(line.bytesSent(), 1u);
        QCOMPARE(line.bytesReceived(), 5u);
    }

    void manyAnswers()
    {
        const QByteArray last = hex("5B 02 02 04 5D");
        FakeLine line;
        line.expectPieces(
            request, {{good, 900ms}, {hex("11") + good, 900ms}, {last.left(2), 900ms}, {last.mid(2), 1ms}});
        QByteArrayList answers;
        const auto take = [&](QByteArrayView answer) {
            answers.append(answer.toByteArray());
            return answer != last;
        };
        QVERIFY(line.exchangeMany(toyExchange(), take)); // the time-out is that between two of them
        QCOMPARE(answers, (QByteArrayList{good, good, last}));

        answers.clear();
        line.expectPieces(request, {{good, 900ms}, {hex("11 22"), 600ms}, {last, 600ms}});
        QCOMPARE(line.exchangeMany(toyExchange(), take).fault(), Fault::Timeout); // and noise does not prolong it
        QCOMPARE(answers, QByteArrayList{good});
    }

    void waitsForAllPieces()
    {
        FakeLine line;
        line.expectInPieces(request, hex("00 11 22") + good);
        const auto answer = line.exchange(toyExchange());
        QVERIFY(answer);
        QCOMPARE(*answer, good);
    }

    void silenceIsATimeout()
    {
        FakeLine line;
        line.expect(request, {});
        const auto answer = line.exchange(toyExchange());
        QVERIFY(!answer);
        QCOMPARE(answer.fault(), Fault::Timeout);
        QCOMPARE(line.elapsed(), 1000ms);
    }

    void aDamagedAnswerEndsTheWaitSoon()
    {
        FakeLine line;
        line.expect(request, bad);
        const auto answer = line.exchange(toyExchange());
        QVERIFY(!answer);
        QCOMPARE(answer.fault(), Fault::Checksum);
        QVERIFY(line.elapsed() < 200ms);
    }

    void aGoodAnswerAfterADamagedOneIsTaken()
    {
        FakeLine line;
        line.expectPieces(request, {{bad, 5ms}, {good, 50ms}});
        const auto answer = line.exchange(toyExchange());
        QVERIFY(answer);
        QCOMPARE(*answer, good);
    }

    void whatCameBeforeTheRequestIsDropped()
    {
        FakeLine line;
        line.expectPieces(request, {{good, 0ms}, {hex("5B 09 09 12 5D"), 0ms}});
        line.expect(request, good);
        QVERIFY(line.exchange(toyExchange()));
        const auto answer = line.exchange(toyExchange());
        QVERIFY(answer);
        QCOMPARE(*answer, good);
    }

    void keepsTheSilenceThatADeviceNeeds()
    {
        FakeLine line;
        line.expect(request, good).expect(request, good).expect(request, good);
        Exchange exchange = toyExchange();
        exchange.quietBefore = 10ms;
        QVERIFY(line.exchange(exchange));
        QVERIFY(line.exchange(exchange));
        line.requireQuiet(16ms);
        QVERIFY(line.exchange(exchange));
        const auto times = line.requestTimes();
        QCOMPARE(times.at(1) - times.at(0), 10ms);
        QCOMPARE(times.at(2) - times.at(1), 16ms);
    }

    void aLineThatVanishesIsClosed()
    {
        FakeLine line;
        line.vanishAfter(request);
        const auto answer = line.exchange(toyExchange());
        QVERIFY(!answer);
        QCOMPARE(answer.fault(), Fault::Closed);
        QVERIFY(!line.isOpen());
    }

    void interruptEndsEveryWait()
    {
        FakeLine line;
        line.expect(request, {});
        line.interrupt();
        const auto answer = line.exchange(toyExchange());
        QVERIFY(!answer);
        QCOMPARE(answer.fault(), Fault::Cancelled);
    }

    void endlessNoiseDoesNotEatTheMemory()
    {
        FakeLine line;
        QList<FakeLine::Piece> noise(100, {QByteArray(1024, '['), 1ms});
        line.expectPieces(request, noise);
        Exchange exchange = toyExchange();
        exchange.scan = [](QByteArrayView) { return Scan::incomplete(); };
        const auto answer = line.exchange(exchange);
        QVERIFY(!answer);
        QCOMPARE(answer.fault(), Fault::BadReply);
    }
};

QTEST_APPLESS_MAIN(TestExchange)
#include "tst_exchange.moc"
