#include "core/config/inifile.h"
#include "core/values/windows1251.h"

#include <QFile>
#include <QTest>

#include <ctime>

using namespace gorizont;
using namespace Qt::Literals::StringLiterals;

namespace {

QByteArray dataFile(const char *name)
{
    QFile file(QStringLiteral(GORIZONT_TEST_DATA "/config/") + QString::fromLatin1(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("missing");
}

QString valueOf(const IniFile &file, const QString &section, const QString &key)
{
    const auto entry = file.find(section, key);
    return entry ? entry->value : u"(none)"_s;
}

QByteArray changed(const QByteArray &bytes, const QString &section, const QString &key, const QString &value)
{
    IniFile file = IniFile::fromBytes(bytes);
    file.setValue(section, key, value);
    return file.toBytes();
}

} // namespace

Q_DECLARE_METATYPE(IniFile::Encoding)

class TestIniFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void detectsTheEncoding_data();
    void detectsTheEncoding();
    void knowsEveryCharacterOfWindows1251();
    void newFileIsWindows1251();
    void ignoresCommentsAndLinesWithoutEquals();
    void ignoresTheCaseOfSectionsAndKeys();
    void keepsTheValueAsWritten();
    void firstOfTwoCounts();
    void knowsTheThreeSpellingsOfScrcError();
    void numbersLinesWhateverTheirEnds();
    void givesBackTheBytesOfAnyInput_data();
    void givesBackTheBytesOfAnyInput();
    void changesNothingButTheValue_data();
    void changesNothingButTheValue();
    void changesInTheEncodingOfTheFile();
    void saysWhatTheEncodingCannotHold();
    void settingEveryValueOfTheExampleAgainChangesNoByte();
    void readsTenMegabytesAtOnce();
};

void TestIniFile::detectsTheEncoding_data()
{
    // The bytes of one text, written by Python's codecs.
    QTest::addColumn<QByteArray>("hex");
    QTest::addColumn<IniFile::Encoding>("encoding");
    QTest::newRow("UTF-8") << QByteArray("5bd09ed0b1d189d0b8d0b55d0d0ad098d0bcd18f203d20d097d0b4d0b0d0bdd0b8d0b520e2"
                                         "8496313b20d0b2d185d0bed0b420c2abd090c2bb0d0a")
                           << IniFile::Encoding::Utf8;
    QTest::newRow("UTF-8 BOM") << QByteArray("efbbbf5bd09ed0b1d189d0b8d0b55d0d0ad098d0bcd18f203d20d097d0b4d0b0d0bdd0"
                                             "b8d0b520e28496313b20d0b2d185d0bed0b420c2abd090c2bb0d0a")
                               << IniFile::Encoding::Utf8Bom;
    QTest::newRow("UTF-16 LE") << QByteArray("fffe5b001e0431044904380435045d000d000a0018043c044f0420003d00200017043404"
                                             "30043d04380435042000162131003b002000320445043e0434042000ab001004bb000d"
                                             "000a00")
                               << IniFile::Encoding::Utf16Le;
    QTest::newRow("UTF-16 BE") << QByteArray("feff005b041e0431044904380435005d000d000a0418043c044f0020003d0020041704"
                                             "340430043d04380435002021160031003b002004320445043e0434002000ab041000bb"
                                             "000d000a")
                               << IniFile::Encoding::Utf16Be;
    QTest::newRow("Windows-1251") << QByteArray("5bcee1f9e8e55d0d0ac8ecff203d20c7e4e0ede8e520b9313b20e2f5eee420abc0bb"
                                                "0d0a")
                                  << IniFile::Encoding::Windows1251;
}

void TestIniFile::detectsTheEncoding()
{
    QFETCH(QByteArray, hex);
    QFETCH(IniFile::Encoding, encoding);
    const QByteArray bytes = QByteArray::fromHex(hex);
    const IniFile file = IniFile::fromBytes(bytes);
    QCOMPARE(file.encoding(), encoding);
    QCOMPARE(file.sections(), QStringList{u"Общие"_s});
    QCOMPARE(valueOf(file, u"общие"_s, u"ИМЯ"_s), u"Здание №1; вход «А»"_s);
    QCOMPARE(file.find(u"Общие"_s, u"Имя"_s)->line, 2);
    QCOMPARE(file.toBytes(), bytes);
}

void TestIniFile::knowsEveryCharacterOfWindows1251()
{
    QByteArray codes;
    for (int code = 0x80; code <= 0xFF; ++code) {
        codes.append(static_cast<char>(code));
    }
    const QString text = u"ЂЃ‚ѓ„…†‡€‰Љ‹ЊЌЋЏђ‘’“”•–—\u0098™љ›њќћџ\u00A0ЎўЈ¤Ґ¦§Ё©Є«¬\u00AD®Ї°±Ііґµ¶·ё№є»јЅѕї"
                         "АБВГДЕЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯабвгдежзийклмнопрстуфхцчшщъыьэюя"_s;
    QCOMPARE(decodeWindows1251(codes), text);
    QCOMPARE(encodeWindows1251(text), codes);
    QCOMPARE(
        encodeWindows1251(u"5 °C, 漢"),
        QByteArray("5 \xB0"
                   "C, ?"));
    QVERIFY(isEncodableInWindows1251(text));
    QVERIFY(!isEncodableInWindows1251(u"漢"));
}

void TestIniFile::newFileIsWindows1251()
{
    IniFile file;
    file.setValue(u"Common"_s, u"Caption"_s, u"Башня"_s);
    file.setValue(u"Common"_s, u"NumOfPorts"_s, u"1"_s);
    QCOMPARE(file.toBytes(), QByteArray("[Common]\r\nCaption=\xC1\xE0\xF8\xED\xFF\r\nNumOfPorts=1\r\n"));
    QCOMPARE(IniFile::fromBytes({}).encoding(), IniFile::Encoding::Windows1251);
}

void TestIniFile::ignoresCommentsAndLinesWithoutEquals()
{
    const IniFile file = IniFile::fromBytes("[A]\n"
                                            ";k1=1\n"
                                            "  ; k2=2\n"
                                            "// k3=3\n"
                                            "\t#k4=4\n"
                                            ",***** k5=5\n"
                                            "no equals sign\n"
                                            "=no key\n"
                                            "\n"
                                            ",k6=a comma alone is no comment\n"
                                            "/k7=neither is one stroke\n");
    QStringList keys;
    for (const IniFile::Entry &entry : file.entries()) {
        keys.append(entry.key);
    }
    QCOMPARE(keys, (QStringList{u",k6"_s, u"/k7"_s}));
}

void TestIniFile::ignoresTheCaseOfSectionsAndKeys()
{
    const IniFile file = IniFile::fromBytes("[pORT1]\nBaudRATE=9600\n[ Timers ] ; why not\nTmRun=5\n[Lost\nx=1\n");
    QCOMPARE(valueOf(file, u"Port1"_s, u"BaudRate"_s), u"9600"_s);
    QCOMPARE(valueOf(file, u"TIMERS"_s, u"tmrun"_s), u"5"_s);
    QCOMPARE(valueOf(file, u"Lost"_s, u"x"_s), u"1"_s);
    QCOMPARE(file.sections(), (QStringList{u"pORT1"_s, u"Timers"_s, u"Lost"_s}));
    QCOMPARE(file.find(u"PORT1"_s, u"BAUDRATE"_s)->key, u"BaudRATE"_s);
    QVERIFY(file.hasSection(u"port1"_s));
    QVERIFY(!file.hasSection(u"Port2"_s));
    QCOMPARE(file.sectionLine(u"timers"_s), 3);
    QCOMPARE(file.sectionLine(u"Port2"_s), 0);
}

void TestIniFile::keepsTheValueAsWritten()
{
    const IniFile file = IniFile::fromBytes("[A]\r\nk =  C:\\new\\table; \"x\", a=b, 100 %  \r\nempty=\r\n");
    QCOMPARE(valueOf(file, u"A"_s, u"k"_s), u"C:\\new\\table; \"x\", a=b, 100 %"_s);
    QCOMPARE(valueOf(file, u"A"_s, u"empty"_s), QString());
    QCOMPARE(valueOf(file, u"A"_s, u"absent"_s), u"(none)"_s);
}

void TestIniFile::firstOfTwoCounts()
{
    const IniFile file = IniFile::fromBytes("[A]\nk=1\nK=2\n[B]\nk=3\n[a]\nk=4\nother=5\n");
    QCOMPARE(valueOf(file, u"A"_s, u"k"_s), u"1"_s);
    QCOMPARE(valueOf(file, u"A"_s, u"other"_s), u"5"_s);
    QCOMPARE(file.entries().size(), 5);
    QCOMPARE(file.entries(u"a"_s).size(), 2);
    QStringList repeated;
    for (const IniFile::Entry &entry : file.repetitions()) {
        repeated.append(u"%1 [%2]%3"_s.arg(entry.line).arg(entry.section, entry.key));
    }
    QCOMPARE(repeated, (QStringList{u"3 [A]K"_s, u"6 [a]"_s}));
}

void TestIniFile::knowsTheThreeSpellingsOfScrcError()
{
    for (const char *key : {"SCRCErr", "SCRCErrors", "SCRCError"}) {
        const QByteArray bytes = QByteArray("[Sleeps]\n") + key + "=600\n";
        QCOMPARE(valueOf(IniFile::fromBytes(bytes), u"Sleeps"_s, u"SCRCError"_s), u"600"_s);
        QCOMPARE(changed(bytes, u"Sleeps"_s, u"SCRCError"_s, u"5"_s), QByteArray("[Sleeps]\nSCRCError=5\n"));
    }
}

void TestIniFile::numbersLinesWhateverTheirEnds()
{
    const IniFile file = IniFile::fromBytes("[A]\r\nb=1\rc=2\n\r\nd=3");
    QCOMPARE(file.find(u"A"_s, u"b"_s)->line, 2);
    QCOMPARE(file.find(u"A"_s, u"c"_s)->line, 3);
    QCOMPARE(file.find(u"A"_s, u"d"_s)->line, 5);
}

void TestIniFile::givesBackTheBytesOfAnyInput_data()
{
    QTest::addColumn<QByteArray>("bytes");
    for (const char *name : {"annex-cp1251.ini", "annex-utf8.ini", "mistakes.ini", "empty.ini", "binary.ini"}) {
        QTest::newRow(name) << dataFile(name);
    }
    QTest::newRow("no final newline") << QByteArray("[A]\r\nb=1");
    QTest::newRow("mixed line ends") << QByteArray("[A]\r\nb=1\nc=2\rd=3\n\re=4\r\r\n");
    QTest::newRow("NUL") << QByteArray("[A\0]\r\nb\0=1\0\n", 13);
    QTest::newRow("only a BOM") << QByteArray("\xEF\xBB\xBF");
    QTest::newRow("invalid UTF-8 after a BOM") << QByteArray("\xEF\xBB\xBF[A]\nb=\xC0\xFF\n");
    QTest::newRow("UTF-16, odd length") << QByteArray("\xFF\xFE[\0A\0]\0\r\0\n\0b\0=\0x", 17);
    QTest::newRow("UTF-16, surrogate alone") << QByteArray("\xFE\xFF\0=\xD8\0\0\n", 8);
    QTest::newRow("UTF-32") << QByteArray("\xFF\xFE\0\0[\0\0\0A\0\0\0", 12);
    QTest::newRow("98h") << QByteArray("[A]\nb=\x98\xFF\n");
}

void TestIniFile::givesBackTheBytesOfAnyInput()
{
    QFETCH(QByteArray, bytes);
    QVERIFY(bytes != "missing");
    QCOMPARE(IniFile::fromBytes(bytes).toBytes(), bytes);
    for (qsizetype size = 0; size < qMin<qsizetype>(bytes.size(), 300); ++size) {
        QCOMPARE(IniFile::fromBytes(bytes.left(size)).toBytes(), bytes.left(size));
        QCOMPARE(IniFile::fromBytes(bytes.right(size)).toBytes(), bytes.right(size));
    }
}

void TestIniFile::changesNothingButTheValue_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QByteArray>("after");
    // Always [A] k.
    QTest::newRow("value") << QByteArray("; c\n[A]\r\nk=1\r\nb=2\n") << u"7"_s
                           << QByteArray("; c\n[A]\r\nk=7\r\nb=2\n");
    QTest::newRow("blanks stay") << QByteArray("[A]\n\t K  =  1 \t\nb=2\n") << u"7 8"_s
                                 << QByteArray("[A]\n\t K  =  7 8 \t\nb=2\n");
    QTest::newRow("the first of two") << QByteArray("[A]\nk=1\nk=2\n") << u"7"_s << QByteArray("[A]\nk=7\nk=2\n");
    QTest::newRow("empty before") << QByteArray("[A]\nk=\n") << u"7"_s << QByteArray("[A]\nk=7\n");
    QTest::newRow("empty after") << QByteArray("[A]\nk=1\n") << QString() << QByteArray("[A]\nk=\n");
    QTest::newRow("no final newline") << QByteArray("[A]\nk=1") << u"7"_s << QByteArray("[A]\nk=7");
    QTest::newRow("line breaks") << QByteArray("[A]\nk=1\n") << u"7\r\n[B]"_s << QByteArray("[A]\nk=7  [B]\n");
    QTest::newRow("new key") << QByteArray("[A]\r\nb=2\r\n\r\n; of B\r\n[B]\r\nk=3\r\n") << u"7"_s
                             << QByteArray("[A]\r\nb=2\r\nk=7\r\n\r\n; of B\r\n[B]\r\nk=3\r\n");
    QTest::newRow("new key, empty section") << QByteArray("[A]\n\n[B]\n") << u"7"_s << QByteArray("[A]\nk=7\n\n[B]\n");
    QTest::newRow("new key, no final newline") << QByteArray("[A]\nb=2") << u"7"_s << QByteArray("[A]\nb=2\nk=7\n");
    QTest::newRow("new key, section in two parts")
        << QByteArray("[A]\nb=2\n[B]\n[A]\nc=3\n") << u"7"_s << QByteArray("[A]\nb=2\nk=7\n[B]\n[A]\nc=3\n");
    QTest::newRow("new section") << QByteArray("[B]\nk=1\n") << u"7"_s << QByteArray("[B]\nk=1\n[A]\nk=7\n");
    QTest::newRow("new section, no final newline")
        << QByteArray("[B]\r\nk=1") << u"7"_s << QByteArray("[B]\r\nk=1\r\n[A]\r\nk=7\r\n");
    QTest::newRow("UTF-16, odd length") << QByteArray("\xFF\xFE[\0A\0]\0x", 9) << u"7"_s
                                        << QByteArray("\xFF\xFE[\0A\0]\0\xFD\xFF\r\0\n\0k\0=\0007\0\r\0\n\0", 24);
}

