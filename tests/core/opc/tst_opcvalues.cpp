#include "core/opc/opcimage.h"
#include "core/values/statusword.h"
#include "tests/core/opc/opcsite.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace gorizont;
using namespace gorizont::test;
using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

namespace {

constexpr UtcTime start{1'700'000'000s};
constexpr SteadyTime opened{100s};

const QString and3 = u"[COM5].Sensor_001[AND3][Addr:002]."_s;
const QString ind3 = u"[COM16].Sensor_002[IND3][Addr:003]."_s;
const QString module_ = u"[COM7].Sensor_030[LVIMS][Addr:001]."_s;
const QString station = u"[COM7].Sensor_030[MK14][Addr:001]."_s;

LineStatus openLine(int port)
{
    LineStatus status;
    status.port = port;
    status.state = LineState::Open;
    status.openedAt = opened;
    return status;
}

/// A healthy answer of an АН-Д3: the word is that of spec/and3.md.
Reading and3Answer(UtcTime time = start + 1s)
{
    Reading reading;
    reading.number = 1;
    reading.time = time;
    reading.isAnswer = true;
    reading.answeredAt = opened + 1s;
    reading.rawStatus = 0x240F;
    reading.tilt = Tilt{-3599.5, 12.25};
    reading.temperature = 26.448;
    reading.acceleration = AccelStatistics{5, 3, -4, 300, 2.5, 1.5, 2};
    reading.ring = RingProgress{5000, 3119};
    return reading;
}

Reading ind3Answer(quint16 status = statusbit::TemperatureInvalid | statusbit::AccelerationInvalid)
{
    Reading reading = and3Answer();
    reading.number = 2;
    reading.status = status;
    reading.rawStatus.reset();
    reading.temperature.reset();
    reading.acceleration.reset();
    reading.ring.reset();
    return reading;
}

/// The image of a site whose lines are open.
class Bench
{
public:
    explicit Bench(const QByteArray &more = {}, bool isOpen = true)
        : m_config(opcSite(more))
        , m_image(m_config.lines, opcTags(m_config.lines), start)
    {
        for (int port = 1; isOpen && port <= 3; ++port) {
            put(openLine(port));
        }
    }

    void put(const Reading &reading) { m_image.update(reading, changed); }
    void put(const LineStatus &status, UtcTime now = start) { m_image.update(status, now, changed); }

    int indexOf(const QString &name) const
    {
        const QList<OpcTag> &tags = m_image.tags();
        const auto tag = std::ranges::find(tags, name, &OpcTag::name);
        return tag != tags.end() ? static_cast<int>(tag - tags.begin()) : -1;
    }
    OpcSample at(const QString &name) const
    {
        const int index = indexOf(name);
        return index >= 0 ? m_image.sample(index) : OpcSample{7777.0, OpcQuality::Good, {}};
    }
    /// `-3599.5 192`, `true 192`, `- 24`
    QString text(const QString &name) const
    {
        const OpcSample sample = at(name);
        QString value = u"-"_s;
        if (const bool *isSet = std::get_if<bool>(&sample.value)) {
            value = *isSet ? u"true"_s : u"false"_s;
        } else if (const double *number = std::get_if<double>(&sample.value)) {
            value = QString::number(*number);
        }
        return value + u' ' + QString::number(static_cast<int>(sample.quality));
    }

    std::vector<int> changed;

private:
    ServerConfig m_config;
    OpcImage m_image;
};

} // namespace

class TestOpcValues : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyFieldOfAnAnswer();
    void stateIsTheRawWord();
    void stateOfASensorWithoutAWord_data();
    void stateOfASensorWithoutAWord();
    void waitsBeforeTheFirstAnswer();
    void silentSensorKeepsItsLastValue();
    void silentSensorThatNeverAnswered();
    void portThatIsGone_data();
    void portThatIsGone();
    void anAnswerFromBeforeThePortWentIsNotOfNow();
    void switchedOff();
    void faultyTransducer();
    void faultyThermometerBehindAnotherCode();
    void notReadyWaits();
    void notMeasuredIsOutOfService();
    void timesAreThoseOfTheReadings();
    void onlyWhatChangedIsTold();
    void countersOfALineChangeNothing();
    void numbersThatAreNoneAreFailures();
    void unknownSensorChangesNothing();
    void vibration();
    void weather();
    void displacement();
};

