#include "app/opc-da/pure/types.h"
#include "app/opc-da/pure/values.h"

#include <QTest>

#include <limits>

using namespace opcda;

class TestOpcGateValues : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsNews_data();
    void tellsNews();
    void revisesRates_data();
    void revisesRates();
    void revisesKeepAlive();
    void knowsAges();
    void offersTypes_data();
    void offersTypes();
    void filtersTypes();
};

void TestOpcGateValues::tellsNews_data()
{
    QTest::addColumn<double>("before");
    QTest::addColumn<double>("after");
    QTest::addColumn<double>("percent");
    QTest::addColumn<double>("high"); // of a scale from 0
    QTest::addColumn<bool>("isNewsNow");
    QTest::newRow("same") << 1.0 << 1.0 << 0.0 << 100.0 << false;
    QTest::newRow("no deadband") << 1.0 << 1.001 << 0.0 << 100.0 << true;
    QTest::newRow("inside") << 10.0 << 14.0 << 5.0 << 100.0 << false;
    QTest::newRow("on the edge") << 10.0 << 15.0 << 5.0 << 100.0 << false;
    QTest::newRow("outside") << 10.0 << 15.5 << 5.0 << 100.0 << true;
    QTest::newRow("outside below") << 10.0 << 4.5 << 5.0 << 100.0 << true;
    QTest::newRow("whole scale") << 0.0 << 100.0 << 100.0 << 100.0 << false;
    QTest::newRow("no scale") << 10.0 << 10.1 << 50.0 << 0.0 << true;
}

void TestOpcGateValues::tellsNews()
{
    QFETCH(double, before);
    QFETCH(double, after);
    QFETCH(double, percent);
    QFETCH(double, high);
    const TagState sent{before, quality::Good, 1, 1};
    const TagState now{after, quality::Good, 2, 2};
    QTEST(isNews(sent, now, percent, 0, high), "isNewsNow");
    QVERIFY(isNews(sent, TagState{before, quality::CommFailure, 2, 2}, percent, 0, high));
    // A deadband is of numbers only.
    QVERIFY(isNews(TagState{false, quality::Good, 1, 1}, TagState{true, quality::Good, 2, 2}, 100, 0, 100));
    QVERIFY(isNews(TagState{{}, quality::Good, 1, 1}, now, 100, 0, 100));
    QVERIFY(!isNews(TagState{true, quality::Good, 1, 1}, TagState{true, quality::Good, 2, 2}, 0, 0, 0));
}

void TestOpcGateValues::revisesRates_data()
{
    QTest::addColumn<quint32>("asked");
    QTest::addColumn<quint32>("given");
    QTest::newRow("fastest") << 0u << 50u;
    QTest::newRow("least") << 50u << 50u;
    QTest::newRow("between") << 51u << 100u;
    QTest::newRow("second") << 1000u << 1000u;
    QTest::newRow("most") << std::numeric_limits<quint32>::max() << 4294967250u;
    QTest::newRow("nearly most") << 4294967249u << 4294967250u;
}

void TestOpcGateValues::revisesRates()
{
    QFETCH(quint32, asked);
    QTEST(quint32(revisedRate(asked)), "given");
}

void TestOpcGateValues::revisesKeepAlive()
{
    QCOMPARE(revisedKeepAlive(0), 0u);
    QCOMPARE(revisedKeepAlive(1), 100u);
    QCOMPARE(revisedKeepAlive(5000), 5000u);
}

void TestOpcGateValues::knowsAges()
{
    QVERIFY(isYoung(1000, 1500, 500));
    QVERIFY(!isYoung(1000, 1501, 500));
    QVERIFY(isYoung(1000, 500, 0)); // the clock was set back
    QVERIFY(isYoung(0, 4000000000, 0xFFFFFFFF));
}

void TestOpcGateValues::offersTypes_data()
{
    QTest::addColumn<int>("type");
    QTest::addColumn<bool>("isOffer");
    // Numbers of VARTYPE as [MS-OAUT] 2.2.7 gives them.
    for (const int type : {0, 2, 3, 4, 5, 6, 7, 8, 11, 14, 16, 17, 18, 19, 20, 21, 22, 23})
        QTest::addRow("type %d", type) << type << true;
    for (const int type : {1, 9, 10, 12, 13, 15, 24, 36, 64, 0x2005, 0x4005, 0xFFFF})
        QTest::addRow("type %d", type) << type << false;
}

void TestOpcGateValues::offersTypes()
{
    QFETCH(int, type);
    QTEST(isOffered(static_cast<std::uint16_t>(type)), "isOffer");
}

void TestOpcGateValues::filtersTypes()
{
    QCOMPARE(canonicalType(TagType::Bool), std::uint16_t{11});
    QCOMPARE(canonicalType(TagType::Double), std::uint16_t{5});
    QVERIFY(passesFilter(TagType::Bool, 0));
    QVERIFY(passesFilter(TagType::Double, 5));
    QVERIFY(!passesFilter(TagType::Double, 11));
}

QTEST_APPLESS_MAIN(TestOpcGateValues)
#include "tst_opcgatevalues.moc"
