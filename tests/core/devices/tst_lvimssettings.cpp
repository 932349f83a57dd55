#include "core/devices/lvims/lvimsservice.h"
#include "tests/core/devices/lvimsbench.h"
#include "tests/support/fakeline.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::lvims;
using namespace gorizont::test;
using namespace std::chrono_literals;
using Qt::Literals::StringLiterals::operator""_s;

namespace {

const QList<quint16> nothing(settingsSize, 0);

/// \a nothing with \a words from \a address on.
QList<quint16> with(int address, const QList<quint16> &words)
{
    QList<quint16> image = nothing;
    std::copy(words.begin(), words.end(), image.begin() + address);
    return image;
}

QByteArray frame(int transaction, const QByteArray &pdu)
{
    QByteArray bytes = hex("80 00 00 00 00 00 01");
    bytes[1] = static_cast<char>(transaction);
    bytes[5] = static_cast<char>(pdu.size() + 1);
    return bytes + pdu;
}

} // namespace

/// Single settings of manual 003, sections 2.4 and 2.5. Addresses and words on the right were computed by hand.
class TestLVimsSettings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everySettingOfTheManual()
    {
        QCOMPARE(allSettings().size(), 7 + 4 * (2 + 8 * 5));
        QList<int> taken(settingsSize, 0);
        for (const Setting &setting : allSettings()) {
            QCOMPARE(settingNamed(setting.name.toLower()), &setting);
            for (int i = 0; i < setting.size; ++i) {
                ++taken[setting.address + i];
            }
        }
        QVERIFY(!taken.contains(2)); // no register belongs to two
        QVERIFY(!settingNamed(u"CH4.SENSOR_K"_s));
        QVERIFY(!settingNamed(u"CH0.MEAS8.TYPE"_s));
        QVERIFY(!settingNamed(QString()));
    }

    void changes_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("address");
        QTest::addColumn<QList<quint16>>("words");
        QTest::addColumn<QString>("shown");
        using Words = QList<quint16>;
        const auto row = [](const char *name, const char *text, int address, const Words &words, const char *shown) {
            QTest::addRow("%s=%s", name, text)
                << QString::fromLatin1(name) << QString::fromUtf8(text) << address << words << QString::fromUtf8(shown);
        };
        row("CUSTOM_NAME", "aНс", 0, {0xD061, 0xD19D, 0x0081}, "aНс");
        row("IP_ADDR", "192.168.1.10", 32, {0xA8C0, 0x0A01}, "192.168.1.10");
        row("IP_MASK", "255.255.240.0", 34, {0xFFFF, 0x00F0}, "255.255.240.0");
        row("IP_GATE", "10.0.0.254", 36, {0x000A, 0xFE00}, "10.0.0.254");
        row("IP_GATE", "0.0.0.0", 36, {0, 0}, "0.0.0.0");
        row("CH_EN_MASK", "0x0d", 112, {13}, "13");
        row("CH_SENS_PWR", "2", 113, {2}, "2");
        row("WF_ACQ_TIME", " 4000 ", 114, {4000}, "4000");
        row("WF_ACQ_TIME", "1", 114, {1}, "1");
        row("CH1.SENSOR_K", "100", 142 + 386, {0x0000, 0x42C8}, "100");
        row("CH3.SENSOR_B", "-264,5", 144 + 3 * 386, {0x4000, 0xC384}, "-264.5");
        row("CH0.MEAS3.TYPE", "16", 208 + 3 * 40, {16}, "16");
        row("CH2.MEAS7.IIR_HP.EN", "1", 230 + 2 * 386 + 7 * 40, {1}, "1");
        row("CH0.MEAS0.IIR_HP.FC", "12.5", 231, {125, 0}, "12.5");
        row("CH3.MEAS7.IIR_LP.FC", "6553,7", 235 + 3 * 386 + 7 * 40, {1, 1}, "6553.7"); // 65537 tenths
        row("CH0.MEAS0.IIR_LP.FC", "429496729.5", 235, {0xFFFF, 0xFFFF}, "429496729.5");
    }

    void changes()
    {
        QFETCH(const QString, name);
        QFETCH(const QString, text);
        QFETCH(const int, address);
        QFETCH(const QList<quint16>, words);
        const Setting *setting = settingNamed(name);
        QVERIFY(setting);
        QList<quint16> image = nothing;
        QCOMPARE(change(image, *setting, text), QString());
        QCOMPARE(image, with(address, words));
        QTEST(valueOf(image, *setting), "shown");
    }

    void whatASettingDoesNotTake_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("text");
        const auto row = [](const char *name, const char *text) {
            QTest::addRow("%s=%s", name, text) << QString::fromLatin1(name) << QString::fromLatin1(text);
        };
        for (const char *text :
             {"", "192.168.1", "192.168.1.256", "192.168.1.10.1", "0.0.0.0", "127.0.0.1", "224.0.0.1",
              "255.255.255.255", "a.b.c.d", "192.168.1.+1", "192.168.1. 1x"}) {
            row("IP_ADDR", text);
        }
        row("IP_MASK", "255.0.255.0");
        row("IP_MASK", "0.0.0.0");
        row("IP_GATE", "255.255.255.0");
        row("CH_EN_MASK", "16");
        row("CH_SENS_PWR", "-1");
        row("WF_ACQ_TIME", "0");
        row("WF_ACQ_TIME", "4001");
        row("WF_ACQ_TIME", "1.5");
        row("CH1.SENSOR_K", "nan");
        row("CH1.SENSOR_K", "1e40");
        row("CH1.SENSOR_B", "inf");
        row("CH0.MEAS3.TYPE", "17");
        row("CH0.MEAS3.IIR_HP.EN", "2");
        row("CH0.MEAS3.IIR_HP.FC", "12.55");
        row("CH0.MEAS3.IIR_HP.FC", "-0.1");
        row("CH0.MEAS3.IIR_LP.FC", "429496729.6");
    }

    void whatASettingDoesNotTake()
    {
        QFETCH(const QString, name);
        QFETCH(const QString, text);
        QList<quint16> image = with(0, {1, 2, 3});
        const QList<quint16> before = image;
        const QString problem = change(image, *settingNamed(name), text);
        QVERIFY2(problem.startsWith(name + u" takes "_s), qPrintable(problem));
        QVERIFY(problem.contains(u"\"%1\""_s.arg(text)));
        QCOMPARE(image, before);
    }

    /// 64 bytes are 32 registers; what does not fit ends before the character that it would cut.
    void aNameThatIsTooLong()
    {
        QList<quint16> image = nothing;
        QCOMPARE(change(image, *settingNamed(u"CUSTOM_NAME"_s), u"a"_s + QString(40, u'Ж')), QString());
        QCOMPARE(valueOf(image, *settingNamed(u"CUSTOM_NAME"_s)), u"a"_s + QString(31, u'Ж'));
        QCOMPARE(int(image.at(31)), 0x0096); // the second byte of Ж = D0 96, then nothing
        QCOMPARE(int(image.at(32)), 0);
    }

    /// Bits that the manual does not describe stay as the module has them.
    void theRestOfAMask()
    {
        QList<quint16> image = with(112, {0xA5F0});
        QCOMPARE(change(image, *settingNamed(u"CH_EN_MASK"_s), u"5"_s), QString());
        QCOMPARE(int(image.at(112)), 0xA5F5);
    }

    void differ()
    {
        QList<quint16> before = with(114, {500});
        QList<quint16> after = before;
        QCOMPARE(differences(before, after), QList<SettingDifference>());
        after[114] = 1000;
        after[32] = 0xA8C0;
        after[33] = 0x0A01;
        after[143] = 0x42C8;
        after[146] = 5; // not described
        after[147] = 6;
        after[7455] = 0xABCD;
        QCOMPARE(
            differences(before, after),
            (QList<SettingDifference>{
                {u"IP_ADDR"_s, u"0.0.0.0"_s, u"192.168.1.10"_s, true},
                {u"WF_ACQ_TIME"_s, u"500"_s, u"1000"_s, false},
                {u"CH0.SENSOR_K"_s, u"0"_s, u"100"_s, false},
                {u"SET+146…147"_s, u"0000 0000"_s, u"0005 0006"_s, false},
                {u"SET+7455"_s, u"0000"_s, u"ABCD"_s, false}}));
        before = with(0, {0x0041, 0x4242});
        QCOMPARE(differences(before, with(0, {0x0041})), QList<SettingDifference>()); // behind the end of the name
    }

    void pieces()
    {
        QList<quint16> wanted = nothing;
        QCOMPARE(piecesToWrite(nothing, wanted), QList<SettingPiece>());
        wanted[114] = 1000;
        wanted[143] = 0x42C8; // half of a float
        QCOMPARE(piecesToWrite(nothing, wanted), (QList<SettingPiece>{{114, {1000}}, {142, {0x0000, 0x42C8}}}));
        const QList<quint16> full(settingsSize, 1);
        qsizetype written = 0;
        for (const SettingPiece &piece : piecesToWrite(nothing, full)) {
            QCOMPARE(qsizetype(piece.offset), written);
            QVERIFY(piece.values.size() <= 123);
            written += piece.values.size();
        }
        QCOMPARE(written, settingsSize);
    }

    void files()
    {
        Identity identity;
        identity.serial = u"7S1"_s;
        const QByteArray bytes = settingsFile(identity, with(114, {500}));
        QVERIFY(bytes.contains("\"serial\":\"7S1\""));
        QCOMPARE(settingsIn(bytes), std::optional(with(114, {500})));
        QCOMPARE(settingsIn(bytes.left(bytes.size() / 2)), std::nullopt);
        QCOMPARE(settingsIn(settingsFile(identity, QList<quint16>(7455, 0))), std::nullopt);
        QByteArray tooLarge = bytes;
        tooLarge.replace("500", "65536");
        QCOMPARE(settingsIn(tooLarge), std::nullopt);
    }

    /// D000h is MUT_SETTINGS, F000h SETTINGS_CMD, FF00h REBOOT_CMD, 0062h the errors; low words first.
    void whatIsSent()
    {
        FakeLine line;
        line.expect(frame(1, hex("03 D0 00 00 7D")), frame(1, hex("03 FA") + QByteArray(250, '\1')))
            .expect(frame(2, hex("03 ED 13 00 0D")), frame(2, hex("03 1A") + QByteArray(26, '\2')))
            .expect(frame(3, hex("10 D0 72 00 01 02 03 E8")), frame(3, hex("10 D0 72 00 01")))
            .expect(frame(4, hex("03 00 62 00 03")), frame(4, hex("03 06 00 03 56 78 12 34")))
            .expect(frame(5, hex("10 F0 00 00 02 04 42 CC 56 49")), frame(5, hex("10 F0 00 00 02")))
            .expect(frame(6, hex("10 F0 00 00 02 04 42 53 56 49")), frame(6, hex("10 F0 00 00 02")))
            .expect(frame(7, hex("10 F0 00 00 02 04 42 AA 56 49")), frame(7, hex("10 F0 00 00 02")))
            .expect(frame(8, hex("10 FF 00 00 04 08 42 4F 4F 53 52 45 53 54")), frame(8, hex("10 FF 00 00 04")));
        Service service({}, {});
        QList<quint16> values;
        QVERIFY(service.readMore(line, moduleRegister("MUT_SETTINGS"), values));
        QCOMPARE(values.size(), 125);
        values.resize(7443);
        QVERIFY(service.readMore(line, moduleRegister("MUT_SETTINGS"), values));
        QCOMPARE(values.size(), 7456);
        QVERIFY(service.write(line, {114, {1000}}));
        const auto errors = service.readErrors(line);
        QVERIFY(errors);
        QCOMPARE(*errors, SettingErrors(3, 0x12345678));
        QVERIFY(service.apply(line));
        QVERIFY(service.saveToFlash(line));
        QVERIFY(service.loadFromFlash(line));
        QVERIFY(service.restart(line));
        QCOMPARE(line.complaints(), QByteArrayList());
        QVERIFY(line.isDone());
    }

    /// MUT is prepared, applied, kept, and taken back from flash; each by its own command only.
    void stepByStep()
    {
        ModuleLine line;
        Service service({}, {});
        const auto inUse = [&line] { return int(line.module().peek(45056 + 114)); };
        QVERIFY(service.write(line, {114, {700}}));
        QCOMPARE(inUse(), 500);
        QVERIFY(service.apply(line));
        QCOMPARE(inUse(), 700);
        QVERIFY(service.loadFromFlash(line));
        QCOMPARE(inUse(), 500);
        QCOMPARE(int(line.module().peek(53248 + 114)), 500);
        QVERIFY(service.write(line, {114, {800}}));
        QVERIFY(service.saveToFlash(line));
        QCOMPARE(inUse(), 500);
        QVERIFY(service.restart(line));
        QCOMPARE(inUse(), 800);
    }

    /// The error of a command stays until the next one; it is none of what is written after it.
    void anErrorOfBefore()
    {
        ModuleLine line;
        Service service({}, {});
        QList<quint16> wanted = service.settings(line, moduleRegister("CUR_SETTINGS"))->values();
        wanted[114] = 0;
        QCOMPARE(service.restoreSettings(line, wanted, false).fault(), Fault::Refused);
        QVERIFY(service.errors().second != 0);
        wanted[114] = 300;
        QVERIFY(service.restoreSettings(line, wanted, false));
        QCOMPARE(int(line.module().peek(45056 + 114)), 300);
        QCOMPARE(*service.readErrors(line), SettingErrors(0, 0));
    }

    /// Registers that may not be written: an exception, and LAST_WR_ERROR says so.
    void aWriteThatIsRefused()
    {
        ModuleLine line;
        Service service({}, {});
        QCOMPARE(service.write(line, {7455, {1, 2}}).fault(), Fault::Refused);
        QVERIFY(service.readErrors(line)->first != 0);
    }

    /// It goes before it answers; a line that is closed was never told.
    void aRestartNeedsNoAnswer()
    {
        ModuleLine line;
        Service service({}, {});
        line.setSilent(true);
        QVERIFY(service.restart(line));
        FakeLine closed;
        closed.close();
        QCOMPARE(service.restart(closed).fault(), Fault::Closed);
    }
};

QTEST_APPLESS_MAIN(TestLVimsSettings)
#include "tst_lvimssettings.moc"
