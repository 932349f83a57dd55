#include "core/values/statustext.h"
#include "core/values/vibrationkinds.h"
#include "core/values/vibrationtext.h"

#include <QTest>

using namespace gorizont;
using Qt::Literals::StringLiterals::operator""_s;

namespace {

VibrationChannel channel(int number, ChannelState state, bool isEnabled = true)
{
    return {number, state, isEnabled, {}};
}

SensorConfig sensorWith(const QString &units)
{
    SensorConfig sensor;
    sensor.index = 2;
    sensor.options.insert(u"measunit"_s, units);
    return sensor;
}

} // namespace

class TestVibrationText : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// spec/l-vims.md, 6.
    void unitsOfTheTypes()
    {
        const QStringList expected{u""_s,      u"mm/s²"_s, u"mm/s"_s, u"µm"_s, u"µm"_s, u"rpm"_s,
                                   u"mm/s²"_s, u"°"_s,     u"mm/s"_s, u"°"_s,  u"µm"_s, u"°"_s,
                                   u"mm/s²"_s, u"mm/s²"_s, u"mm/s"_s, u"µm"_s, u"µm"_s};
        for (int type = 0; type <= 16; ++type) {
            QCOMPARE(MeasurementUnits().of(type), expected.at(type));
        }
        QCOMPARE(MeasurementUnits().of(17), QString());
        QCOMPARE(measurementName(14), u"RMS of a harmonic of velocity"_s);
        QCOMPARE(measurementName(99), QString());
    }

    void aUnitForAllAccelerations()
    {
        const MeasurementUnits units(sensorWith(u"g"_s));
        QCOMPARE(units.complaints(), QStringList());
        for (const int type : {1, 6, 12, 13}) {
            QCOMPARE(units.of(type), u"g"_s);
        }
        QCOMPARE(units.of(2), u"mm/s"_s);
        QCOMPARE(units.of(7), u"°"_s);
    }

    void unitsOfSomeTypes()
    {
        const MeasurementUnits units(sensorWith(u"4: mm , 5:1/s"_s));
        QCOMPARE(units.complaints(), QStringList());
        QCOMPARE(units.of(4), u"mm"_s);
        QCOMPARE(units.of(5), u"1/s"_s);
        QCOMPARE(units.of(3), u"µm"_s);
    }

    void unitsThatAreNotUnderstood()
    {
        const MeasurementUnits units(sensorWith(u"17:mm,0:g,x:g,3:,thisisfartoolongforaunit,2:in/s"_s));
        QCOMPARE(units.complaints().size(), 5);
        QVERIFY(units.complaints().at(0).startsWith(u"MeasUnit2: \"17:mm\" is not understood."_s));
        QCOMPARE(units.of(1), u"mm/s²"_s);
        QCOMPARE(units.of(3), u"µm"_s);
        QCOMPARE(units.of(2), u"in/s"_s);
    }

    void lineFaults()
    {
        Vibration vibration;
        vibration.channels = {
            channel(0, ChannelState::ShortCircuit), channel(1, ChannelState::Break),
            channel(2, ChannelState::ShortCircuit), channel(3, ChannelState::Break, false)};
        QCOMPARE(
            vibrationtext::lineFaults(vibration),
            u"Line of the sensor shorted: channel 0, 2; line of the sensor broken: channel 1"_s);
        vibration.channels = {channel(0, ChannelState::NoData), channel(1, ChannelState::Break)};
        QCOMPARE(vibrationtext::lineFaults(vibration), u"Line of the sensor broken: channel 1"_s);
        vibration.channels = {channel(0, ChannelState::Good)};
        QCOMPARE(vibrationtext::lineFaults(vibration), QString());
    }

    void whenNoSensorWorks()
    {
        Vibration vibration;
        QVERIFY(!vibration.isWithoutSensors()); // no channel at all
        vibration.channels = {channel(0, ChannelState::ShortCircuit), channel(1, ChannelState::Good, false)};
        QVERIFY(vibration.isWithoutSensors());
        vibration.channels[1].isEnabled = true;
        QVERIFY(!vibration.isWithoutSensors());
        vibration.channels[1].state = ChannelState::NoData;
        QVERIFY(!vibration.isWithoutSensors());
        vibration.channels = {channel(0, ChannelState::Break, false)};
        QVERIFY(!vibration.isWithoutSensors()); // none is in use
    }

    /// What the operator reads for code 5: the lines of a module, the transducer of any other sensor.
    void statusOfAModule()
    {
        Reading reading;
        reading.status = 0x5700;
        QCOMPARE(statusText(reading), statusText(StatusCode::TransducerSilent));
        reading.vibration = Vibration{{channel(1, ChannelState::Break)}, {}};
        QCOMPARE(statusText(reading), u"Line of the sensor broken: channel 1"_s);
        reading.status = 0x3700;
        QCOMPARE(statusText(reading), statusText(StatusCode::NoAnswer));
    }

    void flags()
    {
        VibrationMeasurement measurement;
        QCOMPARE(vibrationtext::raised(measurement), QString());
        QCOMPARE(vibrationtext::unknown(measurement), u"fault?, warning?, stop?"_s);
        measurement.fault = true;
        measurement.warning = false;
        measurement.isBaselineExceeded = true;
        QCOMPARE(vibrationtext::raised(measurement), u"fault, far from its usual value"_s);
        QCOMPARE(vibrationtext::unknown(measurement), u"stop?"_s);
    }

    void states()
    {
        QCOMPARE(vibrationtext::stateText(channel(0, ChannelState::Good, false)), u"off"_s);
        QCOMPARE(vibrationtext::stateText(channel(0, ChannelState::NoData)), u"no data"_s);
        QCOMPARE(vibrationtext::stateText(static_cast<ChannelState>(7)), u"state 7"_s);
    }

    void numbers()
    {
        QCOMPARE(vibrationtext::number(70.71068), u"70.7107"_s);
        QCOMPARE(vibrationtext::number(-123.45678), u"-123.457"_s);
        QCOMPARE(vibrationtext::number(1500), u"1500.00"_s);
        QCOMPARE(vibrationtext::number(123456.78), u"123456.8"_s);
    }
};

QTEST_APPLESS_MAIN(TestVibrationText)
#include "tst_vibrationtext.moc"
