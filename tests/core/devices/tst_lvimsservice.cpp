#include "core/devices/lvims/lvimsfiles.h"
#include "core/devices/lvims/lvimsservice.h"
#include "tests/core/devices/lvimsbench.h"
#include "tests/support/fakeline.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace gorizont;
using namespace gorizont::lvims;
using namespace gorizont::test;
using namespace std::chrono_literals;
using Qt::Literals::StringLiterals::operator""_s;

namespace {

/// A module that changes nothing by itself, and a capture from it.
struct Bench
{
    Bench() { line.module().setUpdatePeriod(0s); }

    Result<void> step(Capture &capture)
    {
        line.advance(capture.pause());
        return capture.step(line, SteadyTime(1h) + line.elapsed());
    }

    Result<Capture> run(Capture::Kind kind, int channel)
    {
        Capture capture = service.capture(kind, channel);
        while (!capture.isDone()) {
            if (const auto done = step(capture); !done) {
                return done.fault();
            }
        }
        return capture;
    }

    /// A capture of which something has arrived already.
    Capture begun(Capture::Kind kind, int channel)
    {
        Capture capture = service.capture(kind, channel);
        while (capture.codes().size() < 120) {
            if (const auto done = step(capture); !done) {
                break;
            }
        }
        return capture;
    }

    Result<void> finish(Capture &capture)
    {
        Result<void> done;
        while (done && !capture.isDone()) {
            done = step(capture);
        }
        return done;
    }

    ModuleLine line;
    Service service{{}, {}};
};

SpectrumBin highest(const QList<SpectrumBin> &bins)
{
    return *std::max_element(bins.begin(), bins.end(), [](const SpectrumBin &a, const SpectrumBin &b) {
        return a.amplitude < b.amplitude;
    });
}

constexpr auto wave = Capture::Kind::Waveform;

QByteArray frame(int transaction, const QByteArray &pdu)
{
    QByteArray bytes = hex("80 00 00 00 00 00 01");
    bytes[1] = static_cast<char>(transaction);
    bytes[5] = static_cast<char>(pdu.size() + 1);
    return bytes + pdu;
}

} // namespace

