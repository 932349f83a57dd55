#include "core/station/service/gathering.h"
#include "core/station/service/weatheranswer.h"
#include "tests/support/fakeline.h"

#include <QSignalSpy>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>

using namespace gorizont;
using namespace gorizont::station;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

// Made with Python's struct: command 4 to station 5 with control word 9, and two parameters:
// −3.5, −3.25, −5, 1.5 and 745.5, no value, 740, 750; digital inputs 6.
const QByteArray question = hex("BB 05 04 00 09 00 00 00 33");
const QByteArray answer = hex("BB 05 00 02 06 00 00 00 38 00 00 60 C0 00 00 50 C0 00 00 A0 C0 00 00 C0 3F 00 60 3A 44 "
                              "FF FF FF FF 00 00 39 44 00 80 "
                              "3B 44 1B");
const QByteArray noData = hex("BB 05 00 00 06 00 00 00 3A");

StationPlan planFor(const QByteArray &ini)
{
    StationFiles files;
    files[QStringLiteral("ACK.PSE")] = "1\n";
    files[QStringLiteral("ACK.INI")] = ini;
    files[QStringLiteral("ACK.PAR")] = "\"Air here\" C s T 1 A 0 %5.1f - - - 0 1\n"
                                       "\"Air there\" C s T 2 A 0 %5.1f - - - 0 1\n"
                                       "\"Pressure\" mm s P 1 A 0 %5.1f - - - 0 1\n";
    return planOf(readStation(files).config, {}, QStringLiteral("/station"));
}

GatheredObject objectFive()
{
    GatheredObject object;
    object.number = 5;
    object.command = 4;
    object.ids = {ParameterId{u'T', 2}, ParameterId{u'P', 1}};
    object.line.baudRate = 9600;
    return object;
}

} // namespace

class TestGathering : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void asksAndReads();
    void repeatsAsOftenAsItMay();
    void readsTheLinesOfAckIni();
    void complainsOfTheExtraField_data();
    void complainsOfTheExtraField();
    void gathersOverALine();
    void saysThatAStationIsSilent();
};

void TestGathering::asksAndReads()
{
    FakeLine line;
    line.expectInPieces(question, hex("00 BB 05") + answer, 5);
    const auto said = askObject(line, objectFive(), 9, 3);
    QVERIFY(said);
    QVERIFY2(line.complaints().isEmpty(), line.complaints().value(0));
    const Weather weather = weatherOf(4, *said, objectFive().ids);
    QCOMPARE(weather.digital, 6U);
    QCOMPARE(weather.parameters.size(), 2);
    QCOMPARE(weather.parameters.at(0).code, QChar(u'T'));
    QCOMPARE(weather.parameters.at(0).number, 2);
    QCOMPARE(weather.parameters.at(0).mean, std::optional(-3.5));
    QCOMPARE(weather.parameters.at(0).instant, std::optional(-3.25));
    QCOMPARE(weather.parameters.at(0).minimum, std::optional(-5.0));
    QCOMPARE(weather.parameters.at(0).maximum, std::optional(1.5));
    QCOMPARE(weather.parameters.at(1).mean, std::optional(745.5));
    QVERIFY(!weather.parameters.at(1).instant);
    QVERIFY(!weather.parameters.at(1).deviation);
}

void TestGathering::repeatsAsOftenAsItMay()
{
    FakeLine late;
    late.expect(question, {}).expect(question, hex("BB 05 00")).expect(question, answer);
    QVERIFY(askObject(late, objectFive(), 9, 3));
    QVERIFY(late.isDone());

    FakeLine silent;
    silent.expect(question, {}).expect(question, {}).expect(question, answer);
    const auto said = askObject(silent, objectFive(), 9, 2);
    QVERIFY(!said);
    QCOMPARE(said.fault(), Fault::Timeout);
    QVERIFY(!silent.isDone());

    FakeLine gone;
    gone.vanishAfter(question);
    const auto closed = askObject(gone, objectFive(), 9, 5);
    QVERIFY(!closed);
    QCOMPARE(closed.fault(), Fault::Closed);
    QVERIFY(gone.isDone());

    FakeLine empty;
    empty.expect(question, noData);
    const auto nothing = askObject(empty, objectFive(), 9, 1);
    QVERIFY(nothing && nothing->parameters.isEmpty());
}

