#include "core/history/samplefile.h"
#include "core/history/samplerepair.h"
#include "tests/core/history/failingwrite.h"
#include "tests/core/history/historysupport.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

class TestSampleFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void samplesAreLittleEndian();
    void blockIsSplitAtTheBoundary();
    void fullPairIsFollowedByTheNextBlock();
    void longBlockFillsSeveralPairs();
    void gapBeginsANewPair();
    void takenNameMovesToTheNextFreeSecond();
    void fullDiskLeavesEqualLengths_data();
    void fullDiskLeavesEqualLengths();
    void fullDiskInYCutsX_data();
    void fullDiskInYCutsX();
    void removedFileBeginsANewPair();
    void repairCutsTheNewestPair_data();
    void repairCutsTheNewestPair();
    void repairLeavesOlderAndForeignFilesAlone();

private:
    QStringList names() const { return QDir(m_folder->path()).entryList(QDir::Files, QDir::Name); }
    QByteArray contents(const char *name) const { return readAll(m_folder->filePath(QLatin1String(name))); }

    /// Samples first…last of X as they should lie in the file; with −1 those of Y.
    static QByteArray bytes(int first, int last, int sign = 1);

    std::unique_ptr<QTemporaryDir> m_folder;
    const UtcTime m_start = moscow("2016-03-29T22:46:09.400");
};

QByteArray TestSampleFile::bytes(int first, int last, int sign)
{
    QByteArray result;
    for (int value = first; value <= last; ++value) {
        const unsigned word = static_cast<unsigned>(sign * value) & 0xFFFF;
        result.append(static_cast<char>(word & 0xFF)).append(static_cast<char>(word >> 8));
    }
    return result;
}

void TestSampleFile::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestSampleFile::samplesAreLittleEndian()
{
    SampleFile file(m_folder->path(), 1, 1000, moscowZone());
    SampleBlock block = samples(1, m_start, 0, 0);
    block.x = {1, -2, 32767};
    block.y = {256, -32768, 0};
    QVERIFY(file.append(block));
    QCOMPARE(contents("16_03_29_22_46_09_1X.wrd"), QByteArray::fromHex("0100 FEFF FF7F"));
    QCOMPARE(contents("16_03_29_22_46_09_1Y.wrd"), QByteArray::fromHex("0001 0080 0000"));
    QCOMPARE(file.samplesSaved(), 3U);
}

/// 64 samples a pair, 48 a block: the second pair begins with sample 64, 1.6 s into the second block.
void TestSampleFile::blockIsSplitAtTheBoundary()
{
    SampleFile file(m_folder->path(), 3, 64, moscowZone());
    QVERIFY(file.append(samples(3, m_start, 0, 48, false)));
    QVERIFY(file.append(samples(3, m_start + 4800ms, 48, 48)));
    QCOMPARE(
        names(),
        (QStringList{
            QStringLiteral("16_03_29_22_46_09_3X.wrd"), QStringLiteral("16_03_29_22_46_09_3Y.wrd"),
            QStringLiteral("16_03_29_22_46_15_3X.wrd"), QStringLiteral("16_03_29_22_46_15_3Y.wrd")}));
    QCOMPARE(contents("16_03_29_22_46_09_3X.wrd"), bytes(0, 63));
    QCOMPARE(contents("16_03_29_22_46_09_3Y.wrd"), bytes(0, 63, -1));
    QCOMPARE(contents("16_03_29_22_46_15_3X.wrd"), bytes(64, 95));
    QCOMPARE(contents("16_03_29_22_46_15_3Y.wrd"), bytes(64, 95, -1));
}

void TestSampleFile::fullPairIsFollowedByTheNextBlock()
{
    SampleFile file(m_folder->path(), 1, 32, moscowZone());
    QVERIFY(file.append(samples(1, m_start, 0, 32)));
    QCOMPARE(names().size(), 2); // nothing empty waits for what may never come
    QVERIFY(file.append(samples(1, m_start + 3200ms, 32, 32)));
    QCOMPARE(names().size(), 4);
    QCOMPARE(contents("16_03_29_22_46_12_1X.wrd"), bytes(32, 63));
}

void TestSampleFile::longBlockFillsSeveralPairs()
{
    SampleFile file(m_folder->path(), 1, 20, moscowZone());
    QVERIFY(file.append(samples(1, m_start, 0, 50)));
    QCOMPARE(contents("16_03_29_22_46_09_1X.wrd"), bytes(0, 19));
    QCOMPARE(contents("16_03_29_22_46_11_1X.wrd"), bytes(20, 39));
    QCOMPARE(contents("16_03_29_22_46_13_1Y.wrd"), bytes(40, 49, -1));
}

