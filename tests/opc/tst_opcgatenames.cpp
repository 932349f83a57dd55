#include "app/opc-da/pure/addressspace.h"
#include "app/opc-da/pure/commandline.h"
#include "app/opc-da/pure/engineering.h"
#include "app/opc-da/pure/messages.h"

#include <QTest>

using namespace opcda;

namespace {

QString shown(TextView text)
{
    return QString::fromUtf16(text.data(), static_cast<qsizetype>(text.size()));
}

QStringList shown(const std::vector<Text> &texts)
{
    QStringList list;
    for (const Text &text : texts)
        list << shown(text);
    return list;
}

QStringList listed(const char *parts)
{
    return QString::fromUtf8(parts).split(u'|');
}

Text read(const QString &text)
{
    return text.toStdU16String();
}

Tag tag(TextView id, TagType type = TagType::Double, std::vector<Text> aliases = {})
{
    return {Text(id), type, {}, std::move(aliases), true};
}

} // namespace

class TestOpcGateNames : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void splitsAtDotsOutsideBrackets_data();
    void splitsAtDotsOutsideBrackets();
    void tellsWellFormedNames_data();
    void tellsWellFormedNames();
    void matchesPatterns_data();
    void matchesPatterns();
    void changesEncodings_data();
    void changesEncodings();
    void growsATree();
    void keepsIndicesWhenTheListChanges();
    void findsAliases();
    void readsCommandLines_data();
    void readsCommandLines();
    void knowsScales();
    void speaksTwoLanguages();
};

void TestOpcGateNames::splitsAtDotsOutsideBrackets_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QStringList>("parts");
    QTest::newRow("figure 11.4") << "[COM5].Sensor_001[AND3][Addr:002].STATE.Restart"
                                 << listed("[COM5]|Sensor_001[AND3][Addr:002]|STATE|Restart");
    QTest::newRow("network port") << "[tcp://10.0.0.7:502].Sensor_003.DATA"
                                  << listed("[tcp://10.0.0.7:502]|Sensor_003|DATA");
    QTest::newRow("one part") << "OPCGate" << listed("OPCGate");
    QTest::newRow("empty part") << "a..b" << listed("a||b");
    QTest::newRow("bracket that closes nothing") << "a].b" << listed("a]|b");
}

void TestOpcGateNames::splitsAtDotsOutsideBrackets()
{
    QFETCH(QString, name);
    QFETCH(QStringList, parts);
    QCOMPARE(shown(splitName(read(name))), parts);
}

void TestOpcGateNames::tellsWellFormedNames_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("isGood");
    QTest::newRow("figure 11.4") << "[COM5].Sensor_001[AND3][Addr:002].STATE.Restart" << true;
    QTest::newRow("empty") << "" << false;
    QTest::newRow("dot first") << ".a" << false;
    QTest::newRow("dot last") << "a." << false;
    QTest::newRow("two dots") << "a..b" << false;
    QTest::newRow("open bracket") << "[COM5" << false;
    QTest::newRow("closed twice") << "[COM5]]" << false;
    QTest::newRow("bracket in bracket") << "[[a]]" << false;
}

void TestOpcGateNames::tellsWellFormedNames()
{
    QFETCH(QString, name);
    QFETCH(bool, isGood);
    QCOMPARE(isWellFormed(read(name)), isGood);
}

void TestOpcGateNames::matchesPatterns_data()
{
    QTest::addColumn<QString>("pattern");
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("isMatch");
    QTest::newRow("none") << ""
                          << "anything" << true;
    QTest::newRow("itself") << "Angl_X"
                            << "angl_x" << true;
    QTest::newRow("longer") << "Angl"
                            << "Angl_X" << false;
    QTest::newRow("shorter") << "Angl_XY"
                             << "Angl_X" << false;
    QTest::newRow("star") << "A*_X"
                          << "ARms_X" << true;
    QTest::newRow("star takes nothing") << "Angl*_X"
                                        << "Angl_X" << true;
    QTest::newRow("star again") << "*a*b*c"
                                << "xaxbxbxc" << true;
    QTest::newRow("star last") << "Sensor_*"
                               << "Sensor_" << true;
    QTest::newRow("star misses") << "*_Z"
                                 << "Angl_X" << false;
    QTest::newRow("question") << "?ngl_X"
                              << "Angl_X" << true;
    QTest::newRow("question wants one") << "Angl_X?"
                                        << "Angl_X" << false;
    QTest::newRow("digit") << "Sensor_0#1"
                           << "Sensor_021" << true;
    QTest::newRow("no digit") << "Sensor_#"
                              << "Sensor_x" << false;
    QTest::newRow("set") << "Angl_[XY]"
                         << "Angl_Y" << true;
    QTest::newRow("set misses") << "Angl_[XY]"
                                << "Angl_Z" << false;
    QTest::newRow("range") << "[a-f]ngl"
                           << "Engl" << true;
    QTest::newRow("not in set") << "Angl_[!X]"
                                << "Angl_Y" << true;
    QTest::newRow("in the wrong set") << "Angl_[!X]"
                                      << "Angl_x" << false;
    QTest::newRow("bracket as a set") << "[[]COM5]"
                                      << "[COM5]" << true;
    QTest::newRow("open bracket") << "[COM5"
                                  << "[COM5" << true;
    QTest::newRow("russian") << "ДАТЧ*"
                             << "датчик" << true;
}

