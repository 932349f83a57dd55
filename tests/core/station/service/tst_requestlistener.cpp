#include "core/station/service/requestlistener.h"
#include "tests/support/fakeline.h"

#include <QElapsedTimer>
#include <QTest>

using namespace gorizont;
using namespace gorizont::station;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

// All frames of this file were made with Python's struct.
const QByteArray askOne = hex("BB 01 01 00 00 00 00 00 43");
const QByteArray askOutputs = hex("BB 01 04 00 01 00 00 80 BF");
const QByteArray askSeven = hex("BB 07 01 00 00 00 00 00 3D");
const QByteArray setTime = hex("BB 01 FF 00 00 F1 53 65 9C");
const QByteArray ownFile = hex("BB 01 FF 07 04 00 00 00 3A 41 43 4B 2E 50 41 52 BB 01 01 00 63");
/// Its text is askOne.
const QByteArray foreignFile = hex("BB 07 FF 07 09 00 00 00 2F 41 43 4B 2E 50 41 52 BB 01 01 00 00 00 00 00 43 20");
/// askOne stands among the values of both: answers to commands 3 and 8 with two parameters and one.
const QByteArray foreignAnswer3 =
    hex("BB 07 00 02 03 00 00 00 39 BB 01 01 00 00 00 00 00 43 00 00 00 00 00 00 00 00 00 00 "
        "00 00 00 00 00 00");
const QByteArray foreignAnswer8 =
    hex("BB 07 00 01 03 00 00 00 3A 00 00 C0 3F 00 00 80 3F 00 00 00 40 00 00 40 40 BB 01 01 00 00 00 00 00 43")
    + QByteArray(31, 0) + hex("82");
const QByteArray askSevenThree = hex("BB 07 03 00 00 00 00 00 3B");
const QByteArray askSevenEight = hex("BB 07 08 00 00 00 00 00 36");
const QByteArray unfinishedFile = hex("BB 01 FF 07 C8 00 00 00 76 41 43 4B 2E 50 41 52 61 62 63");

class Listening
{
public:
    QList<ack::Asked> hear(const QByteArray &bytes, std::chrono::milliseconds later = 0ms)
    {
        m_now += later;
        return m_listener.hear(bytes, m_now);
    }

private:
    RequestListener m_listener{[](quint8 address) { return address == 1; }, 1ms};
    SteadyTime m_now{1h};
};

} // namespace

class TestRequestListener : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hearsEveryKind();
    void waitsForEveryPrefix();
    void refusesEveryFlip();
    void findsRequestsInNoise();
    void ignoresOthers_data();
    void ignoresOthers();
    void givesUpWhatDoesNotEnd();
    void hearsManyAtOnce();
};

void TestRequestListener::hearsEveryKind()
{
    Listening line;
    QCOMPARE(line.hear(askOne), (QList<ack::Asked>{{1, 1, 0, {}, {}}}));
    QCOMPARE(line.hear(askOutputs), (QList<ack::Asked>{{1, 4, 0x80000001, {}, {}}}));
    QCOMPARE(line.hear(setTime), (QList<ack::Asked>{{1, 0xFF, 1'700'000'000, {}, {}}}));
    QCOMPARE(line.hear(ownFile), (QList<ack::Asked>{{1, 0xFF, 4, "ACK.PAR", hex("BB 01 01 00")}}));
}

void TestRequestListener::waitsForEveryPrefix()
{
    for (const QByteArray &frame : {askOne, setTime, ownFile}) {
        for (qsizetype length = 0; length < frame.size(); ++length) {
            Listening line;
            QVERIFY2(line.hear(frame.first(length)).isEmpty(), QByteArray::number(length));
            QCOMPARE(line.hear(frame.sliced(length), 900ms).size(), 1);
        }
    }
}

void TestRequestListener::refusesEveryFlip()
{
    for (const QByteArray &frame : {askOne, askOutputs, setTime, ownFile}) {
        for (qsizetype bit = 0; bit < frame.size() * 8; ++bit) {
            QByteArray flipped = frame;
            flipped[bit / 8] = static_cast<char>(flipped.at(bit / 8) ^ (1 << (bit % 8)));
            Listening line;
            QVERIFY2(line.hear(flipped).isEmpty(), flipped.toHex(' '));
            // And the station is not deaf afterwards.
            QCOMPARE(line.hear(askOne, 1100ms).size(), 1);
        }
    }
}

void TestRequestListener::findsRequestsInNoise()
{
    Listening line;
    const QByteArray noise = hex("BB BB 01 00 FF BB 01 01 00 BB");
    const QByteArray between = hex("BB 01 01");
    QCOMPARE(line.hear(noise + askOne + between + askOutputs + noise).size(), 2);
    QCOMPARE(line.hear(askOne).size(), 1);
}

void TestRequestListener::ignoresOthers_data()
{
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("request to another") << askSeven;
    QTest::newRow("file to another with a request inside") << foreignFile;
    QTest::newRow("answer of another with a request inside") << askSevenThree + foreignAnswer3;
    QTest::newRow("the same with extras") << askSevenEight + foreignAnswer8;
    QTest::newRow("no data") << askSevenThree + hex("BB 07 00 00 03 00 00 00 3B");
    QTest::newRow("a command that does not exist") << hex("BB 01 09 00 00 00 00 00 3B");
    QTest::newRow("address 0") << hex("BB 00 01 00 00 00 00 00 44");
}

void TestRequestListener::ignoresOthers()
{
    QFETCH(QByteArray, said);
    Listening whole;
    QVERIFY(whole.hear(said).isEmpty());
    QCOMPARE(whole.hear(askOne).size(), 1);
    Listening pieces;
    for (const char byte : said) {
        QVERIFY(pieces.hear(QByteArray(1, byte), 1ms).isEmpty());
    }
    QCOMPARE(pieces.hear(askOne).size(), 1);
}

/// A file that breaks off must not make the station deaf, neither after a silence nor when the dispatcher goes on asking.
void TestRequestListener::givesUpWhatDoesNotEnd()
{
    Listening silence;
    QVERIFY(silence.hear(unfinishedFile).isEmpty());
    QCOMPARE(silence.hear(askOne, 1100ms).size(), 1);

    Listening busy;
    QVERIFY(busy.hear(unfinishedFile).isEmpty());
    qsizetype heard = 0;
    int asked = 0;
    while (heard == 0 && asked < 20) {
        heard = busy.hear(askOne, 300ms).size();
        ++asked;
    }
    // 217 bytes at 1 ms, twice, and a second.
    QVERIFY2(asked >= 3 && asked <= 6, QByteArray::number(asked));
}

void TestRequestListener::hearsManyAtOnce()
{
    Listening line;
    QByteArray flood;
    for (int i = 0; i < 20'000; ++i) {
        flood += askOne;
    }
    QElapsedTimer timer;
    timer.start();
    QCOMPARE(line.hear(flood).size(), 20'000);
    QVERIFY2(timer.elapsed() < 5000, "a flood takes time that grows with its square");
}

QTEST_GUILESS_MAIN(TestRequestListener)

#include "tst_requestlistener.moc"