void TestOpcValues::everyFieldOfAnAnswer()
{
    Bench bench;
    bench.put(and3Answer());
    QCOMPARE(bench.text(and3 + u"DATA.Angl_X"_s), u"-3599.5 192"_s);
    QCOMPARE(bench.text(and3 + u"DATA.Angl_Y"_s), u"12.25 192"_s);
    QCOMPARE(bench.text(and3 + u"DATA.AMax_X"_s), u"3 192"_s);
    QCOMPARE(bench.text(and3 + u"DATA.AMax_Y"_s), u"-4 192"_s);
    QCOMPARE(bench.text(and3 + u"DATA.ARms_X"_s), u"1.5 192"_s);
    QCOMPARE(bench.text(and3 + u"DATA.ARms_Y"_s), u"2 192"_s);
    QCOMPARE(bench.text(and3 + u"DATA.Temper"_s), u"26.448 192"_s);
    QCOMPARE(bench.text(and3 + u"DATA.8_Reserv"_s), u"3119 192"_s);
    bench.put(ind3Answer());
    QCOMPARE(bench.text(ind3 + u"DATA.Angl_X"_s), u"-3599.5 192"_s);
    for (const char *leaf : {"3_Reserv", "4_Reserv", "5_Reserv", "6_Reserv", "7_Reserv", "8_Reserv"}) {
        QCOMPARE(bench.text(ind3 + u"DATA."_s + QLatin1String(leaf)), u"0 192"_s);
    }
}

/// spec/opc.md: Restart = bit 0, ReadyAngl 1, ReadyTmp 2, ReadErr 4, CRCErr 5, RangdErr 6, TReadErr 8, TRangErr 9.
void TestOpcValues::stateIsTheRawWord()
{
    const QList<QPair<int, QString>> bits{{0, u"Restart"_s},  {1, u"ReadyAngl"_s}, {2, u"ReadyTmp"_s},
                                          {4, u"ReadErr"_s},  {5, u"CRCErr"_s},    {6, u"RangdErr"_s},
                                          {8, u"TReadErr"_s}, {9, u"TRangErr"_s}};
    for (int set = 0; set < 16; ++set) {
        Bench bench;
        Reading reading = and3Answer();
        reading.rawStatus = static_cast<quint16>(1 << set);
        bench.put(reading);
        for (const auto &[bit, leaf] : bits) {
            QCOMPARE(bench.text(and3 + u"STATE."_s + leaf), bit == set ? u"true 192"_s : u"false 192"_s);
        }
    }
}

void TestOpcValues::stateOfASensorWithoutAWord_data()
{
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("set");
    QTest::newRow("well") << 0x0300 << u"Restart ReadyAngl"_s;
    QTest::newRow("well with temperature") << 0x0100 << u"Restart ReadyAngl ReadyTmp"_s;
    QTest::newRow("restarted") << 0x0720 << QString();
    QTest::newRow("transducer silent") << 0x5700 << u"Restart ReadErr"_s;
    QTest::newRow("transducer CRC") << 0x6700 << u"Restart CRCErr"_s;
    QTest::newRow("transducer range") << 0x7700 << u"Restart RangdErr"_s;
    QTest::newRow("thermometer") << 0x8300 << u"Restart ReadyAngl TReadErr"_s;
    QTest::newRow("temperature range") << 0x9300 << u"Restart ReadyAngl TRangErr"_s;
}

void TestOpcValues::stateOfASensorWithoutAWord()
{
    QFETCH(const int, status);
    QFETCH(const QString, set);
    Bench bench;
    bench.put(ind3Answer(static_cast<quint16>(status)));
    QStringList found;
    for (const char *leaf :
         {"Restart", "ReadyAngl", "ReadyTmp", "ReadErr", "CRCErr", "RangdErr", "TReadErr", "TRangErr"}) {
        const QString text = bench.text(ind3 + u"STATE."_s + QLatin1String(leaf));
        QVERIFY2(text.endsWith(u" 192"), qPrintable(text));
        if (text.startsWith(u"true")) {
            found.append(QLatin1String(leaf));
        }
    }
    QCOMPARE(found.join(u' '), set);
}