void TestOpcGateNames::matchesPatterns()
{
    QFETCH(QString, pattern);
    QFETCH(QString, text);
    QFETCH(bool, isMatch);
    QCOMPARE(matches(read(pattern), read(text)), isMatch);
}

void TestOpcGateNames::changesEncodings_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("isClean");
    QTest::newRow("latin") << QByteArray("Angl_X") << "Angl_X" << true;
    QTest::newRow("russian") << QByteArray("\xD0\x9C\xD0\x9A") << "МК" << true;
    QTest::newRow("sign") << QByteArray("\xE2\x80\xB3") << "″" << true;
    QTest::newRow("beyond 16 bits") << QByteArray("\xF0\x9F\x98\x80") << QString::fromUcs4(U"\x1F600", 1) << true;
    QTest::newRow("cut short") << QByteArray("a\xD0") << QStringLiteral("a\uFFFD") << false;
    QTest::newRow("no start") << QByteArray("\x9C") << QStringLiteral("\uFFFD") << false;
    QTest::newRow("too long") << QByteArray("\xE0\x80\xAF") << QStringLiteral("\uFFFD") << false;
}

void TestOpcGateNames::changesEncodings()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, text);
    QFETCH(bool, isClean);
    QCOMPARE(shown(fromUtf8(bytes.toStdString())), text);
    if (isClean)
        QCOMPARE(QByteArray::fromStdString(toUtf8(read(text))), bytes);
    QCOMPARE(toUtf8(Text(1, char16_t(0xD800))), std::string("\xEF\xBF\xBD"));
}

void TestOpcGateNames::growsATree()
{
    AddressSpace space;
    space.replace({tag(u"Own.A")}, 0);
    space.replace(
        {tag(u"[COM5].S.DATA.X"), tag(u"[COM5].S.STATE.R", TagType::Bool), tag(u"[1.2].S.X"), tag(u"[COM5].S.DATA.Y")},
        1);
    QCOMPARE(shown(space.branch({})->branches), listed("Own|[COM5]|[1.2]"));
    QCOMPARE(shown(space.branch(u"[COM5].S")->branches), listed("DATA|STATE"));
    QCOMPARE(space.branch(u"[COM5].S.DATA")->leaves, (std::vector<std::pair<Text, int>>{{u"X", 1}, {u"Y", 4}}));
    QCOMPARE(space.branch(u"[COM6]"), nullptr);
    QCOMPARE(shown(space.above(u"[1.2].S")), QStringLiteral("[1.2]"));
    QCOMPARE(shown(space.above(u"[1.2]")), QString());
    QCOMPARE(space.below(u"[COM5]"), (std::vector<int>{1, 4, 2}));
    QCOMPARE(space.below({}).size(), std::size_t{5});
}

void TestOpcGateNames::keepsIndicesWhenTheListChanges()
{
    AddressSpace space;
    space.replace({tag(u"Own.A")}, 0);
    QCOMPARE(space.replace({tag(u"P.a"), tag(u"P.b"), tag(u"P.c")}, 1), (std::vector<int>{1, 2, 3}));
    QCOMPARE(space.replace({tag(u"P.c"), tag(u"P.d")}, 1), (std::vector<int>{3, 4}));
    QVERIFY(!space.at(1).isListed);
    QVERIFY(space.at(3).isListed);
    QVERIFY(space.at(0).isListed);
    QCOMPARE(space.branch(u"P")->leaves, (std::vector<std::pair<Text, int>>{{u"c", 3}, {u"d", 4}}));
    QCOMPARE(*space.find(u"P.b"), 2);
    QCOMPARE(space.replace({tag(u"P.a")}, 1), (std::vector<int>{1}));
    QVERIFY(space.at(1).isListed);
}

