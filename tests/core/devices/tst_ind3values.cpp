#include "core/devices/ind3/ind3values.h"
#include "tests/support/fakeline.h"

#include <QTest>

#include <limits>

using namespace gorizont;
using namespace gorizont::ind3;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// Vectors of spec/ind3.md; the rest was worked out by hand from the layout of the angle block.
class TstInd3Values : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void angleBlock_data();
    void angleBlock();
    void angleBlockIsSixBytes();
    void noNegativeZero();
    void bothSpellingsOfAnAngle();
    void anglesOutOfRange();
    void anglesAreRounded();
    void codes();
    void codesOutOfRange();
    void names_data();
    void names();
    void namesThatDoNotFit_data();
    void namesThatDoNotFit();
    void namesFilledUp();
    void revision();
};

void TstInd3Values::angleBlock_data()
{
    QTest::addColumn<QByteArray>("block");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("x");

    QTest::newRow("read angles") << hex("6A 77 80 38 C2 00") << -(119 + 106 / 256.0) << 194 + 56 / 256.0;
    QTest::newRow("offset") << hex("80 0A 80 20 05 00") << -10.5 << 5.125;
    QTest::newRow("bare block") << hex("40 04 00 00 03 00") << 4.25 << 3.0;
    QTest::newRow("2.10") << hex("E2 7C 00 72 32 81") << 124 + 226 / 256.0 << -(306 + 114 / 256.0);
    QTest::newRow("zero") << hex("00 00 00 00 00 00") << 0.0 << 0.0;
    QTest::newRow("largest in arc-seconds") << hex("FF FF 3F FF FF BF") << 16384 - 1 / 256.0 << -(16384 - 1 / 256.0);
    QTest::newRow("smallest in arc-minutes")
        << hex("12 11 41 12 11 C1") << (273 + 18 / 256.0) * 60 << -(273 + 18 / 256.0) * 60;
    QTest::newRow("largest in arc-minutes")
        << hex("FF FF 7F FF FF FF") << (16384 - 1 / 256.0) * 60 << -(16384 - 1 / 256.0) * 60;
}

void TstInd3Values::angleBlock()
{
    QFETCH(QByteArray, block);
    QFETCH(double, y);
    QFETCH(double, x);

    const auto tilt = decodeAngleBlock(block);
    QVERIFY(tilt);
    QCOMPARE(tilt->y, y);
    QCOMPARE(tilt->x, x);
    QCOMPARE(encodeAngleBlock({x, y}), block);
}

void TstInd3Values::angleBlockIsSixBytes()
{
    QVERIFY(!decodeAngleBlock({}));
    QVERIFY(!decodeAngleBlock(hex("6A 77 80 38 C2")));
    QVERIFY(!decodeAngleBlock(hex("6A 77 80 38 C2 00 00")));
}

void TstInd3Values::noNegativeZero()
{
    const auto tilt = decodeAngleBlock(hex("00 00 80 00 00 C0"));
    QVERIFY(tilt && !std::signbit(tilt->x) && !std::signbit(tilt->y));
    QCOMPARE(encodeAngleBlock({-0.0, -0.001}), hex("00 00 00 00 00 00"));
}

/// A device may write any angle in arc-minutes.
void TstInd3Values::bothSpellingsOfAnAngle()
{
    QCOMPARE(decodeAngleBlock(hex("80 01 40 80 01 C0")), (Tilt{-90, 90}));
}

void TstInd3Values::anglesOutOfRange()
{
    QVERIFY(!encodeAngleBlock({16384.0 * 60, 0}));
    QVERIFY(!encodeAngleBlock({0, -16384.0 * 60}));
    QVERIFY(!encodeAngleBlock({std::numeric_limits<double>::quiet_NaN(), 0}));
    QVERIFY(!encodeAngleBlock({0, std::numeric_limits<double>::infinity()}));
}

void TstInd3Values::anglesAreRounded()
{
    QCOMPARE(encodeAngleBlock({0.999, 0.5 + 0.6 / 256}), hex("81 00 00 00 01 00"));
    QCOMPARE(encodeAngleBlock({16383.999, 0}), hex("00 00 00 11 11 41")); // 273.0667′: no room for 16384″
}

void TstInd3Values::codes()
{
    const QList<int> bauds{1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200};
    for (int i = 0; i < bauds.size(); ++i) {
        QCOMPARE(baudOfCode(i + 1), bauds.at(i));
        QCOMPARE(codeOfBaud(bauds.at(i)), i + 1);
    }
    const QList<int> ticks{1, 2, 4, 8, 16, 32, 64};
    for (int i = 0; i < ticks.size(); ++i) {
        QCOMPARE(ticksOfCode(i), ticks.at(i));
        QCOMPARE(codeOfTicks(ticks.at(i)), i);
    }
    const QList<std::chrono::milliseconds> periods{10ms, 20ms, 50ms, 100ms};
    for (int i = 0; i < periods.size(); ++i) {
        QVERIFY(periodOfCode(i) == periods.at(i));
        QCOMPARE(codeOfPeriod(periods.at(i)), i);
    }
}

void TstInd3Values::codesOutOfRange()
{
    QVERIFY(!baudOfCode(0));
    QVERIFY(!baudOfCode(9));
    QVERIFY(!codeOfBaud(9601));
    QVERIFY(!ticksOfCode(-1));
    QVERIFY(!ticksOfCode(7));
    QVERIFY(!codeOfTicks(3));
    QVERIFY(!codeOfTicks(128));
    QVERIFY(!periodOfCode(-1));
    QVERIFY(!periodOfCode(4));
    QVERIFY(!codeOfPeriod(30ms));
}

void TstInd3Values::names_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");

    QTest::newRow("factory") << QStringLiteral("NO NAME") << hex("4E 4F 20 4E 41 4D 45");
    QTest::newRow("Russian") << QStringLiteral("Новый датчик") << hex("CD EE E2 FB E9 20 E4 E0 F2 F7 E8 EA");
    QTest::newRow("special") << QStringLiteral("№1 «Ё» ё") << hex("B9 31 20 AB A8 BB 20 B8");
    QTest::newRow("sixteen") << QStringLiteral("АБВГДЕЖЗИЙКЛМНОП")
                             << hex("C0 C1 C2 C3 C4 C5 C6 C7 C8 C9 CA CB CC CD CE CF");
}

void TstInd3Values::names()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QCOMPARE(encodeName(name), bytes);
    QCOMPARE(decodeName(bytes), name);
}

void TstInd3Values::namesThatDoNotFit_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("empty") << QString();
    QTest::newRow("seventeen") << QStringLiteral("12345678901234567");
    QTest::newRow("not in Windows-1251") << QStringLiteral("数");
    QTest::newRow("outside the first plane") << QStringLiteral("a😀");
}

void TstInd3Values::namesThatDoNotFit()
{
    QFETCH(QString, name);
    QVERIFY(!encodeName(name));
}

void TstInd3Values::namesFilledUp()
{
    QCOMPARE(decodeName(hex("4E 4F 00 00 00")), QStringLiteral("NO"));
    QCOMPARE(decodeName({}), QString());
}

void TstInd3Values::revision()
{
    const Revision shown{4144};
    QCOMPARE(shown.type(), 2);
    QCOMPARE(shown.revision(), 48);
    const Revision ofTheDocument{199};
    QCOMPARE(ofTheDocument.type(), 0);
    QCOMPARE(ofTheDocument.revision(), 199);
}

QTEST_GUILESS_MAIN(TstInd3Values)
#include "tst_ind3values.moc"
