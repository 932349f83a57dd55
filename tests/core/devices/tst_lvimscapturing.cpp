#include "core/devices/lvims/lvimsdriver.h"
#include "tests/core/devices/lvimsbench.h"

#include <QDeadlineTimer>
#include <QTest>

#include <algorithm>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;
using Qt::Literals::StringLiterals::operator""_s;

namespace {

SensorConfig capturing(const QHash<QString, QString> &options)
{
    SensorConfig sensor = vimsSensor();
    sensor.options = options;
    return sensor;
}

struct Site
{
    explicit Site(const QHash<QString, QString> &options)
        : line(capturing(options))
    {
        DriverSettings settings;
        settings.sensor = capturing(options);
        driver = lvims::makeDriver(settings);
        line.module().setUpdatePeriod(0s);
    }

    /// Steps until \a count signals have come, in the free time between turns; at most so long as a busy machine needs.
    QList<SignalCapture> fetch(qsizetype count)
    {
        QList<SignalCapture> captures;
        const QDeadlineTimer limit(20'000);
        while (captures.size() < count && !limit.hasExpired()) {
            step();
            captures += driver->takeCaptures();
        }
        return captures;
    }

    /// The pause between two looks is one of the clock on the wall; that of the module goes on by itself.
    void step()
    {
        if (!driver->hasBacklog()) {
            QTest::qSleep(1);
            line.advance(20ms);
            return;
        }
        const int before = line.module().requests();
        lastFetch = driver->fetch(line);
        mostRequests = std::max(mostRequests, line.module().requests() - before);
        ++steps;
    }

    QStringList notes()
    {
        QStringList texts;
        for (const DriverNote &note : driver->takeNotes()) {
            texts.append(note.text);
        }
        return texts;
    }

    ModuleLine line;
    std::unique_ptr<Driver> driver;
    Result<QList<SampleBlock>> lastFetch = QList<SampleBlock>();
    int mostRequests = 0; ///< of a step
    int steps = 0;
};

} // namespace

class TestLVimsCapturing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingUnlessAskedFor()
    {
        Site site({});
        QVERIFY(site.driver->poll(site.line));
        QVERIFY(!site.driver->hasBacklog());
        QVERIFY(!site.driver->backlogAt());
    }

    /// Two channels, waveform and spectrum: the codes that the module keeps, in steps of two requests at most.
    void aRound()
    {
        Site site(
            {{u"captureevery"_s, u"3600"_s}, {u"capturechannels"_s, u"1,3"_s}, {u"capturekinds"_s, u"waveform,200"_s}});
        QVERIFY(!site.driver->hasBacklog()); // nobody knows yet whether the module is there
        site.line.module().setTones(1, {{100, 50, 0}});
        QVERIFY(site.driver->poll(site.line));
        QVERIFY(site.driver->hasBacklog());
        const auto captures = site.fetch(4);
        QCOMPARE(captures.size(), 4);
        const std::pair<int, CaptureKind> expected[] = {
            {1, CaptureKind::Waveform},
            {1, CaptureKind::Spectrum200},
            {3, CaptureKind::Waveform},
            {3, CaptureKind::Spectrum200}};
        for (int i = 0; i < 4; ++i) {
            const SignalCapture &captured = captures.at(i);
            QCOMPARE(captured.number, 7);
            QCOMPARE(captured.information.channel, expected[i].first);
            QCOMPARE(captured.kind, expected[i].second);
            QCOMPARE(captured.codes.size(), captured.kind == CaptureKind::Waveform ? 12800 : 4096);
            QVERIFY(std::chrono::abs(utcNow() - captured.time) < 60s);
        }
        // a tone of 50 mm/s²
        const auto [least, most] = std::minmax_element(captures.at(0).codes.begin(), captures.at(0).codes.end());
        QVERIFY(std::abs(captures.at(0).information.physical(*most) - 50) < 0.5);
        QVERIFY(std::abs(captures.at(0).information.physical(*least) + 50) < 0.5);
        QVERIFY(site.mostRequests <= 2);
        QVERIFY(site.steps > 2 * (12800 + 4096) / 60);
        QCOMPARE(site.notes(), QStringList());
        // The next round is an hour away.
        QVERIFY(!site.driver->hasBacklog());
        const auto next = site.driver->backlogAt();
        QVERIFY(next && *next > SteadyTime::clock::now() + 58min && *next < SteadyTime::clock::now() + 61min);
    }

