#include "app/opc-da/pure/tagbook.h"

#include <QTest>

using namespace opcda;

namespace {

constexpr std::int64_t Now = 1700000000000;
constexpr std::string_view Hello =
    R"({"hello":"GorizontServer","protocol":1,"version":"0.1.0","caption":"Мост","hash":"ab","count":2})";
constexpr std::string_view Tags =
    R"({"tags":[{"name":"[COM5].S.STATE.R","type":"bool","description":"Перезагрузка","aliases":["[COM5].S.STATUS.R"]},)"
    R"({"name":"[COM5].S.DATA.X","type":"double","description":"x"}]})";
constexpr std::string_view Ready = R"({"ready":true})";
constexpr std::string_view Snapshot = R"({"v":[[0,true,192,1522846251330],[1,-3599.5,20,1522846251331]]})";

using Answer = TagBook::Answer;

Answer feed(TagBook &book, std::string_view line)
{
    return book.accept(parseFeedLine(line), Now);
}

void fill(TagBook &book)
{
    for (const std::string_view line : {Hello, Tags, Ready, Snapshot})
        feed(book, line);
}

const TagState &stateOf(const TagBook &book, TextView id)
{
    return book.state(*book.names().find(id));
}

} // namespace

class TestOpcGateFeed : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsLines();
    void refusesLines_data();
    void refusesLines();
    void passesOverUnknownLines();
    void greets();
    void fillsTheBook();
    void keepsValuesWhenTheFeedGoes();
    void comesBackWithAnotherList();
    void waitsForValues();
    void hangsUpOnNonsense_data();
    void hangsUpOnNonsense();
    void comparesHashes();
    void countsChanges();
    void knowsPresetTags();
};

void TestOpcGateFeed::readsLines()
{
    const FeedLine hello = parseFeedLine(Hello);
    QCOMPARE(std::get<FeedHello>(hello).count, std::size_t{2});
    QCOMPARE(std::get<FeedHello>(hello).hash, std::string("ab"));
    const FeedLine tags = parseFeedLine(Tags);
    const Tag &first = std::get<FeedTags>(tags).tags.at(0);
    QVERIFY(first.id == u"[COM5].S.STATE.R" && first.type == TagType::Bool && first.description == u"Перезагрузка");
    QVERIFY(first.aliases == std::vector<Text>{u"[COM5].S.STATUS.R"});
    const FeedLine values = parseFeedLine(R"({"v":[[7,1,192,5],[8,null,32,null]]})");
    const auto &entries = std::get<FeedValues>(values).entries;
    QVERIFY(entries.at(0).index == 7 && std::get<double>(entries.at(0).value) == 1.0 && entries.at(0).time == 5);
    QVERIFY(std::holds_alternative<std::monostate>(entries.at(1).value) && entries.at(1).quality == 32);
    QVERIFY(std::holds_alternative<FeedReady>(parseFeedLine(Ready)));
    QVERIFY(std::holds_alternative<FeedPing>(parseFeedLine(R"({"ping":true})")));
    QVERIFY(std::holds_alternative<FeedEnd>(parseFeedLine(R"({"end":true})")));
}

void TestOpcGateFeed::refusesLines_data()
{
    QTest::addColumn<QByteArray>("line");
    for (const char *line :
         {"", "[]", "5", "{", R"({"hello":"x","protocol":2,"count":1})", R"({"hello":"x","protocol":1})",
          R"({"tags":[{"name":"a..b","type":"bool"}]})", R"({"tags":[{"name":"a","type":"text"}]})",
          R"({"tags":[{"type":"bool"}]})", R"({"v":[[0,"text",192,1]]})", R"({"v":[[0,true,192]]})",
          R"({"v":[[0,true,"good",1]]})", R"({"v":[5]})"})
        QTest::newRow(line) << QByteArray(line);
}

void TestOpcGateFeed::refusesLines()
{
    QFETCH(QByteArray, line);
    QVERIFY(std::holds_alternative<FeedFault>(parseFeedLine(line.toStdString())));
    // Nor does any piece of a good line pass for a line.
    for (const std::string_view whole : {Hello, Tags, Ready, Snapshot}) {
        for (std::size_t size = 0; size < whole.size(); ++size)
            QVERIFY(std::holds_alternative<FeedFault>(parseFeedLine(whole.substr(0, size))));
    }
}

void TestOpcGateFeed::passesOverUnknownLines()
{
    QVERIFY(std::holds_alternative<FeedUnknown>(parseFeedLine(R"({"weather":"fine"})")));
    TagBook book({}, Now);
    QCOMPARE(feed(book, R"({"weather":"fine"})"), Answer::None);
}

void TestOpcGateFeed::greets()
{
    QCOMPARE(
        feedGreeting("0.1.0", 1234, "ab"),
        std::string(R"({"client":"gorizont-opc-da","pid":1234,"registered":"ab","version":"0.1.0"})"
                    "\n"));
}

void TestOpcGateFeed::fillsTheBook()
{
    TagBook book("ab", Now);
    QCOMPARE(feed(book, Hello), Answer::None);
    QCOMPARE(feed(book, Tags), Answer::None);
    QVERIFY(!book.isConnected());
    QCOMPARE(feed(book, Ready), Answer::Ready);
    QCOMPARE(feed(book, Snapshot), Answer::None);
    QVERIFY(book.isConnected());
    const TagState &angle = stateOf(book, u"[COM5].S.DATA.X");
    QCOMPARE(std::get<double>(angle.value), -3599.5);
    QCOMPARE(angle.quality, std::uint16_t{20});
    QCOMPARE(angle.time, std::int64_t{1522846251331});
    QCOMPARE(std::get<bool>(stateOf(book, u"[COM5].S.STATUS.R").value), true);
    QCOMPARE(std::get<bool>(stateOf(book, u"OPCGate.Connection").value), true);
    QCOMPARE(feed(book, R"({"end":true})"), Answer::End);
}

