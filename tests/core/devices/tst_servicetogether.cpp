#include "core/devices/addressscan.h"
#include "core/devices/and3/and3service.h"
#include "core/devices/and3/and3simulator.h"
#include "core/devices/ind3/ind3service.h"
#include "core/devices/ind3/ind3simulator.h"
#include "tests/support/simulatedtime.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// The services and the simulators, each written from the description on its own, on lines where things go wrong: what a
/// service says is so, and it says it in time.
class TstServiceTogether : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void scansInd3();
    void scansAnd3();
    void inclinometers_data();
    void inclinometers();
    void accelerometers_data();
    void accelerometers();
    void lostAnswersOnly();
    void readdressesAndResets();
};

namespace {

constexpr auto patience = 200ms; ///< TORCom of the tests

/// Of one exchange beside the wait for its answer: silence before it, the bytes of the longest answer.
constexpr auto besidePatience = 40ms;

SensorConfig sensor(SensorType type, int number, int address, const QString &protocol = {})
{
    SensorConfig sensor;
    sensor.type = type;
    sensor.number = number;
    sensor.address = address;
    sensor.serialNumber = QString::number(1886 + number);
    sensor.options.insert(QStringLiteral("protocol"), protocol);
    return sensor;
}

LineConfig lineWith(const QList<SensorConfig> &sensors)
{
    LineConfig line;
    line.index = 1;
    line.sensors = sensors;
    return line;
}

template <typename Device> const Device &deviceOf(const SimulatedTimeLine &line)
{
    return dynamic_cast<const Device &>(*line.bus().devices().front());
}

AddressScan scanWith(const auto &service, Line &line)
{
    AddressScan scan;
    while (scan.next() != 0) {
        scan.record(service.probe(line, scan.next()));
    }
    return scan;
}

FaultPlan planOf(const QStringList &faults)
{
    FaultPlan plan;
    for (const QString &fault : faults) {
        plan.append(*parseSimulatedFault(fault));
    }
    return plan;
}

void addFaults(const QString &column)
{
    const QList<QStringList> plans{
        {},
        {QStringLiteral("silent=1")},
        {QStringLiteral("crc=30")},
        {QStringLiteral("crc=100")},
        {QStringLiteral("garbage=100")},
        {QStringLiteral("pieces=100")},
        {QStringLiteral("late=40")},
        {QStringLiteral("late=100")},
        {QStringLiteral("crc=20"), QStringLiteral("garbage=30"), QStringLiteral("pieces=50"),
         QStringLiteral("late=20")}};
    for (const QStringList &plan : plans) {
        const QString name = column + u' ' + plan.join(u' ');
        QTest::newRow(qPrintable(name)) << column << plan;
    }
}

/// Whether what was done on a line since the last restart() took no longer than its requests may.
class Stopwatch
{
public:
    explicit Stopwatch(const SimulatedTimeLine &line)
        : m_line(line)
    {
        restart();
    }

    void restart()
    {
        m_start = m_line.elapsed();
        m_requests = m_line.requests();
    }

    bool isInTime(int mostRequests) const
    {
        const int sent = m_line.requests() - m_requests;
        return sent <= mostRequests && m_line.elapsed() - m_start <= sent * (patience + besidePatience);
    }

private:
    const SimulatedTimeLine &m_line;
    std::chrono::microseconds m_start{0};
    int m_requests = 0;
};

} // namespace

void TstServiceTogether::initTestCase()
{
    QVERIFY(patience == Timing().readCommand);
}

/// Sensors of both protocols share a line; each scan sees its own.
void TstServiceTogether::scansInd3()
{
    const LineConfig config = lineWith(
        {sensor(SensorType::InD, 1, 1), sensor(SensorType::InD, 2, 24), sensor(SensorType::InD, 3, 126),
         sensor(SensorType::InD, 4, 255), sensor(SensorType::InD, 5, 7, QStringLiteral("modbus"))});
    SimulatedTimeLine line(config, {});
    const AddressScan plain = scanWith(ind3::Service({}, ind3::Dialect::V211), line);
    QCOMPARE(plain.found(), (QList<int>{1, 24, 126, 255}));
    QCOMPARE(plain.unclear(), QList<int>());
    QCOMPARE(plain.free().size(), 251);
    const AddressScan modbus = scanWith(ind3::Service({}, ind3::Dialect::Modbus), line);
    QCOMPARE(modbus.found(), QList<int>{7});
}

