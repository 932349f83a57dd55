#include "core/archive/archiveinbox.h"
#include "tests/core/archive/archivesite.h"

#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

/// What there is no room for.
class TestArchiveInbox : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsWhatSamplesItDropped();
    void whatComesBehindFollowsNothing();
    void droppedSamplesAreAGap();

private:
    static SampleBlock block(int number, UtcTime start)
    {
        SampleBlock block = sampleBlock(start, 1, 10); // 10 samples of 10 Hz: a second
        block.number = number;
        return block;
    }
};

void TestArchiveInbox::tellsWhatSamplesItDropped()
{
    ArchiveInbox inbox;
    for (int second = 0; second < ArchiveInbox::mostBlocks + 7; ++second) {
        inbox.put(block(3, noon + second * 1s));
    }
    const ArchiveInbox::Contents contents = inbox.take();
    QCOMPARE(contents.blocks.size(), ArchiveInbox::mostBlocks);
    QCOMPARE(contents.blocksDropped, 7);
    QCOMPARE(contents.droppedBlocks, (QHash<int, TimeSpan>{{3, {noon, noon + 7s}}}));
    QVERIFY(contents.blocks.at(0).start == noon + 7s && !contents.blocks.at(0).followsPrevious);
    QVERIFY(contents.blocks.at(1).followsPrevious);
    QVERIFY(inbox.take().droppedBlocks.isEmpty());
}

/// Even if it comes when the sensor's blocks are all gone.
void TestArchiveInbox::whatComesBehindFollowsNothing()
{
    ArchiveInbox inbox;
    inbox.put(block(4, noon));
    for (int second = 0; second < ArchiveInbox::mostBlocks; ++second) {
        inbox.put(block(3, noon + second * 1s));
    }
    inbox.take();
    inbox.put(block(4, noon + 1s));
    inbox.put(block(4, noon + 2s));
    const ArchiveInbox::Contents contents = inbox.take();
    QVERIFY(!contents.blocks.at(0).followsPrevious);
    QVERIFY(contents.blocks.at(1).followsPrevious);
}

void TestArchiveInbox::droppedSamplesAreAGap()
{
    const QTemporaryDir folder;
    ArchiveBench bench(archiveConfig(folder.filePath(QStringLiteral("archive.sqlite"))));
    bench.open(noon);
    for (int second = 0; second < ArchiveInbox::mostBlocks + 60; ++second) {
        bench.writer->appendBlock(sampleBlock(noon + second * 1s, second % 1000, 10));
    }
    bench.close();
    const QList<Gap> expected{{3, noon, noon + 60s, GapReason::Disk, {}}};
    QList<Gap> gaps = ArchiveQuery(bench.config).gaps({3}, noon, noon + 1h);
    gaps.erase(
        std::remove_if(gaps.begin(), gaps.end(), [](const Gap &gap) { return gap.reason != GapReason::Disk; }),
        gaps.end());
    QCOMPARE(gaps, expected);
}

QTEST_GUILESS_MAIN(TestArchiveInbox)

#include "tst_archiveinbox.moc"
