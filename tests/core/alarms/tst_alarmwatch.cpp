#include "core/alarms/alarmwatch.h"
#include "core/engine/lineworker.h"

#include "tests/core/alarms/alarmsite.h"
#include "tests/support/pluggedline.h"

#include <QSignalSpy>
#include <QTest>
#include <QThread>

using namespace gorizont;
using namespace std::chrono_literals;
using test::turn;

namespace {

LineStatus state(int port, LineState state)
{
    LineStatus status;
    status.port = port;
    status.state = state;
    return status;
}

/// A real worker in its thread, the registry it feeds and the watch over it: the signals in their real order.
class Site
{
public:
    explicit Site(const FaultPlan &faults)
        : registry({settings().line}, settings().rules)
        , watch(registry)
        , worker(settings(), [this, faults] {
            SimulatedBus::Options options;
            options.faults = faults;
            return std::make_unique<test::PluggedLine>(settings().line, options, isPlugged);
        })
    {
        worker.moveToThread(&thread);
        QObject::connect(&thread, &QThread::started, &worker, &LineWorker::start);
        QObject::connect(&thread, &QThread::finished, &worker, &LineWorker::stop, Qt::DirectConnection);
        QObject::connect(&worker, &LineWorker::readingsReady, &registry, &SensorRegistry::update);
        QObject::connect(&worker, &LineWorker::lineChanged, &registry, &SensorRegistry::updateLine);
        thread.start();
    }
    ~Site()
    {
        worker.interrupt();
        thread.quit();
        thread.wait();
    }

    static PollingSettings settings()
    {
        PollingSettings settings;
        settings.line = test::alarmLine(1, true, {test::alarmSensor(1, 1, 1), test::alarmSensor(1, 2, 2)});
        settings.timing.run = 50ms;
        settings.timing.addressChange = 1ms;
        settings.timing.readCommand = 30ms;
        settings.timing.closePause = 100ms;
        settings.timing.reopenPause = 100ms;
        settings.timing.updateInterval = 10ms;
        settings.rules = {3, 3, false};
        return settings;
    }

    LineState lineState() const { return registry.lines().front().status.state; }

    std::atomic_bool isPlugged{true};
    SensorRegistry registry;
    AlarmWatch watch;
    QThread thread;
    LineWorker worker;
};

FaultPlan silent(int number)
{
    return {*parseSimulatedFault(QStringLiteral("silent=%1").arg(number))};
}

} // namespace