void TstServiceTogether::scansAnd3()
{
    const LineConfig config =
        lineWith({sensor(SensorType::AnD3, 1, 3), sensor(SensorType::AnD3, 2, 200), sensor(SensorType::AnD3, 3, 255)});
    SimulatedTimeLine line(config, {1, planOf({QStringLiteral("garbage=50"), QStringLiteral("pieces=50")})});
    const Stopwatch watch(line);
    const AddressScan scan = scanWith(and3::Service({}), line);
    QCOMPARE(scan.found(), (QList<int>{3, 200, 255}));
    QVERIFY(scan.isComplete());
    QVERIFY(watch.isInTime(255 * 3));
}

void TstServiceTogether::inclinometers_data()
{
    QTest::addColumn<QString>("protocol");
    QTest::addColumn<QStringList>("faults");
    addFaults(QStringLiteral("2.11"));
    addFaults(QStringLiteral("modbus"));
}

void TstServiceTogether::inclinometers()
{
    QFETCH(QString, protocol);
    QFETCH(QStringList, faults);
    const bool isModbus = protocol == QStringLiteral("modbus");
    const ind3::Service service({}, *ind3::dialectNamed(protocol));
    const ind3::Changes changes{
        isModbus ? std::optional<QString>() : QStringLiteral("Дом }~ 7"), Tilt{200.25, -300.5}, 64, 100ms};
    int good = 0;
    for (quint64 seed = 1; seed <= 30; ++seed) {
        SimulatedTimeLine line(lineWith({sensor(SensorType::InD, 1, 5, protocol)}), {seed, planOf(faults)});
        const auto &device = deviceOf<ind3::Simulator>(line).sensor();

        Stopwatch watch(line);
        const auto before = service.read(line, 5);
        QVERIFY(watch.isInTime(8 * 3));
        QVERIFY(!before || (before->serialNumber == 1887U && before->ticks == 32 && before->period == 50ms));
        QVERIFY(!before || !before->offset || *before->offset == (Tilt{0, 0}));

        watch.restart();
        const auto outcomes = service.write(line, 5, changes);
        QVERIFY(watch.isInTime(4 * 6));
        QCOMPARE(outcomes.size(), isModbus ? 3 : 4);
        for (const ind3::Outcome &outcome : outcomes) {
            good += outcome.written ? 1 : 0;
            QVERIFY(!outcome.written || outcome.setting != ind3::Setting::Name || device.name == "\xC4\xEE\xEC }~ 7");
            QVERIFY(!outcome.written || outcome.setting != ind3::Setting::Ticks || device.ticksCode == 6);
            QVERIFY(!outcome.written || outcome.setting != ind3::Setting::Period || device.periodCode == 3);
            QVERIFY(!outcome.written || outcome.setting != ind3::Setting::Offset || device.offset[0] == -300.5);
        }

        watch.restart();
        const auto moved = service.changeAddress(line, 5, 9);
        QVERIFY(watch.isInTime(3 + 3 * 4 + 9));
        QVERIFY(!moved || device.address == 9);
        QVERIFY(moved || moved.fault() != Fault::BadReply || device.address == 5);
        QVERIFY(moved || moved.fault() != Fault::Refused); // nobody is at 9
        good += moved ? 1 : 0;
    }
    const bool isHopeless = faults == QStringList{QStringLiteral("silent=1")}
        || faults == QStringList{QStringLiteral("crc=100")} || faults == QStringList{QStringLiteral("late=100")};
    QVERIFY(isHopeless || good > 30 * 2);
    QVERIFY(!isHopeless || good == 0 || faults == QStringList{QStringLiteral("late=100")});
}

void TstServiceTogether::accelerometers_data()
{
    QTest::addColumn<QString>("protocol");
    QTest::addColumn<QStringList>("faults");
    addFaults(QStringLiteral("and3"));
}

