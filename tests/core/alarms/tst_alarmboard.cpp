#include "core/alarms/alarmboard.h"
#include "core/alarms/alarmtext.h"

#include "tests/core/alarms/alarmsite.h"

#include <QTest>

using namespace gorizont;
using test::second;
using test::turn;

namespace {

/// The list as a person reads it: one line an alarm, with its id and the second it began.
QStringList listed(const Alarms &alarms)
{
    QStringList lines;
    for (const Alarm &alarm : alarms) {
        const auto began = std::chrono::duration_cast<std::chrono::seconds>(alarm.began - second(0)).count();
        lines += QStringLiteral("%1 @%2 %3").arg(alarm.id).arg(began).arg(alarmtext::sentence(alarm));
    }
    return lines;
}

QStringList listed(const AlarmBoard &board)
{
    return listed(board.unacknowledged());
}

/// \a type: of N 1.
AlarmBoard openBoard(SensorType type = SensorType::InD)
{
    QList<LineConfig> lines = test::alarmLines();
    lines.first().sensors.first().type = type;
    AlarmBoard board(lines);
    for (const int port : {1, 2, 4}) {
        board.updateLine(port, LineState::Open, second(0));
    }
    return board;
}

} // namespace

class TestAlarmBoard : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// spec/gorizont.md, section 5: what the dispatcher reads when no sensor of a vibration module works.
    void theLinesOfAVibrationModule()
    {
        AlarmBoard board = openBoard(SensorType::LVims);
        Reading reading = turn(1, 0x5700, true, 5);
        reading.vibration = Vibration{
            {{0, ChannelState::ShortCircuit, true, {}},
             {1, ChannelState::Break, true, {}},
             {2, ChannelState::Good, false, {}}},
            {}};
        QCOMPARE(board.update({reading}).raised.size(), 1);
        const Alarm alarm = board.unacknowledged().first();
        QCOMPARE(
            alarmtext::meaning(alarm),
            QStringLiteral("Line of the sensor shorted: channel 0; line of the sensor broken: channel 1"));
        QVERIFY(
            alarmtext::advice(alarm).startsWith(QStringLiteral("Check the cable and the connectors from the module")));
        QVERIFY(!board.update({reading}).isAny);
        reading.vibration->channels[0].state = ChannelState::Break;
        const AlarmBoard::Change change = board.update({reading});
        QVERIFY(change.isAny);
        QVERIFY(change.raised.isEmpty()); // the same alarm, in other words
        QCOMPARE(
            alarmtext::meaning(board.unacknowledged().first()),
            QStringLiteral("Line of the sensor broken: channel 0, 1"));
        board.update({turn(1, 0, true, 9)});
        QVERIFY(board.unacknowledged().isEmpty());
    }

    /// spec/gorizont.md, section 5: code 5 of a weather station is about the supply of its sensors.
    void theSupplyOfAWeatherStation()
    {
        AlarmBoard board = openBoard(SensorType::Mk14);
        Reading reading = turn(1, 0x5700, true, 5);
        reading.weather = Weather();
        board.update({reading});
        QCOMPARE(
            alarmtext::meaning(board.unacknowledged().first()),
            QStringLiteral("The supply voltage of the station's sensors is bad"));
        QVERIFY(alarmtext::advice(board.unacknowledged().first())
                    .startsWith(QStringLiteral("Check the power supply of the weather station")));
    }

    /// Manual 000, section 11.2: all codes but 0 ask for a message; 1 and 2 are those of the port.
    void everyCodeOfASensorIsAMessage_data()
    {
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("meaning");
        QTest::newRow("3") << 0x3700 << "No answer";
        QTest::newRow("4") << 0x4700 << "CRC errors";
        QTest::newRow("5") << 0x5400 << "The transducer does not answer";
        QTest::newRow("6") << 0x6400 << "CRC errors of the transducer";
        QTest::newRow("7") << 0x7400 << "The transducer is out of range";
        QTest::newRow("8") << 0x8200 << "The temperature sensor does not work";
        QTest::newRow("9") << 0x9200 << "The temperature sensor is out of range";
        QTest::newRow("A") << 0xA000 << "The fan does not work";
        QTest::newRow("B") << 0xB010 << "The thermostat takes too long to settle";
    }
    void everyCodeOfASensorIsAMessage()
    {
        QFETCH(int, status);
        QFETCH(QString, meaning);
        AlarmBoard board = openBoard();
        const auto change = board.update({turn(1, status, true, 7)});
        QVERIFY(change.isAny);
        const QString sentence = QStringLiteral("1 @7 ИН-Д3 No. 1 (COM10, address 11), Floor 1: ") + meaning;
        QCOMPARE(listed(change.raised), QStringList(sentence));
        QCOMPARE(listed(board), QStringList(sentence));
        QVERIFY(alarmtext::advice(change.raised.first()).size() > 20);
    }

    void oneMessageAChange()
    {
        AlarmBoard board = openBoard();
        QCOMPARE(board.update({turn(1, 0x3700, false, 1), turn(2, 0x3700, false, 1)}).raised.size(), 2);
        const auto again = board.update({turn(1, 0x3700, false, 2), turn(2, 0x3600, true, 2)});
        QVERIFY(!again.isAny); // the same code with other flags
        QVERIFY(again.raised.isEmpty());
    }

    void flagsWithoutACodeAreNoMessage()
    {
        AlarmBoard board = openBoard();
        QVERIFY(!board.update({turn(1, 0x0720, true), turn(2, 0x0700, false), turn(4, 0x0314, true)}).isAny);
    }

    void anotherCodeIsANewMessage()
    {
        AlarmBoard board = openBoard();
        board.update({turn(1, 0x3700, false, 1)});
        QCOMPARE(board.acknowledge({1}).size(), 1);
        const auto change = board.update({turn(1, 0x4700, false, 5)});
        QCOMPARE(
            listed(change.raised),
            QStringList(QStringLiteral("2 @5 ИН-Д3 No. 1 (COM10, address 11), Floor 1: CRC errors")));
        QCOMPARE(listed(board).size(), 1);
        QCOMPARE(board.acknowledgedCount(), 0); // the old one went with its code
    }

    void aGoodAnswerEndsIt()
    {
        AlarmBoard board = openBoard();
        board.update({turn(1, 0x5400, true)});
        const auto change = board.update({turn(1, 0x0000, true)});
        QVERIFY(change.isAny);
        QVERIFY(change.raised.isEmpty());
        QVERIFY(board.unacknowledged().isEmpty());
        QCOMPARE(board.update({turn(1, 0x5400, true, 9)}).raised.first().id, 2u); // back: a new message
    }

    void acknowledgedLeavesTheListAndStaysSo()
    {
        AlarmBoard board = openBoard();
        board.update({turn(1, 0x3700, false), turn(2, 0x3700, false)});
        QCOMPARE(listed(board.acknowledge({1, 99})).size(), 1);
        QCOMPARE(board.acknowledge({1}), Alarms()); // only once
        QCOMPARE(listed(board).size(), 1);
        QCOMPARE(board.acknowledgedCount(), 1);
        QVERIFY(!board.update({turn(1, 0x3700, false)}).isAny);
        QCOMPARE(board.acknowledgedCount(), 1);
        QVERIFY(board.update({turn(1, 0x0300, true)}).isAny);
        QCOMPARE(board.acknowledgedCount(), 0);
    }

    void whatTheIniSwitchesOffIsNoMessage()
    {
        AlarmBoard board = openBoard();
        QVERIFY(!board.update({turn(3, 0x0F00, false), turn(5, 0x1700, false), turn(6, 0x0F00, false)}).isAny);
        QVERIFY(!board.updateLine(3, LineState::Off, second(1)).isAny);
        QVERIFY(!board.updateLine(4, LineState::Lost, second(1)).isAny); // nobody is polled there
        QVERIFY(!board.updateLine(9, LineState::Lost, second(1)).isAny);
        QVERIFY(!board.update({turn(99, 0x3700, false)}).isAny);
    }

    /// In the order of the engine: first the words of the sensors, then the state of the line.
    void aPortThatFailsIsOneMessage()
    {
        AlarmBoard board = openBoard();
        QVERIFY(!board.update({turn(1, 0x2700, false), turn(2, 0x2700, false)}).isAny);
        const auto lost = board.updateLine(1, LineState::Lost, second(3));
        const QString sentence = QStringLiteral("1 @3 COM10, Adapter 1: %1; sensors without data: 2");
        QCOMPARE(listed(lost.raised), QStringList(sentence.arg(QStringLiteral("The connection to the port is lost"))));
        QVERIFY(lost.raised.first().isWholePort());

        board.acknowledge({1});
        const auto failed = board.updateLine(1, LineState::OpenFailed, second(8));
        QVERIFY(failed.raised.isEmpty()); // the same code: the same message
        QVERIFY(failed.isAny);
        QCOMPARE(board.acknowledgedCount(), 1);

        board.update({turn(1, 0x0700, false), turn(2, 0x0700, false)});
        QVERIFY(board.updateLine(1, LineState::Open, second(13)).isAny);
        QCOMPARE(board.acknowledgedCount(), 0);
        QVERIFY(!board.update({turn(1, 0x0300, true), turn(2, 0x0300, true)}).isAny);
        const auto again = board.updateLine(1, LineState::OpenFailed, second(20));
        QCOMPARE(
            listed(again.raised),
            QStringList(QStringLiteral("2 @20 COM10, Adapter 1: The port cannot be opened; sensors without data: 2")));
    }

    void aPortTakesThePlaceOfItsSensors()
    {
        AlarmBoard board = openBoard();
        board.update({turn(1, 0x3700, false), turn(2, 0xA000, true), turn(4, 0x3700, false)});
        board.update({turn(1, 0x2700, false), turn(2, 0x2700, false)});
        board.updateLine(1, LineState::Lost, second(3));
        QCOMPARE(
            listed(board),
            QStringList({
                QStringLiteral("3 @0 ИН-Д3 No. 4 (COM20, address 11), Floor 4: No answer"),
                QStringLiteral("4 @3 COM10, Adapter 1: The connection to the port is lost; sensors without data: 2"),
            }));
        board.update({turn(1, 0x0700, false), turn(2, 0x0700, false)});
        board.updateLine(1, LineState::Open, second(5));
        QCOMPARE(listed(board).size(), 1);
        QCOMPARE(board.update({turn(2, 0xA000, true, 6)}).raised.size(), 1); // still so, after the port came back
    }

    void aPortThatIsSwitchedOffWhileItWorksIsOneMessage()
    {
        AlarmBoard board = openBoard();
        board.updateLine(1, LineState::Lost, second(1));
        board.acknowledge({1});
        board.update({turn(1, 0x1700, false), turn(2, 0x1700, false)});
        const auto change = board.updateLine(1, LineState::Off, second(2));
        QCOMPARE(
            listed(change.raised),
            QStringList(QStringLiteral("2 @2 COM10, Adapter 1: The port is off; sensors without data: 2")));
        QCOMPARE(board.acknowledgedCount(), 0);
    }

    /// In the order of the engine: words of the sensors, state of the line, and the same on the way back.
    void serviceRaisesNothingAndEndsNothing()
    {
        AlarmBoard board = openBoard();
        board.update({turn(1, 0x5400, true), turn(2, 0x0300, true)});
        const QStringList before = listed(board);
        QCOMPARE(before.size(), 1);
        QVERIFY(!board.update({turn(1, 0x0700, false), turn(2, 0x0700, false)}).isAny);
        QVERIFY(!board.updateLine(1, LineState::Service, second(1)).isAny);
        QVERIFY(!board.update({turn(1, 0x0000, true), turn(2, 0x3700, false)}).isAny);
        QVERIFY(!board.update({turn(1, 0x0700, false), turn(2, 0x0700, false)}).isAny);
        QVERIFY(!board.updateLine(1, LineState::Open, second(9)).isAny);
        QCOMPARE(listed(board), before);
        QVERIFY(!board.update({turn(1, 0x5400, true)}).isAny); // still the same message
        QVERIFY(board.update({turn(1, 0x0300, true)}).isAny);
        QVERIFY(listed(board).isEmpty());
    }

    void noticeOfOneAndOfMany()
    {
        AlarmBoard board = openBoard();
        board.update({turn(1, 0x3700, false)});
        QCOMPARE(
            alarmtext::notice(board.unacknowledged()),
            (alarmtext::Notice{
                QStringLiteral("ИН-Д3 No. 1 (COM10, address 11), Floor 1"),
                QStringLiteral("No answer.\nCheck the power of the sensor, its cable and its address.")}));
        board.update({turn(2, 0x4700, false)});
        board.update({turn(4, 0x7400, true)});
        board.updateLine(2, LineState::Lost, second(1));
        board.updateLine(1, LineState::OpenFailed, second(2));
        const auto ports = alarmtext::notice(board.unacknowledged());
        QCOMPARE(ports.title, QStringLiteral("3 sensor(s) need attention")); // two of COM10 and one of COM20
        QCOMPARE(
            ports.text,
            QStringLiteral("COM10, Adapter 1: The port cannot be opened; sensors without data: 2\n"
                           "COM20, Adapter 2: The connection to the port is lost; sensors without data: 1"));
    }

    void noticeNamesTheNewest()
    {
        Alarms alarms;
        for (int number = 1; number <= 7; ++number) {
            Alarm alarm;
            alarm.number = number;
            alarm.code = StatusCode::NoAnswer;
            alarm.title = QStringLiteral("S%1").arg(number);
            alarms.append(alarm);
        }
        const auto notice = alarmtext::notice(alarms);
        QCOMPARE(notice.title, QStringLiteral("7 sensor(s) need attention"));
        QCOMPARE(notice.text, QStringLiteral("S7: No answer\nS6: No answer\nS5: No answer\nand more: 4"));
    }
};

QTEST_GUILESS_MAIN(TestAlarmBoard)
#include "tst_alarmboard.moc"
