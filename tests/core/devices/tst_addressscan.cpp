#include "core/devices/addressscan.h"

#include <QTest>

using namespace gorizont;

class TstAddressScan : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void emptyLine();
    void findsAndSorts();
    void stopped();
    void partOfTheLine();
    void lostLineIsNoFinding();
    void impossibleRanges_data();
    void impossibleRanges();
};

namespace {

const Result<void> there;

/// Everybody who is not named is silent. Returns the addresses in the order in which they were asked for.
QList<int> run(AddressScan &scan, const QHash<int, Result<void>> &answers = {}, int steps = 1000)
{
    QList<int> asked;
    for (int i = 0; i < steps && scan.next() != 0; ++i) {
        asked.append(scan.next());
        scan.record(answers.value(scan.next(), Fault::Timeout));
    }
    return asked;
}

QList<int> range(int from, int to)
{
    QList<int> list;
    for (int address = from; address <= to; ++address) {
        list.append(address);
    }
    return list;
}

} // namespace

void TstAddressScan::emptyLine()
{
    AddressScan scan;
    QCOMPARE(scan.count(), 255);
    QCOMPARE(scan.probed(), 0);
    QVERIFY(!scan.isComplete());
    QCOMPARE(scan.free(), QList<int>());
    QCOMPARE(run(scan), range(1, 255));
    QCOMPARE(scan.next(), 0);
    QVERIFY(scan.isComplete());
    QCOMPARE(scan.found(), QList<int>());
    QCOMPARE(scan.unclear(), QList<int>());
    QCOMPARE(scan.free(), range(1, 255));
    scan.record(there); // nobody asked
    QCOMPARE(scan.probed(), 255);
    QCOMPARE(scan.found(), QList<int>());
}

void TstAddressScan::findsAndSorts()
{
    AddressScan scan;
    run(scan,
        {{255, there}, {1, there}, {24, there}, {7, Fault::Checksum}, {9, Fault::BadReply}, {11, Fault::Refused}});
    QCOMPARE(scan.found(), (QList<int>{1, 24, 255}));
    QCOMPARE(scan.unclear(), (QList<int>{7, 9, 11}));
    QCOMPARE(scan.free().size(), 249);
    for (const int taken : {1, 7, 9, 11, 24, 255}) {
        QVERIFY(!scan.free().contains(taken));
    }
}

/// Only a complete scan knows what is free.
void TstAddressScan::stopped()
{
    AddressScan scan;
    run(scan, {{3, there}}, 254);
    QCOMPARE(scan.probed(), 254);
    QCOMPARE(scan.found(), QList<int>{3});
    QVERIFY(!scan.isComplete());
    QCOMPARE(scan.free(), QList<int>());
}

void TstAddressScan::partOfTheLine()
{
    AddressScan scan(10, 12);
    QCOMPARE(scan.count(), 3);
    QCOMPARE(run(scan, {{11, there}}), (QList<int>{10, 11, 12}));
    QCOMPARE(scan.found(), QList<int>{11});
    QVERIFY(!scan.isComplete());
    QCOMPARE(scan.free(), QList<int>());
}

/// The address has to be asked again.
void TstAddressScan::lostLineIsNoFinding()
{
    AddressScan scan;
    scan.record(there);
    scan.record(Fault::Closed);
    scan.record(Fault::Cancelled);
    QCOMPARE(scan.next(), 2);
    QCOMPARE(scan.probed(), 1);
    QCOMPARE(scan.found(), QList<int>{1});
}

void TstAddressScan::impossibleRanges_data()
{
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    QTest::addColumn<QList<int>>("asked");
    QTest::newRow("too wide") << -5 << 1000 << range(1, 255);
    QTest::newRow("backwards") << 9 << 3 << QList<int>{9};
    QTest::newRow("beyond") << 300 << 400 << QList<int>{255};
}

void TstAddressScan::impossibleRanges()
{
    QFETCH(int, from);
    QFETCH(int, to);
    QFETCH(QList<int>, asked);
    AddressScan scan(from, to);
    QCOMPARE(run(scan), asked);
}

QTEST_GUILESS_MAIN(TstAddressScan)
#include "tst_addressscan.moc"