void TestOpcGateFeed::keepsValuesWhenTheFeedGoes()
{
    TagBook book("ab", Now);
    fill(book);
    book.lose(Now + 5);
    const TagState &angle = stateOf(book, u"[COM5].S.DATA.X");
    QCOMPARE(angle.quality, std::uint16_t{0x18});
    QCOMPARE(std::get<double>(angle.value), -3599.5);
    QCOMPARE(angle.time, std::int64_t{1522846251331});
    const TagState &connection = stateOf(book, u"OPCGate.Connection");
    QVERIFY(!std::get<bool>(connection.value) && connection.quality == 0xC0 && connection.time == Now + 5);
    QCOMPARE(stateOf(book, u"OPCGate.TagsHashGood").quality, std::uint16_t{0x18});
    fill(book);
    QCOMPARE(stateOf(book, u"[COM5].S.STATE.R").quality, std::uint16_t{0xC0});
}

void TestOpcGateFeed::comesBackWithAnotherList()
{
    TagBook book("ab", Now);
    fill(book);
    book.lose(Now);
    feed(book, R"({"hello":"GorizontServer","protocol":1,"hash":"cd","count":1})");
    feed(book, R"({"tags":[{"name":"[COM5].S.DATA.X","type":"double"}]})");
    feed(book, Ready);
    feed(book, R"({"v":[[0,7.5,192,9]]})");
    QCOMPARE(std::get<double>(stateOf(book, u"[COM5].S.DATA.X").value), 7.5);
    QCOMPARE(stateOf(book, u"[COM5].S.STATE.R").quality, std::uint16_t{0x04}); // no longer configured
    QCOMPARE(std::get<bool>(stateOf(book, u"OPCGate.TagsHashGood").value), false);
}

void TestOpcGateFeed::waitsForValues()
{
    TagBook book({}, Now);
    for (const std::string_view line : {Hello, Tags, Ready})
        feed(book, line);
    QCOMPARE(stateOf(book, u"[COM5].S.DATA.X").quality, std::uint16_t{0x20});
    feed(book, R"({"v":[[1,null,8,0]]})");
    QCOMPARE(stateOf(book, u"[COM5].S.DATA.X").quality, std::uint16_t{8});
    QCOMPARE(stateOf(book, u"[COM5].S.DATA.X").time, Now);
}

void TestOpcGateFeed::hangsUpOnNonsense_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::newRow("no such tag") << QByteArray(R"({"v":[[2,1.5,192,1]]})");
    QTest::newRow("number for a bool") << QByteArray(R"({"v":[[0,1.5,192,1]]})");
    QTest::newRow("bool for a number") << QByteArray(R"({"v":[[1,true,192,1]]})");
    QTest::newRow("more tags") << QByteArray(R"({"tags":[]})");
    QTest::newRow("broken") << QByteArray("{");
}

void TestOpcGateFeed::hangsUpOnNonsense()
{
    QFETCH(QByteArray, line);
    TagBook book({}, Now);
    fill(book);
    QCOMPARE(feed(book, line.toStdString()), Answer::HangUp);
    QVERIFY(!book.fault().empty());

    TagBook empty({}, Now);
    QCOMPARE(feed(empty, Snapshot), Answer::HangUp); // values before the list
    feed(empty, Hello);
    QCOMPARE(feed(empty, Ready), Answer::HangUp); // two tags are missing
    TagBook full({}, Now);
    feed(full, Hello);
    feed(full, Tags);
    QCOMPARE(feed(full, Tags), Answer::HangUp); // four of two
}

void TestOpcGateFeed::comparesHashes()
{
    TagBook good("ab", Now);
    fill(good);
    QVERIFY(std::get<bool>(stateOf(good, u"OPCGate.TagsHashGood").value));
    TagBook never({}, Now);
    fill(never);
    QVERIFY(!std::get<bool>(stateOf(never, u"OPCGate.TagsHashGood").value));
}

void TestOpcGateFeed::countsChanges()
{
    TagBook book({}, Now);
    fill(book);
    const std::uint64_t before = stateOf(book, u"[COM5].S.DATA.X").version;
    feed(book, R"({"v":[[1,-3599.5,20,1522846259999]]})"); // a new time alone is no change
    QCOMPARE(stateOf(book, u"[COM5].S.DATA.X").version, before);
    QCOMPARE(stateOf(book, u"[COM5].S.DATA.X").time, std::int64_t{1522846259999});
    feed(book, R"({"v":[[1,-3599.5,192,1522846260000]]})");
    QVERIFY(stateOf(book, u"[COM5].S.DATA.X").version > before);
}

void TestOpcGateFeed::knowsPresetTags()
{
    TagBook book({}, Now);
    const FeedLine line = parseFeedLine(Tags);
    book.preset(std::get<FeedTags>(line).tags, Now);
    QCOMPARE(stateOf(book, u"[COM5].S.DATA.X").quality, std::uint16_t{0x18});
    QVERIFY(book.names().at(*book.names().find(u"[COM5].S.DATA.X")).isListed);
    fill(book);
    QCOMPARE(std::get<double>(stateOf(book, u"[COM5].S.DATA.X").value), -3599.5);
}

QTEST_APPLESS_MAIN(TestOpcGateFeed)
#include "tst_opcgatefeed.moc"
