#include "core/devices/drivercatalog.h"
#include "core/devices/lvims/lvimsdriver.h"
#include "tests/core/devices/lvimsbench.h"
#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::lvims;
using namespace gorizont::test;
using namespace std::chrono_literals;
using Qt::Literals::StringLiterals::operator""_s;

namespace {

DriverSettings settingsOf(const SensorConfig &sensor)
{
    DriverSettings settings;
    settings.sensor = sensor;
    return settings;
}

/// A driver and a simulated module whose registers change only when the test says so.
struct Site
{
    explicit Site(const SensorConfig &sensor = vimsSensor())
        : line(sensor)
        , driver(lvims::makeDriver(settingsOf(sensor)))
    {
        line.module().setUpdatePeriod(0s);
    }

    int requestsOfAPoll()
    {
        const int before = line.module().requests();
        last = driver->poll(line);
        return line.module().requests() - before;
    }

    QStringList notes()
    {
        QStringList texts;
        for (const DriverNote &note : driver->takeNotes()) {
            texts.append(note.text);
        }
        return texts;
    }

    const VibrationChannel &channel(int index) { return last->vibration->channels.at(index); }

    ModuleLine line;
    std::unique_ptr<Driver> driver;
    Result<Measurement> last = Fault::Timeout;
};

QByteArray frame(int transaction, const QByteArray &pdu)
{
    QByteArray bytes = hex("00 00 00 00 00 00 01");
    bytes[1] = static_cast<char>(transaction);
    bytes[5] = static_cast<char>(pdu.size() + 1);
    return bytes + pdu;
}

} // namespace

