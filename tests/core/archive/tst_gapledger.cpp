#include "core/archive/gapledger.h"
#include "core/archive/gapmath.h"
#include "core/values/statusword.h"

#include <QTest>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

const UtcTime noon{std::chrono::sys_days(std::chrono::year(2024) / 12 / 31) + 12h};

QList<LineConfig> site()
{
    LineConfig line;
    line.index = 1;
    line.isOn = true;
    for (int number = 1; number <= 2; ++number) {
        SensorConfig sensor;
        sensor.port = 1;
        sensor.number = number;
        sensor.isOn = true;
        sensor.measuresTilt = true;
        line.sensors.append(sensor);
    }
    LineConfig off = line;
    off.index = 2;
    off.isOn = false;
    off.sensors = {line.sensors.first()};
    off.sensors.first().number = 3;
    return {line, off};
}

Reading good(int number, UtcTime time)
{
    Reading reading;
    reading.number = number;
    reading.time = time;
    reading.isAnswer = true;
    reading.tilt = Tilt{1, 2};
    reading.period = 1s;
    return reading;
}

Reading bad(int number, UtcTime time, StatusCode code = StatusCode::Good, quint64 crcErrors = 0)
{
    Reading reading = good(number, time);
    reading.isAnswer = false;
    reading.counters.crcErrors = crcErrors;
    reading.status = static_cast<quint16>((static_cast<int>(code) << 12) | statusbit::TiltInvalid);
    return reading;
}

LineStatus port(LineState state)
{
    LineStatus status;
    status.port = 1;
    status.state = state;
    return status;
}

/// `NoAnswer 0…5` in seconds after noon; `NoAnswer 0…` goes on.
QStringList texts(const QList<Gap> &gaps, int number = 1)
{
    static const char *const names[] = {"",    "SensorOff",   "PortOff", "PortError",      "NoAnswer",
                                        "Crc", "DeviceFault", "Service", "ProgramStopped", "Clock",
                                        "Disk"};
    QStringList list;
    for (const Gap &gap : gaps) {
        if (gap.number == number) {
            const auto seconds = [](UtcTime time) {
                return QString::number(std::chrono::duration<double>(time - noon).count());
            };
            list.append(QStringLiteral("%1 %2…%3")
                            .arg(
                                QLatin1String(names[static_cast<int>(gap.reason)]), seconds(gap.from),
                                gap.to ? seconds(*gap.to) : QString()));
        }
    }
    return list;
}

/// At noon, everything answering until a second later.
GapLedger running()
{
    GapLedger ledger(site());
    ledger.start(noon, {});
    ledger.add(port(LineState::Open), noon);
    ledger.add(good(1, noon + 1s));
    ledger.add(good(2, noon + 1s));
    return ledger;
}

} // namespace

class TestGapLedger : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneMissedTurnIsNoGap();
    void tellsSilenceWhenItBeginsAndEnds();
    void tellsWrongCheckSums();
    void followsTheReason();
    void aGuessNeverReplacesWhatIsCertain();
    void tellsServiceAndOff();
    void tellsADeviceThatIsNotWell();
    void knowsThatTheProgramWasAway();
    void knowsThatTheProgramWasAwayAndThePortIsNot();
    void noticesThatNothingComesAtAll();
    void acceptsClockSteps();
    void tellsLosses();
    void stopEndsWhatIsOpen();
    void fillsParts();
    void fillsFromOneValueToTheNext_data();
    void fillsFromOneValueToTheNext();
    void joinsWhatIsFilled();
    void countsCompleteness();
    void countsDaysOfTheZone();
};

void TestGapLedger::oneMissedTurnIsNoGap()
{
    GapLedger ledger = running();
    ledger.add(bad(1, noon + 2s));
    ledger.tick(noon + 2s);
    ledger.add(good(1, noon + 3s));
    ledger.tick(noon + 4s);
    QCOMPARE(texts(ledger.takeChanges()), QStringList());
}