void TestIniFile::changesNothingButTheValue()
{
    QFETCH(QByteArray, before);
    QFETCH(QString, value);
    QFETCH(QByteArray, after);
    QCOMPARE(changed(before, u"A"_s, u"k"_s, value), after);
}

void TestIniFile::changesInTheEncodingOfTheFile()
{
    QCOMPARE(changed("[A]\nk=\xCF\xEE\xF0\xF2\n", u"A"_s, u"k"_s, u"Этаж"_s), QByteArray("[A]\nk=\xDD\xF2\xE0\xE6\n"));
    QCOMPARE(changed("[A]\nk=\xD0\x9F\n", u"A"_s, u"k"_s, u"Э"_s), QByteArray("[A]\nk=\xD0\xAD\n"));
    QCOMPARE(
        changed(QByteArray("\xFE\xFF\0[\0A\0]\0\n\0k\0=\0001\0\n", 18), u"A"_s, u"k"_s, u"Э"_s),
        QByteArray("\xFE\xFF\0[\0A\0]\0\n\0k\0=\x04\x2D\0\n", 18));
    IniFile file = IniFile::fromBytes("[A]\nk=1\n");
    file.setValue(u"A"_s, u"k"_s, u" 2 "_s);
    QCOMPARE(valueOf(file, u"A"_s, u"k"_s), u"2"_s);
}