class TstLVimsDriver : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theCatalogKnowsIt()
    {
        QVERIFY(gorizont::makeDriver(settingsOf(vimsSensor())));
        QVERIFY(gorizont::makeSimulatedDevice(vimsSensor(), 1));
    }

    /// Identity, status, enabled channels, four channels, relays; then the status alone.
    void oneRequestWhenNothingChanged()
    {
        Site site;
        QCOMPARE(site.requestsOfAPoll(), 8);
        QVERIFY(site.last);
        const Measurement first = *site.last;
        for (int i = 0; i < 5; ++i) {
            site.line.advance(1s);
            QCOMPARE(site.requestsOfAPoll(), 1);
            QCOMPARE(*site.last, first);
        }
    }

    /// The bytes themselves, typed from the manual: 1…100, 1024…1053, 45168, 1280 + 88·I, 1632…1633.
    void whatIsAsked()
    {
        QByteArray identity = hex("03 C8") + QByteArray(200, '\0');
        identity[2 + 2 * 96 + 1] = 2; // DEVMODE 97
        const QByteArray status = hex("03 3C") + QByteArray(60, '\1');
        QByteArray channel = hex("03 B0") + QByteArray(176, '\0');
        channel.replace(2 + 16, 10, hex("00 05 00 01 20 00 45 9C 00 64")); // 5, true, 459C2000h = 4996.0, 100
        FakeLine line;
        line.expect(frame(1, hex("03 00 01 00 64")), frame(1, identity))
            .expect(frame(2, hex("03 04 00 00 1E")), frame(2, status))
            .expect(frame(3, hex("03 B0 70 00 01")), frame(3, hex("03 02 00 05")))
            .expect(frame(4, hex("03 05 00 00 58")), frame(4, channel))
            .expectInPieces(frame(5, hex("03 05 58 00 58")), frame(5, channel), 7)
            .expect(frame(6, hex("03 05 B0 00 58")), frame(6, channel))
            .expect(frame(7, hex("03 06 08 00 58")), frame(7, channel))
            .expect(frame(8, hex("03 06 60 00 02")), frame(8, hex("03 04 00 01 01 00")))
            .expect(frame(9, hex("03 04 00 00 1E")), frame(9, status));
        const auto driver = lvims::makeDriver(settingsOf(vimsSensor()));
        const auto measured = driver->poll(line);
        QVERIFY(measured && measured->vibration);
        QCOMPARE(measured->vibration->channels.size(), 4);
        const VibrationChannel &second = measured->vibration->channels.at(1);
        QCOMPARE(second.channel, 1);
        QVERIFY(!second.isEnabled); // mask 5: channels 0 and 2
        QVERIFY(measured->vibration->channels.at(2).isEnabled);
        QCOMPARE(second.measurements.size(), 1);
        QCOMPARE(second.measurements.at(0).type, 5);
        QCOMPARE(second.measurements.at(0).value, std::optional(4996.0));
        QCOMPARE(second.measurements.at(0).percent, std::optional(100.0));
        QCOMPARE(second.measurements.at(0).fault, std::optional(true));
        QCOMPARE(measured->vibration->relays.at(0), (Relay{0, true, false, false, true}));
        QVERIFY(driver->poll(line));
        QCOMPARE(line.complaints(), QByteArrayList());
        QVERIFY(line.isDone());
    }

    void onlyWhatChanged()
    {
        Site site;
        QVERIFY(site.requestsOfAPoll() > 1);
        site.line.module().setRelays(0x01000101);
        QCOMPARE(site.requestsOfAPoll(), 2);
        QCOMPARE(site.last->vibration->relays.at(0), (Relay{0, true, true, false, true}));
        site.line.module().setTones(2, {{10, 100, 0}});
        site.line.module().update();
        QCOMPARE(site.requestsOfAPoll(), 5); // all four counted
        QCOMPARE(site.requestsOfAPoll(), 1);
    }

    /// 100 mm/s² at 10 Hz: RMS 100/√2 mm/s², 100/(√2·2π·10) mm/s, 1000·100/(√2·(2π·10)²) µm.
    void values()
    {
        Site site;
        site.line.module().setTones(1, {{10, 100, 0}});
        site.line.module().update();
        site.requestsOfAPoll();
        const auto &measurements = site.channel(1).measurements;
        QCOMPARE(measurements.size(), 3);
        const double expected[] = {70.7107, 1.12540, 17.9113};
        for (int i = 0; i < 3; ++i) {
            QCOMPARE(measurements.at(i).type, i + 1);
            QVERIFY(qAbs(*measurements.at(i).value - expected[i]) < 1e-4 * expected[i]);
        }
    }

    void shortCircuitAndBreak()
    {
        Site site;
        site.requestsOfAPoll();
        QCOMPARE(site.notes(), QStringList());
        site.line.module().setChannelStatus(1, 1);
        site.line.module().setChannelStatus(3, 2);
        site.line.module().update();
        site.requestsOfAPoll();
        QCOMPARE(site.channel(0).state, ChannelState::Good);
        QCOMPARE(site.channel(1).state, ChannelState::ShortCircuit);
        QCOMPARE(site.channel(3).state, ChannelState::Break);
        QVERIFY(!site.channel(1).measurements.at(0).value);
        QCOMPARE(
            site.notes(),
            (QStringList{
                u"Channel 1: the line of the sensor is shorted. Check its cable."_s,
                u"Channel 3: the line of the sensor is broken. Check its cable."_s}));
        site.line.module().update();
        site.requestsOfAPoll();
        QCOMPARE(site.notes(), QStringList()); // once per change
        site.line.module().setChannelStatus(1, 0);
        site.line.module().update();
        site.requestsOfAPoll();
        QCOMPARE(site.notes(), QStringList{u"Channel 1: the sensor works again."_s});
    }

    /// Code 5 of the status word: every channel in use is shorted or broken.
    void noSensorWorks()
    {
        Site site;
        for (int i = 0; i < 4; ++i) {
            site.line.module().setChannelStatus(i, i % 2 + 1);
        }
        site.line.module().update();
        site.requestsOfAPoll();
        QCOMPARE(site.last->conditions, Conditions(Condition::TransducerSilent));
        site.line.module().setChannelStatus(2, 0);
        site.line.module().update();
        site.requestsOfAPoll();
        QCOMPARE(site.last->conditions, Conditions());
    }

    /// What was not read because of an exception in the middle is read in the next turn.
    void anExceptionInTheMiddle()
    {
        Site site;
        site.line.module().refuse(4, 5);
        QCOMPARE(site.requestsOfAPoll(), 6);
        QCOMPARE(site.last.fault(), Fault::Refused);
        QCOMPARE(site.notes().size(), 1);
        QCOMPARE(site.requestsOfAPoll(), 4); // status, two channels, relays
        QVERIFY(site.last);
        QCOMPARE(site.last->vibration->channels.size(), 4);
    }

    void silence()
    {
        Site site;
        site.line.setSilent(true);
        site.requestsOfAPoll();
        QCOMPARE(site.last.fault(), Fault::Timeout);
        site.line.setSilent(false);
        site.requestsOfAPoll();
        QVERIFY(site.last);
    }

    /// A module that restarted counts from the beginning: everything is read again.
    void aRestart()
    {
        Site site;
        site.requestsOfAPoll();
        site.line.module().restart(site.line.elapsed());
        site.driver->restart();
        QCOMPARE(site.requestsOfAPoll(), 8);
        QVERIFY(site.last);
    }

    void theBootLoader()
    {
        Site site;
        site.line.module().setMode(1);
        QCOMPARE(site.requestsOfAPoll(), 1);
        QCOMPARE(site.last.fault(), Fault::Refused);
        QCOMPARE(site.notes().size(), 1);
        QCOMPARE(site.requestsOfAPoll(), 1);
        QCOMPARE(site.notes(), QStringList());
        site.line.module().setMode(2);
        QVERIFY(site.requestsOfAPoll() > 1);
        QVERIFY(site.last);
    }

    void saysWhatItIs()
    {
        Site site;
        site.requestsOfAPoll();
        const auto information = site.driver->takeInformation();
        QVERIFY(information);
        QCOMPARE(information->number, 7);
        QCOMPARE(information->firmware, u"1.0.7"_s);
    }

    void options()
    {
        SensorConfig sensor = vimsSensor();
        sensor.options = {{u"unit"_s, u"17"_s}, {u"readfunction"_s, u"4"_s}, {u"percentcode"_s, u"20000"_s}};
        Site site(sensor);
        site.requestsOfAPoll();
        QVERIFY(site.last);
        QCOMPARE(site.notes(), QStringList());
        const Options options = Options::from(sensor);
        QCOMPARE(int(options.address.unit), 17);
        QCOMPARE(options.address.readFunction, modbustcp::ReadFunction::InputRegisters);
        QCOMPARE(options.fullScale, std::optional(20000.0));
    }

    void optionsThatAreNotUnderstood()
    {
        SensorConfig sensor = vimsSensor();
        sensor.options = {{u"unit"_s, u"256"_s}, {u"readfunction"_s, u"5"_s}};
        Site site(sensor);
        const QStringList notes = site.notes();
        QCOMPARE(notes.size(), 2);
        QVERIFY(notes.contains(u"unit1 is \"256\", but takes 0…255. Its usual value is used."_s));
        site.line.setSilent(true);
        QCOMPARE(int(Options::from(sensor).address.unit), 1);
    }
};

QTEST_APPLESS_MAIN(TstLVimsDriver)
#include "tst_lvimsdriver.moc"