void TestSampleFile::gapBeginsANewPair()
{
    SampleFile file(m_folder->path(), 1, 1000, moscowZone());
    QVERIFY(file.append(samples(1, m_start, 0, 32)));
    QVERIFY(file.append(samples(1, m_start + 3200ms, 32, 32)));
    QVERIFY(file.append(samples(1, m_start + 60s, 600, 32, false)));
    QCOMPARE(contents("16_03_29_22_46_09_1X.wrd"), bytes(0, 63));
    QCOMPARE(contents("16_03_29_22_47_09_1X.wrd"), bytes(600, 631));
    QCOMPARE(contents("16_03_29_22_47_09_1Y.wrd"), bytes(600, 631, -1));
    QCOMPARE(file.samplesSaved(), 96U);
}

void TestSampleFile::takenNameMovesToTheNextFreeSecond()
{
    writeAll(m_folder->filePath(QStringLiteral("16_03_29_22_46_09_1X.wrd")), "old!");
    writeAll(m_folder->filePath(QStringLiteral("16_03_29_22_46_10_1Y.wrd")), "old?");
    SampleFile file(m_folder->path(), 1, 1000, moscowZone());
    QVERIFY(file.append(samples(1, m_start, 0, 32, false)));
    QVERIFY(file.append(samples(1, m_start, 100, 32, false)));
    QCOMPARE(contents("16_03_29_22_46_09_1X.wrd"), "old!");
    QCOMPARE(contents("16_03_29_22_46_10_1Y.wrd"), "old?");
    QCOMPARE(contents("16_03_29_22_46_11_1X.wrd"), bytes(0, 31));
    QCOMPARE(contents("16_03_29_22_46_12_1Y.wrd"), bytes(100, 131, -1));
    QCOMPARE(names().size(), 6);
}

void TestSampleFile::fullDiskLeavesEqualLengths_data()
{
    QTest::addColumn<int>("limit");
    QTest::addColumn<int>("files");
    QTest::newRow("nothing of the first block fits") << 0 << 0;
    QTest::newRow("half of the first block") << 33 << 0;
    QTest::newRow("one block and an odd number of bytes") << 95 << 2;
}

void TestSampleFile::fullDiskLeavesEqualLengths()
{
    QFETCH(int, limit);
    SampleFile file(m_folder->path(), 1, 1000, moscowZone());
    {
        const FileSizeLimit full(limit);
        QCOMPARE(file.append(samples(1, m_start, 0, 32)), limit >= 64);
        QVERIFY(!file.append(samples(1, m_start + 3200ms, 32, 32)));
        QVERIFY2(file.error().contains(u"1X.wrd: "), qPrintable(file.error()));
    }
    QTEST(static_cast<int>(names().size()), "files");
    QCOMPARE(contents("16_03_29_22_46_09_1X.wrd"), limit >= 64 ? bytes(0, 31) : QByteArray());
    QCOMPARE(contents("16_03_29_22_46_09_1Y.wrd"), limit >= 64 ? bytes(0, 31, -1) : QByteArray());
    QVERIFY(file.append(samples(1, m_start + 6400ms, 64, 32))); // follows a block that was lost
    QCOMPARE(contents("16_03_29_22_46_15_1X.wrd"), bytes(64, 95));
    QCOMPARE(contents("16_03_29_22_46_15_1Y.wrd"), bytes(64, 95, -1));
}

void TestSampleFile::fullDiskInYCutsX_data()
{
    QTest::addColumn<int>("bytesLeft");
    QTest::newRow("nothing fits") << 0;
    QTest::newRow("an odd number of bytes fits") << 33;
}

void TestSampleFile::fullDiskInYCutsX()
{
    QFETCH(int, bytesLeft);
    SampleFile file(m_folder->path(), 1, 1000, moscowZone());
    QVERIFY(file.append(samples(1, m_start, 0, 32)));
    {
        const FailingWrite full(QStringLiteral("Y.wrd"), bytesLeft);
        QVERIFY(!file.append(samples(1, m_start + 3200ms, 32, 32)));
    }
    QCOMPARE(file.error(), u"16_03_29_22_46_09_1Y.wrd: No space left on device");
    QCOMPARE(contents("16_03_29_22_46_09_1X.wrd"), bytes(0, 31));
    QCOMPARE(contents("16_03_29_22_46_09_1Y.wrd"), bytes(0, 31, -1));
    QVERIFY(file.append(samples(1, m_start + 6400ms, 64, 32)));
    QCOMPARE(contents("16_03_29_22_46_15_1X.wrd"), bytes(64, 95));
    QCOMPARE(file.samplesSaved(), 64U);
}