void TestGapLedger::tellsSilenceWhenItBeginsAndEnds()
{
    GapLedger ledger = running();
    for (int second = 2; second < 12; ++second) {
        ledger.add(bad(1, noon + second * 1s));
        ledger.add(good(2, noon + second * 1s));
        ledger.tick(noon + second * 1s);
    }
    const QList<Gap> begun = ledger.takeChanges();
    QCOMPARE(texts(begun), QStringList{QStringLiteral("NoAnswer 1…")});
    QCOMPARE(texts(begun, 2), QStringList());
    ledger.add(bad(1, noon + 12s, StatusCode::NoAnswer));
    ledger.add(good(1, noon + 13s));
    QCOMPARE(texts(ledger.takeChanges()), QStringList{QStringLiteral("NoAnswer 1…13")});
}

void TestGapLedger::tellsWrongCheckSums()
{
    GapLedger ledger = running();
    for (int second = 2; second < 8; ++second) {
        ledger.add(bad(1, noon + second * 1s, StatusCode::Good, static_cast<quint64>(second)));
    }
    ledger.add(good(1, noon + 8s));
    QCOMPARE(texts(ledger.takeChanges()), QStringList{QStringLiteral("Crc 1…8")});
}

void TestGapLedger::followsTheReason()
{
    GapLedger ledger = running();
    ledger.add(bad(1, noon + 2s, StatusCode::NoAnswer));
    ledger.tick(noon + 10s);
    ledger.add(port(LineState::Lost), noon + 20s);
    ledger.add(bad(1, noon + 20s, StatusCode::PortError));
    ledger.tick(noon + 30s);
    ledger.add(port(LineState::Open), noon + 40s);
    ledger.add(bad(1, noon + 40s));
    ledger.add(good(1, noon + 41s));
    const QStringList expected{
        QStringLiteral("NoAnswer 1…"), QStringLiteral("NoAnswer 1…20"), QStringLiteral("PortError 20…"),
        QStringLiteral("PortError 20…41")};
    QCOMPARE(texts(ledger.takeChanges()), expected);
}

void TestGapLedger::aGuessNeverReplacesWhatIsCertain()
{
    GapLedger ledger = running();
    ledger.add(port(LineState::Lost), noon + 1500ms);
    ledger.add(bad(1, noon + 2s));
    ledger.add(port(LineState::Open), noon + 20s);
    ledger.add(bad(1, noon + 21s, StatusCode::Good, 5));
    ledger.add(good(1, noon + 22s));
    QCOMPARE(texts(ledger.takeChanges()), QStringList{QStringLiteral("PortError 1…22")});
}

void TestGapLedger::tellsServiceAndOff()
{
    GapLedger ledger = running();
    ledger.add(port(LineState::Service), noon + 2s);
    ledger.add(bad(1, noon + 2s));
    ledger.tick(noon + 60s);
    ledger.add(good(1, noon + 62s));
    const QList<Gap> changes = ledger.takeChanges();
    QCOMPARE(texts(changes), (QStringList{QStringLiteral("Service 1…"), QStringLiteral("Service 1…62")}));
    QCOMPARE(texts(changes, 3), QStringList{QStringLiteral("PortOff 0…")});
}

void TestGapLedger::tellsADeviceThatIsNotWell()
{
    GapLedger ledger = running();
    Reading reading = good(1, noon + 2s);
    reading.status = static_cast<quint16>((5 << 12) | statusbit::TiltInvalid);
    ledger.add(reading);
    reading.time = noon + 9s;
    ledger.add(reading);
    ledger.add(good(1, noon + 10s));
    QCOMPARE(texts(ledger.takeChanges()), QStringList{QStringLiteral("DeviceFault 1…10")});
}

void TestGapLedger::knowsThatTheProgramWasAway()
{
    GapLedger ledger(site());
    ledger.start(noon, {{1, noon - 3600s}, {2, noon + 50s}, {3, noon - 60s}});
    ledger.add(bad(1, noon));
    ledger.add(good(1, noon + 2s));
    ledger.add(good(2, noon + 2s)); // the clock was set back while the program was away
    ledger.tick(noon + 5s);
    const QList<Gap> changes = ledger.takeChanges();
    QCOMPARE(texts(changes), QStringList{QStringLiteral("ProgramStopped -3600…2")});
    QCOMPARE(texts(changes, 2), QStringList());
    QCOMPARE(texts(changes, 3), (QStringList{QStringLiteral("ProgramStopped -60…0"), QStringLiteral("PortOff 0…")}));
}

