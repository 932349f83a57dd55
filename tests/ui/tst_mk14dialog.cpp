#include "tests/ui/mk14dialogbench.h"
#include "translations/translation.h"
#include "ui/pages/tableview.h"
#include "ui/service/mk14outputspanel.h"
#include "ui/service/mk14transferpanel.h"
#include "ui/weather/weathermodel.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QTabWidget>
#include <QTemporaryDir>

using namespace gorizont;
using namespace gorizont::test;
using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

namespace {

const QList<SensorConfig> one{station(1, 1, 7, u"0x0005"_s)};
const QList<SensorConfig> two{station(1, 1, 7, u"0x0005"_s), station(2, 2, 9)};

} // namespace

/// Looking, outputs, clock and files in the service window of МК-14.
class TestMk14Dialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { m.reset(); }

    void showsTheStationsOfThePort()
    {
        open(two, two);
        QCOMPARE(m->dialog->windowTitle(), u"Settings of the weather station МК-14 on COM16"_s);
        QCOMPARE(m->addresses(), QList<int>({7, 9}));
        QCOMPARE(values()->rowCount(), 6);
        QCOMPARE(m->text("outputsInForce"), u"0x00000005 (0, 2)"_s);
        QCOMPARE(m->find<QLineEdit>("outputWord")->text(), u"0x00000005"_s);
        m->chooseValue("addressCombo", 9);
        QTRY_COMPARE_WITH_TIMEOUT(m->text("outputsInForce"), u"0x00000000 (none is on)"_s, patience);
    }

    /// Whoever is asked gets a control word with it: stations that the ini does not know would lose their outputs.
    void asksNobodyWhoseOutputsAreNotKnown()
    {
        open(one, two);
        QCOMPARE(m->addresses(), QList<int>{7});
        QVERIFY(m->sent(7, 1) > 0);
        QCOMPARE(m->sent(9, 1), 0);
        for (const QByteArray &request : m->bench.sent()) {
            QCOMPARE(request.mid(4, 4), QByteArray::fromHex("05000000"));
        }
    }

    void readsWithEveryCommand_data()
    {
        QTest::addColumn<int>("command");
        QTest::addColumn<QList<int>>("columns"); // that have a value of the temperature
        using M = WeatherModel;
        QTest::newRow("1") << 1 << QList<int>{M::Mean};
        QTest::newRow("2") << 2 << QList<int>{M::Mean, M::Instant};
        QTest::newRow("3") << 3 << QList<int>{M::Mean, M::Minimum, M::Maximum};
        QTest::newRow("4") << 4 << QList<int>{M::Mean, M::Instant, M::Minimum, M::Maximum};
        QTest::newRow("5") << 5 << QList<int>{M::Mean, M::Instant, M::Minimum, M::Maximum, M::Voltage};
        QTest::newRow("6") << 6
                           << QList<int>{M::Mean, M::Instant, M::Minimum, M::Maximum, M::Voltage, M::VoltageInstant};
        QTest::newRow("7") << 7 << QList<int>{M::Mean, M::MaxPeriod, M::Deviation};
        QTest::newRow("8") << 8 << QList<int>{M::Mean};
    }
    void readsWithEveryCommand()
    {
        QFETCH(const int, command);
        open(one, one);
        m->chooseValue("dataCommand", command);
        m->bench.forgetSent();
        m->button("readNow")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m->button("readNow")->isEnabled(), patience);
        QCOMPARE(m->message(), u"Station 7 was read."_s);
        QCOMPARE(m->sent(7, command), 1);
        QList<int> filled;
        for (int column = WeatherModel::Mean; column < WeatherModel::ColumnCount; ++column) {
            if (values()->index(1, column).data().toString() != u"—"_s) {
                filled += column;
            }
        }
        QTEST(filled, "columns");
        QCOMPARE(m->look([](const mk14::Simulator &device) { return device.outputs(); }), 5U);
    }

    void saysThatThereAreNoData()
    {
        open(one, one);
        m->change([](mk14::Simulator &device) { device.setHasData(false); });
        m->button("readNow")->click();
        QTRY_COMPARE_WITH_TIMEOUT(m->message(), u"Station 7 answers, but it has no data yet."_s, patience);
        QCOMPARE(values()->rowCount(), 0);
    }

    void setsTheOutputs()
    {
        open(one, one);
        m->find<QCheckBox>("output2")->setChecked(false);
        m->find<QCheckBox>("output31")->setChecked(true);
        QCOMPARE(m->find<QLineEdit>("outputWord")->text(), u"0x80000001"_s);
        m->button("setOutputs")->click();
        QVERIFY(m->question().startsWith(u"Set the outputs of station 7 to 0x80000001 (0, 31)?"_s));
        m->answer(false);
        QCOMPARE(m->look([](const mk14::Simulator &device) { return device.outputs(); }), 5U);
        m->button("setOutputs")->click();
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(u"0x80000001 (0, 31), confirmed."_s), patience);
        QVERIFY(m->message().contains(u"write Outputs1=2147483649 into [Port4]"_s));
        QCOMPARE(m->look([](const mk14::Simulator &device) { return device.outputs(); }), 0x80000001U);
        QCOMPARE(m->text("outputsInForce"), u"0x80000001 (0, 31)"_s);
        QCOMPARE(m->bench.journalTexts(JournalKind::Info).filter(u"outputs 0x80000001"_s).size(), 1);
        m->bench.forgetSent();
        m->button("serviceExit")->click(); // nothing is left unsaid: no question
        QTRY_VERIFY_WITH_TIMEOUT(m->bench.isPolled() && m->bench.sent().size() > 2, patience);
        for (const QByteArray &request : m->bench.sent()) {
            QCOMPARE(request.mid(4, 4), QByteArray::fromHex("01000080")); // polling repeats what was set
        }
    }

    void outputsAsANumber()
    {
        QCOMPARE(Mk14OutputsPanel::typedWord(u"0x1f"_s), std::optional<quint32>(31));
        QCOMPARE(Mk14OutputsPanel::typedWord(u" 31 "_s), std::optional<quint32>(31));
        QCOMPARE(Mk14OutputsPanel::typedWord(u"0xFFFFFFFF"_s), std::optional<quint32>(0xFFFFFFFF));
        for (const QString &bad : {u""_s, u"0x"_s, u"-1"_s, u"4294967296"_s, u"1F"_s, u"0x100000000"_s}) {
            QVERIFY2(!Mk14OutputsPanel::typedWord(bad), qPrintable(bad));
        }
        open(one, one);
        m->find<QTabWidget>("mk14Tabs")->setCurrentIndex(1);
        auto *number = m->find<QLineEdit>("outputWord");
        number->selectAll();
        QTest::keyClicks(number, u"0x12"_s);
        QVERIFY(m->find<QCheckBox>("output4")->isChecked());
        QVERIFY(!m->find<QCheckBox>("output0")->isChecked());
        QTest::keyClicks(number, u"z"_s);
        QVERIFY(!m->button("setOutputs")->isEnabled());
        m->find<QCheckBox>("output0")->setChecked(true);
        QCOMPARE(number->text(), u"0x00000013"_s);
        QVERIFY(m->button("setOutputs")->isEnabled());
        m->bench.forgetSent();
        m->button("serviceExit")->click();
        QCOMPARE(m->question(), u"The new control word of station 7 was not sent. Discard it?"_s);
        m->answer(false);
        QVERIFY(m->dialog && m->dialog->isVisible());
        m->button("readNow")->click();
        QTRY_COMPARE_WITH_TIMEOUT(m->message(), u"Station 7 was read."_s, patience);
        QCOMPARE(number->text(), u"0x00000013"_s); // what is typed stays
        for (const QByteArray &request : m->bench.sent()) {
            QCOMPARE(request.mid(4, 4), QByteArray::fromHex("05000000")); // and is not sent by reading
        }
    }

    void outputsThatNobodyConfirms()
    {
        open(one, one);
        m->find<QCheckBox>("output2")->setChecked(false);
        silence();
        m->button("setOutputs")->click();
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(u"not confirmed (no answer)"_s), patience);
        QCOMPARE(m->text("outputsInForce"), u"0x00000005 (0, 2)"_s);
        QCOMPARE(m->bench.journalTexts(JournalKind::Error).filter(u"not confirmed"_s).size(), 1);
    }

    void setsTheClock()
    {
        open(one, one);
        QVERIFY(m->text("clockRule").contains(u"shows local time"_s));
        m->button("setTime")->click();
        QVERIFY(m->question().contains(u"local time of this computer"_s));
        m->bench.forgetSent();
        m->answer(false);
        QCOMPARE(m->sent(7, 0xFF), 0);
        m->button("setTime")->click();
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(m->message().endsWith(u", confirmed"_s), patience);
        QCOMPARE(m->sent(7, 0xFF), 1);
        const QDateTime now = QDateTime::currentDateTime();
        const qint64 wall = now.toSecsSinceEpoch() + now.offsetFromUtc();
        const qint64 set = wordOf(m->bench.sent().constLast());
        QVERIFY2(std::abs(set - wall) < 60, qPrintable(QString::number(set - wall)));
        const QString day = QDateTime::fromSecsSinceEpoch(set, Qt::UTC).toString(u"dd.MM.yyyy HH:mm:ss"_s);
        QCOMPARE(m->message(), u"Station 7: clock set to %1, confirmed"_s.arg(day));
    }

    void clockOfAUtcStation()
    {
        QList<SensorConfig> utc = one;
        utc.first().options.insert(u"stationclock"_s, u"UTC"_s);
        open(utc, utc);
        QVERIFY(m->text("clockRule").contains(u"StationClock=UTC"_s));
        QVERIFY(m->text("clockTime").endsWith(u" UTC"_s));
        m->bench.forgetSent();
        m->button("setTime")->click();
        QVERIFY(m->question().contains(u"UTC?"_s));
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(m->message().endsWith(u" UTC, confirmed"_s), patience);
        const qint64 off = wordOf(m->bench.sent().constLast()) - QDateTime::currentSecsSinceEpoch();
        QVERIFY2(std::abs(off) < 60, qPrintable(QString::number(off)));
    }

    void sendsAFile()
    {
        open(one, one);
        QVERIFY(!m->button("sendFile")->isEnabled());
        const QByteArray text("\"Temperature\" C T T 1 A 60 %6.2f -60 60 5 0 20\r\n");
        choose(u"АСК.PAR"_s, text); // Cyrillic letters
        QVERIFY(m->text("chosenFile").endsWith(u"АСК.PAR, %1 byte(s)"_s.arg(text.size())));
        QCOMPARE(m->find<QLineEdit>("stationFileName")->text(), u"ACK.PAR"_s); // Latin ones
        m->button("sendFile")->click();
        QVERIFY(m->question().contains(u"ACK.PAR"_s));
        m->answer(false);
        QVERIFY(m->look([](const mk14::Simulator &device) { return device.files(); }).isEmpty());
        m->button("sendFile")->click();
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(m->message().endsWith(u", confirmed"_s), patience);
        const auto files = m->look([](const mk14::Simulator &device) { return device.files(); });
        QCOMPARE(files.value("ACK.PAR"), text);
        QCOMPARE(m->bench.journalTexts(JournalKind::Info).filter(u"file ACK.PAR"_s).size(), 1);
    }

    void aFileThatNobodyConfirms()
    {
        open(one, one);
        choose(u"ACK.PAR"_s, "x");
        silence();
        m->button("sendFile")->click();
        m->answer(true);
        QTRY_VERIFY_WITH_TIMEOUT(
            m->message().contains(u"not confirmed (no answer): the station may have it"_s), patience);
        QVERIFY(m->button("sendFile")->isEnabled());
    }

    void filesThatAreNotSent_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("why");
        QTest::newRow("empty") << QByteArray() << u"The file is empty"_s;
        QTest::newRow("too large") << QByteArray(65537, 'x') << u"more than 65536 bytes"_s;
    }
    void filesThatAreNotSent()
    {
        QFETCH(const QByteArray, bytes);
        QFETCH(const QString, why);
        open(one, one);
        choose(u"ACK.PAR"_s, bytes);
        QVERIFY2(m->message().contains(why), qPrintable(m->message()));
        QVERIFY(!m->button("sendFile")->isEnabled());
        choose(u"ACK.PAR"_s, QByteArray(65536, 'x'));
        QCOMPARE(m->message(), QString());
        QVERIFY(m->button("sendFile")->isEnabled());
        for (const QString &name : {u""_s, u"АКП.ИНИ"_s, u"../ACK.PAR"_s, u"C:ACK.PAR"_s, u"A B"_s}) {
            m->find<QLineEdit>("stationFileName")->setText(name);
            QVERIFY2(!m->button("sendFile")->isEnabled(), qPrintable(name));
        }
    }

    void aFileThatIsGone()
    {
        open(one, one);
        auto *panel = m->find<Mk14TransferPanel>("mk14Transfer");
        QVERIFY(panel->takeFile(m_folder.filePath(u"nowhere"_s)).startsWith(u"The file cannot be read: "_s));
        QVERIFY(panel->takeFile(m_folder.path()).startsWith(u"The file cannot be read: "_s)); // a folder
    }

    void aPortThatVanishesEndsService()
    {
        open(one, one);
        m->bench.isPlugged = false;
        m->button("readNow")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m->message().contains(u"COM16 is gone"_s), patience);
        QTRY_VERIFY_WITH_TIMEOUT(!m->button("setOutputs")->isEnabled(), patience);
        QVERIFY(!m->button("setTime")->isEnabled() && !m->button("sendFile")->isEnabled());
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
        open(one, one);
        QVERIFY(QTest::qWaitForWindowExposed(m->dialog));
        auto *tabs = m->find<QTabWidget>("mk14Tabs");
        for (int tab = 0; tab < tabs->count(); ++tab) {
            tabs->setCurrentIndex(tab);
            QCoreApplication::processEvents();
            for (const QWidget *widget : m->dialog->findChildren<QWidget *>()) {
                const auto *label = qobject_cast<const QLabel *>(widget);
                const auto *button = qobject_cast<const QAbstractButton *>(widget);
                if (!widget->isVisible() || !(label || (button && !button->text().isEmpty()))) {
                    continue;
                }
                const QString text = label ? label->text() : button->text();
                QVERIFY2(
                    (label && label->wordWrap()) || widget->width() >= widget->minimumSizeHint().width(),
                    qPrintable(text));
                QVERIFY2(
                    !label || !label->wordWrap() || widget->height() >= label->heightForWidth(label->width()),
                    qPrintable(text));
            }
        }
        QVERIFY(installTranslation(u"en"_s));
    }

private:
    void open(const QList<SensorConfig> &ini, const QList<SensorConfig> &connected)
    {
        m = std::make_unique<Mk14DialogBench>(
            ini, connected, BenchOptions{.faults = {*parseSimulatedFault(u"silent=1@7200"_s)}});
        m->open();
    }
    /// From now on nobody answers any more.
    void silence() { m->bench.skip(3h); }
    const QAbstractItemModel *values() const { return m->find<TableView>("mk14Values")->model(); }
    static qint64 wordOf(const QByteArray &request)
    {
        qint64 word = 0;
        for (int i = 7; i >= 4; --i) {
            word = word << 8 | static_cast<quint8>(request[i]);
        }
        return word;
    }
    /// As a user chooses it in the file dialog.
    void choose(const QString &name, const QByteArray &bytes)
    {
        QFile file(m_folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
        file.close();
        m->button("chooseFile")->click();
        auto *dialog = m->dialog->findChild<QFileDialog *>(u"stationFileDialog"_s);
        QVERIFY(dialog);
        Q_EMIT dialog->fileSelected(file.fileName());
        delete dialog;
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Mk14DialogBench> m;
};

QTEST_MAIN(TestMk14Dialog)
#include "tst_mk14dialog.moc"
