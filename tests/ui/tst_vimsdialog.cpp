#include "tests/ui/vimsdialogbench.h"
#include "translations/translation.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;
using Qt::Literals::StringLiterals::operator""_s;

namespace {

constexpr int cur = 45056;
constexpr int mut = 53248;
constexpr int acquisition = 114;

} // namespace

/// Reading, comparing, changing and commanding in the service window of L-VIMS.
class TestVimsDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { m.reset(); }

    void saysWhatTheModuleIs()
    {
        open();
        QCOMPARE(m->dialog->windowTitle(), u"Settings of the module L-VIMS on COM16"_s);
        QCOMPARE(m->text("moduleName"), u"VIMS_ICP"_s);
        QVERIFY(m->text("moduleSerial").startsWith(u"7S"));
        QCOMPARE(m->text("moduleFirmware"), u"1.0.7"_s);
        QCOMPARE(m->text("moduleBoard"), u"2"_s);
        QCOMPARE(m->text("moduleMode"), u"2, at work"_s);
        QCOMPARE(m->text("writeError"), u"0, none"_s);
        QCOMPARE(m->text("settingsError"), u"0, none"_s);
        QCOMPARE(m->bench.state(), LineState::Service);
    }

    void showsEverySetting()
    {
        open();
        QCOMPARE(edit("CUSTOM_NAME")->text(), u"Насос 1"_s);
        QCOMPARE(edit("IP_ADDR")->text(), u"192.168.1.10"_s);
        QCOMPARE(edit("IP_MASK")->text(), u"255.255.255.0"_s);
        QCOMPARE(edit("IP_GATE")->text(), u"192.168.1.1"_s);
        QCOMPARE(time()->value(), 500);
        QVERIFY(m->find<QCheckBox>("CH_EN_MASK.3")->isChecked());
        QCOMPARE(edit("CH3.SENSOR_K")->text(), u"100"_s);
        QCOMPARE(m->find<QComboBox>("CH2.MEAS1.TYPE")->currentData().toInt(), 2);
        QCOMPARE(m->find<QComboBox>("CH2.MEAS1.TYPE")->currentText(), u"2 velocity"_s);
        QCOMPARE(m->find<QComboBox>("CH2.MEAS7.TYPE")->currentText(), u"0 not used"_s);
        QVERIFY(!m->find<QCheckBox>("CH0.MEAS0.IIR_HP.EN")->isChecked());
        QCOMPARE(edit("CH0.MEAS0.IIR_HP.FC")->text(), u"0.0"_s);
        for (const lvims::Setting &setting : lvims::allSettings()) {
            QVERIFY2(m->find<QWidget>(qPrintable(setting.name))->isEnabled(), qPrintable(setting.name));
        }
        QVERIFY(!m->button("writeSettings")->isEnabled()); // nothing was changed
    }

    /// Prepared, applied, kept: three buttons, three questions, three lines in the journal.
    void oneThingAfterTheOther()
    {
        open();
        time()->setValue(700);
        edit("CH1.SENSOR_K")->setText(u"12,5"_s);
        m->button("writeSettings")->click();
        QVERIFY(m->question().contains(u"WF_ACQ_TIME: 500 → 700\nCH1.SENSOR_K: 100 → 12.5"));
        m->answer(false);
        QCOMPARE(m->peek(mut + acquisition), 500);
        m->button("writeSettings")->click();
        m->answer(true);
        m->waitForSettings();
        QCOMPARE(m->peek(mut + acquisition), 700);
        QCOMPARE(m->peek(mut + 143 + 386), 0x4148); // 41480000h = 12.5
        QCOMPARE(m->peek(cur + acquisition), 500);
        QVERIFY(m->message().contains(u"it does not use them yet"));

        m->button("applySettings")->click();
        QVERIFY(m->question().contains(u"WF_ACQ_TIME: 500 → 700"));
        QVERIFY(!m->question().contains(u"network"));
        m->answer(true);
        m->waitForSettings();
        QCOMPARE(m->peek(cur + acquisition), 700);

        m->button("flashSettings")->click();
        m->answer(true);
        m->waitForSettings();
        m->change([](lvims::SimulatedModule &module) { module.restart(std::chrono::hours(1)); });
        QTRY_COMPARE_WITH_TIMEOUT(m->peek(cur + acquisition), 700, patience);
        const QStringList told = m->bench.journalTexts(JournalKind::Info);
        for (const QString &text :
             {u"settings prepared in the module"_s, u"settings applied"_s, u"settings kept in flash"_s}) {
            QCOMPARE(told.filter(u"COM16, L-VIMS: "_s + text).size(), 1);
        }
    }

    void differencesStandOut()
    {
        m = std::make_unique<VimsDialogBench>(QList<SensorConfig>{vims(1, 1, 1)});
        m->start();
        m->waitForSettings();
        time()->setValue(700);
        QCOMPARE(table()->rowCount(), 1);
        QCOMPARE(row(0), (QStringList{u"WF_ACQ_TIME"_s, u"500"_s, u"500"_s, u"700"_s}));
        QVERIFY(time()->font().bold());
        QCOMPARE(time()->toolTip(), u"WF_ACQ_TIME: in use is 500"_s);
        QCOMPARE(m->find<QTabWidget>("vimsTabs")->tabText(2), u"Differences (1)"_s);
        m->button("writeSettings")->click();
        m->answer(true);
        m->waitForSettings();
        QCOMPARE(row(0), (QStringList{u"WF_ACQ_TIME"_s, u"500"_s, u"700"_s, u"700"_s}));
        time()->setValue(500);
        QCOMPARE(row(0), (QStringList{u"WF_ACQ_TIME"_s, u"500"_s, u"700"_s, u"500"_s}));
        QVERIFY(!time()->font().bold());
        m->button("reloadSettings")->click();
        m->answer(true);
        QTRY_COMPARE_WITH_TIMEOUT(m->peek(mut + acquisition), 500, patience);
    }

    void whatIsNotPossibleIsNotWritten()
    {
        open();
        edit("IP_MASK")->setText(u"255.0.255.0"_s);
        QVERIFY(!m->button("writeSettings")->isEnabled());
        QVERIFY(m->text("settingsComplaint").startsWith(u"IP_MASK takes a mask of a network"));
        edit("IP_MASK")->setText(u"255.255.255.0"_s);
        edit("CH0.MEAS0.IIR_LP.FC")->setText(u"12.55"_s);
        QVERIFY(m->text("settingsComplaint").contains(u"in steps of 0.1"));
        edit("CH0.MEAS0.IIR_LP.FC")->setText(u"12.5"_s);
        QCOMPARE(m->text("settingsComplaint"), QString());
        QVERIFY(m->button("writeSettings")->isEnabled());
    }

    void anotherNetworkAddress()
    {
        open();
        edit("IP_ADDR")->setText(u"192.168.1.77"_s);
        m->button("writeSettings")->click();
        m->answer(true);
        m->waitForSettings();
        m->button("applySettings")->click();
        QVERIFY(
            m->question().contains(u"the connection to the module will be lost. Write the new address 192.168.1.77"));
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(u"into Device of [Port4]"), patience);
        QCOMPARE(m->peek(cur + 33), 0x4D01);
    }

    void aModuleThatRefuses()
    {
        open();
        m->change([](lvims::SimulatedModule &module) { module.refuse(4); });
        time()->setValue(700);
        m->button("writeSettings")->click();
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(u"the settings were not written whole: refused"), patience);
        QCOMPARE(m->bench.journalTexts(JournalKind::Error).filter(u"not written whole"_s).size(), 1);
        QCOMPARE(time()->value(), 700); // what was typed stays
        QVERIFY(m->button("writeSettings")->isEnabled());
    }

    /// Another client has prepared what the module does not like.
    void theErrorOfACommandIsShown()
    {
        open();
        m->change([](lvims::SimulatedModule &module) {
            module.answer(QByteArray::fromHex("10D0720001020000"), std::chrono::hours(1)); // WF_ACQ_TIME 0
        });
        m->button("applySettings")->click();
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(u"settings applied, not done: refused"), patience);
        QVERIFY(m->message().contains(u"LAST_CHECK_SETTINGS_ERR 2"));
        QTRY_COMPARE_WITH_TIMEOUT(m->text("settingsError"), u"2 (2h)"_s, patience);
    }

    void restartEndsService()
    {
        open();
        m->button("restartModule")->click();
        QVERIFY(m->question().contains(u"It measures nothing meanwhile"));
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(u"The module restarts"), patience);
        m->bench.forgetAnswers();
        QTRY_VERIFY_WITH_TIMEOUT(m->bench.isPolled(), patience);
        QVERIFY(!m->button("applySettings")->isEnabled());
        m->button("portButton")->click(); // and again
        m->waitForSettings();
    }

    void backupAndRestore()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(u"backup.json"_s);
        open();
        m->button("saveSettings")->click();
        chooseFile(path);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path), patience);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        auto image = lvims::settingsIn(file.readAll());
        QVERIFY(image);
        QCOMPARE(int(image->at(acquisition)), 500);
        (*image)[acquisition] = 900;
        (*image)[146] = 5; // not described
        file.close();
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(lvims::settingsFile({}, *image));
        file.close();
        m->button("openSettings")->click();
        chooseFile(path);
        QTRY_COMPARE_WITH_TIMEOUT(time()->value(), 900, patience);
        QCOMPARE(row(1), (QStringList{u"SET+146"_s, u"0000"_s, u"0000"_s, u"0005"_s}));
        m->button("writeSettings")->click();
        m->answer(true);
        m->waitForSettings();
        QCOMPARE(m->peek(mut + acquisition), 900);
        QCOMPARE(m->peek(mut + 146), 5);

        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{}");
        file.close();
        m->button("openSettings")->click();
        chooseFile(path);
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(u"is no file of settings"), patience);
        QCOMPARE(time()->value(), 900);
    }

    void whatWasTypedIsNotLostUnasked()
    {
        open();
        time()->setValue(700);
        m->dialog->reject();
        QVERIFY(m->question().contains(u"is not written to the module yet"));
        m->answer(false);
        QCOMPARE(time()->value(), 700);
        m->dialog->reject();
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(!m->dialog, patience);
        m->bench.forgetAnswers();
        QTRY_VERIFY_WITH_TIMEOUT(m->bench.isPolled(), patience);
    }

    /// Two modules behind one address, told apart by their units.
    void chooseBetweenModules()
    {
        m = std::make_unique<VimsDialogBench>(QList<SensorConfig>{vims(1, 4, 1), vims(2, 9, 0)});
        m->open();
        QCOMPARE(m->addresses(), (QList<int>{1, 2}));
        QCOMPARE(m->find<QComboBox>("addressCombo")->itemText(1), u"9  Pump 9 (L-VIMS)"_s);
        const QString first = m->text("moduleSerial");
        m->choose("addressCombo", 1);
        QTRY_VERIFY_WITH_TIMEOUT(m->text("moduleSerial") != first && m->text("moduleSerial") != u"—"_s, patience);
        m->waitForSettings();
        time()->setValue(700);
        m->button("writeSettings")->click();
        m->answer(true);
        m->waitForSettings();
        QCOMPARE(m->peek(mut + acquisition, 1), 700);
        QCOMPARE(m->peek(mut + acquisition, 0), 500);
    }

    void aModuleThatIsAway()
    {
        m = std::make_unique<VimsDialogBench>(QList<SensorConfig>{vims(1, 4, 1)});
        m->bench.skip(0ms);
        m->start();
        m->bench.isPlugged = false;
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(u"COM16 is gone"), patience);
        QVERIFY(!m->button("readSettings")->isEnabled());
        QCOMPARE(m->bench.journalTexts(JournalKind::Info).filter(u"L-VIMS"_s).size(), 0);
    }

    void nothingIsCutOff_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("ru") << u"ru"_s;
        QTest::newRow("en") << u"en"_s;
    }
    void nothingIsCutOff()
    {
        QFETCH(const QString, language);
        QVERIFY(installTranslation(language));
        open();
        QVERIFY(QTest::qWaitForWindowExposed(m->dialog));
        auto *tabs = m->find<QTabWidget>("vimsTabs");
        for (int tab = 0; tab < tabs->count(); ++tab) {
            tabs->setCurrentIndex(tab);
            QCoreApplication::processEvents();
            QCOMPARE(cutOff(*m->dialog), QString());
        }
        QVERIFY(installTranslation(u"en"_s));
    }

