#include "tests/ui/modeltext.h"
#include "tests/ui/samplesite.h"
#include "translations/translation.h"
#include "ui/displacement/displacementpage.h"
#include "ui/displacement/profilemodel.h"
#include "ui/pages/tableview.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>
#include <QtTest>

using namespace gorizont;
using namespace Qt::Literals::StringLiterals;

/// The page <Перемещения>. Thirty degrees over two metres are a metre.
class TestDisplacementPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(installTranslation(QStringLiteral("ru"))); }
    void init();

    void zeroIsReadAsItWasWritten();
    void zeroOfAStrangersFile_data();
    void zeroOfAStrangersFile();
    void aShapeWithAHoleMakesNoZero();
    void tableShowsTheTopFirst();
    void storesAndForgetsTheZero();
    void asksBeforeItReplacesTheZero();
    void comparesNothingThatHangsElsewhere();
    void tellsWhyTheZeroWasNotStored();
    void withoutChainsItSaysWhatToDo();
    void sentencesDoNotWidenTheWindow();

private:
    void tilt(int number, double x, double y);
    static ChainNode node(int number, double height) { return {number, height, {}, {}}; }
    template <typename T> static T *find(QWidget &page, const char *name)
    {
        return page.findChild<T *>(QString::fromLatin1(name));
    }
    QStringList rows(DisplacementPage &page) const;

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<SensorRegistry> m_registry;
};

void TestDisplacementPage::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_registry = std::make_unique<SensorRegistry>(test::sampleConfig().lines, StatusRules());
    m_registry->setChains({{7, u"Колонна"_s, {{2, 2.0}, {3, 1.0}}}});
}

void TestDisplacementPage::tilt(int number, double x, double y)
{
    m_registry->update({test::tiltReading(number, x, y, std::chrono::steady_clock::now())});
}

QStringList TestDisplacementPage::rows(DisplacementPage &page) const
{
    const QAbstractItemModel *model = find<QTableView>(page, "profileTable")->model();
    QStringList lines;
    for (int row = 0; row < model->rowCount(); ++row) {
        QStringList cells;
        for (int column = ProfileModel::Height; column < model->columnCount(); ++column) {
            cells += model->index(row, column).data().toString();
        }
        lines += model->index(row, 0).data().toString() + u": "_s + cells.join(u' ');
    }
    return lines;
}

void TestDisplacementPage::zeroIsReadAsItWasWritten()
{
    const QByteArray json = R"({"time":"2026-11-22T06:00:00.250Z","nodes":[{"number":2,"height":2.5,"x":1.5,"y":-2},)"
                            R"({"number":3,"x":0,"y":10}]})";
    const auto zero = ProfileZero::fromJson(json);
    QVERIFY(zero);
    QCOMPARE(zero->time, UtcTime(std::chrono::milliseconds(1795327200250)));
    QCOMPARE(zero->at(node(2, 2.5)), std::optional(Displacement{1.5, -2}));
    QVERIFY(!zero->at(node(2, 2.51))); // it hangs elsewhere by now
    QVERIFY(!zero->at(node(4, 2.5)));
    QCOMPARE(zero->at(node(3, 7)), std::optional(Displacement{0, 10})); // an older file does not say where it hung
    QCOMPARE(ProfileZero::fromJson(zero->toJson()), zero);
}

void TestDisplacementPage::zeroOfAStrangersFile_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("half") << QByteArray(R"({"time":"2026-11-22T06:00:00.250Z","nodes":[{"number":2)");
    QTest::newRow("no time") << QByteArray(R"({"nodes":[{"number":2,"x":1.5,"y":-2}]})");
    QTest::newRow("no nodes") << QByteArray(R"({"time":"2026-11-22T06:00:00.250Z","nodes":[]})");
    QTest::newRow("no y") << QByteArray(R"({"time":"2026-11-22T06:00:00.250Z","nodes":[{"number":2,"x":1.5}]})");
}

void TestDisplacementPage::zeroOfAStrangersFile()
{
    QFETCH(const QByteArray, json);
    QVERIFY(!ProfileZero::fromJson(json));
}

void TestDisplacementPage::aShapeWithAHoleMakesNoZero()
{
    std::vector<ChainNode> nodes{{2, 1, Displacement{1, 1}, Displacement{1, 1}}, {3, 2, {}, {}}};
    QVERIFY(!ProfileZero::of(nodes, utcNow()));
    nodes.pop_back();
    QVERIFY(ProfileZero::of(nodes, utcNow()));
}

void TestDisplacementPage::tableShowsTheTopFirst()
{
    DisplacementPage page(*m_registry, m_folder->path());
    const QAbstractItemModelTester tester(find<QTableView>(page, "profileTable")->model());
    QCOMPARE(rows(page), QStringList({u"3: 3.00 — — — — — — — —"_s, u"2: 2.00 — — — — — — — —"_s}));
    QVERIFY(!find<QPushButton>(page, "storeZero")->isEnabled());
    tilt(3, -108000, 0);
    page.refresh();
    QCOMPARE(
        rows(page), QStringList({u"3: 3.00 -30.000 +0.000 -500.00 +0.00 — — — —"_s, u"2: 2.00 — — — — — — — —"_s}));
    tilt(2, 108000, 324000);
    page.refresh();
    QCOMPARE(
        rows(page),
        QStringList(
            {u"3: 3.00 -30.000 +0.000 -500.00 +0.00 +500.00 +2000.00 — —"_s,
             u"2: 2.00 +30.000 +90.000 +1000.00 +2000.00 +1000.00 +2000.00 — —"_s}));
    QCOMPARE(find<QComboBox>(page, "chainBox")->currentText(), u"Цепочка 7: Колонна"_s);
}

