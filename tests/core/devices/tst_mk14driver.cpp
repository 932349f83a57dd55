#include "core/devices/mk14/mk14driver.h"
#include "tests/core/devices/mk14station.h"
#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

// Packed by Python's struct module from manual 004, sections 3.6 and 4.2; address 1, parameters T and M.
namespace {

const QByteArray askEight = hex("BB 01 08 00 00 00 00 00 3C");
const QByteArray askFour = hex("BB 01 04 00 00 00 00 00 40");
const QByteArray eight =
    hex("BB 01 00 02 05 00 00 00 3D 00 00 60 C0 00 00 98 40 00 00 48 41 00 00 40 3F 00 00 10 41 10 FF 53 65 00 00 00 "
        "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 E8");
const QByteArray four =
    hex("BB 01 00 02 05 00 00 00 3D 00 00 60 C0 00 00 50 C0 00 00 80 C0 00 00 40 C0 00 00 98 40 00 00 B0 40 00 00 00 "
        "40 00 00 14 41 33");
const QByteArray threeParameters = hex("BB 01 00 03 00 00 00 00 41 00 00 60 C0 00 00 98 40 00 50 3A 44 3A");
const QByteArray noData = hex("BB 01 00 00 00 00 00 00 44");

DriverSettings settings(const QHash<QString, QString> &options = {})
{
    DriverSettings settings;
    settings.sensor = weatherStation();
    settings.sensor.options = {{QStringLiteral("params"), QStringLiteral("T,M")}};
    settings.sensor.options.insert(options);
    return settings;
}

QStringList textsOf(Driver &driver)
{
    QStringList texts;
    for (const DriverNote &note : driver.takeNotes()) {
        texts.append(note.text);
    }
    return texts;
}

std::optional<double> speed(const Result<Measurement> &measurement, std::optional<double> WeatherParameter::*member)
{
    const WeatherParameter *found = measurement ? measurement->weather->find(weathercode::windSpeed) : nullptr;
    return found ? found->*member : std::nullopt;
}

} // namespace

