#include "tests/ui/ind3dialogbench.h"

#include <QProgressBar>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

/// Requests of protocol 2.11 that set something.
QList<QByteArray> writesOf(const QList<QByteArray> &requests)
{
    QList<QByteArray> writes;
    for (const QByteArray &request : requests) {
        if (request.size() > 3 && request.at(1) == '\x9C'
            && QByteArray("\x02\x04\x06\x09\x0D\x0F").contains(request.at(2))) {
            writes.append(request.toHex());
        }
    }
    return writes;
}

} // namespace

/// What the service window of ИН-Д3 shows, offers and writes.
class TestInd3Dialog : public Ind3DialogBench
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { close(); }

    /// Manual 000, sections 8.6 and 8.7.
    void scanFindsTheSensors()
    {
        open(two, two);
        QCOMPARE(m_dialog->windowTitle(), QStringLiteral("Settings of ИН-Д3 sensors on COM16"));
        QCOMPARE(text("portNumber"), QStringLiteral("16"));
        QCOMPARE(text("portSpeed"), QStringLiteral("115200"));
        QCOMPARE(m_bench->state(), LineState::Service);
        QCOMPARE(addresses(), QList<int>({11, 24}));
        QCOMPARE(text("foundCount"), QStringLiteral("2"));
        QCOMPARE(find<QComboBox>("addressCombo")->currentText(), QStringLiteral("11"));
        QCOMPARE(find<QLineEdit>("nameEdit")->text(), QStringLiteral("NO NAME"));
        QCOMPARE(text("sensorSpeed"), QStringLiteral("9600"));
        QCOMPARE(text("sensorVersion"), QStringLiteral("v2.11"));
        QCOMPARE(text("softwareRevision"), QStringLiteral("4144"));
        QCOMPARE(text("factoryNumber"), QStringLiteral("3591"));
        QCOMPARE(find<QLineEdit>("offsetXEdit")->text(), QStringLiteral("0.000"));
        QCOMPARE(find<QComboBox>("ticksCombo")->currentText(), QStringLiteral("32"));
        QCOMPARE(find<QComboBox>("periodCombo")->currentText(), QStringLiteral("50"));
        QVERIFY(button("changeAddress")->isEnabled());
        QVERIFY(!button("applySettings")->isEnabled()); // nothing was changed
        QTRY_VERIFY_WITH_TIMEOUT(
            text("liveTilt").contains(QRegularExpression(QStringLiteral("^[+-]\\d+\\.\\d [+-]\\d+\\.\\d$"))), patience);
    }

    void anotherAddressIsRead()
    {
        open(two, two);
        choose("addressCombo", 1);
        QTRY_COMPARE_WITH_TIMEOUT(text("factoryNumber"), QStringLiteral("3592"), patience);
        QVERIFY(find<QLineEdit>("nameEdit")->isEnabled());
    }

    void aStoppedScanGivesNoAddressAway()
    {
        start(two, two, {.pace = 20ms});
        QTRY_VERIFY_WITH_TIMEOUT(addresses().contains(11), patience); // as they are found
        QVERIFY(find<QProgressBar>("scanProgress")->value() >= 11);
        QCOMPARE(button("scanButton")->text(), QStringLiteral("&Stop"));
        QVERIFY(!button("applySettings")->isEnabled());
        button("scanButton")->click();
        QTRY_COMPARE_WITH_TIMEOUT(text("factoryNumber"), QStringLiteral("3591"), patience);
        QCOMPARE(button("scanButton")->text(), QStringLiteral("&Scan"));
        QVERIFY(find<QLineEdit>("nameEdit")->isEnabled()); // everything but the address can be changed
        QVERIFY(!button("changeAddress")->isEnabled());
        QVERIFY(button("changeAddress")->toolTip().contains(QStringLiteral("complete scan")));
        QVERIFY(text("scanText").contains(QStringLiteral("not complete")));
    }

    void namesAreChecked_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("isGood");
        QTest::newRow("Cyrillic") << QStringLiteral("Новый датчик №1") << true;
        QTest::newRow("signs") << QStringLiteral("A-7 (N#2);«x»") << true;
        QTest::newRow("16") << QStringLiteral("1234567890123456") << true;
        QTest::newRow("not in Windows-1251") << QStringLiteral("roof → 2") << false;
        QTest::newRow("empty") << QString() << false;
    }
    void namesAreChecked()
    {
        QFETCH(QString, name);
        QFETCH(bool, isGood);
        open(two, two);
        type("nameEdit", name);
        QCOMPARE(button("applySettings")->isEnabled(), isGood);
        QCOMPARE(text("formProblem").isEmpty(), isGood);
    }

    void aLongNameIsCut()
    {
        open(two, two);
        type("nameEdit", QStringLiteral("12345678901234567"));
        QCOMPARE(find<QLineEdit>("nameEdit")->text(), QStringLiteral("1234567890123456"));
    }

    /// Manual 000, section 8.11: the fraction stands after a point or a comma.
    void offsetsTakePointAndComma_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QByteArray>("block"); // Y 0, X in 1/256 arc-second; empty: refused
        QTest::newRow("point") << QStringLiteral("200.5") << QByteArray("00000080c800");
        QTest::newRow("comma") << QStringLiteral("200,5") << QByteArray("00000080c800");
        QTest::newRow("negative") << QStringLiteral("-0,125") << QByteArray("000000200080");
        QTest::newRow("whole") << QStringLiteral("300") << QByteArray("000000002c01");
        QTest::newRow("word") << QStringLiteral("ten") << QByteArray();
        QTest::newRow("two marks") << QStringLiteral("1,000.5") << QByteArray();
        QTest::newRow("too large") << QStringLiteral("16384") << QByteArray();
        QTest::newRow("nan") << QStringLiteral("nan") << QByteArray();
        QTest::newRow("nothing") << QString() << QByteArray();
    }
    void offsetsTakePointAndComma()
    {
        QFETCH(QString, typed);
        QFETCH(QByteArray, block);
        const QLocale before;
        QLocale::setDefault(QLocale(QLocale::Russian));
        const auto restore = qScopeGuard([before] { QLocale::setDefault(before); });
        open(two, two);
        type("offsetXEdit", typed);
        QCOMPARE(button("applySettings")->isEnabled(), !block.isEmpty());
        if (block.isEmpty()) {
            QVERIFY(text("formProblem").contains(QStringLiteral("16383.99")));
            return;
        }
        m_bench->forgetSent();
        button("applySettings")->click();
        QTRY_VERIFY_WITH_TIMEOUT(text("serviceMessage").endsWith(QStringLiteral("written.")), patience);
        QTRY_VERIFY_WITH_TIMEOUT(find<QLineEdit>("offsetXEdit")->isEnabled(), patience);
        const QList<QByteArray> writes = writesOf(m_bench->sent());
        QCOMPARE(writes.size(), 1);
        QCOMPARE(writes.first().mid(8, 12), block);
    }

    void onlyWhatChangedIsWritten()
    {
        open(two, two);
        m_bench->forgetSent();
        choose("ticksCombo", 4);
        button("applySettings")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!text("serviceMessage").startsWith(QStringLiteral("Writing")), patience);
        QTRY_VERIFY_WITH_TIMEOUT(find<QLineEdit>("nameEdit")->isEnabled(), patience);
        QCOMPARE(writesOf(m_bench->sent()), QList<QByteArray>{"7e9c0d0b049e7e"}); // 16 ticks to address 11
        QCOMPARE(find<QComboBox>("ticksCombo")->currentText(), QStringLiteral("16"));
        QVERIFY(!button("applySettings")->isEnabled());

        m_bench->forgetSent();
        type("nameEdit", QStringLiteral("Новый датчик"));
        type("offsetXEdit", QStringLiteral("200.000"));
        QTest::keyClick(find<QLineEdit>("offsetXEdit"), Qt::Key_Return); // the default button
        QTRY_COMPARE_WITH_TIMEOUT(find<QLineEdit>("offsetXEdit")->text(), QStringLiteral("200.000"), patience);
        QTRY_VERIFY_WITH_TIMEOUT(find<QLineEdit>("nameEdit")->isEnabled(), patience);
        QCOMPARE(
            writesOf(m_bench->sent()),
            QList<QByteArray>({"7e9c040bcdeee2fbe920e4e0f2f7e8ea637e", "7e9c060b00000000c800597e"}));
        QVERIFY(!button("applySettings")->isEnabled());
        QCOMPARE(find<QLineEdit>("nameEdit")->text(), QStringLiteral("Новый датчик"));
        QVERIFY(find<QLineEdit>("offsetXEdit")->hasFocus()); // where it was
        const QStringList lines = m_bench->journalTexts(JournalKind::Info);
        QVERIFY(lines.contains(QStringLiteral("COM16, ИН-Д3 address 11: averaging ticks 16, written")));
        QVERIFY(lines.contains(QStringLiteral("COM16, ИН-Д3 address 11: name “Новый датчик”, written")));
        QVERIFY(lines.contains(QStringLiteral("COM16, ИН-Д3 address 11: zero offset X 200.000″, Y 0.000″, written")));
        QCOMPARE(m_bench->journal.entries().back().number, 1);
    }

    /// A value of the sensor that has more digits than the field shows does not count as changed.
    void roundingIsNoChange()
    {
        open(two, two);
        type("offsetXEdit", QStringLiteral("0.00390625")); // 1/256
        button("applySettings")->click();
        QTRY_COMPARE_WITH_TIMEOUT(find<QLineEdit>("offsetXEdit")->text(), QStringLiteral("0.004"), patience);
        QTRY_VERIFY_WITH_TIMEOUT(find<QLineEdit>("offsetXEdit")->isEnabled(), patience);
        m_bench->forgetSent();
        type("offsetXEdit", QStringLiteral("0,0040"));
        QVERIFY(!button("applySettings")->isEnabled());
        type("offsetYEdit", QStringLiteral("1"));
        button("applySettings")->click();
        QTRY_COMPARE_WITH_TIMEOUT(find<QLineEdit>("offsetYEdit")->text(), QStringLiteral("1.000"), patience);
        QTRY_VERIFY_WITH_TIMEOUT(find<QLineEdit>("offsetYEdit")->isEnabled(), patience);
        QCOMPARE(writesOf(m_bench->sent()).first().mid(8, 12), QByteArray("000100010000"));
    }

    void unappliedSettingsAreAskedAbout()
    {
        open(two, two);
        type("nameEdit", QStringLiteral("Roof"));
        choose("addressCombo", 1);
        QTRY_VERIFY_WITH_TIMEOUT(m_dialog->findChild<QDialog *>(QStringLiteral("serviceQuestion")), patience);
        button("questionStay")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog->findChild<QDialog *>(QStringLiteral("serviceQuestion")), patience);
        QCOMPARE(find<QComboBox>("addressCombo")->currentText(), QStringLiteral("11"));
        QCOMPARE(find<QLineEdit>("nameEdit")->text(), QStringLiteral("Roof"));

        QTest::keyClick(m_dialog, Qt::Key_Escape);
        button("questionStay")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog->findChild<QDialog *>(QStringLiteral("serviceQuestion")), patience);
        QVERIFY(m_dialog->isVisible());

        choose("addressCombo", 1);
        button("questionGo")->click();
        QTRY_COMPARE_WITH_TIMEOUT(text("factoryNumber"), QStringLiteral("3592"), patience);
        QVERIFY(writesOf(m_bench->sent()).isEmpty());
    }

    /// Manual 000, sections 8.12 and 8.13.
    void addressIsChanged()
    {
        open({inclinometer(1, 1, 11), inclinometer(2, 2, 24), inclinometer(3, 3, 40)}, two);
        button("changeAddress")->click();
        auto *offered = find<QComboBox>("newAddressCombo");
        QCOMPARE(offered->count(), 253);
        QCOMPARE(offered->findData(11), -1);
        QCOMPARE(offered->findData(24), -1);
        QCOMPARE(offered->itemText(offered->findData(40)), QStringLiteral("40 (N 3 in the ini)"));
        QVERIFY(!button("newAddressApply")->isEnabled()); // nothing is chosen yet
        m_bench->forgetSent();
        button("newAddressCancel")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!m_dialog->findChild<QDialog *>(QStringLiteral("newAddressDialog")), patience);
        QVERIFY(writesOf(m_bench->sent()).isEmpty());

        button("changeAddress")->click();
        offered = find<QComboBox>("newAddressCombo");
        offered->setCurrentIndex(offered->findData(12));
        button("newAddressApply")->click();
        QTRY_COMPARE_WITH_TIMEOUT(addresses(), QList<int>({12, 24}), patience);
        QTRY_COMPARE_WITH_TIMEOUT(
            text("factoryNumber"), QStringLiteral("3591"), patience); // polled again where it is now
        QCOMPARE(find<QComboBox>("addressCombo")->currentText(), QStringLiteral("12"));
        QCOMPARE(writesOf(m_bench->sent()), QList<QByteArray>{"7e9c090b0c927e"});
        QVERIFY(text("serviceMessage").contains(QStringLiteral("adr1=12 into [Port4]")));
        QVERIFY(m_bench->journalTexts(JournalKind::Info)
                    .join(u'\n')
                    .contains(QStringLiteral("COM16, ИН-Д3 address 11: new address 12, written")));
        QTRY_VERIFY_WITH_TIMEOUT(button("changeAddress")->isEnabled(), patience);
        button("changeAddress")->click(); // the old one is free again
        offered = find<QComboBox>("newAddressCombo");
        QVERIFY(offered->findData(11) >= 0 && offered->findData(12) < 0);
    }

    void unclearAddressesAreListed()
    {
        start(two, two, {.faults = {*parseSimulatedFault(QStringLiteral("crc=100"))}});
        QTRY_VERIFY_WITH_TIMEOUT(text("scanText").contains(QStringLiteral("Unclear: 11, 24.")), patience);
        QCOMPARE(text("foundCount"), QStringLiteral("0"));
        QVERIFY(!button("changeAddress")->isEnabled());
    }

    void modbusIsAnotherScan()
    {
        open(two, {inclinometer(1, 1, 11), inclinometer(2, 2, 14, QStringLiteral("modbus"))});
        QCOMPARE(addresses(), QList<int>({11}));
        choose("protocolCombo", 1);
        QTRY_COMPARE_WITH_TIMEOUT(text("factoryNumber"), QStringLiteral("3592"), patience);
        QCOMPARE(addresses(), QList<int>({14}));
        QVERIFY(!find<QLineEdit>("nameEdit")->isEnabled()); // it has none there
        QCOMPARE(text("sensorVersion"), QStringLiteral("—"));
        QVERIFY(find<QLineEdit>("offsetXEdit")->isEnabled());
    }

    void protocolOfTheIniIsTheFirst()
    {
        const QList<SensorConfig> modbus{inclinometer(1, 1, 14, QStringLiteral("modbus"))};
        open(modbus, modbus);
        QCOMPARE(addresses(), QList<int>({14}));
    }

    /// Manual, section 8.7, from the top down.
    void tabFollowsThePicture()
    {
        open(two, two);
        QStringList order;
        find<QWidget>("portButton")->setFocus();
        for (int i = 0; i < 20; ++i) {
            const QString name = m_dialog->focusWidget()->objectName();
            if (order.contains(name)) {
                break;
            }
            order += name;
            QTest::keyClick(m_dialog->focusWidget(), Qt::Key_Tab);
        }
        QCOMPARE(
            order.join(u' '),
            QStringLiteral(
                "portButton addressCombo changeAddress nameEdit protocolCombo offsetXEdit ticksCombo offsetYEdit "
                "periodCombo scanButton serviceExit"));
    }
};

QTEST_MAIN(TestInd3Dialog)
#include "tst_ind3dialog.moc"