void TestOpcValues::waitsBeforeTheFirstAnswer()
{
    Bench bench({}, false);
    QCOMPARE(bench.text(and3 + u"DATA.Angl_X"_s), u"- 32"_s);
    QCOMPARE(bench.text(and3 + u"STATE.Restart"_s), u"- 32"_s);
    QCOMPARE(bench.at(and3 + u"STATE.Restart"_s).time, start);
    bench.put(openLine(1));
    QCOMPARE(bench.text(and3 + u"DATA.Angl_X"_s), u"- 32"_s);
}

void TestOpcValues::silentSensorKeepsItsLastValue()
{
    Bench bench;
    bench.put(and3Answer());
    Reading silent = and3Answer(start + 12s);
    silent.isAnswer = false;
    silent.status = 0x3700;
    bench.put(silent);
    QCOMPARE(bench.text(and3 + u"DATA.Angl_X"_s), u"-3599.5 20"_s);
    QCOMPARE(bench.text(and3 + u"STATE.ReadyAngl"_s), u"true 20"_s);
    silent.status = 0x4700;
    bench.put(silent);
    QCOMPARE(bench.text(and3 + u"DATA.Angl_X"_s), u"-3599.5 20"_s);
    bench.put(and3Answer(start + 13s));
    QCOMPARE(bench.text(and3 + u"DATA.Angl_X"_s), u"-3599.5 192"_s);
    // a word of the program is not the sensor's last state
    bench.put(ind3Answer());
    Reading quiet = ind3Answer(0x3700);
    quiet.isAnswer = false;
    bench.put(quiet);
    QCOMPARE(bench.text(ind3 + u"STATE.ReadyAngl"_s), u"true 20"_s);
}

void TestOpcValues::silentSensorThatNeverAnswered()
{
    Bench bench;
    Reading silent;
    silent.number = 1;
    silent.status = 0x3700;
    bench.put(silent);
    QCOMPARE(bench.text(and3 + u"DATA.Angl_X"_s), u"- 24"_s);
    QCOMPARE(bench.text(and3 + u"STATE.Restart"_s), u"- 24"_s);
}

void TestOpcValues::portThatIsGone_data()
{
    QTest::addColumn<LineState>("state");
    QTest::addColumn<int>("quality");
    QTest::newRow("cannot be opened") << LineState::OpenFailed << 8;
    QTest::newRow("lost") << LineState::Lost << 8;
    QTest::newRow("off") << LineState::Off << 28;
    QTest::newRow("service") << LineState::Service << 28;
    QTest::newRow("opening") << LineState::Opening << 32;
}

void TestOpcValues::portThatIsGone()
{
    QFETCH(const LineState, state);
    QFETCH(const int, quality);
    Bench bench;
    bench.put(and3Answer());
    bench.put(ind3Answer());
    LineStatus status;
    status.port = 1;
    status.state = state;
    bench.put(status, start + 5s);
    QCOMPARE(bench.text(and3 + u"DATA.Angl_X"_s), u"-3599.5 %1"_s.arg(quality));
    QCOMPARE(bench.at(and3 + u"DATA.Angl_X"_s).time, start + 5s);
    QCOMPARE(bench.text(ind3 + u"DATA.Angl_X"_s), u"-3599.5 192"_s);
}

void TestOpcValues::anAnswerFromBeforeThePortWentIsNotOfNow()
{
    Bench bench;
    bench.put(and3Answer());
    LineStatus again = openLine(1);
    again.openedAt = opened + 60s;
    bench.put(again);
    QCOMPARE(bench.text(and3 + u"STATE.Restart"_s), u"true 32"_s);
    Reading reading = and3Answer(start + 61s);
    reading.answeredAt = opened + 61s;
    bench.put(reading);
    QCOMPARE(bench.text(and3 + u"STATE.Restart"_s), u"true 192"_s);
}

