#include "tests/core/archive/archivesite.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// What a chain makes of tilts is kept as what is measured.
class TestArchiveDisplacement : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isKeptToAMicrometre()
    {
        const QTemporaryDir folder;
        ArchiveConfig config = archiveConfig(folder.filePath(QStringLiteral("archive.sqlite")));
        config.lines.first().sensors.first().isInChain = true;
        ArchiveBench bench(config);
        bench.open(noon);
        for (int second = 1; second <= 4000; ++second) { // some of it is in chunks, some not
            Reading reading = tiltReading(1, noon + second * 1s, second);
            reading.displacement = LinkDisplacement{{0, 0}, Displacement{second + 0.0004999, -1.0 / 3}};
            if (second == 7) {
                reading.displacement->sum.reset(); // a link below says nothing
            }
            bench.writer->updateReadings({reading, tiltReading(2, reading.time, 0)});
            bench.now = reading.time;
            if (second % 100 == 0) {
                bench.writer->flush();
            }
        }
        bench.close();
        const Buckets x = bench.fullRate({1, Quantity::DisplacementX}, noon, noon + 2h);
        const Buckets y = bench.fullRate({1, Quantity::DisplacementY}, noon, noon + 2h);
        QCOMPARE(x.size(), 3999);
        QCOMPARE(x.last().mean, 4000.0);
        QCOMPARE(y.last().mean, -0.333);
        QVERIFY(x.at(5).from == noon + 6s && x.at(6).from == noon + 8s);
        const Series minutes = bench.ask({1, Quantity::DisplacementX}, noon, noon + 1h, 60);
        QCOMPARE(minutes.buckets.at(1).maximum, 119.0);
        QVERIFY(bench.fullRate({2, Quantity::DisplacementX}, noon, noon + 2h).isEmpty());
        QCOMPARE(bench.sentences, QStringList());
    }

private:
    using Buckets = QList<SeriesBucket>;
};

QTEST_GUILESS_MAIN(TestArchiveDisplacement)
#include "tst_archivedisplacement.moc"
