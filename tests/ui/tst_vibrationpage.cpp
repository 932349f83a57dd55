#include "tests/ui/vimsdialogbench.h"
#include "ui/plots/cursorlines.h"
#include "ui/vibration/capturetext.h"
#include "ui/vibration/spectrumplot.h"
#include "ui/vibration/vibrationpage.h"
#include "ui/vibration/vibrationplots.h"

#include <QAction>
#include <QCheckBox>
#include <QMenu>
#include <QSpinBox>
#include <QTemporaryDir>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;
using Qt::Literals::StringLiterals::operator""_s;

namespace {

/// Function 23 of Modbus TCP.
bool isTransfer(const QByteArray &request)
{
    return request.size() > 7 && request.at(7) == 0x17;
}

} // namespace

/// The page <Вибрация> over a real worker whose line ends in a simulated module.
class TestVibrationPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { make({vims(1, 4, 1)}); }
    void cleanup()
    {
        m_page.reset();
        m.reset();
    }

    void nothingYet()
    {
        QVERIFY(text("vibrationHint").contains(u"press <Capture>"));
        QVERIFY(find<QLabel>("vibrationHint")->isVisible());
        QVERIFY(!find<QPushButton>("vibrationSave")->isEnabled());
        QVERIFY(!find<QPushButton>("vibrationStop")->isEnabled());
        QCOMPARE(find<QComboBox>("vibrationModule")->currentText(), u"4  Pump 4 (L-VIMS)"_s);
        QCOMPARE(find<QComboBox>("vibrationChannel")->count(), 4);
    }

    void aSiteWithoutModule()
    {
        const SensorRegistry registry({}, {});
        VibrationPage page(const_cast<SensorRegistry &>(registry), [](int) { return nullptr; }, {});
        QCOMPARE(
            page.findChild<QLabel *>(u"vibrationHint"_s)->text(), u"No sensor of the configuration is an L-VIMS."_s);
        QVERIFY(!page.findChild<QPushButton *>(u"vibrationCapture"_s)->isEnabled());
    }

    /// 500 mm/s² at 100 Hz: seen in the waveform, in its own spectrum and in both of the module.
    void capturesWithoutService()
    {
        m->change([](lvims::SimulatedModule &module) { module.setTones(1, {{100, 500, 0}}); });
        find<QComboBox>("vibrationChannel")->setCurrentIndex(1);
        m->bench.forgetAnswers();
        capture();
        QVERIFY(!find<QLabel>("vibrationHint")->isVisible());
        QVERIFY2(text("vibrationState").contains(u"12800 samples, 25600 a second"), qPrintable(text("vibrationState")));
        auto *wave = plot("vibrationWave");
        QCOMPARE(wave->graph(0)->dataCount(), 12800);
        QCOMPARE(wave->yAxis->label(), u"Acceleration, mm/s²"_s);
        QVERIFY(qAbs(highest(wave) - 500.25) < 0.5);
        for (const char *name : {"vibrationTo5000", "vibrationTo200"}) {
            QCOMPARE(plot(name)->yAxis->label(), u"Amplitude, mm/s²"_s);
            QVERIFY(qAbs(highest(plot(name), 0) - 500) < 10);
            QTRY_VERIFY_WITH_TIMEOUT(qAbs(highest(plot(name), 1) - 500) < 10, patience);
        }
        QTRY_VERIFY_WITH_TIMEOUT(
            text("vibrationPeaks").contains(u"Peaks of the waveform, mm/s²: 100.000 Hz (500.0"), patience);
        QVERIFY2(text("vibrationPeaks").contains(u"to 5000 Hz: 100.000 Hz (500.0"), qPrintable(text("vibrationPeaks")));
        QVERIFY2(text("vibrationPeaks").contains(u"to 200 Hz: 100.000 Hz (500.0"), qPrintable(text("vibrationPeaks")));
        QVERIFY(m->bench.isPolled()); // all the while
        QCOMPARE(m->bench.journalTexts(JournalKind::Off), QStringList());
    }

    /// 0.1 V/g and 9.80665 m/s² a g: 500 mm/s² are 5.0986 mV, the module adds 1 mV. Density: 500²/2 in a band of 1.5 bins of 2 Hz.
    void unitsAndScales()
    {
        m->change([](lvims::SimulatedModule &module) { module.setTones(0, {{100, 500, 0}}); });
        capture();
        find<QComboBox>("vibrationUnit")->setCurrentIndex(1);
        QCOMPARE(plot("vibrationWave")->yAxis->label(), u"Voltage, V"_s);
        QVERIFY(qAbs(highest(plot("vibrationWave")) - 0.0060986) < 1e-5);
        QTRY_VERIFY_WITH_TIMEOUT(qAbs(highest(plot("vibrationTo5000"), 1) - 0.0050986) < 1e-4, patience);
        QVERIFY(qAbs(highest(plot("vibrationTo200"), 0) - 0.0050986) < 1e-4);
        find<QComboBox>("vibrationUnit")->setCurrentIndex(0);
        find<QComboBox>("vibrationScale")->setCurrentIndex(1);
        QCOMPARE(plot("vibrationTo200")->yAxis->label(), u"Density, (mm/s²)²/Hz"_s);
        QTRY_VERIFY_WITH_TIMEOUT(qAbs(highest(plot("vibrationTo5000"), 1) / (125000 / 3.0) - 1) < 0.02, patience);
        // Blackman: 0.3046 · 8/4 … its equivalent noise is 1.7268 bins; of 0.125 Hz, and of 3.125 Hz where 100 Hz is a bin
        QVERIFY(qAbs(highest(plot("vibrationTo200"), 0) / (125000 / (1.7268 * 0.125)) - 1) < 0.02);
        QVERIFY(qAbs(highest(plot("vibrationTo5000"), 0) / (125000 / (1.7268 * 3.125)) - 1) < 0.02);
    }

    /// A line that is shared: the sensors have their turns while hundreds of requests are made.
    void othersKeepTheirTurns()
    {
        make({vims(1, 4, 1), vims(2, 5, 2)}, {.pace = 1ms});
        m->bench.forgetSent();
        capture();
        const QList<QByteArray> sent = m->bench.sent();
        const auto first = std::find_if(sent.begin(), sent.end(), isTransfer);
        const auto last = std::find_if(sent.rbegin(), sent.rend(), isTransfer).base();
        const QByteArray status = QByteArray::fromHex("030400001E");
        QSet<char> polled;
        for (auto request = first; request != last; ++request) {
            if (request->mid(7) == status && quint8(request->at(0)) < 0x80) { // a transaction of polling
                polled.insert(request->at(6));
            }
        }
        QCOMPARE(polled, (QSet<char>{1, 2}));
    }

    void stopAndAgain()
    {
        make({vims(1, 4, 1)}, {.pace = 2ms});
        start();
        QTRY_VERIFY_WITH_TIMEOUT(text("vibrationState").contains(u"Fetching the waveform"), patience);
        find<QPushButton>("vibrationStop")->click();
        QCOMPARE(text("vibrationState"), u"Stopped."_s);
        QVERIFY(find<QPushButton>("vibrationCapture")->isEnabled());
        waitForTurn();
        m->bench.forgetSent();
        waitForTurn();
        QVERIFY(!isTransferring());
        capture();
        QCOMPARE(plot("vibrationWave")->graph(0)->dataCount(), 12800);
    }

    void leavingThePageEndsIt()
    {
        make({vims(1, 4, 1)}, {.pace = 2ms});
        start();
        QTRY_VERIFY_WITH_TIMEOUT(text("vibrationState").contains(u"Fetching"), patience);
        m_page->hide();
        QCOMPARE(text("vibrationState"), u"Stopped, because the page was left."_s);
        waitForTurn();
        m->bench.forgetSent();
        waitForTurn();
        QVERIFY(!isTransferring());
    }

    void repeats()
    {
        find<QCheckBox>("vibrationRepeats")->setChecked(true);
        find<QSpinBox>("vibrationPeriod")->setValue(1);
        capture();
        QVERIFY(find<QPushButton>("vibrationStop")->isEnabled()); // it waits for the next
        m->bench.forgetSent();
        QTRY_VERIFY_WITH_TIMEOUT(isTransferring(), patience);
        find<QPushButton>("vibrationStop")->click();
        QVERIFY(!find<QPushButton>("vibrationStop")->isEnabled());
    }

    void aClientThatNeverStops()
    {
        m->change([](lvims::SimulatedModule &module) { module.meddle(1'000'000); });
        start();
        QTRY_VERIFY_WITH_TIMEOUT(
            text("vibrationState").contains(u"Another client has changed the selection of the module 3 times"),
            patience);
        QVERIFY(find<QLabel>("vibrationHint")->isVisible());
        m->change([](lvims::SimulatedModule &module) { module.meddle(0); });
        capture();
        QVERIFY(text("vibrationState").startsWith(u"Captured at"));
    }

    /// The waveform is refused; the spectra come all the same.
    void aRefusal()
    {
        make({vims(1, 4, 1)}, {.pace = 2ms});
        start();
        QTRY_VERIFY_WITH_TIMEOUT(text("vibrationState").contains(u"Fetching the waveform"), patience);
        m->change([](lvims::SimulatedModule &module) { module.refuse(4, 0, 40); });
        QTRY_VERIFY_WITH_TIMEOUT(text("vibrationState").contains(u"The module refuses the"), patience);
        QVERIFY(text("vibrationState").contains(u"(exception 4 of Modbus)"));
    }

    void aCaptureThatNeverEnds()
    {
        m->change([](lvims::SimulatedModule &module) {
            module.answer(QByteArray::fromHex("10D072000102000A"), std::chrono::hours(1)); // 10 ms
            module.answer(
                QByteArray::fromHex("10F000000204"
                                    "42CC5649"),
                std::chrono::hours(1));
            module.setCaptureTime(std::chrono::hours(100));
        });
        start();
        QTRY_VERIFY_WITH_TIMEOUT(
            text("vibrationState").contains(u"The module answers and does not finish the waveform"), patience);
        QTRY_VERIFY_WITH_TIMEOUT(plot("vibrationTo200")->graph(0)->dataCount() > 1000, patience);
    }

    void thePortIsGone()
    {
        make({vims(1, 4, 1)}, {.pace = 2ms});
        start();
        QTRY_VERIFY_WITH_TIMEOUT(text("vibrationState").contains(u"Fetching"), patience);
        m->bench.isPlugged = false;
        QTRY_VERIFY_WITH_TIMEOUT(text("vibrationState").contains(u"The port is gone or in service"), patience);
        QTRY_VERIFY_WITH_TIMEOUT(text("vibrationHint").startsWith(u"The module is away"), patience);
        QVERIFY(!find<QPushButton>("vibrationCapture")->isEnabled());
        m->bench.isPlugged = true;
        QTRY_VERIFY_WITH_TIMEOUT(find<QPushButton>("vibrationCapture")->isEnabled(), patience);
        capture();
    }

    void inService()
    {
        QFuture<Result<void>> entered = m->bench.worker->enterService();
        entered.waitForFinished();
        QTRY_VERIFY_WITH_TIMEOUT(text("vibrationHint").startsWith(u"The port is in service"), patience);
        QVERIFY(!find<QPushButton>("vibrationCapture")->isEnabled());
        m->bench.worker->leaveService();
        QTRY_VERIFY_WITH_TIMEOUT(find<QPushButton>("vibrationCapture")->isEnabled(), patience);
    }

    void shortCircuit()
    {
        m->change([](lvims::SimulatedModule &module) {
            module.setChannelStatus(0, 1);
            module.update();
        });
        capture();
        QVERIFY(text("vibrationState").contains(u"Channel 0: the line of the sensor is shorted. Check its cable."));
        QCOMPARE(plot("vibrationWave")->graph(0)->dataCount(), 12800);
    }

    void noData()
    {
        m->change([](lvims::SimulatedModule &module) {
            module.setChannelStatus(0, 0xFFFF);
            module.update();
        });
        capture();
        QVERIFY(text("vibrationState").contains(u"There is no data on this channel (waveform)."));
        QCOMPARE(plot("vibrationWave")->graph(0)->dataCount(), 0);
    }

    void cursors()
    {
        m->change([](lvims::SimulatedModule &module) { module.setTones(0, {{100, 500, 0}}); });
        capture();
        QVERIFY(!find<QLabel>("cursorReadings")->isVisible());
        find<QCheckBox>("vibrationCursors")->click();
        auto *cursors = plot("vibrationWave")->findChild<CursorLines *>();
        QVERIFY(qAbs(cursors->firstKey() - 0.5 / 3) < 1e-6);
        cursors->placeAt(0.1, 0.11);
        QVERIFY2(
            text("cursorReadings").contains(u"B − A 0.01000 s (1/T = 100.00 Hz)"), qPrintable(text("cursorReadings")));
        plot("vibrationTo200")->findChild<CursorLines *>()->placeAt(50, 100);
        QTRY_VERIFY_WITH_TIMEOUT(text("cursorReadings").contains(u"B 100.000 Hz: 500.0"), patience);
    }

    void zoomByKeys()
    {
        capture();
        auto *wave = plot("vibrationWave");
        QCOMPARE(wave->xAxis->range(), QCPRange(0, 0.5));
        QTest::keyClick(wave, Qt::Key_Plus);
        QVERIFY(qAbs(wave->xAxis->range().size() - 0.5 / 1.5) < 1e-9);
        QTest::keyClick(wave, Qt::Key_PageDown);
        QCOMPARE(wave->xAxis->range().upper, 0.5); // not beyond the end
        QTest::keyClick(wave, Qt::Key_Home);
        QCOMPARE(wave->xAxis->range(), QCPRange(0, 0.5));
    }

    void files()
    {
        using Export = VibrationPage::Export;
        QTemporaryDir folder;
        const QString path = folder.filePath(u"x"_s);
        QCOMPARE(m_page->exportTo(path, Export::WaveformCsv), u"Nothing was captured yet."_s);
        capture();
        const auto written = [&](Export form) {
            QFile file(path);
            return m_page->exportTo(path, form).isEmpty() && file.open(QIODevice::ReadOnly) ? file.readAll()
                                                                                            : QByteArray();
        };
        QVERIFY(written(Export::WaveformCsv).startsWith("time,code,value\n0,"));
        QCOMPARE(written(Export::WaveformCsv).count('\n'), 12801);
        QCOMPARE(written(Export::WaveformWav).size(), 44 + 4 * 12800);
        QVERIFY(written(Export::WaveformWav).startsWith("RIFF"));
        QVERIFY(written(Export::Spectrum5000Csv).contains("\n3.125,"));
        QVERIFY(written(Export::Spectrum200Csv).contains("\n0.125,"));
        QVERIFY(m_page->exportTo(folder.filePath(u"no/such"_s), Export::WaveformCsv)
                    .startsWith(u"The file was not written"));
    }

    /// Another channel: what is seen belongs to it or is not there.
    void anotherChannelBeginsAnew()
    {
        capture();
        find<QComboBox>("vibrationChannel")->setCurrentIndex(2);
        QVERIFY(find<QLabel>("vibrationHint")->isVisible());
        QCOMPARE(plot("vibrationWave")->graph(0)->dataCount(), 0);
        QVERIFY(!find<QPushButton>("vibrationSave")->isEnabled());
    }

    void sentences()
    {
        CaptureFailure silent;
        QVERIFY(capturetext::failure(silent).startsWith(u"The module does not answer (waveform)."));
        CaptureFailure empty{lvims::Capture::Kind::Spectrum200, Fault::BadReply};
        empty.isEmpty = true;
        QVERIFY(capturetext::failure(empty).startsWith(u"There is no data on this channel (spectrum up to 200 Hz)."));
        QVERIFY(capturetext::channel({2, ChannelState::Break, true, {}}).contains(u"broken"));
        QVERIFY(capturetext::channel({2, ChannelState::NoData, true, {}}).contains(u"no data"));
        QVERIFY(capturetext::channel({2, ChannelState::Good, false, {}}).contains(u"switched off"));
        QCOMPARE(capturetext::channel({2, ChannelState::Good, true, {}}), QString());
        QCOMPARE(capturetext::number(500), u"500.00"_s);
        QCOMPARE(capturetext::number(0.0012345), u"0.00123"_s);
        QCOMPARE(capturetext::number(1234567), u"1234567"_s);
    }