void TestOpcValues::switchedOff()
{
    Bench bench("[Port3]\nNum=7\nOn=0\nNumOfSensors=1\nadr1=1\nN1=30\nOn1=1\nName1=IN-D3\n", false);
    QCOMPARE(bench.text(u"[COM7].Sensor_030[IND3][Addr:001].DATA.Angl_X"_s), u"- 28"_s); // by its port
    Bench other("[Port3]\nNum=7\nOn=1\nNumOfSensors=1\nadr1=1\nN1=30\nOn1=0\nName1=IN-D3\n");
    QCOMPARE(other.text(u"[COM7].Sensor_030[IND3][Addr:001].DATA.Angl_X"_s), u"- 28"_s); // by itself
    Reading reading = and3Answer();
    reading.status = statusbit::NotPolled | 0x0700;
    other.put(reading);
    QCOMPARE(other.text(and3 + u"DATA.Angl_X"_s), u"- 28"_s);
}

void TestOpcValues::faultyTransducer()
{
    for (const int code : {5, 6, 7}) {
        Bench bench;
        Reading reading = and3Answer();
        reading.status = static_cast<quint16>(code << 12 | statusbit::TiltInvalid);
        bench.put(reading);
        QCOMPARE(bench.text(and3 + u"DATA.Angl_X"_s), u"-3599.5 16"_s);
        QCOMPARE(bench.text(and3 + u"DATA.Temper"_s), u"26.448 192"_s);
    }
    for (const int code : {8, 9}) {
        Bench bench;
        Reading reading = and3Answer();
        reading.status = static_cast<quint16>(code << 12 | statusbit::TemperatureInvalid);
        bench.put(reading);
        QCOMPARE(bench.text(and3 + u"DATA.Temper"_s), u"26.448 16"_s);
        QCOMPARE(bench.text(and3 + u"DATA.Angl_X"_s), u"-3599.5 192"_s);
    }
}

void TestOpcValues::faultyThermometerBehindAnotherCode()
{
    Bench bench;
    Reading reading = and3Answer();
    reading.status = 0x5000 | statusbit::TiltInvalid | statusbit::TemperatureInvalid;
    bench.put(reading);
    QCOMPARE(bench.text(and3 + u"DATA.Temper"_s), u"26.448 32"_s);
    reading.rawStatus = 0x0111;
    bench.put(reading);
    QCOMPARE(bench.text(and3 + u"DATA.Temper"_s), u"26.448 16"_s);
}

void TestOpcValues::notReadyWaits()
{
    Bench bench;
    Reading reading = and3Answer();
    reading.status = statusbit::TiltInvalid | statusbit::TemperatureInvalid | statusbit::AccelerationInvalid;
    reading.tilt.reset();
    bench.put(reading);
    QCOMPARE(bench.text(and3 + u"DATA.Angl_X"_s), u"- 32"_s);
    QCOMPARE(bench.text(and3 + u"DATA.Temper"_s), u"26.448 32"_s);
    QCOMPARE(bench.text(and3 + u"DATA.AMax_X"_s), u"3 32"_s);
    QCOMPARE(bench.text(and3 + u"STATE.Restart"_s), u"true 192"_s);
}

void TestOpcValues::notMeasuredIsOutOfService()
{
    Bench bench("[Port3]\nNum=7\nOn=1\nNumOfSensors=1\nadr1=1\nN1=30\nOn1=1\nName1=АН-Д3\nAccelOn1=0\n");
    Reading reading = and3Answer();
    reading.number = 30;
    bench.put(reading);
    QCOMPARE(bench.text(u"[COM7].Sensor_030[AND3][Addr:001].DATA.AMax_X"_s), u"- 28"_s);
    QCOMPARE(bench.text(u"[COM7].Sensor_030[AND3][Addr:001].DATA.Angl_X"_s), u"-3599.5 192"_s);
}