void TestIniFile::saysWhatTheEncodingCannotHold()
{
    const IniFile old = IniFile::fromBytes("[A]\nk=\xFF\n");
    QVERIFY(old.canHold(u"Башня №1"_s));
    QVERIFY(!old.canHold(u"塔"_s));
    QVERIFY(IniFile::fromBytes("[A]\nk=1\n").canHold(u"塔"_s));
}

void TestIniFile::settingEveryValueOfTheExampleAgainChangesNoByte()
{
    for (const char *name : {"annex-cp1251.ini", "annex-utf8.ini"}) {
        const QByteArray bytes = dataFile(name);
        IniFile file = IniFile::fromBytes(bytes);
        QCOMPARE(file.entries().size(), 158);
        for (const IniFile::Entry &entry : file.entries()) {
            file.setValue(entry.section, entry.key, entry.value);
        }
        QCOMPARE(file.toBytes(), bytes);
    }
}

void TestIniFile::readsTenMegabytesAtOnce()
{
    QByteArray bytes;
    for (int section = 0; bytes.size() < 10'000'000; ++section) {
        bytes += "[Port" + QByteArray::number(section) + "]\r\n";
        for (int key = 0; key < 1000; ++key) {
            bytes += "adr" + QByteArray::number(key) + "=\xC0\xE4\r\n";
        }
    }
    const std::clock_t start = std::clock();
    const IniFile file = IniFile::fromBytes(bytes);
    int found = 0;
    for (int key = 0; key < 1000; ++key) {
        for (int section = 0; section < 100; ++section) {
            found += file.find(u"port%1"_s.arg(section), u"ADR%1"_s.arg(key)) ? 1 : 0;
        }
    }
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    QCOMPARE(found, 100'000);
    QCOMPARE(file.toBytes(), bytes);
    qInfo() << seconds << "s for" << file.entries().size() << "entries";
    QVERIFY2(seconds < 60, "an index is missing somewhere");
}

QTEST_GUILESS_MAIN(TestIniFile)

#include "tst_inifile.moc"
