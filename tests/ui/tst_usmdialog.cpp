#include "tests/ui/usmdialogbench.h"
#include "translations/translation.h"

#include <QCheckBox>
#include <QDateTimeEdit>
#include <QLineEdit>
#include <QProgressBar>
#include <QSpinBox>
#include <QTabWidget>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;
using usmisn::Simulator;

namespace {

const QList<SensorConfig> two{usm(1, 1, 7), usm(2, 2, 9)};
const QList<SensorConfig> farApart{usm(1, 1, 7), usm(2, 2, 250)};

} // namespace

/// Looking, measuring and setting in the service window of УСМ-ИСН.
class TestUsmDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { m.reset(); }

    /// Manual 002, 3.1 – 3.6.
    void scanFindsTheDevices()
    {
        open();
        QCOMPARE(m->dialog->windowTitle(), QStringLiteral("Settings of УСМ-ИСН sensors on COM16"));
        QCOMPARE(m->addresses(), QList<int>({7, 9}));
        QCOMPARE(m->text("deviceSerial"), QStringLiteral("00003591"));
        QCOMPARE(m->text("deviceType"), QStringLiteral("028"));
        QCOMPARE(m->text("calibratedOn"), QStringLiteral("14.04.2017"));
        QCOMPARE(m->text("calibrations"), QStringLiteral("2"));
        QCOMPARE(m->text("deviceProgram"), QStringLiteral("14.04.2017"));
        QCOMPARE(m->text("deviceChannels"), QStringLiteral("0000359101: Angle_X, Grad\n0000359102: Angle_Y, Grad"));
        QCOMPARE(m->find<QComboBox>("newAddressCombo")->count(), 253);
        QVERIFY(!m->button("writeAddress")->isEnabled()); // nothing is chosen
        m->chooseValue("addressCombo", 9);
        QTRY_COMPARE_WITH_TIMEOUT(m->text("deviceSerial"), QStringLiteral("00003592"), patience);
    }

    void findsBySerialNumber()
    {
        m = std::make_unique<UsmDialogBench>(farApart, farApart, BenchOptions{.pace = 20ms});
        m->start();
        QTRY_VERIFY_WITH_TIMEOUT(m->addresses().contains(7), patience);
        m->button("scanButton")->click(); // long before it comes to the other one
        QTRY_VERIFY_WITH_TIMEOUT(m->button("measure")->isEnabled(), patience);
        QCOMPARE(m->addresses(), QList<int>{7});
        auto *edit = m->find<QLineEdit>("serialEdit");
        edit->setText(QStringLiteral("12a"));
        QVERIFY(!m->button("findSerial")->isEnabled());
        edit->setText(QStringLiteral("00003592, 1234567"));
        m->button("findSerial")->click();
        QTRY_COMPARE_WITH_TIMEOUT(m->text("deviceSerial"), QStringLiteral("00003592"), patience);
        QCOMPARE(m->addresses(), QList<int>({7, 250}));
        QTRY_COMPARE_WITH_TIMEOUT(m->message(), QStringLiteral("00003592: address 250\n01234567: no answer"), patience);
    }

    /// A measurement fills the memory of the device only if that is wanted (3.11).
    void measures()
    {
        open();
        const QRegularExpression value(QStringLiteral("^[+-]\\d\\.\\d{5}° ± 0\\.\\d{5}°, -?\\d+\\.\\d\\d °C$"));
        m->button("measure")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m->text("valueY").contains(value), patience);
        QVERIFY2(m->text("valueX").contains(value), qPrintable(m->text("valueX")));
        QCOMPARE(stored(), 0);
        QTRY_VERIFY_WITH_TIMEOUT(m->button("measure")->isEnabled(), patience);
        m->find<QCheckBox>("storeValue")->setChecked(true);
        m->button("measure")->click();
        QTRY_COMPARE_WITH_TIMEOUT(m->message(), QStringLiteral("The device keeps what it measured."), patience);
        QCOMPARE(stored(), 2);
    }

    void saysWhyThereIsNoValue()
    {
        open();
        m->change(0, [](Simulator &device) { device.setOutOfRange(true); });
        m->button("measure")->click();
        QTRY_VERIFY_WITH_TIMEOUT(
            m->text("valueY").startsWith(QStringLiteral("out of the range of measurement, ")), patience);
        m->change(0, [](Simulator &device) { device.setBroken(true); });
        QTRY_VERIFY_WITH_TIMEOUT(m->button("measure")->isEnabled(), patience);
        m->button("measure")->click();
        const QString broken = QStringLiteral("the device cannot measure; its transducer may be broken (ErrorSensor)");
        QTRY_COMPARE_WITH_TIMEOUT(m->text("valueY"), broken, patience);
        QCOMPARE(m->text("valueX"), broken);
    }

    void anotherDeviceIsLeftAlone()
    {
        m = std::make_unique<UsmDialogBench>(two, QList<SensorConfig>{two.first()});
        m->change(0, [](Simulator &device) { device.setType("017"); });
        m->start();
        QTRY_COMPARE_WITH_TIMEOUT(m->text("deviceType"), QStringLiteral("17, not an УСМ-ИСН"), patience);
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(QStringLiteral("(type 17)")), patience);
        for (const char *name : {"measure", "writePort", "factoryPort", "startCycle", "downloadNew", "downloadAll"}) {
            QVERIFY2(!m->button(name)->isEnabled(), name);
        }
    }

    void changesTheAddress()
    {
        open();
        m->chooseValue("newAddressCombo", 32);
        m->bench.forgetSent();
        m->button("writeAddress")->click();
        QCOMPARE(m->question(), QStringLiteral("Give sensor 7 the address 32?"));
        m->answer(false);
        QVERIFY(!m->wasSent("SetAddress"));
        m->button("writeAddress")->click();
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(QStringLiteral("Write adr1=32 into [Port4]")), patience);
        QVERIFY(m->wasSent("%/Q/7/") && m->wasSent("SetAddress/32/%"));
        QCOMPARE(m->addresses(), QList<int>({9, 32}));
        QCOMPARE(m->bench.device<Simulator>(0, [](const Simulator &device) { return device.address(); }), 32);
        QCOMPARE(m->bench.journalTexts(JournalKind::Info).filter(QStringLiteral("new address 32, written")).size(), 1);
        QTRY_COMPARE_WITH_TIMEOUT(m->text("deviceSerial"), QStringLiteral("00003591"), patience);
    }

    void aStoppedScanGivesNoAddressAway()
    {
        start({.pace = 20ms});
        QTRY_VERIFY_WITH_TIMEOUT(m->addresses().contains(7), patience);
        m->button("scanButton")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m->button("measure")->isEnabled(), patience);
        QVERIFY(!m->find<QComboBox>("newAddressCombo")->isEnabled());
        QVERIFY(!m->button("writeAddress")->isEnabled());
        QVERIFY(m->button("writePort")->isEnabled());
    }

    /// The device is asked at its new settings, and the line comes back to its own.
    void changesThePort()
    {
        open();
        m->chooseValue("baudCombo", 19200);
        m->chooseValue("parityCombo", int(Parity::Even));
        m->button("writePort")->click();
        QVERIFY(m->question().startsWith(QStringLiteral("Give sensor 7 the port settings 19200-E-1?")));
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(
            m->message().contains(QStringLiteral("it answers at its new port settings 19200-E-1")), patience);
        QVERIFY(m->message().contains(QStringLiteral("BaudRate=19200, Parity=E, StopBits=1 into [Port4]")));
        const PortSettings own =
            m->bench.device<Simulator>(0, [](const Simulator &device) { return device.ownPort(); });
        QCOMPARE(own, (PortSettings{19200, Parity::Even, StopBits::One}));
        QTRY_VERIFY_WITH_TIMEOUT(m->find<QComboBox>("addressCombo")->isEnabled(), patience);
        m->chooseValue("addressCombo", 9); // is heard at the settings of the line
        QTRY_COMPARE_WITH_TIMEOUT(m->text("deviceSerial"), QStringLiteral("00003592"), patience);
    }

    void resetsThePort()
    {
        open();
        m->button("factoryPort")->click();
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(
            m->message().contains(QStringLiteral("it answers at its new port settings 9600-N-1")), patience);
        QVERIFY(m->wasSent("ResetPortSettings"));
    }

    /// A broadcast stands behind a warning of its own, and nobody answers it.
    void tellsAllDevices()
    {
        open();
        m->find<QCheckBox>("settingsForAll")->setChecked(true);
        m->button("writePort")->click();
        QVERIFY(m->question().startsWith(QStringLiteral("Give ALL devices of the УСМ series on this line")));
        m->bench.forgetSent();
        m->answer(false);
        QVERIFY(!m->wasSent("SetPortSettings"));
        m->chooseValue("baudCombo", 4800);
        m->button("writePort")->click();
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(QStringLiteral("sent to all devices")), patience);
        QVERIFY(m->wasSent("%/Q/000/"));
        for (int index : {0, 1}) {
            const int baud =
                m->bench.device<Simulator>(index, [](const Simulator &device) { return device.ownPort().baudRate; });
            QCOMPARE(baud, 4800);
        }
        QVERIFY(!m->button("writeAddress")->isEnabled()); // the scan is not to be trusted any more
    }

    void silenceRestartsWhoHangs()
    {
        open();
        m->bench.forgetSent();
        m->button("keepSilent")->click();
        QVERIFY(!m->button("measure")->isEnabled());
        QVERIFY(m->bench.sent().isEmpty());
        QTRY_VERIFY_WITH_TIMEOUT(
            m->message().startsWith(QStringLiteral("The line was silent; devices that hung have restarted.")),
            patience);
        QTRY_VERIFY_WITH_TIMEOUT(m->button("measure")->isEnabled(), patience);
    }

    /// Manual 002, 3.13 and 3.14.
    void recordsAndWakes()
    {
        open();
        m->find<QSpinBox>("recorderPeriod")->setValue(1800);
        m->button("startCycle")->click();
        QVERIFY(m->question().contains(QStringLiteral("Make sensor 7 a recorder? It sleeps, measures every 1800 s")));
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(QStringLiteral("it records and sleeps")), patience);
        QVERIFY(isRecording());
        QVERIFY(!m->button("startCycle")->isEnabled());
        m->button("stopCycle")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(QStringLiteral("it does not record any more")), patience);
        QVERIFY(!isRecording());
        QTRY_COMPARE_WITH_TIMEOUT(m->text("deviceSerial"), QStringLiteral("00003591"), patience);
        QVERIFY(m->button("measure")->isEnabled());
    }

    void aStartInThePastIsNotSent()
    {
        open();
        m->find<QDateTimeEdit>("firstMeasurement")->setDateTime(QDateTime::currentDateTime().addSecs(-120));
        m->bench.forgetSent();
        m->button("startCycle")->click();
        QVERIFY(m->question().isEmpty());
        QCOMPARE(m->message(), QStringLiteral("The first measurement has to lie in the future. Nothing was sent."));
        QVERIFY(!m->wasSent("StartCycle"));
    }

    void wakingGivesUpAfterTwoMinutes()
    {
        open();
        m->find<QSpinBox>("wakeAddress")->setValue(33); // nobody
        m->bench.forgetSent();
        m->button("stopCycle")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(QStringLiteral("did not answer for two minutes")), patience);
        const QList<QByteArray> sent = m->bench.sent();
        const auto isStop = [](const auto &request) { return request.contains("StopCycle"); };
        QCOMPARE(std::count_if(sent.begin(), sent.end(), isStop), 240); // one every half second
    }

    void wakingCanBeStopped()
    {
        start({.pace = 20ms});
        QTRY_VERIFY_WITH_TIMEOUT(m->addresses().contains(7), patience);
        m->button("scanButton")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m->button("stopCycle")->isEnabled(), patience);
        m->find<QSpinBox>("wakeAddress")->setValue(33);
        m->button("stopCycle")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m->find<QProgressBar>("wakeProgress")->value() > 0, patience);
        QVERIFY(!m->button("measure")->isEnabled());
        m->button("stopCycle")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(QStringLiteral("waking was stopped")), patience);
        QTRY_VERIFY_WITH_TIMEOUT(m->button("measure")->isEnabled(), patience);
    }

    void aPortThatVanishesEndsService()
    {
        open();
        m->bench.isPlugged = false;
        m->button("measure")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(QStringLiteral("COM16 is gone")), patience);
        QTRY_VERIFY_WITH_TIMEOUT(!m->button("measure")->isEnabled(), patience);
    }

    void nothingIsCutOff_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("ru") << QStringLiteral("ru");
        QTest::newRow("en") << QStringLiteral("en");
    }
    void nothingIsCutOff()
    {
        QFETCH(QString, language);
        QVERIFY(installTranslation(language));
        open();
        QVERIFY(QTest::qWaitForWindowExposed(m->dialog));
        auto *tabs = m->find<QTabWidget>("usmTabs");
        for (int tab = 0; tab < tabs->count(); ++tab) {
            tabs->setCurrentIndex(tab);
            QCoreApplication::processEvents();
            QCOMPARE(cutOff(*m->dialog), QString());
        }
        QVERIFY(installTranslation(QStringLiteral("en")));
    }

