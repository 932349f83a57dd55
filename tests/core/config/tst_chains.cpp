#include "tests/core/config/configreading.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace Qt::Literals::StringLiterals;

/// [Chain{k}].
class TestChains : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsChainsInAscendingOrder();
    void aChainWithAMistakeIsLeftOut_data();
    void aChainWithAMistakeIsLeftOut();

private:
    /// Inclinometers 1 … 3 and the thermometer 4; \a chains begin in line 14.
    static ConfigReading readSite(const QByteArray &chains);
};

ConfigReading TestChains::readSite(const QByteArray &chains)
{
    return read(
        "[Common]\nNumOfPorts=1\n[Port1]\nOn=1\nNum=3\nNumOfSensors=4\nName1=IN-D3\nadr1=1\nName2=IN-D3\nadr2=2\n"
        "Name3=IN-D3\nadr3=3\nName4=TMP05\n"
        + chains);
}

void TestChains::readsChainsInAscendingOrder()
{
    const ConfigReading reading =
        readSite("[chain12]\nN1=3\nL1=0,5\n[Chain2]\nName=Tower\nN1=2\nL1=3.25\nN2=1\nL2=4\n");
    const QList<ChainConfig> expected{{2, u"Tower"_s, {{2, 3.25}, {1, 4}}}, {12, {}, {{3, 0.5}}}};
    QVERIFY(reading.config.chains == expected);
    QList<bool> areInChain;
    for (const SensorConfig &sensor : reading.config.lines.first().sensors) {
        areInChain.append(sensor.isInChain);
    }
    QCOMPARE(areInChain, QList<bool>({true, true, true, false}));
}

void TestChains::aChainWithAMistakeIsLeftOut_data()
{
    QTest::addColumn<QByteArray>("lines");
    QTest::addColumn<QString>("complaint");
    const auto row = [](const QByteArray &lines, const QString &complaint) {
        QTest::newRow(lines.constData()) << lines << complaint;
    };
    row("Name=a", u"[Chain1], line 14: The chain has no links. The chain is left out."_s);
    row("N1=9\nL1=1", u"[Chain1] N1, line 15: The site has no tilt sensor with number 9. The chain is left out."_s);
    row("N1=4\nL1=1", u"[Chain1] N1, line 15: The site has no tilt sensor with number 4. The chain is left out."_s);
    row("N1=x\nL1=1", u"[Chain1] N1, line 15: “x” is not a whole number. The chain is left out."_s);
    row("N1=1", u"[Chain1], line 14: The length L1 of link 1, in metres, is missing. The chain is left out."_s);
    row("N1=1\nL1=0", u"[Chain1] L1, line 16: “0” is outside 0.001…1000. The chain is left out."_s);
    row("N1=1\nL1=2\nN2=1\nL2=2",
        u"[Chain1] N2, line 17: Sensor 1 stands in a chain already. The chain is left out."_s);
}

void TestChains::aChainWithAMistakeIsLeftOut()
{
    QFETCH(const QByteArray, lines);
    QFETCH(const QString, complaint);
    const ConfigReading reading = readSite("[Chain1]\n" + lines + "\n[Chain2]\nN1=1\nL1=1\n");
    QVERIFY2(complaintTexts(reading).contains(complaint), qPrintable(complaintTexts(reading).join(u'\n')));
    // What the broken chain named is free for others.
    QCOMPARE(reading.config.chains.size(), 1);
    QCOMPARE(reading.config.chains.first().index, 2);
}

QTEST_APPLESS_MAIN(TestChains)

#include "tst_chains.moc"