void TestGapLedger::knowsThatTheProgramWasAwayAndThePortIsNot()
{
    GapLedger ledger(site());
    ledger.start(noon, {{1, noon - 3600s}});
    ledger.add(bad(1, noon + 1s));
    ledger.add(bad(1, noon + 9s, StatusCode::NoAnswer));
    ledger.tick(noon + 10s);
    const QStringList expected{QStringLiteral("ProgramStopped -3600…0"), QStringLiteral("NoAnswer 0…")};
    QCOMPARE(texts(ledger.takeChanges()), expected);
}

void TestGapLedger::noticesThatNothingComesAtAll()
{
    GapLedger ledger = running();
    ledger.tick(noon + 9s);
    QCOMPARE(texts(ledger.takeChanges()), QStringList());
    ledger.tick(noon + 12s);
    QCOMPARE(texts(ledger.takeChanges()), QStringList{QStringLiteral("NoAnswer 1…")});
    Reading slow = good(2, noon + 20s);
    slow.period = 60s;
    ledger.add(slow);
    ledger.takeChanges();
    ledger.tick(noon + 300s);
    QCOMPARE(texts(ledger.takeChanges(), 2), QStringList());
    ledger.tick(noon + 321s);
    QCOMPARE(texts(ledger.takeChanges(), 2), QStringList{QStringLiteral("NoAnswer 20…")});
}

void TestGapLedger::acceptsClockSteps()
{
    GapLedger ledger = running();
    ledger.clockStepped(noon + 2s, noon + 3602s);
    ledger.add(good(1, noon + 3603s));
    ledger.tick(noon + 3603s);
    QCOMPARE(texts(ledger.takeChanges()), QStringList{QStringLiteral("Clock 2…3602")});
    ledger.add(bad(1, noon + 3604s, StatusCode::NoAnswer));
    ledger.tick(noon + 3608s);
    ledger.takeChanges();
    ledger.clockStepped(noon + 3610s, noon + 10s);
    ledger.add(good(1, noon + 20s));
    const QStringList expected{QStringLiteral("NoAnswer 3603…3610"), QStringLiteral("NoAnswer 10…20")};
    QCOMPARE(texts(ledger.takeChanges()), expected);
}

void TestGapLedger::tellsLosses()
{
    GapLedger ledger = running();
    ledger.addLost(1, {noon + 2s, noon + 9s});
    ledger.addLost(1, {noon + 9s, noon + 9s});
    QCOMPARE(texts(ledger.takeChanges()), QStringList{QStringLiteral("Disk 2…9")});
}

void TestGapLedger::stopEndsWhatIsOpen()
{
    GapLedger ledger = running();
    ledger.add(bad(1, noon + 2s, StatusCode::NoAnswer));
    ledger.stop(noon + 30s);
    const QList<Gap> changes = ledger.takeChanges();
    QCOMPARE(texts(changes), QStringList{QStringLiteral("NoAnswer 1…30")});
    QCOMPARE(texts(changes, 2), QStringList());
}

void TestGapLedger::fillsParts()
{
    const QList<Gap> gaps{
        {1, noon, noon + 10s, GapReason::NoAnswer, {}}, {1, noon + 20s, noon + 30s, GapReason::Crc, {}}};
    const QString ring = QStringLiteral("ring");
    const QList<Gap> expected{
        {1, noon, noon + 4s, GapReason::NoAnswer, {}},
        {1, noon + 4s, noon + 10s, GapReason::NoAnswer, ring},
        {1, noon + 20s, noon + 25s, GapReason::Crc, ring},
        {1, noon + 25s, noon + 30s, GapReason::Crc, {}}};
    QCOMPARE(filled(gaps, {noon + 4s, noon + 25s}, ring), expected);
    QCOMPARE(filled(expected, {noon + 4s, noon + 25s}, QStringLiteral("other")), expected);
    const QList<Gap> open{{1, noon, {}, GapReason::NoAnswer, {}}};
    const QList<Gap> both{
        {1, noon, noon + 10s, GapReason::NoAnswer, ring}, {1, noon + 10s, {}, GapReason::NoAnswer, {}}};
    QCOMPARE(filled(open, {noon - 5s, noon + 10s}, ring), both);
}

