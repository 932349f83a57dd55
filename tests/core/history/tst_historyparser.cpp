#include "core/history/historyparser.h"

#include <QTest>

using namespace gorizont;

namespace {

/// spec/gorizont.md, section 3.
const QByteArray line = "18:33:03 07.02.18\t3300\t  -264.0\t -6644.6\t\t     0.0\t 0 0011 0011 1000"
                        "\t -3599.5\t -3599.5\t   21.38\t     0.0\t 0 0000 0001 1000\r\n";

} // namespace

/// Old records, whole and damaged.
class TestHistoryParser : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theLineOfTheManual()
    {
        const std::optional<HistoryRow> row = HistoryRow::parse(line);
        QVERIFY(row);
        QCOMPARE(row->date(), QDate(2018, 2, 7));
        QCOMPARE(row->time(), QTime(18, 33, 3));
        QCOMPARE(row->groups(), 2);
        QCOMPARE(row->group(0), (HistoryGroup{{-264.0, -6644.6, std::nullopt, 0.0}, 0x0338}));
        QCOMPARE(row->group(1), (HistoryGroup{{-3599.5, -3599.5, 21.38, 0.0}, 0x0018}));
        QVERIFY(!row->group(2));
        QVERIFY(!row->group(-1));
    }

    /// spec/gorizont.md, section 3: code in decimal, the other bits in binary.
    void statusWords()
    {
        QCOMPARE(parseStatusDigits("10 0000 0001 0100"), quint16{0xA014});
        QCOMPARE(parseStatusDigits(" 0 1111 0000 0000"), quint16{0x0F00});
        QCOMPARE(parseStatusDigits(" 1 0111 0000 0000"), quint16{0x1700});
        for (const char *damaged :
             {"", "10", "16 0000 0000 0000", "   0000 0000 0000", " 0 0000 0000 000", " 0 0000 0000 00002",
              " 0 0002 0000 0000", " 0 0000-0000 0000", "-1 0000 0000 0000"}) {
            QVERIFY2(!parseStatusDigits(damaged), damaged);
        }
    }

    /// A torn line gives its whole groups and never a value that is cut short.
    void everyBeginningOfTheLine()
    {
        const std::optional<HistoryRow> whole = HistoryRow::parse(line);
        for (qsizetype size = 0; size < line.size() - 2; ++size) {
            const std::optional<HistoryRow> row = HistoryRow::parse(QByteArrayView(line).first(size));
            for (qsizetype group = 0; row && group < 2; ++group) {
                const std::optional<HistoryGroup> read = row->group(group);
                QVERIFY(!read || read == whole->group(group));
            }
            QVERIFY(!row || !row->group(1));
        }
    }

    void whatIsNoRecord_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("nothing") << QByteArray();
        QTest::newRow("line end") << QByteArray("\r\n");
        QTest::newRow("hour") << QByteArray("24:00:00 07.02.18\t3300");
        QTest::newRow("day") << QByteArray("18:33:03 30.02.18\t3300");
        QTest::newRow("letters") << QByteArray("18:3a:03 07.02.18\t3300");
        QTest::newRow("no tab") << QByteArray("18:33:03 07.02.18 3300");
        QTest::newRow("zeros") << QByteArray(400, '\0');
        QTest::newRow("Windows-1251") << QByteArray(
            "\xcf\xf0\xee\xe3\xf0\xe0\xec\xec\xe0 \xe7\xe0\xef\xf3\xf9\xe5\xed\xe0\t");
    }
    void whatIsNoRecord()
    {
        QFETCH(QByteArray, text);
        QVERIFY(!HistoryRow::parse(text));
    }

    /// A field that is no number is absent; its neighbours stay.
    void damagedFields()
    {
        const std::optional<HistoryRow> row =
            HistoryRow::parse("18:33:03 07.02.18\t3300\t-264,5\t\xcf\xf0\t 1e400\t1.5x\t 0 0000 0000 "
                              "0000\t1\t2\t3\t4\t?\t5\t6\t7\t8\t 0 0000 0000 0000");
        QVERIFY(row);
        QCOMPARE(row->group(0), (HistoryGroup{{-264.5, std::nullopt, std::nullopt, std::nullopt}, 0}));
        QVERIFY(!row->group(1)); // nobody knows what they were worth
        QCOMPARE(row->group(2), (HistoryGroup{{5.0, 6.0, 7.0, 8.0}, 0}));
    }

    void readings()
    {
        const Reading tilt = tiltReading({{-264.0, -6644.6, std::nullopt, 12.5}, 0x0338});
        QCOMPARE(tilt.tilt, (Tilt{-264.0, -6644.6}));
        QCOMPARE(tilt.heaterPower, 12.5);
        QCOMPARE(tilt.status, 0x0338);
        QVERIFY(!tilt.temperature);
        QVERIFY(!tiltReading({{1.0, std::nullopt, 2.0, 3.0}, 0}).tilt);
        const Reading moved = accelerationReading({{-3.0, -4.0, 5.0, 12.0}, 0});
        QCOMPARE(moved.acceleration->maximum, 5.0);
        QCOMPARE(moved.acceleration->rms, 13.0);
        QVERIFY(std::abs(moved.acceleration->direction - 233.13010235415598) < 1e-9); // 180° + atan(4/3)
        QVERIFY(!accelerationReading({{-3.0, std::nullopt, 5.0, 12.0}, 0}).acceleration);
    }

    /// spec/gorizont.md, section 4.
    void sampleFiles()
    {
        const std::optional<SampleFileName> name = parseSampleFileName(QStringLiteral("16_03_29_22_46_09_12X.wrd"));
        QVERIFY(name);
        QCOMPARE(name->start.date(), QDate(2016, 3, 29));
        QCOMPARE(name->start.time(), QTime(22, 46, 9));
        QCOMPARE(name->number, 12);
        QCOMPARE(name->axis, 'X');
        for (const char *other :
             {"", "16_03_29_22_46_09_X.wrd", "16_03_29_22_46_09_1Z.wrd", "16_13_29_22_46_09_1X.wrd",
              "16_03_29_22_46_09_1X.txt", "16_03_29-22_46_09_1X.wrd", "copy of 16_03_29_22_46_09_1X.wrd",
              "16_03_29_22_46_09_1234567X.wrd"}) {
            QVERIFY2(!parseSampleFileName(QString::fromLatin1(other)), other);
        }
    }
};

QTEST_APPLESS_MAIN(TestHistoryParser)
#include "tst_historyparser.moc"