void TestSampleFile::removedFileBeginsANewPair()
{
    SampleFile file(m_folder->path(), 1, 1000, moscowZone());
    QVERIFY(file.append(samples(1, m_start, 0, 32)));
    QVERIFY(QFile::remove(m_folder->filePath(QStringLiteral("16_03_29_22_46_09_1Y.wrd"))));
    QVERIFY(file.append(samples(1, m_start + 3200ms, 32, 32)));
    QCOMPARE(contents("16_03_29_22_46_12_1X.wrd"), bytes(32, 63));
    QCOMPARE(contents("16_03_29_22_46_12_1Y.wrd"), bytes(32, 63, -1));
}

void TestSampleFile::repairCutsTheNewestPair_data()
{
    QTest::addColumn<int>("sizeX");
    QTest::addColumn<int>("sizeY");
    QTest::addColumn<int>("expected"); // −1: removed
    QTest::addColumn<QStringList>("changed");
    const QString x = QStringLiteral("16_03_29_22_46_09_1X.wrd");
    const QString y = QStringLiteral("16_03_29_22_46_09_1Y.wrd");
    QTest::newRow("whole") << 64 << 64 << 64 << QStringList();
    QTest::newRow("killed between X and Y") << 128 << 64 << 64 << QStringList{x};
    QTest::newRow("Y is longer") << 64 << 128 << 64 << QStringList{y};
    QTest::newRow("half a sample") << 65 << 65 << 64 << QStringList{x, y};
    QTest::newRow("odd and longer") << 70 << 65 << 64 << QStringList{x, y};
    QTest::newRow("no sample in Y") << 64 << 0 << -1 << QStringList{x, y};
    QTest::newRow("less than a sample") << 1 << 1 << -1 << QStringList{x, y};
}

void TestSampleFile::repairCutsTheNewestPair()
{
    QFETCH(int, sizeX);
    QFETCH(int, sizeY);
    QFETCH(int, expected);
    writeAll(m_folder->filePath(QStringLiteral("16_03_29_22_46_09_1X.wrd")), bytes(0, 99).left(sizeX));
    writeAll(m_folder->filePath(QStringLiteral("16_03_29_22_46_09_1Y.wrd")), bytes(0, 99, -1).left(sizeY));
    QTEST(repairSampleFiles(m_folder->path()), "changed");
    QCOMPARE(names().isEmpty(), expected < 0);
    QCOMPARE(contents("16_03_29_22_46_09_1X.wrd"), bytes(0, 99).left(std::max(expected, 0)));
    QCOMPARE(contents("16_03_29_22_46_09_1Y.wrd"), bytes(0, 99, -1).left(std::max(expected, 0)));
    QVERIFY(repairSampleFiles(m_folder->path()).isEmpty());
}

void TestSampleFile::repairLeavesOlderAndForeignFilesAlone()
{
    const QList<std::pair<const char *, int>> files{
        {"16_03_29_22_46_09_1X.wrd", 7},  {"16_03_29_22_46_09_1Y.wrd", 9},
        {"16_03_30_00_00_00_1X.wrd", 8},  {"16_03_30_00_00_00_1Y.wrd", 6},
        {"16_03_29_22_46_09_11X.wrd", 4}, {"16_03_29_22_46_09_11Y.wrd", 2},
        {"16_03_29_22_46_09_2X.wrd", 5},  {"notes.txt", 3},
        {"16_03_31_00_00_00_1Z.wrd", 1},  {"2016_03_31_00_00_00_1X.wrd", 1}};
    for (const auto &[name, size] : files) {
        writeAll(m_folder->filePath(QLatin1String(name)), QByteArray(size, 'x'));
    }
    QCOMPARE(
        repairSampleFiles(m_folder->path()),
        (QStringList{QStringLiteral("16_03_29_22_46_09_11X.wrd"), QStringLiteral("16_03_30_00_00_00_1X.wrd")}));
    QCOMPARE(contents("16_03_29_22_46_09_1X.wrd").size(), 7);
    QCOMPARE(contents("16_03_30_00_00_00_1X.wrd").size(), 6);
    QCOMPARE(contents("16_03_29_22_46_09_11X.wrd").size(), 2);
    QCOMPARE(contents("16_03_29_22_46_09_2X.wrd").size(), 5);
    QCOMPARE(names().size(), files.size());
}

QTEST_GUILESS_MAIN(TestSampleFile)
#include "tst_samplefile.moc"