void TestGapLedger::fillsFromOneValueToTheNext_data()
{
    using Seconds = QList<int>;
    QTest::addColumn<Seconds>("values");
    QTest::addColumn<Seconds>("parts"); // from, to, from, to …
    QTest::newRow("none") << Seconds{} << Seconds{};
    QTest::newRow("outside") << Seconds{-10, 100, 110} << Seconds{};
    QTest::newRow("one") << Seconds{40} << Seconds{40, 50};
    QTest::newRow("one at the beginning") << Seconds{15} << Seconds{0, 25};
    QTest::newRow("one at the end") << Seconds{85} << Seconds{85, 100};
    QTest::newRow("the last has no room") << Seconds{84} << Seconds{84, 94};
    QTest::newRow("late ones") << Seconds{20, 35, 45, 57} << Seconds{20, 67};
    QTest::newRow("one is missing") << Seconds{20, 30, 46, 50} << Seconds{20, 40, 46, 60};
    QTest::newRow("all of it") << Seconds{0, 10, 20, 30, 40, 50, 60, 70, 80, 90} << Seconds{0, 100};
}

/// A gap of 100 s and a recorder with a period of ten.
void TestGapLedger::fillsFromOneValueToTheNext()
{
    QFETCH(QList<int>, values);
    QFETCH(QList<int>, parts);
    std::vector<UtcTime> times;
    for (const int value : values) {
        times.push_back(noon + value * 1s);
    }
    QList<int> found;
    for (const TimeSpan &part : filledParts({noon, noon + 100s}, times, 10s)) {
        found << static_cast<int>((part.from - noon) / 1s) << static_cast<int>((part.to - noon) / 1s);
    }
    QCOMPARE(found, parts);
    QCOMPARE(usualDistance({noon, noon + 9s, noon + 20s, noon + 90s}), std::chrono::microseconds(11s));
    QCOMPARE(usualDistance({noon}), std::chrono::microseconds(0));
}

void TestGapLedger::joinsWhatIsFilled()
{
    const QString ring = QStringLiteral("ring");
    const QList<Gap> gaps{{1, noon, noon + 1s, GapReason::Crc, {}},
                          {1, noon + 1s, noon + 2s, GapReason::Crc, ring},
                          {1, noon + 2s, noon + 3s, GapReason::Crc, ring},
                          {1, noon + 4s, noon + 5s, GapReason::Crc, ring},
                          {1, noon + 5s, noon + 6s, GapReason::Disk, ring},
                          {1, noon + 6s, {}, GapReason::Disk, {}}};
    QList<Gap> expected = gaps;
    expected.removeAt(2);
    expected[1].to = noon + 3s;
    QCOMPARE(joined(gaps), expected);
}

void TestGapLedger::countsCompleteness()
{
    const UtcTime midnight = noon + 12h;
    const QList<Gap> gaps{
        {1, noon + 9h, noon + 15h, GapReason::NoAnswer, {}},
        {1, noon + 10h, noon + 11h, GapReason::Disk, {}},
        {1, midnight + 4h, midnight + 5h, GapReason::Crc, QStringLiteral("ring")},
        {1, midnight + 21h, {}, GapReason::Crc, {}}};
    const QList<DayCompleteness> expected{{1, QDate(2024, 12, 31), 9h, 12h}, {1, QDate(2025, 1, 1), 18h, 24h}};
    QCOMPARE(completeness(1, gaps, {noon, midnight + 24h}, QTimeZone::utc()), expected);
    QCOMPARE(completeness(1, gaps, {noon, noon}, QTimeZone::utc()), QList<DayCompleteness>());
}

/// Noon in Greenwich is three in the afternoon there.
void TestGapLedger::countsDaysOfTheZone()
{
    const QList<Gap> gaps{{2, noon, noon + 9h, GapReason::NoAnswer, {}}};
    const auto days = completeness(2, gaps, {noon - 15h, noon + 10h}, QTimeZone(3 * 3600));
    const QList<DayCompleteness> expected{{2, QDate(2024, 12, 31), 15h, 24h}, {2, QDate(2025, 1, 1), 1h, 1h}};
    QCOMPARE(days, expected);
}

QTEST_APPLESS_MAIN(TestGapLedger)

#include "tst_gapledger.moc"