    void roundAfterRound()
    {
        Site site({{u"captureevery"_s, u"1"_s}, {u"capturechannels"_s, u"0"_s}, {u"capturekinds"_s, u"200"_s}});
        QVERIFY(site.driver->poll(site.line));
        const auto captures = site.fetch(3);
        QCOMPARE(captures.size(), 3);
        QVERIFY(captures.at(2).time - captures.at(0).time > 1s);
    }

    /// A turn between any two steps finds the line free, and the capture goes on behind it.
    void pollingGoesOn()
    {
        Site site({{u"captureevery"_s, u"3600"_s}, {u"capturechannels"_s, u"2"_s}});
        QVERIFY(site.driver->poll(site.line));
        QList<SignalCapture> captures;
        const QDeadlineTimer limit(20'000);
        while (captures.isEmpty()) {
            QVERIFY(!limit.hasExpired());
            site.step();
            const int before = site.line.module().requests();
            QVERIFY(site.driver->poll(site.line));
            QCOMPARE(site.line.module().requests() - before, 1);
            captures += site.driver->takeCaptures();
        }
        QCOMPARE(captures.first().codes.size(), 12800);
    }

    void onlyChannelsInUse()
    {
        Site site({{u"captureevery"_s, u"3600"_s}, {u"capturekinds"_s, u"200"_s}});
        // CH_EN_MASK of MUT_SETTINGS, 53248 + 112 = D070h: channels 0 and 2; then 564942CCh, apply
        site.line.module().answer(QByteArray::fromHex("10 D070 0001 02 0005"), 0s);
        site.line.module().answer(QByteArray::fromHex("10 F000 0002 04 42CC 5649"), 0s);
        QVERIFY(site.driver->poll(site.line));
        const auto captures = site.fetch(2);
        QCOMPARE(captures.size(), 2);
        QCOMPARE(captures.at(0).information.channel, 0);
        QCOMPARE(captures.at(1).information.channel, 2);
        QVERIFY(!site.driver->hasBacklog());
    }

    /// The journal hears of it once when it begins and once when it ends; the values come all the while.
    void aFailureIsToldOnce()
    {
        Site site({{u"captureevery"_s, u"1"_s}, {u"capturechannels"_s, u"0"_s}, {u"capturekinds"_s, u"200"_s}});
        QVERIFY(site.driver->poll(site.line));
        site.line.module().refuse(4, 0, 1'000'000);
        QStringList notes;
        const QDeadlineTimer rounds(2'500);
        while (!rounds.hasExpired()) {
            site.step();
            QVERIFY(site.lastFetch); // no failure of the sensor
            notes += site.notes();
        }
        QCOMPARE(
            notes,
            QStringList{
                u"The spectrum of channel 0 up to 200 Hz cannot be captured: the module refuses it. It is tried "
                "again at the next time."_s});
        QVERIFY(site.driver->takeCaptures().isEmpty());
        site.line.module().refuse(4, 0, 0);
        QVERIFY(site.driver->poll(site.line));
        QCOMPARE(site.fetch(1).size(), 1);
        QCOMPARE(site.notes(), QStringList{u"The spectrum of channel 0 up to 200 Hz is captured again."_s});
    }

    void aModuleThatIsSilentCapturesNothing()
    {
        Site site({{u"captureevery"_s, u"1"_s}});
        QVERIFY(site.driver->poll(site.line));
        QVERIFY(site.driver->hasBacklog());
        site.line.setSilent(true);
        QVERIFY(!site.driver->poll(site.line));
        QVERIFY(!site.driver->hasBacklog());
        QVERIFY(!site.driver->backlogAt());
        site.line.setSilent(false);
        QVERIFY(site.driver->poll(site.line));
        QVERIFY(site.driver->hasBacklog());
    }

    /// Service, or a line that was opened anew: what was half fetched is given up.
    void aRestart()
    {
        Site site({{u"captureevery"_s, u"3600"_s}, {u"capturechannels"_s, u"0"_s}});
        QVERIFY(site.driver->poll(site.line));
        for (int i = 0; i < 100; ++i) {
            site.step();
        }
        site.driver->restart();
        QVERIFY(!site.driver->hasBacklog());
        QVERIFY(site.driver->poll(site.line));
        QVERIFY(!site.driver->hasBacklog()); // the next round is due in an hour
        QVERIFY(site.driver->takeCaptures().isEmpty());
    }

    void complaintsAreTold()
    {
        Site site({{u"captureevery"_s, u"often"_s}});
        QCOMPARE(site.notes().size(), 1);
    }
};

QTEST_APPLESS_MAIN(TestLVimsCapturing)
#include "tst_lvimscapturing.moc"
