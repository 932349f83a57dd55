#include "core/archive/spoolbatch.h"
#include "core/archive/spoolfile.h"
#include "tests/core/archive/archivesite.h"
#include "tests/core/archive/failingdisk.h"

#include <QDir>
#include <QTest>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

constexpr qint64 plenty = 1 << 20;
constexpr qint64 name = 0x0102030405060708;
// make_spool.py
const QList<QByteArray> records{
    QByteArray::fromHex("4753504c0500000008070605040302012900000000000000e68a98056669727374"),
    QByteArray::fromHex("4753504c0000000008070605040302012a00000000000000e314f6e3"),
    QByteArray::fromHex("4753504c0e00000008070605040302012b0000000000000011311859746865204753504c206f66206974")};
const QByteArrayList batches{"first", "", "the GSPL of it"};

QByteArrayList readAll(SpoolFile &spool)
{
    QByteArrayList all;
    qint64 at = spool.from();
    while (const auto entry = spool.read(at)) {
        all.append(entry->batch);
        at = entry->end;
    }
    return all;
}

} // namespace

class TestSpool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void readsWhatIsThere();
    void writesTheSameBytes();
    void survivesEveryTornEnd();
    void survivesEveryChangedByte();
    void numbersGoOn();
    void becomesEmpty();
    void hasABound();
    void explainsWhereItCannotBe();
    void everyCallMayFail_data();
    void everyCallMayFail();
    void packsBatches();
    void refusesCutBatches();

private:
    void put(const QByteArray &bytes) const;
    QByteArray content() const;
    QString path() const { return m_folder->filePath(QStringLiteral("deep/a.spool")); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestSpool::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("deep")));
}

