#include "tests/core/modbus/answeredsite.h"

#include <QTest>
#include <QtEndian>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// What a client that asks unit 1 gets: whole requests and answers, refusals, and the clocks of the moment.
class TestExtendedMapRequests : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void bothFunctionsReadTheSame()
    {
        const UnitImages images = answered();
        QCOMPARE(
            ask(images, "0001 0000 0006 01 04 0C2C 0002").toHex(), hex("0001 0000 0007 01 04 04 C5610000").toHex());
        QCOMPARE(
            ask(images, "0001 0000 0006 01 03 0C2C 0002").toHex(), hex("0001 0000 0007 01 03 04 C5610000").toHex());
    }

    void refusals_data()
    {
        QTest::addColumn<QByteArray>("request");
        QTest::addColumn<QByteArray>("answer");
        const auto row = [](const char *name, const char *request, const char *answer) {
            QTest::newRow(name) << QByteArray(request) << hex(answer);
        };
        row("function 1", "0001 0000 0006 01 01 0000 0001", "0001 0000 0003 01 81 01");
        row("function 6", "0001 0000 0006 01 06 0000 0001", "0001 0000 0003 01 86 01");
        row("function 16", "0001 0000 0009 01 10 0000 0001 02 0000", "0001 0000 0003 01 90 01");
        row("function 23", "0001 0000 000D 01 17 0000 0001 0000 0001 02 0000", "0001 0000 0003 01 97 01");
        row("quantity 0", "0001 0000 0006 01 03 0000 0000", "0001 0000 0003 01 83 03");
        row("quantity 126", "0001 0000 0006 01 03 0000 007E", "0001 0000 0003 01 83 03");
        row("quantity before address", "0001 0000 0006 01 04 FFFF 007E", "0001 0000 0003 01 84 03");
        row("beyond the last block", "0001 0000 0006 01 03 0D47 0002", "0001 0000 0003 01 83 02"); // 3399, 3400
        row("address and quantity wrap", "0001 0000 0006 01 03 FFFF 0002", "0001 0000 0003 01 83 02");
        row("unit 3 has no holding registers", "0001 0000 0006 03 03 0000 0001", "0001 0000 0003 03 83 01");
        row("unit 6 has no holding registers", "0001 0000 0006 06 03 0000 0001", "0001 0000 0003 06 83 01");
    }

    void refusals()
    {
        QFETCH(const QByteArray, request);
        const UnitImages images(modbusSite());
        QTEST(ask(images, request.constData()), "answer");
    }

    void oneRequestReadsABlock()
    {
        const UnitImages images = answered();
        const QByteArray block = ask(images, "0001 0000 0006 01 04 0C1C 007D"); // 3100, 125 registers
        QCOMPARE(block.size(), 9 + 250);
        QCOMPARE(block.mid(9, 4), hex("0000 0002"));
        QCOMPARE(block.mid(9 + 200, 4), hex("0000 0004")); // and the start of the next
    }

    void clocksAreOfTheAnswer()
    {
        const SteadyTime answeredAt = SteadyTime::clock::now();
        UnitImages images(modbusSite());
        Reading reading = answer();
        reading.answeredAt = answeredAt;
        images.update(reading);
        QVERIFY(images.unit(1)->hasClocks());
        // 1234 ms after the answer, at 2018-02-07 10:33:04.690 UTC: 1517999584690 = 161 6FD375B2h.
        const Moment now{UtcTime(1517999584690000us), answeredAt + 1234ms};
        QByteArray head(2 * 6, 'x');
        images.unit(1)->writeClocks(head.data(), 7, 6, now);
        QCOMPARE(head.first(2), QByteArray("xx"));
        QCOMPARE(head.sliced(2, 8).toHex(), hex("0000 0161 6FD3 75B2").toHex());
        // Only its middle asked for.
        QByteArray middle(2 * 2, 'x');
        images.unit(1)->writeClocks(middle.data(), 9, 2, now);
        QCOMPARE(middle.toHex(), hex("0161 6FD3").toHex());
        // Ages of N=1 (never answered) and N=2: 1234 = 4D2h. The rest is left alone.
        QByteArray blocks(2 * 125, 'x');
        images.unit(1)->writeClocks(blocks.data(), 3000, 125, now);
        QCOMPARE(blocks.sliced(20, 4).toHex(), hex("FFFF FFFF").toHex());
        QCOMPARE(blocks.sliced(220, 4).toHex(), hex("0000 04D2").toHex());
        QCOMPARE(blocks.count('x'), 250 - 8);
        QByteArray half(2, 'x');
        images.unit(1)->writeClocks(half.data(), 3111, 1, now);
        QCOMPARE(half.toHex(), hex("04D2").toHex());
        // A clock that is behind the reading shows 0, not 49 days.
        images.unit(1)->writeClocks(half.data(), 3111, 1, {now.utc, answeredAt - 1ms});
        QCOMPARE(half.toHex(), hex("0000").toHex());
    }

    void answersCarryTheClocks()
    {
        const UnitImages images = answered();
        const auto ms = [] {
            return std::chrono::floor<std::chrono::milliseconds>(utcNow().time_since_epoch()).count();
        };
        const auto before = ms();
        const QByteArray answer = ask(images, "0001 0000 0006 01 03 0008 0006");
        const auto after = ms();
        QCOMPARE(answer.size(), 9 + 12);
        const auto served = qFromBigEndian<qint64>(answer.constData() + 9);
        QVERIFY(served >= before && served <= after);
        const QByteArray later = ask(images, "0001 0000 0006 01 03 0C26 0002"); // 3110: the age of N=2
        QVERIFY(qFromBigEndian<quint32>(later.constData() + 9) < 100000U);
    }

    void units3And6HaveNoClocks()
    {
        const UnitImages images(modbusSite());
        QVERIFY(!images.unit(3)->hasClocks());
        QVERIFY(!images.unit(6)->hasClocks());
    }
};

QTEST_APPLESS_MAIN(TestExtendedMapRequests)
#include "tst_extendedmaprequests.moc"
