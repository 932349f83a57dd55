#include "core/protocol/ackmessages.h"
#include "tests/support/fakeline.h"
#include "tests/support/scanning.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::ack;
using namespace gorizont::test;

namespace {

const QByteArray means = hex("BB 01 00 06 05 00 00 00 39  00 00 C0 41 00 00 60 C0 00 50 3A 44 FF FF FF FF 00 80 3B 43 "
                             "00 00 98 40 3F");
const QByteArray withEvents =
    hex("BB 01 00 02 00 00 00 00 42  00 00 C0 41 FF FF FF FF  00 00 48 41 00 00 40 3F 00 00 10 41 "
        "10 FF 53 65 00 0F AC 9A F0 C9 53 65 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 "
        "00 00 00 00 00 00 00 00 05 00 00 00 18");
const QByteArray file = hex("BB 03 FF 07 07 00 00 00 35  41 43 4B 2E 50 53 45 31 0D 0A BB 30 0D 0A D1");
const Question meansOfOne{1, 1, 6};

QByteArray found(const ScanFunction &scan, const QByteArray &bytes)
{
    return answerIn(scan, bytes).value_or(QByteArray());
}

} // namespace

/// The request and its check sum stand in spec/mk14.md; the other bytes were packed by Python's struct module.
class TstAckMessages : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void requests()
    {
        QCOMPARE(ask({1, 1, 0}, 0).bytes, hex("BB 01 01 00 00 00 00 00 43"));
        QCOMPARE(ask({2, 8, 0}, 0xA5).bytes, hex("BB 02 08 00 A5 00 00 00 96"));
        QCOMPARE(askTime(3, 1700000000).bytes, hex("BB 03 FF 00 00 F1 53 65 9A"));
        QCOMPARE(
            askFile(
                3, "ACK.PSE",
                "1\r\n\xBB"
                "0\r\n")
                ->bytes,
            file);
    }

    void filesThatCannotBeSent()
    {
        QVERIFY(!askFile(1, {}, "1"));
        QVERIFY(!askFile(1, QByteArray(256, 'n'), "1"));
        QVERIFY(!askFile(1, "ACK.PAR", QByteArray(longestFile + 1, ' ')));
        QVERIFY(askFile(1, QByteArray(255, 'n'), QByteArray(longestFile, ' ')));
    }

    void valuesOfACommand()
    {
        const QList<int> counts{0, 1, 2, 3, 4, 5, 6, 3, 1, 0};
        for (int command = 0; command < counts.size(); ++command) {
            QCOMPARE(valuesPerParameter(command), counts.at(command));
        }
    }

    void answerWithMeans()
    {
        const auto answer = decodeAnswer(means, meansOfOne);
        QVERIFY(answer);
        QCOMPARE(answer->digital, 5U);
        const QList<Values> expected{{24.0F}, {-3.5F}, {745.25F}, {std::nullopt}, {187.5F}, {4.75F}};
        QVERIFY(answer->parameters == expected);
        QVERIFY(answer->extras.isEmpty() && answer->precipitation.isEmpty());
    }

    void answerGroupsTheValuesOfAParameter()
    {
        const auto answer = decodeAnswer(
            hex("BB 07 00 02 01 00 00 80 BB  00 00 C0 41 00 00 C4 41 00 00 60 C0 FF FF FF FF DE"), {7, 2, 0});
        QVERIFY(answer);
        QCOMPARE(answer->digital, 0x80000001U);
        const QList<Values> expected{{24.0F, 24.5F}, {-3.5F, std::nullopt}};
        QVERIFY(answer->parameters == expected);
    }

    void answerWithEvents_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("LEN counts the parameters") << withEvents;
        QByteArray other = withEvents;
        other[3] = 15; // 2 + 13
        other[8] = 0x35;
        QTest::newRow("LEN counts the extras too") << other;
    }

    void answerWithEvents()
    {
        QFETCH(const QByteArray, bytes);
        const Question question{1, 8, 2};
        QCOMPARE(found(ask(question, 0).scan, bytes), bytes);
        const auto answer = decodeAnswer(bytes, question);
        QVERIFY(answer);
        const QList<Values> parameters{{24.0F}, {std::nullopt}};
        QVERIFY(answer->parameters == parameters);
        const Values extras{12.5F, 0.75F, 9.0F};
        QVERIFY(answer->extras == extras);
        // What stands behind the first 0 is no event.
        QCOMPARE(answer->precipitation, (QList<qint32>{1700003600, -1700000000, 1699990000}));
    }

    void answerWithoutData()
    {
        const QByteArray bare = hex("BB 01 00 00 05 00 00 00 3F");
        QCOMPARE(found(ask(meansOfOne, 0).scan, bare), bare);
        const auto answer = decodeAnswer(bare, meansOfOne);
        QVERIFY(answer && answer->parameters.isEmpty());
        QCOMPARE(answer->digital, 5U);
    }

    void scansHoldTheirProperties()
    {
        const QByteArray garbage = hex("00 BB 01 BB BB 02 00 00 00 00 00 00 43");
        QCOMPARE(brokenProperties(ask(meansOfOne, 0).scan, means, garbage), QStringList());
        QCOMPARE(brokenProperties(ask({1, 8, 2}, 0).scan, withEvents, garbage), QStringList());
        QCOMPARE(
            brokenProperties([](QByteArrayView bytes) { return scanRequest(bytes, 3); }, file, garbage), QStringList());
    }

    void everyBitIsGuarded()
    {
        QCOMPARE(unguardedBits(ask(meansOfOne, 0).scan, means), QStringList());
        QCOMPARE(unguardedBits(ask({1, 8, 2}, 0).scan, withEvents), QStringList());
        QCOMPARE(unguardedBits([](QByteArrayView bytes) { return scanRequest(bytes, 3); }, file), QStringList());
    }

    void foreignAnswersAndEchoesArePassedOver()
    {
        const QByteArray foreign = hex("BB 02 00 00 00 00 00 00 43");
        const QByteArray echo = hex("BB 01 01 00 00 00 00 00 43");
        QCOMPARE(found(ask(meansOfOne, 0).scan, foreign + echo + means), means);
    }

    void aFrameInsideDataIsData()
    {
        const QByteArray bytes = hex("BB 01 00 03 00 00 00 00 41  BB 01 00 00 00 00 00 00 44 00 00 00 00");
        for (qsizetype length = 9; length < bytes.size(); ++length) {
            QCOMPARE(ask({1, 1, 3}, 0).scan(bytes.first(length)).state, Scan::State::Incomplete);
        }
        QCOMPARE(found(ask({1, 1, 3}, 0).scan, bytes), bytes);
    }

    void aTrueFrameInsideADamagedOneIsFound()
    {
        // LEN promises four bytes and a check sum; what comes are the first five of a whole frame.
        const QByteArray broken = hex("BB 01 00 01 00 00 00 00 43");
        const QByteArray whole = hex("BB 01 00 00 05 00 00 00 3F");
        for (const qsizetype piece : {0, 1, 5, 7}) {
            QCOMPARE(answerIn(ask({1, 1, 0}, 0).scan, broken + whole, piece), std::optional<QByteArray>(whole));
        }
    }

    void confirmationIsABareHeader()
    {
        const ScanFunction scan = askTime(3, 1700000000).scan;
        QCOMPARE(found(scan, hex("BB 03 00 00 00 00 00 00 42")), hex("BB 03 00 00 00 00 00 00 42"));
        QVERIFY(!answerIn(scan, means));
    }

    void theStationHears()
    {
        QVERIFY((*decodeRequest(hex("BB 02 08 00 A5 00 00 00 96")) == Asked{2, 8, 0xA5, {}, {}}));
        const auto time = decodeRequest(hex("BB 03 FF 00 00 F1 53 65 9A"));
        QVERIFY(time && time->isTime() && !time->isFile());
        QCOMPARE(time->digital, 1700000000U);
        const auto received = decodeRequest(file);
        QVERIFY(received && received->isFile());
        QCOMPARE(received->fileName, "ACK.PSE");
        QCOMPARE(
            received->file,
            "1\r\n\xBB"
            "0\r\n");
        QCOMPARE(found([](QByteArrayView bytes) { return scanRequest(bytes, 3); }, means + file), file);
        QVERIFY(!answerIn([](QByteArrayView bytes) { return scanRequest(bytes, 4); }, file));
    }

    void theStationAnswers()
    {
        const QList<Values> six{{24.0F}, {-3.5F}, {745.25F}, {std::nullopt}, {187.5F}, {4.75F}};
        QCOMPARE(encodeAnswer(1, 1, {5, six, {}, {}}), means);
        const QList<Values> two{{24.0F}, {std::nullopt}};
        // The tenth time of the recorded answer stands behind a 0, so it is no event and not sent again.
        QByteArray expected = withEvents;
        expected[expected.size() - 5] = 0;
        expected[expected.size() - 1] = 0x1D;
        QCOMPARE(encodeAnswer(1, 8, {0, two, {12.5F, 0.75F, 9.0F}, {1700003600, -1700000000, 1699990000}}), expected);
        QCOMPARE(encodeAnswer(1, 1, {5, {}, {}, {}}), hex("BB 01 00 00 05 00 00 00 3F"));
        QCOMPARE(encodeConfirmation(3, 0), hex("BB 03 00 00 00 00 00 00 42"));
    }

    void badRequestsAreRefused()
    {
        QVERIFY(!decodeRequest(hex("BB 01 00 00 00 00 00 00 44"))); // an answer
        QVERIFY(!decodeRequest(hex("BB 01 01 02 00 00 00 00 41"))); // data commands have no block
        QVERIFY(!decodeRequest(hex("BB 01 01 00 00 00 00 00 44")));
        QVERIFY(!decodeRequest(file.first(file.size() - 1)));
    }
};

QTEST_GUILESS_MAIN(TstAckMessages)
#include "tst_ackmessages.moc"