void TestSpool::put(const QByteArray &bytes) const
{
    QFile file(path());
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

QByteArray TestSpool::content() const
{
    QFile file(path());
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void TestSpool::readsWhatIsThere()
{
    put(records.join());
    SpoolFile spool(path(), plenty);
    QVERIFY(spool.open());
    QVERIFY(!spool.isEmpty());
    QCOMPARE(readAll(spool), batches);
    QCOMPARE(spool.next(), (SpoolMark{name, 44}));
    const auto second = spool.read(records.at(0).size());
    QCOMPARE(second->mark, (SpoolMark{name, 42}));
    QVERIFY(!second->hasDamageBefore);
}

void TestSpool::writesTheSameBytes()
{
    put(records.at(0));
    SpoolFile spool(path(), plenty);
    QVERIFY(spool.open());
    QVERIFY(spool.append(batches.at(1)) && spool.append(batches.at(2)));
    QCOMPARE(content().toHex(), records.join().toHex());
}

/// What is whole stays, and what comes then is read again.
void TestSpool::survivesEveryTornEnd()
{
    const QByteArray all = records.join();
    for (qsizetype length = 0; length < all.size(); ++length) {
        put(all.first(length));
        const qsizetype first = records.at(0).size();
        const qsizetype whole = length < first ? 0 : length < first + records.at(1).size() ? 1 : 2;
        SpoolFile spool(path(), plenty);
        QVERIFY(spool.open());
        QCOMPARE(readAll(spool), batches.first(whole));
        QVERIFY(spool.append("new"));
        SpoolFile after(path(), plenty);
        QVERIFY(after.open());
        QCOMPARE(readAll(after), batches.first(whole) + QByteArrayList{"new"});
    }
}

/// It costs the batch that it is in, and no other one.
void TestSpool::survivesEveryChangedByte()
{
    const qsizetype from = records.at(0).size();
    for (qsizetype at = from; at < from + records.at(1).size(); ++at) {
        QByteArray bytes = records.join();
        bytes[at] = static_cast<char>(bytes.at(at) ^ 0x10);
        put(bytes);
        SpoolFile spool(path(), plenty);
        QVERIFY(spool.open());
        QCOMPARE(readAll(spool), (QByteArrayList{batches.at(0), batches.at(2)}));
        QVERIFY(spool.read(from)->hasDamageBefore);
        QCOMPARE(spool.next(), (SpoolMark{name, 44}));
    }
}

void TestSpool::numbersGoOn()
{
    SpoolFile spool(path(), plenty);
    QVERIFY(spool.open());
    const SpoolMark first = spool.next();
    QVERIFY(first.spool > 0);
    QCOMPARE(first.sequence, 1);
    spool.skip();
    QVERIFY(spool.append("a"));
    QCOMPARE(spool.read(0)->mark, (SpoolMark{first.spool, 2}));
    SpoolFile again(path(), plenty);
    QVERIFY(again.open());
    QCOMPARE(again.next(), (SpoolMark{first.spool, 3}));
    SpoolFile other(m_folder->filePath(QStringLiteral("b.spool")), plenty);
    QVERIFY(other.open());
    QVERIFY(other.next().spool != first.spool);
}

void TestSpool::becomesEmpty()
{
    put(records.join());
    SpoolFile spool(path(), plenty);
    QVERIFY(spool.open());
    spool.drop(records.at(0).size());
    QCOMPARE(readAll(spool), batches.sliced(1));
    spool.drop(spool.size());
    QVERIFY(spool.isEmpty());
    QCOMPARE(content(), QByteArray());
    QVERIFY(spool.append("next"));
    QCOMPARE(readAll(spool), QByteArrayList{"next"});
    QCOMPARE(spool.read(spool.from())->mark, (SpoolMark{name, 44}));
}

void TestSpool::hasABound()
{
    const QByteArray all = records.join();
    put(all);
    SpoolFile spool(path(), all.size() + 30);
    QVERIFY(spool.open());
    QVERIFY(!spool.append("abc"));
    QVERIFY(spool.error().endsWith(QStringLiteral("is full")));
    QCOMPARE(content(), all);
    QVERIFY(spool.append("ab"));
}

void TestSpool::explainsWhereItCannotBe()
{
    put("x");
    SpoolFile spool(path() + QStringLiteral("/a.spool"), plenty);
    QVERIFY(!spool.open());
    QVERIFY(!spool.append("a"));
    QVERIFY(!spool.error().isEmpty());
}

void TestSpool::everyCallMayFail_data()
{
    QTest::addColumn<DiskCall>("call");
    QTest::newRow("write") << DiskCall::Write;
    QTest::newRow("fsync") << DiskCall::Sync;
    QTest::newRow("open") << DiskCall::Open;
    QTest::newRow("truncate") << DiskCall::Truncate;
}

/// What failed is tried again, and is there once, in its place.
void TestSpool::everyCallMayFail()
{
    QFETCH(DiskCall, call);
    bool hasFailed = true;
    int failures = 0;
    for (int nth = 1; hasFailed; ++nth) {
        init();
        const QString file = m_folder->filePath(QStringLiteral("archive.spool"));
        QByteArrayList expected;
        {
            SpoolFile spool(file, plenty);
            const FailingDisk disk(call, nth);
            for (int i = 0; i < 10; ++i) {
                expected.append("batch " + QByteArray::number(i));
                QVERIFY(spool.append(expected.last()) || spool.append(expected.last()));
                if (i == 4) {
                    spool.drop(spool.size()); // the server had them; the file becomes empty, or does so later
                    expected.clear();
                }
            }
            hasFailed = disk.hasFailed();
            failures += hasFailed ? 1 : 0;
            QCOMPARE(readAll(spool), expected);
        }
        SpoolFile again(file, plenty);
        QVERIFY(again.open());
        QCOMPARE(again.next().sequence, 11);
        QCOMPARE(readAll(again).sliced(readAll(again).size() - 5), expected);
    }
    QCOMPARE(failures, call == DiskCall::Open || call == DiskCall::Truncate ? 1 : 10);
}

void TestSpool::packsBatches()
{
    ArchiveBatch batch;
    batch.time = noon;
    QCOMPARE(ArchiveBatch::decode(batch.encode()), batch);
    batch.startedAt = noon - 1us;
    batch.readings = {
        keptReading(tiltReading(1, noon, 77), {Quantity::TiltX, Quantity::TiltY}),
        {2, noon + 1s, {{Quantity::TiltX, {}}, {Quantity::Temperature, 0.1}}}};
    batch.blocks = {sampleBlock(noon, -32768, 40)};
    batch.entries = {{JournalKind::Error, noon, QStringLiteral("Порт COM3"), 3, 0}, {JournalKind::On, noon, {}, 0, 9}};
    batch.gaps = {{1, noon, {}, GapReason::Crc, {}}, {2, noon, noon + 5s, GapReason::Disk, QStringLiteral("device")}};
    const auto read = ArchiveBatch::decode(batch.encode());
    QVERIFY(read);
    QCOMPARE(read->readings, batch.readings);
    QCOMPARE(read->entries, batch.entries);
    QVERIFY(*read == batch);
    batch.backfills = {
        {7, QStringLiteral("память"), 900s, {{7, noon - 1h, QStringLiteral("X 12"), QByteArray("\0\1", 2)}}, {}, {}},
        {1, {}, 0s, {}, batch.readings, batch.blocks}};
    QVERIFY(ArchiveBatch::decode(batch.encode()) == batch);
}

void TestSpool::refusesCutBatches()
{
    ArchiveBatch batch;
    batch.time = noon;
    batch.readings = {keptReading(tiltReading(1, noon, 77), {Quantity::TiltX})};
    batch.entries = {{JournalKind::Error, noon, QStringLiteral("text"), 3, 0}};
    for (int round = 0; round < 2; ++round) {
        const QByteArray bytes = batch.encode();
        for (qsizetype length = 0; length < bytes.size(); ++length) {
            QVERIFY(!ArchiveBatch::decode(bytes.first(length)));
        }
        QVERIFY(!ArchiveBatch::decode(bytes + 'x'));
        batch.backfills = {{7, QStringLiteral("memory"), 900s, {{7, noon, QStringLiteral("X"), "data"}}, {}, {}}};
    }
}

QTEST_GUILESS_MAIN(TestSpool)

#include "tst_spool.moc"