void TestGathering::readsTheLinesOfAckIni()
{
    const StationPlan plan = planFor("1 600 x\n"
                                     "1 0 q1 9600 8 1 0\n"
                                     "1 0 q:tcp://127.0.0.1:4001\n"
                                     "5 60 q2 4800 7 2 2 3:T2,-,P01\n"
                                     "6 0 q:tcp://10.0.0.1:4001\n"
                                     "7 30 q3 9600 8 1 0 8\n");
    QCOMPARE(plan.complaints, QList<StationComplaint>());
    QCOMPARE(plan.dispatchers.size(), 2);
    QCOMPARE(plan.dispatchers.at(0).line.com, 1);
    QVERIFY(!plan.dispatchers.at(0).isListening);
    QVERIFY(plan.dispatchers.at(1).isListening);
    QCOMPARE(plan.gathered.size(), 3);
    const GatheredObject &five = plan.gathered.at(0);
    QCOMPARE(five.number, 5);
    QCOMPARE(five.period, 60s);
    QCOMPARE(five.command, 3);
    QCOMPARE(five.line.baudRate, 4800);
    QCOMPARE(five.line.dataBits, 7);
    QCOMPARE(five.line.parity, Parity::Even);
    QCOMPARE(five.ids, (QList<std::optional<ParameterId>>{ParameterId{u'T', 2}, std::nullopt, ParameterId{u'P', 1}}));
    QCOMPARE(plan.gathered.at(1).command, 4);
    QCOMPARE(plan.gathered.at(1).period, 60s);
    QCOMPARE(plan.gathered.at(2).command, 8);
    // Records: all parameters of the x object, and what the two with a period send.
    QCOMPARE(plan.records.size(), 3);
    QCOMPARE(plan.records.at(0).parameters, (QList<int>{0, 1, 2}));
    QVERIFY(!plan.records.at(0).isGathered);
    QVERIFY(plan.records.at(1).isGathered);
    QCOMPARE(plan.records.at(2).number, 7);
}

void TestGathering::complainsOfTheExtraField_data()
{
    QTest::addColumn<QByteArray>("extra");
    QTest::newRow("no such parameter") << QByteArray("4:T9");
    QTest::newRow("no parameter at all") << QByteArray("4:!x");
    QTest::newRow("command 0") << QByteArray("0:T1");
    QTest::newRow("command 9") << QByteArray("9");
    QTest::newRow("no command") << QByteArray("x:T1");
}

void TestGathering::complainsOfTheExtraField()
{
    QFETCH(QByteArray, extra);
    const StationPlan plan = planFor("1 0 x\n5 60 q2 9600 8 1 0 " + extra + "\n");
    QCOMPARE(plan.complaints.size(), 1);
    QCOMPARE(plan.complaints.at(0).file, QStringLiteral("ACK.INI"));
    QCOMPARE(plan.complaints.at(0).line, 2);
    QCOMPARE(plan.complaints.at(0).field, 8);
    QCOMPARE(plan.gathered.size(), 1); // it is polled all the same
    QCOMPARE(plan.gathered.at(0).command, 4);
}

/// Through a real socket; the values become those of the parameters that ACK.INI names, the others stay as they are.
void TestGathering::gathersOverALine()
{
    QTcpServer server;
    QVERIFY(server.listen(QHostAddress::LocalHost));
    QByteArray heard;
    connect(&server, &QTcpServer::newConnection, this, [&] {
        QTcpSocket *socket = server.nextPendingConnection();
        connect(socket, &QTcpSocket::readyRead, socket, [socket, &heard] {
            heard += socket->readAll();
            if (heard.endsWith(question)) {
                socket->write(answer);
            }
        });
    });
    const StationPlan plan =
        planFor("1 0 x\n5 60 q:tcp://127.0.0.1:" + QByteArray::number(server.serverPort()) + " 9600 8 1 0 4:T02,P01\n");
    Gathering gathering(plan, {});
    QVERIFY(gathering.isObject(5) && !gathering.isObject(6));
    QVERIFY(!gathering.last(5));
    gathering.setOutputs(5, 9);
    gathering.poll(6000);
    QTRY_VERIFY(gathering.last(5));
    QCOMPARE(heard, question);
    gathering.poll(6001); // the same period
    gathering.poll(6059);
    Weather weather;
    for (const auto &[code, number] : {std::pair{u'T', 1}, std::pair{u'T', 2}, std::pair{u'P', 1}}) {
        WeatherParameter parameter;
        parameter.code = code;
        parameter.number = number;
        parameter.name = QStringLiteral("mine");
        parameter.mean = code == u'T' && number == 1 ? std::optional(20.0) : std::nullopt;
        weather.parameters.append(parameter);
    }
    gathering.mergeInto(weather);
    QCOMPARE(weather.parameters.at(0).mean, std::optional(20.0));
    QCOMPARE(weather.parameters.at(1).mean, std::optional(-3.5));
    QCOMPARE(weather.parameters.at(1).name, QStringLiteral("mine"));
    QCOMPARE(weather.parameters.at(2).maximum, std::optional(750.0));
    QCOMPARE(heard, question);
    gathering.poll(6060);
    QTRY_COMPARE(heard, question + question);
}

void TestGathering::saysThatAStationIsSilent()
{
    const StationPlan plan = planFor("1 0 x\n5 1 q:/dev/there-is-no-such-port 9600 8 1 0 4:T02,P01\n");
    Gathering gathering(plan, {});
    const QSignalSpy changes(&gathering, &Gathering::stateChanged);
    for (qint64 clock = 0; clock < 5; ++clock) {
        gathering.poll(clock);
        QTest::qWait(50);
    }
    QCOMPARE(changes.size(), 1); // once, not once a poll
    QCOMPARE(changes.at(0).at(0).toBool(), false);
    QVERIFY(!gathering.last(5));
    QVERIFY(gathering.isObject(5));
}

QTEST_GUILESS_MAIN(TestGathering)

#include "tst_gathering.moc"
