#include "core/devices/usmisn/usmisnrecords.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::usmisn;

class TstUsmisnRecords : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachOnce();
    void onlyStoredOnes();
    void inOrder();
    void missing_data();
    void missing();
    void table();
    void notOfTheTable_data();
    void notOfTheTable();
    void forTheArchive();
    void saysWhatTheSensorMeasured();
};

namespace {

Value record(quint32 measurement, int channel = 1, quint32 serial = 1234567)
{
    Value value;
    value.timestamp = 1483267255;
    value.channel = ChannelId::of(serial, channel);
    value.measurement = measurement;
    value.value = -2.48289;
    value.variation = 0.0086;
    value.temperature = 26.33;
    return value;
}

} // namespace

void TstUsmisnRecords::eachOnce()
{
    RecordBook book;
    QVERIFY(book.add(record(1)));
    QVERIFY(!book.add(record(1)));
    QVERIFY(book.add(record(1, 2))); // the other channel
    QVERIFY(book.add(record(1, 1, 7))); // another device
    QCOMPARE(book.size(), 3);
}

void TstUsmisnRecords::onlyStoredOnes()
{
    RecordBook book;
    Value value = record(5);
    value.timestamp = 0;
    QVERIFY(!book.add(value));
    value = record(5);
    value.state = ValueState::ErrorSensor;
    QVERIFY(!book.add(value));
    value.state = ValueState::OutOfRange;
    QVERIFY(book.add(value));
}

void TstUsmisnRecords::inOrder()
{
    RecordBook book;
    for (const quint32 measurement : {9U, 3U, 4294967295U, 4U}) {
        book.add(record(measurement));
    }
    QList<quint32> measurements;
    for (const Value &value : book.records()) {
        measurements.append(value.measurement);
    }
    QCOMPARE(measurements, (QList<quint32>{3, 4, 9, 4294967295U}));
}

void TstUsmisnRecords::missing_data()
{
    QTest::addColumn<QList<quint32>>("ofX");
    QTest::addColumn<QList<quint32>>("ofY");
    QTest::addColumn<qint64>("expected");
    QTest::newRow("none") << QList<quint32>{} << QList<quint32>{} << qint64(0);
    QTest::newRow("one") << QList<quint32>{100} << QList<quint32>{} << qint64(0);
    QTest::newRow("a row") << QList<quint32>{45610, 45611, 45612} << QList<quint32>{} << qint64(0);
    QTest::newRow("two lost") << QList<quint32>{10, 11, 14} << QList<quint32>{} << qint64(2);
    QTest::newRow("axes by turns") << QList<quint32>{1, 3, 5} << QList<quint32>{2, 4, 6} << qint64(0);
    QTest::newRow("axes together") << QList<quint32>{1, 2, 3} << QList<quint32>{1, 2, 3} << qint64(0);
    QTest::newRow("one of the other axis") << QList<quint32>{1, 3, 5} << QList<quint32>{2} << qint64(1);
}

void TstUsmisnRecords::missing()
{
    QFETCH(QList<quint32>, ofX);
    QFETCH(QList<quint32>, ofY);
    QFETCH(qint64, expected);
    RecordBook book;
    for (const quint32 measurement : ofX) {
        book.add(record(measurement, 1));
    }
    for (const quint32 measurement : ofY) {
        book.add(record(measurement, 2));
    }
    QCOMPARE(book.missing(), expected);
    book.add(record(1'000'000, 1, 9)); // another device has a counter of its own
    QCOMPARE(book.missing(), expected);
}

void TstUsmisnRecords::table()
{
    QCOMPARE(csv::header(), QByteArray("time,timestamp,serial,channel,measurement,value,variation,temperature\r\n"));
    const QByteArray line = "2017-01-01T10:40:55Z,1483267255,01234567,1,45612,-2.48289,0.00860,26.33\r\n";
    QCOMPARE(csv::line(record(45612)), line);
    const auto parsed = csv::parse(line);
    QVERIFY(parsed);
    QVERIFY(*parsed == record(45612));

    Value out = record(45612, 2);
    out.state = ValueState::OutOfRange;
    out.value = 0;
    const QByteArray empty = "2017-01-01T10:40:55Z,1483267255,01234567,2,45612,,0.00860,26.33\r\n";
    QCOMPARE(csv::line(out), empty);
    QVERIFY(*csv::parse(empty) == out);
}

void TstUsmisnRecords::notOfTheTable_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::newRow("header") << csv::header();
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("broken off") << QByteArray("2017-01-01T10:40:55Z,1483267255,01234567,1,45612,-2.48289,0.00860");
    QTest::newRow("text") << QByteArray("2017-01-01T10:40:55Z,1483267255,01234567,1,45612,x,0.00860,26.33");
    QTest::newRow("no time") << QByteArray(",0,01234567,1,45612,1.0,0.00860,26.33");
}

void TstUsmisnRecords::notOfTheTable()
{
    QFETCH(QByteArray, line);
    QVERIFY(!csv::parse(line));
}

/// Under channel and number, at the time of the device: so that it is there once.
void TstUsmisnRecords::forTheArchive()
{
    const DeviceRecord kept = deviceRecord(record(45612), 7);
    QCOMPARE(kept.number, 7);
    QCOMPARE(kept.name, QStringLiteral("0123456701 45612"));
    QVERIFY(kept.start == UtcTime(std::chrono::seconds(1483267255)));
    QCOMPARE(kept.data, QByteArray("2017-01-01T10:40:55Z,1483267255,01234567,1,45612,-2.48289,0.00860,26.33\r\n"));
}

/// 3.6″ is 0.001°. Whoever lacks its other axis says nothing.
void TstUsmisnRecords::saysWhatTheSensorMeasured()
{
    SensorConfig sensor;
    sensor.number = 5;
    sensor.isYInverted = true;
    sensor.offsetX = 0.6;
    sensor.offsetT = 1;
    RecordBook book;
    const auto add = [&book](quint32 measurement, int channel, qint64 timestamp, double value) {
        Value one = record(measurement, channel);
        one.timestamp = timestamp;
        one.value = value;
        QVERIFY(book.add(one));
    };
    add(1, 1, 1000, 0.001);
    add(2, 2, 1001, 0.002);
    add(3, 2, 1900, 0.004); // X of it is lost
    add(5, 1, 2800, 0.003);
    add(6, 2, 3700, 0.005); // of another time
    add(7, 1, 4600, -0.001);
    add(8, 2, 4600, 0);
    Value outOfRange = record(9, 1);
    outOfRange.timestamp = 5500;
    outOfRange.state = ValueState::OutOfRange;
    QVERIFY(book.add(outOfRange));
    add(10, 2, 5501, 1);
    const Readings readings = readingsOf(book.records(), sensor);
    QCOMPARE(readings.size(), 2);
    QCOMPARE(readings.first().number, 5);
    QVERIFY(readings.first().time == UtcTime(std::chrono::seconds(1000)));
    QVERIFY(readings.first().isAnswer);
    QCOMPARE(readings.first().tilt.value().x, 3.0);
    QCOMPARE(readings.first().tilt.value().y, -7.2);
    QCOMPARE(readings.first().temperature.value(), 25.33);
    QVERIFY(readings.last().time == UtcTime(std::chrono::seconds(4600)));
    QCOMPARE(readings.last().tilt.value().x, -4.2);
}

QTEST_GUILESS_MAIN(TstUsmisnRecords)
#include "tst_usmisnrecords.moc"