class TstLVimsService : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysWhatItIs()
    {
        Bench bench;
        const auto identity = bench.service.identity(bench.line);
        QVERIFY(identity);
        QCOMPARE(identity->name, u"VIMS_ICP"_s);
        QCOMPARE(identity->mode, workingMode);
        QCOMPARE(int(identity->writeError), 0);
    }

    void state()
    {
        Bench bench;
        bench.line.module().setChannelStatus(2, 1);
        bench.line.module().update();
        bench.line.module().setRelays(0x02000000);
        const auto state = bench.service.state(bench.line);
        QVERIFY(state);
        QCOMPARE(state->channels.size(), 4);
        QCOMPARE(state->channels.at(2).state, ChannelState::ShortCircuit);
        QVERIFY(state->relays.at(1).isEnabled);
    }

    void settings()
    {
        Bench bench;
        const int before = bench.line.module().requests();
        const auto set = bench.service.settings(bench.line, moduleRegister("CUR_SETTINGS"));
        QVERIFY(set);
        QCOMPARE(set->values().size(), 7456);
        QCOMPARE(bench.line.module().requests() - before, 60); // 59 × 125 + 81
        QCOMPARE(set->text(settingRegister("CUSTOM_NAME")), u"Насос 1"_s);
        QCOMPARE(set->ipAddress(settingRegister("IP_ADDR")), u"192.168.1.10"_s);
        QCOMPARE(int(set->word(settingRegister("WF_ACQ_TIME"))), 500);
        QCOMPARE(set->real(settingRegister("CH_SENSOR_K"), 3), 100.0f);
    }

    void restoresSettings()
    {
        Bench bench;
        auto set = bench.service.settings(bench.line, moduleRegister("CUR_SETTINGS"));
        QVERIFY(set);
        QList<quint16> wanted = set->values();
        wanted[114] = 4000;
        QVERIFY(bench.service.restoreSettings(bench.line, wanted, false));
        QCOMPARE(int(bench.line.module().peek(45056 + 114)), 4000);
        bench.line.module().restart(bench.line.elapsed());
        QCOMPARE(int(bench.line.module().peek(45056 + 114)), 500); // not in flash
        QVERIFY(bench.service.restoreSettings(bench.line, wanted, true));
        bench.line.module().restart(bench.line.elapsed());
        QCOMPARE(int(bench.line.module().peek(45056 + 114)), 4000);

        wanted[114] = 4001;
        QCOMPARE(bench.service.restoreSettings(bench.line, wanted, true).fault(), Fault::Refused);
        QVERIFY(bench.service.errors().second != 0);
        QCOMPARE(int(bench.line.module().peek(45056 + 114)), 4000);
        QCOMPARE(bench.service.restoreSettings(bench.line, wanted.mid(1), false).fault(), Fault::Refused);
    }

    void files()
    {
        CaptureInformation information;
        information.rate = 4;
        information.physicalK = 0.5;
        information.physicalB = 1;
        information.windowSum = 2;
        QCOMPARE(waveformCsv(information, {-4, 2}), QByteArray("time,code,value\n0,-4,-1\n0.25,2,2\n"));
        QCOMPARE(spectrumCsv(information, {10, 0, 3, -4}), QByteArray("frequency,amplitude\n0,2.5\n1,2.5\n"));
        QCOMPARE(
            waveformWav(information, {-4, 2}),
            QByteArray("RIFF") + hex("2C 00 00 00") + "WAVEfmt " + hex("10 00 00 00 03 00 01 00 04 00 00 00")
                + hex("10 00 00 00 04 00 20 00") + "data" + hex("08 00 00 00 00 00 00 BF 00 00 80 3F"));
    }

    /// 500 ms of 100 Hz, 500 mm/s²: 50 periods; the offset of the module is 0.25 mm/s².
    void aWaveform()
    {
        Bench bench;
        bench.line.module().setTones(1, {{100, 500, 0}});
        const int before = bench.line.module().requests();
        const auto capture = bench.run(wave, 1);
        QVERIFY(capture);
        QCOMPARE(capture->disturbances(), 0);
        const CaptureInformation &information = capture->information();
        QCOMPARE(information.channel, 1);
        QCOMPARE(information.size, 12800u);
        QCOMPARE(information.rate, 25600.0);
        QCOMPARE(information.state->state, ChannelState::Good);
        QCOMPARE(information.state->measurements.size(), 3);
        QCOMPARE(capture->codes().size(), 12800);
        double largest = 0;
        int rising = 0;
        for (qsizetype i = 0; i < capture->codes().size(); ++i) {
            const double value = information.physical(capture->codes().at(i)) - 0.25;
            largest = std::max(largest, std::abs(value));
            rising += i > 0 && capture->codes().at(i - 1) < 0 && capture->codes().at(i) >= 0 ? 1 : 0;
        }
        QVERIFY(std::abs(largest - 500) < 0.2);
        QVERIFY(rising == 50 || rising == 49);
        QCOMPARE(information.time(12800), 0.5);
        // 214 times 60 samples, two looks before, the command, the information, and a look each 20 ms of 500
        QVERIFY(bench.line.module().requests() - before <= 214 + 4 + 27);
    }

    /// ADC codes have a sign although the manual says U32; low word first. 10 V are 2^23 codes.
    void voltsAndSign()
    {
        Bench bench;
        bench.line.module().setTones(0, {{10, 98.0665, std::numbers::pi}}); // 10 mg, that is 1 mV at 100 mV/g
        const auto capture = bench.run(wave, 0);
        QVERIFY(capture);
        const auto [low, high] = std::minmax_element(capture->codes().begin(), capture->codes().end());
        QCOMPARE(*low, -839); // 0.001 V / 10 V · 2^23
        QCOMPARE(*high, 839);
        QVERIFY(std::abs(capture->information().volts(*high) - 0.002) < 2e-6); // and 1 mV of offset
    }

    void spectra_data()
    {
        QTest::addColumn<Capture::Kind>("kind");
        QTest::addColumn<double>("frequency");
        QTest::addColumn<double>("amplitude");
        QTest::addColumn<double>("step");
        QTest::newRow("5000") << Capture::Kind::Spectrum5000 << 1000.0 << 200.0 << 3.125;
        QTest::newRow("200") << Capture::Kind::Spectrum200 << 50.0 << 120.0 << 0.125;
    }

    void spectra()
    {
        QFETCH(const Capture::Kind, kind);
        QFETCH(const double, amplitude);
        Bench bench;
        bench.line.module().setTones(3, {{50, 120, 0.3}, {1000, 200, 1}});
        const auto capture = bench.run(kind, 3);
        QVERIFY(capture);
        const auto bins = spectrumOf(capture->information(), capture->codes());
        QCOMPARE(bins.size(), 2048);
        QTEST(bins.at(1).frequency - bins.at(0).frequency, "step");
        QTEST(highest(bins).frequency, "frequency");
        QVERIFY(std::abs(highest(bins).amplitude - amplitude) < 0.01 * amplitude);
    }

    /// By hand: N = 2 bins, f(1) = 1·8 / (2·2); 0.5·10/2; 2·0.5·|3 + 4i|/2.
    void physicalUnitsOfASpectrum()
    {
        CaptureInformation information;
        information.rate = 8;
        information.physicalK = 0.5;
        information.physicalB = 100; // does not apply
        information.windowSum = 2;
        QCOMPARE(spectrumOf(information, {10, 0, 3, -4}), (QList<SpectrumBin>{{0, 2.5, 0}, {2, 2.5, 0}}));
        information.windowSum2 = 4; // (0.5·10)² / (8·4); 2·(0.5·5)² / (8·4)
        information.voltsK = -2; // a sign turns the phase only: 2·10/2, 2·2·5/2; (2·10)²/32, 2·(2·5)²/32
        QCOMPARE(spectrumOf(information, {10, 0, 3, -4}), (QList<SpectrumBin>{{0, 2.5, 0.78125}, {2, 2.5, 0.390625}}));
        QCOMPARE(
            spectrumOf(information, {10, 0, 3, -4}, CodeUnit::Volts),
            (QList<SpectrumBin>{{0, 10, 12.5}, {2, 10, 6.25}}));
    }

    /// The bytes, typed from the manual: 5651h to A000h; channel 1, type 1, from 9200h, information from 9300h.
    void whatIsAsked()
    {
        const QByteArray select = hex("92 00 00 04 08 00 01 00 01 00 00 00 00");
        QByteArray information = hex("17 24 00 01 00 01 00 04 00 00 00 00 44 00") + QByteArray(8, '\0')
            + hex("00 00 3F 00 00 00 00 00 00 00 40 00 00 00 3F 80"); // 512 Hz, K 0.5, window 2 and 1
        FakeLine line;
        line.expect(frame(1, hex("10 A0 00 00 01 02 56 51")), frame(1, hex("10 A0 00 00 01")))
            .expect(frame(2, hex("17 93 00 00 12") + select), frame(2, information))
            .expectInPieces(
                frame(3, hex("17 92 00 00 0C") + select),
                frame(3, hex("17 18 00 01 00 01 00 00 00 00 00 0A 00 00 00 00 00 00 FF FD FF FF 00 00 00 01")), 5);
        Capture capture = Service({}, {}).capture(Capture::Kind::Spectrum200, 1);
        for (int i = 0; i < 4; ++i) {
            QVERIFY(capture.step(line, SteadyTime(1h)));
        }
        QCOMPARE(line.complaints(), QByteArrayList());
        QVERIFY(capture.isDone());
        QCOMPARE(capture.codes(), (QList<qint32>{10, 0, -3, 65536}));
        QCOMPARE(capture.information().rate, 512.0);
        QCOMPARE(capture.information().windowSum2, 1.0);
    }

    /// The whole way of a waveform of two samples: WF_ACQ_TIME from B072h, 5649h to A000h, the information with function 23 and
    /// 124 registers from 9100h, the samples from 9000h; channel 2, ID 8.
    void whatIsAskedForAWaveform()
    {
        const auto status = [](char id, char ready) {
            QByteArray registers(60, '\0');
            registers[2 * (4 + 2) + 1] = id;
            registers[2 * (8 + 2) + 1] = ready;
            return hex("03 3C") + registers;
        };
        const QByteArray select = hex("90 00 00 04 08 00 02 00 08 00 00 00 00");
        QByteArray information =
            hex("00 02 00 08 00 02 00 00 00 00 46 C8 00 00 3F 00 00 00 3F 80 00 00 40 00 00 00 BF 80");
        information += QByteArray(248 - information.size(), '\0');
        information[2 * 36 + 1] = 2; // CH_STATUS: a break
        FakeLine line;
        line.expect(frame(1, hex("03 04 00 00 1E")), frame(1, status(7, 1)))
            .expect(frame(2, hex("03 B0 72 00 01")), frame(2, hex("03 02 01 F4")))
            .expect(frame(3, hex("10 A0 00 00 01 02 56 49")), frame(3, hex("10 A0 00 00 01")))
            .expect(frame(4, hex("03 04 00 00 1E")), frame(4, status(7, 0)))
            .expect(frame(5, hex("03 04 00 00 1E")), frame(5, status(8, 1)))
            .expect(frame(6, hex("17 91 00 00 7C") + select), frame(6, hex("17 F8") + information))
            .expectInPieces(
                frame(7, hex("17 90 00 00 08") + select),
                frame(7, hex("17 10 00 02 00 08 00 00 00 00 FF FE FF FF 00 05 00 00")), 3);
        Capture capture = Service({}, {}).capture(wave, 2);
        for (int i = 0; i < 6; ++i) {
            QVERIFY(!capture.isDone());
            QVERIFY(capture.step(line, SteadyTime(1h)));
        }
        QCOMPARE(line.complaints(), QByteArrayList());
        QVERIFY(line.isDone() && capture.isDone());
        QCOMPARE(capture.codes(), (QList<qint32>{-2, 5}));
        const CaptureInformation &told = capture.information();
        QCOMPARE(told.rate, 25600.0);
        QCOMPARE(told.volts(-2), 0.0); // 0.5·x + 1
        QCOMPARE(told.physical(5), 9.0); // 2·x − 1
        QCOMPARE(told.state->state, ChannelState::Break);
    }

    /// The connection is lost in the middle.
    void aDisconnect()
    {
        FakeLine line;
        line.expect(frame(1, hex("10 A0 00 00 01 02 56 51")), frame(1, hex("10 A0 00 00 01")))
            .vanishAfter(frame(2, hex("17 93 00 00 12 92 00 00 04 08 00 01 00 01 00 00 00 00")));
        Capture capture = Service({}, {}).capture(Capture::Kind::Spectrum200, 1);
        QVERIFY(capture.step(line, SteadyTime(1h)));
        QVERIFY(capture.step(line, SteadyTime(1h)));
        QCOMPARE(capture.step(line, SteadyTime(1h)).fault(), Fault::Closed);
        QVERIFY(!capture.isDone());
    }

    /// Nothing has arrived on the channel yet: a waveform of no samples.
    void aChannelWithoutData()
    {
        Bench bench;
        bench.line.module().setChannelStatus(1, 0xFFFF);
        Capture capture = bench.service.capture(wave, 1);
        QCOMPARE(bench.finish(capture).fault(), Fault::BadReply);
        QCOMPARE(capture.information().rate, 25600.0);
        QCOMPARE(capture.information().size, 0U);
        QCOMPARE(capture.disturbances(), 0);
    }

    /// Another client moved the selection between our write and our read: the echo shows it.
    void theEchoOfAForeignClient()
    {
        for (const Capture::Kind kind : {wave, Capture::Kind::Spectrum200}) {
            Bench bench;
            Capture capture = bench.begun(kind, 2);
            bench.line.module().meddle(1);
            QVERIFY(bench.finish(capture));
            QCOMPARE(capture.disturbances(), 1);
            const auto undisturbed = bench.run(kind, 2);
            QVERIFY(undisturbed);
            QCOMPARE(undisturbed->information().size, quint32(capture.codes().size()));
        }
    }

    void aClientThatNeverStops()
    {
        Bench bench;
        Capture capture = bench.begun(wave, 2);
        bench.line.module().meddle(1000);
        QCOMPARE(bench.finish(capture).fault(), Fault::BadReply);
        QCOMPARE(capture.disturbances(), 3);
    }

    void anExceptionInTheMiddle()
    {
        Bench bench;
        Capture capture = bench.begun(wave, 0);
        bench.line.module().refuse(4);
        QVERIFY(bench.finish(capture));
        QCOMPARE(capture.disturbances(), 1);
        QCOMPARE(capture.codes().size(), 12800);
        bench.line.module().refuse(4, 0, 1000);
        Capture refused = bench.service.capture(wave, 0);
        QCOMPARE(bench.finish(refused).fault(), Fault::Refused);
        QCOMPARE(refused.exception(), 4);
    }

    /// Another client lets the module keep another waveform: ours is gone, the new one is taken.
    void anotherWaveformMeanwhile()
    {
        Bench bench;
        Capture capture = bench.begun(wave, 0);
        const int id = capture.information().id;
        QVERIFY(bench.run(wave, 3));
        QVERIFY(bench.finish(capture));
        QCOMPARE(capture.information().id, id + 1);
        QCOMPARE(capture.disturbances(), 1);
    }

    void aSlowCapture()
    {
        Bench bench;
        bench.line.module().setCaptureTime(1900ms);
        QVERIFY(bench.run(wave, 0));
        bench.line.module().setCaptureTime(2100ms); // beyond 2 · 500 ms + 1 s
        const auto started = bench.line.elapsed();
        Capture late = bench.service.capture(wave, 0);
        QCOMPARE(bench.finish(late).fault(), Fault::Timeout);
        QVERIFY(late.isLate());
        QVERIFY(bench.line.elapsed() - started < 2100ms);
    }

    /// The module forgets the waveform when it restarts, and nobody makes it keep another one.
    void aRestartInTheMiddle()
    {
        Bench bench;
        Capture capture = bench.begun(wave, 0);
        bench.line.module().restart(bench.line.elapsed());
        QCOMPARE(bench.finish(capture).fault(), Fault::Timeout);
    }

    void silence()
    {
        Bench bench;
        bench.line.setSilent(true);
        Capture silent = bench.service.capture(wave, 0);
        QCOMPARE(bench.finish(silent).fault(), Fault::Timeout);
        QVERIFY(!silent.isLate());
        QCOMPARE(bench.service.identity(bench.line).fault(), Fault::Timeout);
    }

    /// One exchange a step, so that a line is never held.
    void aStepIsShort()
    {
        Bench bench;
        Capture capture = bench.service.capture(wave, 0);
        QVERIFY(bench.step(capture));
        while (!capture.isDone()) {
            const int before = bench.line.module().requests();
            QVERIFY(bench.step(capture));
            QCOMPARE(bench.line.module().requests() - before, 1);
        }
    }
};

QTEST_APPLESS_MAIN(TstLVimsService)
#include "tst_lvimsservice.moc"