/// What the recordings in tests/data/mk14 do not show: the words for the journal, and how turns depend on each other.
class TstMk14Driver : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneRequestATurn()
    {
        StationLine line;
        const auto driver = mk14::makeDriver(settings({{QStringLiteral("params"), QString()}}));
        for (int turn = 1; turn <= 4; ++turn) {
            QVERIFY(driver->poll(line));
            QCOMPARE(line.requests(), turn);
        }
    }

    void aFailedTurnForgetsWhatOtherTurnsBrought()
    {
        FakeLine line;
        line.expect(askEight, eight).expect(askFour, four).expect(askEight, {}).expect(askFour, four);
        const auto driver = mk14::makeDriver(settings());
        QCOMPARE(speed(driver->poll(line), &WeatherParameter::deviation), 0.75);
        QCOMPARE(speed(driver->poll(line), &WeatherParameter::deviation), 0.75);
        QCOMPARE(driver->poll(line).fault(), Fault::Timeout);
        const auto last = driver->poll(line);
        QCOMPARE(speed(last, &WeatherParameter::maximum), 9.25);
        QVERIFY(!speed(last, &WeatherParameter::deviation));
        QVERIFY(line.isDone() && line.complaints().isEmpty());
    }

    void aLateAnswerIsNotTakenForTheNextOne()
    {
        FakeLine line;
        line.expectPieces(askEight, {{eight, 220ms}}).expect(askFour, four);
        const auto driver = mk14::makeDriver(settings());
        QCOMPARE(driver->poll(line).fault(), Fault::Timeout);
        const auto next = driver->poll(line);
        QVERIFY(next);
        QCOMPARE(speed(next, &WeatherParameter::instant), 5.5);
        QVERIFY(next->weather->events.isEmpty());
        QVERIFY(line.complaints().isEmpty());
    }

    void aLateAnswerAmidTheNextOneIsPassedOver()
    {
        FakeLine line;
        line.expect(askEight, {}).expectPieces(askFour, {{eight, 5ms}, {four, 5ms}});
        const auto driver = mk14::makeDriver(settings());
        QVERIFY(!driver->poll(line));
        const auto next = driver->poll(line);
        QVERIFY(next);
        QCOMPARE(speed(next, &WeatherParameter::maximum), 9.25);
    }

    void anotherNumberOfParametersIsToldOnce()
    {
        FakeLine line;
        for (int i = 0; i < 3; ++i) {
            line.expect(hex("BB 01 01 00 00 00 00 00 43"), threeParameters);
        }
        const auto driver = mk14::makeDriver(settings({{QStringLiteral("cmd"), QStringLiteral("1")}}));
        QVERIFY(driver->takeNotes().isEmpty());
        for (int i = 0; i < 3; ++i) {
            const auto measurement = driver->poll(line);
            QVERIFY(measurement);
            QCOMPARE(measurement->weather->parameters.size(), 3);
            QCOMPARE(measurement->weather->parameters.last().code, u'?');
            QCOMPARE(measurement->weather->parameters.last().mean, 745.25);
        }
        QCOMPARE(
            textsOf(*driver),
            QStringList{QStringLiteral("The station sends 3 parameters, but 2 are listed. Its values are named by "
                                       "their place. Make Params1 or "
                                       "ParFile1 agree with the station's ACK.PAR.")});
    }

    void noDataAndDataAgainAreToldOnce()
    {
        FakeLine line;
        line.expect(askEight, noData).expect(askFour, noData).expect(askEight, eight).expect(askFour, four);
        const auto driver = mk14::makeDriver(settings());
        for (int i = 0; i < 4; ++i) {
            const auto measurement = driver->poll(line);
            QVERIFY(measurement);
            QCOMPARE(measurement->temperature.has_value(), i >= 2);
            QVERIFY(!measurement->conditions);
        }
        QCOMPARE(
            textsOf(*driver),
            QStringList(
                {QStringLiteral("The station answers, but has no data. It may just have been switched on."),
                 QStringLiteral("The station has data again.")}));
    }

    void aCommandThatIsNotKnownThereIsTold()
    {
        FakeLine line;
        for (int i = 0; i < 7; ++i) {
            line.expect(askEight, {}).expect(askFour, four);
        }
        const auto driver = mk14::makeDriver(settings());
        for (int i = 0; i < 14; ++i) {
            QCOMPARE(bool(driver->poll(line)), i % 2 == 1);
        }
        QCOMPARE(
            textsOf(*driver),
            QStringList{
                QStringLiteral("The station does not answer CMD 8, but others it does. Leave it out in Cmd1.")});
    }

    void silenceIsNoReasonForSuchWords()
    {
        FakeLine line;
        line.expect(askEight, eight);
        for (int i = 0; i < 10; ++i) {
            line.expect(i % 2 == 0 ? askFour : askEight, {});
        }
        const auto driver = mk14::makeDriver(settings());
        QVERIFY(driver->poll(line));
        for (int i = 0; i < 10; ++i) {
            QVERIFY(!driver->poll(line));
        }
        QCOMPARE(textsOf(*driver), QStringList());
    }

    void outputsOfTheUserStandInEveryPoll()
    {
        FakeLine line;
        line.expect(hex("BB 01 01 00 05 00 00 00 3E"), threeParameters)
            .expect(hex("BB 01 01 00 00 00 00 80 C3"), threeParameters);
        const auto driver = mk14::makeDriver(
            settings({{QStringLiteral("cmd"), QStringLiteral("1")}, {QStringLiteral("outputs"), QStringLiteral("5")}}));
        QVERIFY(driver->poll(line));
        line.setStandingWord(2, 0xFF); // of another station
        line.setStandingWord(1, 0x80000000);
        driver->restart();
        QVERIFY(driver->poll(line));
        QVERIFY(line.isDone() && line.complaints().isEmpty());
    }

    void complaintsReachTheJournal()
    {
        const auto driver = mk14::makeDriver(settings({{QStringLiteral("cmd"), QStringLiteral("9")}}));
        const QStringList texts = textsOf(*driver);
        QCOMPARE(texts.size(), 1);
        QVERIFY(texts.first().startsWith(QStringLiteral("Cmd1 is \"9\"")));
    }
};

QTEST_GUILESS_MAIN(TstMk14Driver)
#include "tst_mk14driver.moc"