private:
    /// The texts, divided by `; `.
    static QString cutOff(const QWidget &window)
    {
        QStringList list;
        for (const QWidget *widget : window.findChildren<QWidget *>()) {
            const auto *label = qobject_cast<const QLabel *>(widget);
            const auto *button = qobject_cast<const QAbstractButton *>(widget);
            const auto *tabs = qobject_cast<const QTabBar *>(widget);
            const bool isTold = label || tabs || (button && !button->text().isEmpty());
            const bool isNarrow = !(label && label->wordWrap()) && widget->width() < widget->minimumSizeHint().width();
            const bool isLow =
                widget->height() < (label && label->wordWrap() ? label->heightForWidth(label->width()) : 0);
            const bool hasScroll = tabs && tabs->width() < tabs->sizeHint().width();
            if (widget->isVisible() && isTold && (isNarrow || isLow || hasScroll)) {
                list += label ? label->text() : button ? button->text() : tabs->tabText(0);
            }
        }
        return list.join(QStringLiteral("; "));
    }

    void start(const BenchOptions &options = {})
    {
        m = std::make_unique<UsmDialogBench>(two, two, options);
        m->start();
    }
    void open()
    {
        m = std::make_unique<UsmDialogBench>(two, two);
        m->open();
    }
    int stored()
    {
        return m->bench.device<Simulator>(0, [](const Simulator &device) {
            return static_cast<int>(device.memory().size());
        });
    }
    bool isRecording()
    {
        return m->bench.device<Simulator>(0, [](const Simulator &device) { return device.isRecording(); });
    }

    std::unique_ptr<UsmDialogBench> m;
};

QTEST_MAIN(TestUsmDialog)
#include "tst_usmdialog.moc"