void TestOpcValues::timesAreThoseOfTheReadings()
{
    Bench bench;
    bench.put(and3Answer(start + 1s));
    bench.put(and3Answer(start + 2s)); // the same values, asked anew
    QCOMPARE(bench.at(and3 + u"DATA.Angl_X"_s).time, start + 2s);
    Reading silent = and3Answer(start + 3s);
    silent.isAnswer = false;
    bench.put(silent); // one lost answer, not yet a failure
    QCOMPARE(bench.at(and3 + u"DATA.Angl_X"_s).time, start + 2s);
    silent.status = 0x3700;
    silent.time = start + 4s;
    bench.put(silent);
    QCOMPARE(bench.at(and3 + u"DATA.Angl_X"_s).time, start + 4s);
    silent.time = start + 5s;
    bench.put(silent); // still silent
    QCOMPARE(bench.at(and3 + u"DATA.Angl_X"_s).time, start + 4s);
}

void TestOpcValues::onlyWhatChangedIsTold()
{
    Bench bench;
    bench.put(and3Answer());
    bench.changed.clear();
    Reading reading = and3Answer();
    reading.tilt->y = 13;
    bench.put(reading);
    QCOMPARE(bench.changed, std::vector<int>{bench.indexOf(and3 + u"DATA.Angl_Y"_s)});
}

void TestOpcValues::countersOfALineChangeNothing()
{
    Bench bench;
    bench.put(and3Answer());
    bench.changed.clear();
    LineStatus status = openLine(1);
    status.bytesReceived = 1000;
    bench.put(status, start + 9s);
    QVERIFY(bench.changed.empty());
    QCOMPARE(bench.at(and3 + u"DATA.Angl_X"_s).time, start + 1s);
}

void TestOpcValues::numbersThatAreNoneAreFailures()
{
    Bench bench;
    Reading reading = and3Answer();
    reading.tilt = Tilt{std::nan(""), INFINITY};
    bench.put(reading);
    QCOMPARE(bench.text(and3 + u"DATA.Angl_X"_s), u"- 16"_s);
    QCOMPARE(bench.text(and3 + u"DATA.Angl_Y"_s), u"- 16"_s);
}

void TestOpcValues::unknownSensorChangesNothing()
{
    Bench bench;
    bench.changed.clear();
    Reading reading = and3Answer();
    reading.number = 99;
    bench.put(reading);
    bench.put(openLine(9));
    QVERIFY(bench.changed.empty());
}

void TestOpcValues::vibration()
{
    Bench bench(
        "[Port3]\nNum=7\nOn=1\nDevice=tcp://127.0.0.1:502\nNumOfSensors=1\nadr1=1\nN1=30\nOn1=1\nName1=L-VIMS\n");
    Reading reading;
    reading.number = 30;
    reading.time = start + 1s;
    reading.isAnswer = true;
    reading.answeredAt = opened + 1s;
    reading.status = 0x0700;
    VibrationMeasurement measurement;
    measurement.index = 2;
    measurement.type = 5;
    measurement.value = 1.25;
    measurement.warning = true;
    measurement.stop = false;
    VibrationChannel good{0, ChannelState::Good, true, {measurement}};
    VibrationChannel broken{1, ChannelState::Break, true, {measurement}};
    VibrationChannel off{2, ChannelState::Good, false, {measurement}};
    VibrationChannel early{3, ChannelState::NoData, true, {measurement}};
    reading.vibration =
        Vibration{{good, broken, off, early}, {{4, true, false, true, true}, {5, true, true, false, false}}};
    bench.put(reading);
    const auto text = [&](const char *path) { return bench.text(module_ + QLatin1String(path)); };
    QCOMPARE(text("DATA.Channel_0.Meas_2.Value"), u"1.25 192"_s);
    QCOMPARE(text("DATA.Channel_0.Meas_2.Type"), u"5 192"_s);
    QCOMPARE(text("DATA.Channel_0.Meas_2.Percent"), u"- 16"_s);
    QCOMPARE(text("DATA.Channel_0.Meas_1.Value"), u"- 28"_s); // not in use
    QCOMPARE(text("STATE.Channel_0.Meas_2.Warning"), u"true 192"_s);
    QCOMPARE(text("STATE.Channel_0.Meas_2.Stop"), u"false 192"_s);
    QCOMPARE(text("STATE.Channel_0.Meas_2.Fault"), u"- 32"_s); // the module does not know
    QCOMPARE(text("STATE.Channel_0.Meas_2.Baseline"), u"- 28"_s); // there is none
    QCOMPARE(text("STATE.Channel_0.Break"), u"false 192"_s);
    QCOMPARE(text("STATE.Channel_1.Break"), u"true 192"_s);
    QCOMPARE(text("STATE.Channel_1.ShortCircuit"), u"false 192"_s);
    QCOMPARE(text("DATA.Channel_1.Meas_2.Value"), u"1.25 16"_s);
    QCOMPARE(text("DATA.Channel_2.Meas_2.Value"), u"- 28"_s);
    QCOMPARE(text("DATA.Channel_3.Meas_2.Value"), u"1.25 32"_s);
    QCOMPARE(text("STATE.Channel_3.Break"), u"- 32"_s);
    QCOMPARE(text("STATE.Relay_4.Logical"), u"true 192"_s);
    QCOMPARE(text("STATE.Relay_4.Physical"), u"false 192"_s);
    QCOMPARE(text("STATE.Relay_4.Error"), u"true 192"_s);
    QCOMPARE(text("STATE.Relay_5.Logical"), u"- 28"_s);
    reading.vibration->channels[0].state = ChannelState::ShortCircuit;
    bench.put(reading);
    QCOMPARE(text("STATE.Channel_0.ShortCircuit"), u"true 192"_s);
}