void TestDisplacementPage::storesAndForgetsTheZero()
{
    tilt(2, 0, 0);
    tilt(3, 108000, 0);
    {
        DisplacementPage page(*m_registry, m_folder->filePath(u"Zero"_s));
        QVERIFY(find<QLabel>(page, "zeroText")->text().contains(u"не сохранён"_s));
        find<QPushButton>(page, "storeZero")->click();
        QVERIFY(find<QLabel>(page, "zeroText")->text().startsWith(u"Нуль от "_s));
        tilt(3, 324000, 0);
        page.refresh();
        QCOMPARE(rows(page).first(), u"3: 3.00 +90.000 +0.000 +1000.00 +0.00 +1000.00 +0.00 +500.00 +0.00"_s);
    }
    DisplacementPage page(*m_registry, m_folder->filePath(u"Zero"_s)); // the next start of the program
    QVERIFY(rows(page).first().endsWith(u" +500.00 +0.00"_s));
    find<QPushButton>(page, "removeZero")->click();
    auto *question = find<QMessageBox>(page, "removeZeroQuestion");
    QVERIFY(question);
    find<QPushButton>(*question, "removeZeroYes")->click();
    QVERIFY(rows(page).first().endsWith(u" — —"_s));
    QVERIFY(!find<QPushButton>(page, "removeZero")->isEnabled());
    DisplacementPage next(*m_registry, m_folder->filePath(u"Zero"_s));
    QVERIFY(!find<QPushButton>(next, "removeZero")->isEnabled());
    QVERIFY(!QFile::exists(m_folder->filePath(u"Zero/chain7.json"_s)));
}

void TestDisplacementPage::asksBeforeItReplacesTheZero()
{
    tilt(2, 0, 0);
    tilt(3, 108000, 0);
    DisplacementPage page(*m_registry, m_folder->path());
    find<QPushButton>(page, "storeZero")->click();
    tilt(3, 324000, 0);
    page.refresh();
    const QString moved = u" +500.00 +0.00"_s;
    QVERIFY(rows(page).first().endsWith(moved));
    find<QPushButton>(page, "storeZero")->click();
    find<QPushButton>(page, "replaceZeroNo")->click();
    QVERIFY(rows(page).first().endsWith(moved));
    QTRY_VERIFY(!find<QMessageBox>(page, "replaceZeroQuestion"));
    find<QPushButton>(page, "storeZero")->click();
    find<QPushButton>(page, "replaceZeroYes")->click();
    QVERIFY(rows(page).first().endsWith(u" +0.00 +0.00"_s));
}

void TestDisplacementPage::comparesNothingThatHangsElsewhere()
{
    tilt(2, 0, 0);
    tilt(3, 108000, 0);
    DisplacementPage page(*m_registry, m_folder->path());
    find<QPushButton>(page, "storeZero")->click();
    QVERIFY(rows(page).first().endsWith(u" +0.00 +0.00"_s));
    m_registry->setChains({{7, u"Колонна"_s, {{2, 2.0}, {3, 1.5}}}});
    page.refresh();
    QVERIFY(rows(page).first().endsWith(u" — —"_s));
    QVERIFY(rows(page).last().endsWith(u" +0.00 +0.00"_s)); // the one below stands where it stood
    QVERIFY(find<QLabel>(page, "zeroText")->text().contains(u"на другой высоте"_s));
}

void TestDisplacementPage::tellsWhyTheZeroWasNotStored()
{
    tilt(2, 0, 0);
    tilt(3, 0, 0);
    QFile inTheWay(m_folder->filePath(u"Zero"_s));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    DisplacementPage page(*m_registry, m_folder->filePath(u"Zero"_s));
    find<QPushButton>(page, "storeZero")->click();
    const auto *warning = find<QMessageBox>(page, "zeroWarning");
    QVERIFY(warning);
    QVERIFY(warning->text().contains(u"chain7.json"_s));
    QVERIFY(!find<QPushButton>(page, "removeZero")->isEnabled());
}

void TestDisplacementPage::withoutChainsItSaysWhatToDo()
{
    m_registry->setChains({});
    DisplacementPage page(*m_registry, m_folder->path());
    QCOMPARE(rows(page), QStringList());
    QVERIFY(!find<QPushButton>(page, "storeZero")->isEnabled());
    QCOMPARE(
        find<TableView>(page, "profileTable")->emptyText(),
        u"В конфигурации нет ни одной цепочки датчиков ([Chain1])."_s);
}

void TestDisplacementPage::sentencesDoNotWidenTheWindow()
{
    DisplacementPage page(*m_registry, m_folder->path());
    QVERIFY(find<QLabel>(page, "zeroText")->text().size() > 60);
    QVERIFY2(page.minimumSizeHint().width() <= 700, qPrintable(QString::number(page.minimumSizeHint().width())));
}

QTEST_MAIN(TestDisplacementPage)

#include "tst_displacementpage.moc"
