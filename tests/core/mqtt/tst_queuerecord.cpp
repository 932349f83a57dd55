#include "core/mqtt/queuerecord.h"

#include <QTest>

using namespace gorizont;

/// The check sums were computed bit by bit by another program, which gives 906e for "123456789" as the standard wants.
class TestQueueRecord : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void encodesAndParses_data();
    void encodesAndParses();
    void noShorterLineIsARecord();
    void noFlippedBitIsOverlooked();
    void garbageIsNoRecord_data();
    void garbageIsNoRecord();
};

void TestQueueRecord::encodesAndParses_data()
{
    QTest::addColumn<quint64>("sequence");
    QTest::addColumn<QByteArray>("topic");
    QTest::addColumn<QByteArray>("payload");
    QTest::addColumn<QByteArray>("line");
    QTest::newRow("usual") << quint64{1767225600000000} << QByteArray("sensor/3/reading")
                           << QByteArray("{\"number\":3}")
                           << QByteArray("66f5 1767225600000000 sensor/3/reading {\"number\":3}\n");
    QTest::newRow("short") << quint64{7} << QByteArray("t") << QByteArray("{}") << QByteArray("db83 7 t {}\n");
    QTest::newRow("Cyrillic") << quint64{17} << QByteArray("sensor/12/reading") << QByteArray("{\"name\":\"ИН-Д3\"}")
                              << QByteArray("3bad 17 sensor/12/reading {\"name\":\"ИН-Д3\"}\n");
}

void TestQueueRecord::encodesAndParses()
{
    QFETCH(const quint64, sequence);
    QFETCH(const QByteArray, topic);
    QFETCH(const QByteArray, payload);
    QFETCH(const QByteArray, line);
    const QueuedMessage message{sequence, topic, payload};
    QCOMPARE(encodeRecord(message), line);
    const auto parsed = parseRecord(line.chopped(1));
    QVERIFY(parsed);
    QCOMPARE(parsed->sequence, sequence);
    QCOMPARE(parsed->topic, topic);
    QCOMPARE(parsed->payload, payload);
}

void TestQueueRecord::noShorterLineIsARecord()
{
    const QByteArray line("66f5 1767225600000000 sensor/3/reading {\"number\":3}");
    QVERIFY(parseRecord(line));
    for (qsizetype size = 0; size < line.size(); ++size) {
        QVERIFY2(!parseRecord(line.first(size)), line.first(size));
    }
}

void TestQueueRecord::noFlippedBitIsOverlooked()
{
    const QByteArray line("66f5 1767225600000000 sensor/3/reading {\"number\":3}");
    for (qsizetype bit = 0; bit < line.size() * 8; ++bit) {
        QByteArray flipped = line;
        flipped[bit / 8] = static_cast<char>(flipped.at(bit / 8) ^ (1 << (bit % 8)));
        QVERIFY2(!parseRecord(flipped), flipped);
    }
}

void TestQueueRecord::garbageIsNoRecord_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::newRow("zeros") << QByteArray(100, '\0');
    QTest::newRow("blanks") << QByteArray(100, ' ');
    QTest::newRow("four digits") << QByteArray("0000");
    QTest::newRow("check sum of nothing") << QByteArray("0000 ");
    QTest::newRow("no topic") << QByteArray("b544 7");
    QTest::newRow("no number") << QByteArray("e4db x t {}");
}

void TestQueueRecord::garbageIsNoRecord()
{
    QFETCH(const QByteArray, line);
    QVERIFY(!parseRecord(line));
}

QTEST_APPLESS_MAIN(TestQueueRecord)
#include "tst_queuerecord.moc"
