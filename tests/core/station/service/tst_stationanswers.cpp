#include "core/station/service/weatheranswer.h"
#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::station;
using namespace gorizont::test;

namespace {

/// P1 has every value, T1 none; it began to rain after it had ended.
Weather weather()
{
    WeatherParameter pressure;
    pressure.code = u'P';
    pressure.mean = 12.5;
    pressure.instant = 12.25;
    pressure.minimum = 12;
    pressure.maximum = 13;
    pressure.voltage = 2.5;
    pressure.voltageInstant = 2.25;
    pressure.maxPeriod = 12.75;
    pressure.deviation = 0.5;
    WeatherParameter temperature;
    temperature.code = u'T';
    WeatherParameter vector;
    vector.code = u'W';
    vector.mean = 99;
    Weather made;
    made.digital = 0x80000005;
    made.parameters = {pressure, temperature, vector};
    made.events = {{true, 1'700'000'600}, {false, 1'700'000'000}};
    return made;
}

const WindExtras extras{10.5, std::nullopt, 7.25};

} // namespace

class TestStationAnswers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void answersEveryCommand_data();
    void answersEveryCommand();
    void saysNothingWithoutAValue();
    void readsWhatAnotherStationSays_data();
    void readsWhatAnotherStationSays();
};

// Made with Python's struct; the third parameter is not sent.
void TestStationAnswers::answersEveryCommand_data()
{
    QTest::addColumn<int>("command");
    QTest::addColumn<QByteArray>("expected");
    QTest::newRow("1") << 1 << hex("BB 01 00 02 05 00 00 80 BD 00 00 48 41 FF FF FF FF 7B");
    QTest::newRow("2") << 2 << hex("BB 01 00 02 05 00 00 80 BD 00 00 48 41 00 00 44 41 FF FF FF FF FF FF FF FF FA");
    QTest::newRow("3")
        << 3
        << hex("BB 01 00 02 05 00 00 80 BD 00 00 48 41 00 00 40 41 00 00 50 41 FF FF FF FF FF FF FF FF FF FF FF FF 71");
    QTest::newRow("4") << 4
                       << hex("BB 01 00 02 05 00 00 80 BD 00 00 48 41 00 00 44 41 00 00 40 41 00 00 50 41 FF FF FF FF "
                              "FF FF FF FF FF FF FF FF FF FF FF FF F0");
    QTest::newRow("5") << 5
                       << hex("BB 01 00 02 05 00 00 80 BD 00 00 48 41 00 00 44 41 00 00 40 41 00 00 50 41 00 00 20 40 "
                              "FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF 94");
    QTest::newRow("6") << 6
                       << hex("BB 01 00 02 05 00 00 80 BD 00 00 48 41 00 00 44 41 00 00 40 41 00 00 50 41 00 00 20 40 "
                              "00 00 10 40 FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF 48");
    QTest::newRow("7")
        << 7
        << hex("BB 01 00 02 05 00 00 80 BD 00 00 48 41 00 00 4C 41 00 00 00 3F FF FF FF FF FF FF FF FF FF FF FF FF B7");
    QTest::newRow("8") << 8
                       << hex("BB 01 00 02 05 00 00 80 BD 00 00 48 41 FF FF FF FF 00 00 28 41 FF FF FF FF 00 00 E8 40 "
                              "58 F3 53 65 00 0F AC 9A 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 "
                              "00 00 00 00 00 00 00 00 00 00 00 96");
}

void TestStationAnswers::answersEveryCommand()
{
    QFETCH(int, command);
    QFETCH(QByteArray, expected);
    const ack::Answer answer = answerOf(command, weather(), 2, extras);
    QCOMPARE(ack::encodeAnswer(1, command, answer).toHex(' '), expected.toHex(' '));
}

void TestStationAnswers::saysNothingWithoutAValue()
{
    Weather empty = weather();
    empty.parameters.first() = WeatherParameter();
    for (int command = 1; command <= 8; ++command) {
        const ack::Answer answer = answerOf(command, empty, 2, extras);
        QCOMPARE(ack::encodeAnswer(1, command, answer).toHex(' '), hex("BB 01 00 00 05 00 00 80 BF").toHex(' '));
        QVERIFY(answerOf(command, {}, 6, {}).parameters.isEmpty());
    }
}

void TestStationAnswers::readsWhatAnotherStationSays_data()
{
    answersEveryCommand_data();
}

void TestStationAnswers::readsWhatAnotherStationSays()
{
    QFETCH(int, command);
    QFETCH(QByteArray, expected);
    const auto answer = ack::decodeAnswer(expected, {1, static_cast<quint8>(command), 2});
    QVERIFY(answer);
    const Weather read = weatherOf(command, *answer, {ParameterId{u'P', 1}});
    QCOMPARE(read.digital, 0x80000005U);
    QCOMPARE(read.parameters.size(), 2);
    QCOMPARE(read.parameters.at(0).code, QChar(u'P'));
    QCOMPARE(read.parameters.at(0).mean, std::optional(12.5));
    QCOMPARE(read.parameters.at(0).instant.has_value(), command == 2 || (command >= 4 && command <= 6));
    QCOMPARE(read.parameters.at(0).minimum.has_value(), command >= 3 && command <= 6);
    QCOMPARE(read.parameters.at(0).voltageInstant, command == 6 ? std::optional(2.25) : std::nullopt);
    QCOMPARE(read.parameters.at(0).maxPeriod, command == 7 ? std::optional(12.75) : std::nullopt);
    QVERIFY(read.parameters.at(1).code.isNull());
    QVERIFY(!read.parameters.at(1).mean);
    QCOMPARE(read.events, command == 8 ? weather().events : QList<PrecipitationEvent>());
    QCOMPARE(extrasOf(*answer), command == 8 ? extras : WindExtras());
}

QTEST_GUILESS_MAIN(TestStationAnswers)

#include "tst_stationanswers.moc"