class TestAlarmWatch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void followsTheRegistry()
    {
        SensorRegistry registry(test::alarmLines(), {});
        AlarmWatch watch(registry);
        const QSignalSpy raised(&watch, &AlarmWatch::raised);
        const QSignalSpy changed(&watch, &AlarmWatch::changed);
        registry.updateLine(state(1, LineState::Open));
        registry.update({turn(1, 0x3700, false), turn(2, 0x3700, false)});
        registry.updateLine(state(2, LineState::OpenFailed));
        QCOMPARE(raised.size(), 3);
        QCOMPARE(raised.at(2).first().value<Alarm>().title, QStringLiteral("COM20"));
        QCOMPARE(watch.unacknowledged().size(), 3);
        QTRY_COMPARE(changed.size(), 1); // once for all of them
        registry.update({turn(1, 0x3700, false)});
        registry.updateLine(state(2, LineState::OpenFailed));
        QTest::qWait(150);
        QCOMPARE(changed.size(), 1);
        QCOMPARE(raised.size(), 3);
        registry.update({turn(1, 0x0300, true)});
        QTRY_COMPARE(changed.size(), 2);
        QCOMPARE(watch.unacknowledged().size(), 2);
    }

    void startsFromWhatStands()
    {
        SensorRegistry registry(test::alarmLines(), {});
        registry.updateLine(state(1, LineState::Open));
        registry.updateLine(state(2, LineState::Lost));
        registry.update({turn(1, 0x7400, true), turn(2, 0x0300, true), turn(4, 0x2700, false)});
        const AlarmWatch watch(registry);
        QCOMPARE(watch.unacknowledged().size(), 2);
    }

    void acknowledgingIsWrittenIntoTheJournal()
    {
        SensorRegistry registry(test::alarmLines(), {});
        AlarmWatch watch(registry);
        QSignalSpy changed(&watch, &AlarmWatch::changed);
        const QSignalSpy journal(&watch, &AlarmWatch::journal);
        registry.update({turn(1, 0x3700, false), turn(2, 0x4700, false)});
        QTRY_COMPARE(changed.size(), 1);
        QCOMPARE(journal.size(), 0); // the engine has told it
        watch.acknowledge({2, 77});
        QCOMPARE(changed.size(), 2); // at once
        QCOMPARE(watch.acknowledgedCount(), 1);
        QCOMPARE(watch.unacknowledged().size(), 1);
        QCOMPARE(journal.size(), 1);
        const auto entry = journal.first().first().value<JournalEntry>();
        QCOMPARE(
            entry.text,
            QStringLiteral("Accepted by the dispatcher: ИН-Д3 No. 2 (COM10, address 12), Floor 2: CRC errors"));
        QCOMPARE(entry.kind, JournalKind::Info);
        QCOMPARE(entry.port, 1);
        QCOMPARE(entry.number, 2);
        watch.acknowledge({2});
        QCOMPARE(journal.size(), 1);
        QCOMPARE(changed.size(), 2);
    }

    void acknowledgingAWholeSiteIsOneLine()
    {
        QList<SensorConfig> sensors;
        Readings silence;
        QList<quint64> ids;
        for (int number = 1; number <= 21; ++number) {
            sensors.append(test::alarmSensor(1, number, number));
            silence.append(turn(number, 0x3700, false));
            ids.append(static_cast<quint64>(number));
        }
        SensorRegistry registry({test::alarmLine(1, true, sensors)}, {});
        AlarmWatch watch(registry);
        const QSignalSpy journal(&watch, &AlarmWatch::journal);
        registry.update(silence);
        watch.acknowledge(ids);
        QCOMPARE(watch.acknowledgedCount(), 21);
        QCOMPARE(journal.size(), 1);
        QVERIFY(journal.first().first().value<JournalEntry>().text.contains(QStringLiteral("21")));
    }

    void noticesGoTogether()
    {
        SensorRegistry registry(test::alarmLines(), {});
        AlarmWatch watch(registry, {.gathering = 300ms, .distance = 600ms, .repetition = 1h});
        const QSignalSpy notices(&watch, &AlarmWatch::noticeDue);
        registry.update({turn(1, 0x3700, false), turn(2, 0x3700, false)});
        registry.update({turn(4, 0x3700, false)});
        registry.update({turn(2, 0x0300, true)});
        QCOMPARE(notices.size(), 0);
        QTRY_COMPARE(notices.size(), 1);
        QCOMPARE(notices.first().first().value<Alarms>().size(), 2);
        registry.update({turn(4, 0x0300, true)});
        registry.update({turn(4, 0x3700, false), turn(2, 0x5400, true)});
        QTRY_COMPARE(notices.size(), 2);
        const auto second = notices.at(1).first().value<Alarms>();
        QCOMPARE(second.size(), 1); // N 4 came back, which was told a moment ago
        QCOMPARE(second.first().number, 2);
    }

    void aSilentSensorOfARealLine()
    {
        Site site(silent(2));
        QSignalSpy raised(&site.watch, &AlarmWatch::raised);
        QTRY_COMPARE(raised.size(), 1);
        QCOMPARE(raised.first().first().value<Alarm>().number, 2);
        QCOMPARE(raised.first().first().value<Alarm>().code, StatusCode::NoAnswer);

        site.worker.enterService();
        QTRY_COMPARE(site.lineState(), LineState::Service);
        QCOMPARE(site.watch.unacknowledged().size(), 1);
        site.worker.leaveService();
        QTRY_COMPARE(site.lineState(), LineState::Open);
        QTRY_COMPARE(statusCode(site.registry.sensors()[1].reading.status), StatusCode::NoAnswer);
        QCOMPARE(site.watch.unacknowledged().size(), 1);
        QCOMPARE(raised.size(), 1); // the service did not make it a new one
    }

    void aPortThatVanishesAndComesBack()
    {
        Site site({});
        QSignalSpy raised(&site.watch, &AlarmWatch::raised);
        QTRY_VERIFY(site.registry.sensors()[1].reading.counters.answers > 1);
        site.isPlugged = false;
        QTRY_COMPARE(site.lineState(), LineState::OpenFailed);
        QCOMPARE(raised.size(), 1);
        QCOMPARE(site.watch.unacknowledged().size(), 1);
        QCOMPARE(site.watch.unacknowledged().first().sensors, 2);
        QCOMPARE(site.watch.unacknowledged().first().line, LineState::OpenFailed);
        site.isPlugged = true;
        QTRY_VERIFY(site.watch.unacknowledged().isEmpty());
        QTRY_VERIFY(site.registry.sensors()[1].reading.isAnswer);
        QCOMPARE(raised.size(), 1);
    }
};

QTEST_GUILESS_MAIN(TestAlarmWatch)
#include "tst_alarmwatch.moc"