void TstServiceTogether::accelerometers()
{
    QFETCH(QStringList, faults);
    const and3::Service service({});
    int good = 0;
    for (quint64 seed = 1; seed <= 30; ++seed) {
        SimulatedTimeLine line(lineWith({sensor(SensorType::AnD3, 1, 5)}), {seed, planOf(faults)});

        Stopwatch watch(line);
        const auto settings = service.read(line, 5);
        QVERIFY(watch.isInTime(3 * 3));
        QVERIFY(!settings || (settings->configuration[4] == 5 && settings->configuration[5] == 1));
        QVERIFY(!settings || !settings->firmware || settings->firmware->build == 12);

        watch.restart();
        const auto change = service.storeAddress(line, 5, 9);
        QVERIFY(watch.isInTime(3 + 3 * 5 + 3 * (1 + 3 * 4)));
        QCOMPARE(change.step == and3::AddressStep::Done, static_cast<bool>(change.result));
        QCOMPARE(deviceOf<and3::And3Simulator>(line).address(), 5); // only after a restart
        const bool isReset = change.result && service.reset(line, 5);
        line.wait(and3::Service::restartTime);
        const auto heard = service.probe(line, 9);
        QVERIFY(!heard || isReset);
        QVERIFY(!isReset || deviceOf<and3::And3Simulator>(line).address() == 9);
        good += isReset ? 1 : 0;
    }
    const bool isHopeless = faults == QStringList{QStringLiteral("silent=1")}
        || faults == QStringList{QStringLiteral("crc=100")} || faults == QStringList{QStringLiteral("late=100")};
    QVERIFY(isHopeless ? good == 0 : good > 5);
}

/// The sensor hears everything and is not heard: nothing may be called done.
void TstServiceTogether::lostAnswersOnly()
{
    const QList<SensorConfig> sensors{sensor(SensorType::InD, 1, 5)};
    SimulatedTimeLine line(lineWith(sensors), {1, planOf({QStringLiteral("silent=1@0-60")})});
    const ind3::Service service({}, ind3::Dialect::V211);
    const auto outcomes = service.write(line, 5, {{}, {}, 64, {}});
    QVERIFY(!outcomes.at(0).written && outcomes.at(0).written.fault() == Fault::Timeout);
    QVERIFY(service.changeAddress(line, 5, 9).fault() == Fault::Timeout);
    line.wait(60s);
    const auto settings = service.read(line, 9);
    QVERIFY(settings);
    QCOMPARE(settings->ticks, 64);
}

/// Out and back again; the configuration beside the address stays.
void TstServiceTogether::readdressesAndResets()
{
    SimulatedTimeLine line(lineWith({sensor(SensorType::AnD3, 1, 5), sensor(SensorType::AnD3, 2, 6)}), {});
    const and3::Service service({});
    QVERIFY(service.storeAddress(line, 5, 6).result.fault() == Fault::Refused);
    const auto before = service.read(line, 5);
    QVERIFY(before);
    QVERIFY(service.storeAddress(line, 5, 9).result);
    QVERIFY(service.probe(line, 5)); // until it restarts
    QVERIFY(service.reset(line, 5));
    line.wait(and3::Service::restartTime);
    QVERIFY(service.probe(line, 5).fault() == Fault::Timeout);
    const auto after = service.read(line, 9);
    QVERIFY(after);
    auto expected = before->configuration;
    expected[and3::addressIndex] = 9;
    QVERIFY(after->configuration == expected);
    QVERIFY(after->values.samples < before->values.samples + 60);
    QVERIFY(!(after->values.rawStatus & and3::statusbit::RebootAcknowledged));
    QVERIFY(service.storeAddress(line, 9, 5).result);
    QVERIFY(service.reset(line, 9));
    line.wait(and3::Service::restartTime);
    QVERIFY(service.read(line, 5)->configuration == before->configuration);
    QVERIFY(service.probe(line, 6));
}

QTEST_GUILESS_MAIN(TstServiceTogether)
#include "tst_servicetogether.moc"