private:
    void make(const QList<SensorConfig> &sensors, const BenchOptions &options = {})
    {
        m_page.reset();
        m = std::make_unique<VimsDialogBench>(sensors, options);
        QTRY_COMPARE_WITH_TIMEOUT(m->bench.state(), LineState::Open, patience);
        for (int i = 0; i < sensors.size(); ++i) {
            m->change([](lvims::SimulatedModule &module) { module.setCaptureTime(1ms); }, i);
        }
        m_page = std::make_unique<VibrationPage>(
            m->bench.registry, [this](int) { return m->bench.worker.get(); }, m->bench.port().timing);
        m_page->resize(1100, 800);
        m_page->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
    }
    void start()
    {
        QTRY_VERIFY_WITH_TIMEOUT(find<QPushButton>("vibrationCapture")->isEnabled(), patience);
        find<QPushButton>("vibrationCapture")->click();
    }
    void capture()
    {
        start();
        QTRY_VERIFY_WITH_TIMEOUT(find<QPushButton>("vibrationCapture")->isEnabled(), patience);
    }
    /// Something was fetched since forgetSent().
    bool isTransferring() const
    {
        const QList<QByteArray> sent = m->bench.sent();
        return std::any_of(sent.begin(), sent.end(), isTransfer);
    }
    /// What the thread of the line has begun is over.
    void waitForTurn()
    {
        m->bench.forgetAnswers();
        QTRY_VERIFY_WITH_TIMEOUT(m->bench.isPolled(), patience);
    }
    template <typename T> T *find(const char *name) const
    {
        T *found = m_page->findChild<T *>(QLatin1String(name));
        if (!found) {
            qFatal("no widget %s", name);
        }
        return found;
    }
    QString text(const char *name) const { return find<QLabel>(name)->text(); }
    ScopePlot *plot(const char *name) const { return find<ScopePlot>(name); }
    static double highest(const QCustomPlot *plot, int curve = 0)
    {
        double value = 0;
        for (const QCPGraphData &point : *plot->graph(curve)->data()) {
            value = std::max(value, point.value);
        }
        return value;
    }

    std::unique_ptr<VimsDialogBench> m;
    std::unique_ptr<VibrationPage> m_page;
};

QTEST_MAIN(TestVibrationPage)
#include "tst_vibrationpage.moc"