private:
    void open()
    {
        m = std::make_unique<VimsDialogBench>(QList<SensorConfig>{vims(1, 1, 1)});
        m->open();
    }
    QLineEdit *edit(const char *name) const { return m->find<QLineEdit>(name); }
    QSpinBox *time() const { return m->find<QSpinBox>("WF_ACQ_TIME"); }
    QTableWidget *table() const { return m->find<QTableWidget>("comparison"); }
    QStringList row(int index) const
    {
        QStringList texts;
        for (int column = 0; column < table()->columnCount() && index < table()->rowCount(); ++column) {
            texts += table()->item(index, column)->text();
        }
        return texts;
    }
    void chooseFile(const QString &path)
    {
        auto *dialog = m->find<QFileDialog>("settingsFileDialog");
        Q_EMIT dialog->fileSelected(path);
        delete dialog;
    }

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
            const bool hasScroll = tabs && tabs->width() < tabs->sizeHint().width();
            if (widget->isVisible() && isTold && (isNarrow || hasScroll)) {
                list += label ? label->text() : button ? button->text() : tabs->tabText(0);
            }
        }
        return list.join(u"; "_s);
    }

    std::unique_ptr<VimsDialogBench> m;
};

QTEST_MAIN(TestVimsDialog)
#include "tst_vimsdialog.moc"