void TestOpcGateNames::findsAliases()
{
    AddressSpace space;
    space.replace(
        {tag(u"S.STATE.R", TagType::Bool, {u"S.STATUS.R"}),
         tag(u"S.DATA.T", TagType::Double, {u"S.STATUS.R", u"S.DATA.Rezerv"})},
        0);
    QCOMPARE(*space.find(u"S.STATUS.R"), 0); // who came first keeps the name
    QCOMPARE(*space.find(u"S.DATA.Rezerv"), 1);
    QVERIFY(!space.find(u"S.DATA"));
}

void TestOpcGateNames::readsCommandLines_data()
{
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("action");
    QTest::addColumn<int>("port");
    QTest::addColumn<bool>("isPerUser");
    const auto row = [](const char *name, const char *words, CommandLine::Action action, int port = 0,
                        bool isPerUser = false) {
        QTest::newRow(name) << (*words ? listed(words) : QStringList()) << static_cast<int>(action) << port
                            << isPerUser;
    };
    using Action = CommandLine::Action;
    row("by COM", "-Embedding", Action::Serve);
    row("by hand", "", Action::Serve);
    row("register", "/RegServer|/Port=5000|/Hash=ab|/Tags=C:\\a b.json", Action::Register, 5000);
    row("for one user", "-regserver|-peruser", Action::Register, 0, true);
    row("unregister", "/UnregServer", Action::Unregister);
    row("port is none", "/RegServer|/Port=0", Action::Wrong);
    row("port is too large", "/RegServer|/Port=65536", Action::Wrong);
    row("port is a word", "/RegServer|/Port=com", Action::Wrong);
    row("unknown word", "/RegServer|/Quick", Action::Wrong);
    row("no option", "RegServer", Action::Wrong);
    row("a lone slash", "/", Action::Wrong);
}

void TestOpcGateNames::readsCommandLines()
{
    QFETCH(QStringList, words);
    std::vector<Text> texts;
    for (const QString &word : words)
        texts.push_back(read(word));
    const CommandLine line = parseCommandLine(texts);
    QTEST(static_cast<int>(line.action), "action");
    QTEST(int(line.port.value_or(0)), "port");
    QTEST(line.isPerUser, "isPerUser");
    if (words.contains(QStringLiteral("/Hash=ab"))) {
        QCOMPARE(shown(line.hash.value()), QStringLiteral("ab"));
        QCOMPARE(shown(line.tagsFile.value()), QStringLiteral("C:\\a b.json"));
    } else {
        QVERIFY(!line.hash && !line.tagsFile);
    }
}

void TestOpcGateNames::knowsScales()
{
    QCOMPARE(scaleOf(tag(u"S.DATA.Angl_Y")).high, 3600.0);
    QCOMPARE(shown(scaleOf(tag(u"S.DATA.ARms_X")).unit), QStringLiteral("mm/s²"));
    QCOMPARE(scaleOf(tag(u"S.DATA.Temper")).low, -60.0);
    QVERIFY(!scaleOf(tag(u"S.DATA.8_Reserv")).hasRange());
    QVERIFY(!scaleOf(tag(u"S.STATE.Angl_X", TagType::Bool)).hasRange());
}

void TestOpcGateNames::speaksTwoLanguages()
{
    QVERIFY(!errorText(0x80004005, Language::English));
    for (const std::uint32_t code :
         {0xC0040001u, 0xC0040004u, 0xC0040006u, 0xC0040007u, 0xC0040008u, 0xC004000Au, 0xC004000Cu, 0x0004000Du,
          0x0004000Fu, 0xC0040203u, 0xC0040400u, 0xC0040401u, 0xC0040403u}) {
        const auto english = errorText(code, Language::English);
        const auto russian = errorText(code, Language::Russian);
        QVERIFY(english && russian && *english != *russian);
    }
    QCOMPARE(shown(propertyName(100, Language::Russian)), QStringLiteral("Единица измерения"));
    QVERIFY(propertyName(99, Language::English).empty());
}

QTEST_APPLESS_MAIN(TestOpcGateNames)
#include "tst_opcgatenames.moc"