void TestOpcValues::weather()
{
    Bench bench("[Port3]\nNum=7\nOn=1\nNumOfSensors=1\nadr1=1\nN1=30\nOn1=1\nName1=МК-14\n");
    Reading reading;
    reading.number = 30;
    reading.time = start + 1s;
    reading.isAnswer = true;
    reading.answeredAt = opened + 1s;
    reading.status = 0x0700;
    WeatherParameter parameter;
    parameter.code = u'T';
    parameter.mean = -3.5;
    parameter.deviation = 0.25;
    reading.weather = Weather{0x80000005, {parameter}, {}};
    bench.put(reading);
    const auto text = [&](const char *path) { return bench.text(station + QLatin1String(path)); };
    QCOMPARE(text("DATA.T_1.Mean"), u"-3.5 192"_s);
    QCOMPARE(text("DATA.T_1.Deviation"), u"0.25 192"_s);
    QCOMPARE(text("DATA.T_1.Instant"), u"- 32"_s); // never given so far
    QCOMPARE(text("DATA.P_1.Mean"), u"- 32"_s);
    QCOMPARE(text("STATE.Input_00"), u"true 192"_s);
    QCOMPARE(text("STATE.Input_01"), u"false 192"_s);
    QCOMPARE(text("STATE.Input_31"), u"true 192"_s);
    QCOMPARE(text("STATE.Precipitation"), u"- 32"_s);
    reading.weather->parameters[0].mean.reset();
    reading.weather->events = {{false, 20}, {true, 10}}; // the newest first
    bench.put(reading);
    QCOMPARE(text("DATA.T_1.Mean"), u"-3.5 16"_s); // it was there and is not any more
    QCOMPARE(text("STATE.Precipitation"), u"false 192"_s);
}

void TestOpcValues::displacement()
{
    Bench bench("[Port3]\nNum=7\nOn=1\nNumOfSensors=1\nadr1=1\nN1=30\nOn1=1\nName1=IN-D3\n[Chain1]\nN1=30\nL1=3\n");
    Reading reading = ind3Answer();
    reading.number = 30;
    reading.displacement = LinkDisplacement{{1, 2}, Displacement{3.5, -4}};
    bench.put(reading);
    QCOMPARE(bench.text(u"[COM7].Sensor_030[IND3][Addr:001].DATA.Displ_X"_s), u"3.5 192"_s);
    QCOMPARE(bench.text(u"[COM7].Sensor_030[IND3][Addr:001].DATA.Displ_Y"_s), u"-4 192"_s);
    reading.displacement->sum.reset();
    bench.put(reading);
    QCOMPARE(bench.text(u"[COM7].Sensor_030[IND3][Addr:001].DATA.Displ_X"_s), u"3.5 16"_s);
}

QTEST_APPLESS_MAIN(TestOpcValues)
#include "tst_opcvalues.moc"
