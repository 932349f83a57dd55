#include "tests/core/archive/archivesite.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

constexpr SeriesKey tiltX{1, Quantity::TiltX};

} // namespace

/// Rollups that were damaged come back when their time is written to again.
class TestRollupMending : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void damagedRollupsAreMadeAgain_data();
    void damagedRollupsAreMadeAgain();
    void rollupsOfSamplesToo();
};

void TestRollupMending::damagedRollupsAreMadeAgain_data()
{
    QTest::addColumn<QString>("rows");
    QTest::addColumn<int>("count");
    QTest::newRow("minutes") << "kind = 3" << 2;
    QTest::newRow("hours") << "kind = 4" << 2;
    QTest::newRow("days") << "kind = 5" << 2;
    QTest::newRow("one curve") << "quantity = 1" << 3;
    QTest::newRow("all") << "kind > 0" << 6;
}

/// The same with and without the damage.
void TestRollupMending::damagedRollupsAreMadeAgain()
{
    QFETCH(QString, rows);
    QFETCH(int, count);
    QList<Buckets> expected;
    for (const bool isDamaged : {false, true}) {
        const QTemporaryDir folder;
        ArchiveBench bench(archiveConfig(folder.filePath(QStringLiteral("archive.sqlite"))));
        bench.open(noon);
        for (int i = 1; i <= 3000; ++i) {
            bench.read(1, noon + i * 5s, i * 37 % 1009);
            if (i % 100 == 0) {
                bench.writer->flush();
            }
            if (i == 2000 && isDamaged) {
                bench.close();
                ArchiveDatabase database(bench.config, ArchiveDatabase::Access::Write);
                QVERIFY(database.open());
                QVERIFY(database.execute(QStringLiteral("UPDATE rollup SET data = x'0102' WHERE ") + rows));
                database.close();
                bench.open(noon + i * 5s);
            }
        }
        QList<Buckets> answers;
        for (const int width : {250, 5}) {
            answers.append(bench.ask(tiltX, noon, noon + 250min, width).buckets);
        }
        answers.append(bench.ask(tiltX, noon - 12h, noon + 36h, 2).buckets);
        bench.close();
        if (!isDamaged) {
            expected = answers;
            QCOMPARE(expected.at(0).size(), 250);
            QCOMPARE(bench.sentences, QStringList());
            continue;
        }
        for (qsizetype i = 0; i < answers.size(); ++i) {
            QCOMPARE(answers.at(i).size(), expected.at(i).size());
            for (qsizetype k = 0; k < answers.at(i).size(); ++k) {
                const SeriesBucket &made = answers.at(i).at(k);
                const SeriesBucket &known = expected.at(i).at(k);
                QVERIFY(made.from == known.from && made.minimum == known.minimum && made.maximum == known.maximum);
                QCOMPARE(made.count, known.count);
                QVERIFY(std::abs(made.mean - known.mean) < 1.0 / 256 / 8);
            }
        }
        QCOMPARE(bench.sentences.size(), 1);
        QVERIFY2(
            bench.sentences.first().contains(QStringLiteral("damaged, %1 of them").arg(count)),
            qPrintable(bench.sentences.first()));
    }
}

void TestRollupMending::rollupsOfSamplesToo()
{
    const QTemporaryDir folder;
    ArchiveBench bench(archiveConfig(folder.filePath(QStringLiteral("archive.sqlite"))));
    bench.open(noon);
    for (int second = 0; second < 3600; second += 10) {
        bench.writer->appendBlock(sampleBlock(noon + second * 1s, second, 100, second > 0));
        bench.now = noon + second * 1s;
        bench.writer->flush();
        if (second == 2000) {
            bench.close();
            ArchiveDatabase database(bench.config, ArchiveDatabase::Access::Write);
            QVERIFY(database.open() && database.execute(QStringLiteral("UPDATE rollup SET data = x''")));
            database.close();
            bench.open(bench.now);
        }
    }
    const Buckets minutes = bench.ask({3, Quantity::SampleY}, noon, noon + 1h, 60).buckets;
    bench.close();
    QCOMPARE(minutes.size(), 60);
    for (qsizetype minute = 0; minute < minutes.size(); ++minute) {
        QCOMPARE(minutes.at(minute).count, 600U);
        QCOMPARE(minutes.at(minute).maximum, -0.5 * static_cast<double>(60 * minute));
    }
}

QTEST_GUILESS_MAIN(TestRollupMending)

#include "tst_rollupmending.moc"
