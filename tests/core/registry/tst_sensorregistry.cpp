#include "core/registry/journal.h"
#include "core/registry/sensorregistry.h"

#include <QSignalSpy>
#include <QTest>

using namespace gorizont;

namespace {

SensorConfig sensor(int port, int index, int number, bool isOn = true)
{
    SensorConfig sensor;
    sensor.port = port;
    sensor.index = index;
    sensor.number = number;
    sensor.isOn = isOn;
    sensor.measuresTilt = true;
    return sensor;
}

/// Port 1 is on with sensors 5 and 2 (off), port 3 is off with sensor 4.
QList<LineConfig> lines()
{
    LineConfig first;
    first.index = 1;
    first.isOn = true;
    first.sensors = {sensor(1, 1, 5), sensor(1, 2, 2, false)};
    LineConfig third;
    third.index = 3;
    third.sensors = {sensor(3, 1, 4)};
    return {first, third};
}

} // namespace

class TestSensorRegistry : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sensorsAscendAndLinesKeepTheOrderOfTheIni()
    {
        const SensorRegistry registry(lines(), {});
        QCOMPARE(registry.sensors().size(), 3u);
        QCOMPARE(registry.sensors()[0].config.number, 2);
        QCOMPARE(registry.sensors()[1].config.number, 4);
        QCOMPARE(registry.sensors()[2].config.number, 5);
        QCOMPARE(registry.lines()[0].sensors, (std::vector<int>{2, 0}));
        QCOMPARE(registry.sensors()[1].line, 1);
        QCOMPARE(registry.indexOf(4), 1);
        QCOMPARE(registry.indexOf(99), -1);
        QCOMPARE(registry.lineIndexOf(3), 1);
        QCOMPARE(registry.lineIndexOf(2), -1);
    }

    void startsWithTheWordsOfWhatWasNotTriedYet()
    {
        const SensorRegistry registry(lines(), {});
        const Readings readings = registry.readings();
        QCOMPARE(readings.at(0).status, quint16(0x0F00)); // switched off
        QCOMPARE(readings.at(1).status, quint16(0x1700)); // its port is off
        QCOMPARE(readings.at(2).status, quint16(0x0700)); // no answer yet
        QCOMPARE(registry.lineStatuses().at(0).state, LineState::Opening);
        QCOMPARE(registry.lineStatuses().at(1).state, LineState::Off);
    }

    void takesOverBatchesAndPassesThemOn()
    {
        SensorRegistry registry(lines(), {});
        const QSignalSpy changes(&registry, &SensorRegistry::readingsChanged);
        Reading reading;
        reading.number = 5;
        reading.tilt = Tilt{1.5, -2.5};
        Reading stranger;
        stranger.number = 77;
        registry.update({reading, stranger});
        QCOMPARE(registry.sensors()[2].reading, reading);
        QCOMPARE(changes.size(), 1); // one signal a batch
    }

    /// Sensor 4 stands on 5: thirty degrees over 2 m are 1000 mm, over 1 m 500 mm.
    void readingsOfAChainSayTheirDisplacement()
    {
        SensorRegistry registry(lines(), {});
        const ChainConfig chain{1, {}, {{5, 2}, {4, 1}}};
        registry.setChains({chain});
        QList<Reading> told;
        connect(&registry, &SensorRegistry::readingsChanged, this, [&](const Readings &batch) { told = batch; });
        Reading upper;
        upper.number = 4;
        upper.tilt = Tilt{108000, 0};
        registry.update({upper});
        QCOMPARE(told.at(0).displacement.value().own.x, 500.0);
        QVERIFY(!told.at(0).displacement.value().sum); // nothing is known of the lower one
        Reading lower = upper;
        lower.number = 5;
        Reading apart = upper;
        apart.number = 2;
        registry.update({lower, upper, apart});
        QCOMPARE(told.at(1).displacement.value().sum.value().x, 1500.0);
        QVERIFY(!told.at(2).displacement);
        QCOMPARE(registry.sensors()[1].reading.displacement, told.at(1).displacement);
        lower.status = 0x3700;
        registry.update({lower});
        QVERIFY(!told.at(0).displacement);
        QVERIFY(!registry.nodesOf(chain).back().sum);
    }

    void takesOverLineStates()
    {
        SensorRegistry registry(lines(), {});
        const QSignalSpy changes(&registry, &SensorRegistry::lineChanged);
        LineStatus status;
        status.port = 3;
        status.state = LineState::Lost;
        registry.updateLine(status);
        QCOMPARE(registry.lines()[1].status.state, LineState::Lost);
        status.port = 9;
        registry.updateLine(status);
        QCOMPARE(changes.size(), 1); // nobody hears of a port that is not in the ini
    }

    void journalKeepsTheNewest()
    {
        Journal journal;
        const QSignalSpy added(&journal, &Journal::added);
        for (std::size_t i = 0; i < Journal::capacity + 5; ++i) {
            journal.add(JournalKind::Info, QString::number(i));
        }
        QCOMPARE(journal.entries().size(), Journal::capacity);
        QCOMPARE(journal.entries().front().text, QStringLiteral("5"));
        QCOMPARE(journal.total(), quint64(Journal::capacity + 5));
        QCOMPARE(added.size(), static_cast<qsizetype>(Journal::capacity + 5));
    }

    void informationStaysWithItsSensor()
    {
        SensorRegistry registry(lines(), {});
        QCOMPARE(registry.sensors()[2].information.firmware, QString());
        DeviceInformation information;
        information.number = 5;
        information.firmware = QStringLiteral("2.3.12");
        registry.setInformation(information);
        QVERIFY(registry.sensors()[2].information == information);
        QCOMPARE(registry.sensors()[1].information.firmware, QString());
        information.number = 99;
        registry.setInformation(information); // of nobody
    }
};

QTEST_GUILESS_MAIN(TestSensorRegistry)
#include "tst_sensorregistry.moc"
