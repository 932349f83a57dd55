#include "core/archive/integercolumn.h"
#include "core/archive/readingchunk.h"
#include "core/archive/rollupchunk.h"
#include "core/archive/samplechunk.h"
#include "core/archive/tailbatch.h"
#include "core/archive/valuecolumn.h"

#include <QFile>
#include <QRandomGenerator>
#include <QTest>

#include <cmath>
#include <functional>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

const UtcTime start{std::chrono::microseconds(1'700'000'000'000'000)};

/// Made by make_chunks.py of this folder.
QByteArray chunkFile(const QString &name)
{
    QFile file(QStringLiteral(GORIZONT_TEST_DATA "/archive/%1.bin").arg(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

std::vector<qint64> backAndForth(const std::vector<qint64> &values)
{
    ArchiveBytes bytes;
    appendIntegers(bytes, values);
    ArchiveCursor cursor(bytes.bytes());
    std::vector<qint64> back = takeIntegers(cursor, values.size());
    return cursor.isGood() && cursor.isAtEnd() ? back : std::vector<qint64>{-1};
}

qsizetype bytesOf(const std::vector<double> &values, double offset = 0)
{
    ArchiveBytes bytes;
    appendValues(bytes, values, offset);
    ArchiveCursor cursor(bytes.bytes());
    const std::vector<double> back = takeValues(cursor, values.size());
    return back == values && cursor.isAtEnd() ? bytes.bytes().size() : -1;
}

bool isRead(const QString &kind, QByteArrayView bytes)
{
    if (kind == QStringLiteral("readings")) {
        return decodeReadingChunk(bytes).has_value();
    }
    if (kind == QStringLiteral("samples")) {
        return decodeSampleChunk(bytes).has_value();
    }
    return kind == QStringLiteral("rollup") ? decodeRollup(bytes, ChunkKind::Minutes).has_value()
                                            : TailBatch::decode(bytes).has_value();
}

} // namespace

class TestArchiveChunks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knowsTheCheckSum();
    void readsReadings();
    void readsOneQuantity();
    void readsSamples();
    void readsRollup();
    void readsTail();
    void refusesDamage_data();
    void refusesDamage();
    void refusesOtherKindsAndVersions();
    void keepsEveryInteger_data();
    void keepsEveryInteger();
    void findsTheGridOfADevice_data();
    void findsTheGridOfADevice();
    void keepsWhatIsOnNoGrid();
    void keepsReadings();
    void keepsSamples();
    void keepsRollups();
    void keepsTail();
};

/// The check value of the catalogue of CRCs (CRC-32/ISO-HDLC).
void TestArchiveChunks::knowsTheCheckSum()
{
    QCOMPARE(crc32("123456789"), 0xCBF43926U);
    QCOMPARE(crc32(""), 0U);
    QCOMPARE(crc32("a"), 0xE8B7BE43U);
}

void TestArchiveChunks::readsReadings()
{
    const auto chunk = decodeReadingChunk(chunkFile(QStringLiteral("readings")));
    QVERIFY(chunk);
    QCOMPARE(chunk->size(), std::size_t{130});
    QCOMPARE(chunk->columns.size(), std::size_t{3});
    for (int i = 0; i < 130; ++i) {
        const auto at = static_cast<std::size_t>(i);
        QVERIFY(chunk->times[at] == start + i * 1s + (i == 129 ? 5ms : 0ms));
        QCOMPARE(chunk->columns[0].values[at], (i * i % 97 - 40) / 256.0);
        QCOMPARE(chunk->columns[1].values[at], (-2640 + i) / 10.0 - 12.3);
        QCOMPARE(bool(chunk->columns[2].isValid[at]), i % 3 != 2);
        QCOMPARE(chunk->columns[2].values[at], i % 3 == 2 ? 0 : 0.1 + 0.2 * (i / 64));
    }
    QCOMPARE(chunk->columns[2].quantity, Quantity::Temperature);
}

void TestArchiveChunks::readsOneQuantity()
{
    const auto chunk = decodeReadingChunk(chunkFile(QStringLiteral("readings")), Quantity::TiltY);
    QVERIFY(chunk && chunk->columns.size() == 1 && chunk->column(Quantity::TiltY));
    QCOMPARE(chunk->column(Quantity::TiltY)->values[129], -251.1 - 12.3);
}

void TestArchiveChunks::readsSamples()
{
    const auto chunk = decodeSampleChunk(chunkFile(QStringLiteral("samples")));
    QVERIFY(chunk);
    QVERIFY(chunk->followsPrevious);
    QCOMPARE(chunk->rate, 10.0);
    QCOMPARE(chunk->scale, -0.0059);
    QCOMPARE(chunk->x.size(), std::size_t{96});
    for (int i = 0; i < 96; ++i) {
        const auto at = static_cast<std::size_t>(i);
        QCOMPARE(chunk->x[at], i * 37 % 201 - 100);
        QCOMPARE(chunk->y[at], i == 5 ? -32768 : i == 6 ? 32767 : 0);
    }
    const std::vector<UtcTime> times = chunk->times();
    QVERIFY(times[31] == start + 3100ms && times[32] == start + 3200ms && times[65] == start + 6500100us);
    QVERIFY(chunk->end() == start + 9600100us);
}

void TestArchiveChunks::readsRollup()
{
    const auto buckets = decodeRollup(chunkFile(QStringLiteral("rollup")), ChunkKind::Minutes);
    const UtcTime minute = floored(start, 1min);
    const Buckets expected{
        {minute, -2.5, -2.0, -1.5, 60, 60},
        {minute + 1min, -3.0, -3.0 + 121 / 160.0, -1.5, 60, 59},
        {minute + 2min, 0, 0, 0, 58, 0},
        {minute + 4min, 0.4, 0.4, 0.4, 7, 7}};
    QVERIFY(buckets);
    QCOMPARE(*buckets, expected);
}

void TestArchiveChunks::readsTail()
{
    const auto contents = TailBatch::decode(chunkFile(QStringLiteral("tail")));
    const KeptReading reading{
        300, start, {{Quantity::TiltX, -264.5}, {Quantity::TiltY, {}}, {Quantity::Temperature, 21.0625}}};
    const SampleBlock block{7, start + 1us, 10, 0.5, true, {-3, 4}, {32767, -32768}};
    QVERIFY(contents);
    QCOMPARE(*contents, (TailBatch::Contents{{reading}, {block}}));
    QCOMPARE(*TailBatch::decode(chunkFile(QStringLiteral("tail")), {7}), (TailBatch::Contents{{}, {block}}));
    QCOMPARE(*TailBatch::decode(chunkFile(QStringLiteral("tail")), {8}), TailBatch::Contents());
}

void TestArchiveChunks::refusesDamage_data()
{
    QTest::addColumn<QString>("kind");
    for (const char *kind : {"readings", "samples", "rollup", "tail"}) {
        QTest::newRow(kind) << QString::fromLatin1(kind);
    }
}

void TestArchiveChunks::refusesDamage()
{
    QFETCH(QString, kind);
    const QByteArray good = chunkFile(kind);
    QVERIFY(isRead(kind, good));
    for (qsizetype length = 0; length < good.size(); ++length) {
        QVERIFY(!isRead(kind, good.first(length)));
    }
    for (qsizetype bit = 0; bit < good.size() * 8; ++bit) {
        QByteArray bad = good;
        bad[bit / 8] = static_cast<char>(bad.at(bit / 8) ^ (1 << (bit % 8)));
        QVERIFY2(!isRead(kind, bad), QByteArray::number(bit));
    }
    QVERIFY(!isRead(kind, good + '\0'));
    QVERIFY(!isRead(kind, '\0' + good));
}

void TestArchiveChunks::refusesOtherKindsAndVersions()
{
    const auto resealed = [](QByteArray bytes, qsizetype at, char value) {
        bytes.chop(4);
        bytes[at] = value;
        ArchiveBytes again;
        again.raw(bytes);
        return again.sealed();
    };
    const QByteArray rollup = chunkFile(QStringLiteral("rollup"));
    QVERIFY(isRead(QStringLiteral("rollup"), resealed(rollup, 1, 3)));
    QVERIFY(!isRead(QStringLiteral("rollup"), resealed(rollup, 0, 2)));
    QVERIFY(!isRead(QStringLiteral("rollup"), resealed(rollup, 1, 4)));
    QVERIFY(!decodeRollup(rollup, ChunkKind::Hours));
    QVERIFY(!decodeReadingChunk(chunkFile(QStringLiteral("samples"))));
    QVERIFY(!decodeSampleChunk(chunkFile(QStringLiteral("readings"))));
    QVERIFY(!isRead(QStringLiteral("tail"), resealed(chunkFile(QStringLiteral("tail")), 0, 9)));
}

void TestArchiveChunks::keepsEveryInteger_data()
{
    QTest::addColumn<std::function<qint64(qint64)>>("make");
    using Make = std::function<qint64(qint64)>;
    auto *random = QRandomGenerator::global();
    const auto max = std::numeric_limits<qint64>::max();
    QTest::newRow("zeros") << Make([](qint64) { return 0; });
    QTest::newRow("a ramp") << Make([](qint64 i) { return i * 1'000'000; });
    QTest::newRow("a parabola") << Make([](qint64 i) { return i * i * 77 - 5; });
    QTest::newRow("both ends") << Make([max](qint64 i) { return i % 2 == 0 ? max : -max - 1; });
    QTest::newRow("noise") << Make([random](qint64) { return random->bounded(1000); });
    QTest::newRow("anything") << Make([random](qint64) { return static_cast<qint64>(random->generate64()); });
    QTest::newRow("rare steps") << Make([](qint64 i) { return i / 50 * 12345678901; });
    QTest::newRow("one outlier") << Make([max](qint64 i) { return i == 70 ? max : 3; });
    QTest::newRow("every size") << Make([](qint64 i) { return (qint64{1} << (i % 63)) * (i % 2 == 0 ? 1 : -1); });
}

void TestArchiveChunks::keepsEveryInteger()
{
    using Make = std::function<qint64(qint64)>;
    QFETCH(Make, make);
    for (const qint64 count : {0, 1, 2, 3, 63, 64, 65, 127, 128, 129, 1000}) {
        std::vector<qint64> values;
        for (qint64 i = 0; i < count; ++i) {
            values.push_back(make(i));
        }
        QCOMPARE(backAndForth(values), values);
    }
}

void TestArchiveChunks::findsTheGridOfADevice_data()
{
    QTest::addColumn<double>("parts");
    QTest::addColumn<double>("offset");
    QTest::newRow("1/256 of ИН-Д3") << 256.0 << 0.0;
    QTest::newRow("its Modbus, 1/1000") << 1000.0 << 0.0;
    QTest::newRow("tenths less an offset") << 10.0 << 0.123;
    QTest::newRow("1/256 less an offset") << 256.0 << 17.35;
    QTest::newRow("1/16 °C") << 16.0 << -0.7;
}

/// White noise of 2⁸ steps costs 8 bits a value and a little, whatever the grid; as doubles it would cost over 6 bytes.
void TestArchiveChunks::findsTheGridOfADevice()
{
    QFETCH(double, parts);
    QFETCH(double, offset);
    QRandomGenerator random(7);
    std::vector<double> values;
    for (int i = 0; i < 512; ++i) {
        values.push_back((random.bounded(256) - 100) / parts - offset);
    }
    const qsizetype bytes = bytesOf(values, offset);
    QVERIFY2(bytes > 0 && bytes < 512 * 1.25, QByteArray::number(bytes));
}

void TestArchiveChunks::keepsWhatIsOnNoGrid()
{
    const double inf = std::numeric_limits<double>::infinity();
    const double least = std::numeric_limits<double>::denorm_min();
    QVERIFY(bytesOf({0.1 + 0.2, -1.0 / 3, 1e300, -1e-300, inf, -inf, least, 0, -7}) > 0);
    ArchiveBytes bytes;
    appendValues(bytes, std::vector<double>{std::nan(""), 1}, 0);
    ArchiveCursor cursor(bytes.bytes());
    const std::vector<double> back = takeValues(cursor, 2);
    QVERIFY(std::isnan(back.at(0)) && back.at(1) == 1);
    // Statistics stay as they are for several readings: that costs next to nothing.
    std::vector<double> held;
    for (int i = 0; i < 512; ++i) {
        held.push_back(std::sqrt(2.0 + i / 128));
    }
    QVERIFY(bytesOf(held) < 150);
}

void TestArchiveChunks::keepsReadings()
{
    ReadingChunk chunk;
    chunk.append({1, start, {{Quantity::TiltX, 1.5}}});
    chunk.append({1, start + 1s, {{Quantity::TiltX, {}}, {Quantity::Temperature, 20.1}}});
    chunk.append({1, start + 2s, {{Quantity::TiltY, -7.0}}});
    chunk.append({1, start - 9s, {}});
    QCOMPARE(chunk.columns.size(), std::size_t{3});
    QCOMPARE(chunk.column(Quantity::TiltX)->isValid, (std::vector<bool>{true, false, false, false}));
    QCOMPARE(chunk.column(Quantity::TiltY)->isValid, (std::vector<bool>{false, false, true, false}));
    QCOMPARE(chunk.column(Quantity::Temperature)->values, (std::vector<double>{0, 20.1, 0, 0}));
    const auto back = decodeReadingChunk(encodeChunk(chunk));
    QVERIFY(back && *back == chunk);
    QVERIFY(decodeReadingChunk(encodeChunk(ReadingChunk())) == ReadingChunk());
}

void TestArchiveChunks::keepsSamples()
{
    SampleChunk chunk;
    QVERIFY(chunk.append({1, start, 10, 0.5, false, {1, 2, 3}, {4, 5, 6}}));
    QVERIFY(chunk.append({1, start + 300ms, 10, 0.5, true, {-32768}, {32767}}));
    QVERIFY(!chunk.append({1, start + 400ms, 10, 0.5, false, {1}, {1}}));
    QVERIFY(!chunk.append({1, start + 400ms, 20, 0.5, true, {1}, {1}}));
    QVERIFY(!chunk.append({1, start + 400ms, 10, 0.6, true, {1}, {1}}));
    QVERIFY(!chunk.append({1, start + 300ms, 10, 0.5, true, {1}, {1}}));
    const auto back = decodeSampleChunk(encodeChunk(chunk));
    QVERIFY(back && *back == chunk);
}

void TestArchiveChunks::keepsRollups()
{
    const UtcTime hour = floored(start, 1h);
    const Buckets coarse{{hour, -1.5, 0.25, 2, 10, 9}, {hour + 2h, 0, 0, 0, 4, 0}, {hour + 3h, 7, 7, 7, 1, 1}};
    QCOMPARE(decodeRollup(encodeRollup(ChunkKind::Hours, coarse, 0), ChunkKind::Hours), coarse);
    const Buckets fine{{hour, 1 / 3.0, 0.4, 0.5, 3, 3}, {hour + 1h, -1e200, 0, 1e200, 3, 3}};
    QCOMPARE(decodeRollup(encodeRollup(ChunkKind::Hours, fine, 0), ChunkKind::Hours), fine);
    QCOMPARE(decodeRollup(encodeRollup(ChunkKind::Days, {}, 0), ChunkKind::Days), Buckets());
}

void TestArchiveChunks::keepsTail()
{
    TailBatch batch;
    const KeptReading reading{4, start, {{Quantity::TiltX, 1 / 3.0}, {Quantity::TiltY, {}}}};
    const SampleBlock block{4, start, 10, -0.25, false, {1}, {-1}};
    batch.add(reading);
    batch.add(block);
    batch.add(reading);
    QCOMPARE(TailBatch::decode(batch.take()), (TailBatch::Contents{{reading, reading}, {block}}));
    QVERIFY(batch.isEmpty());
}

QTEST_APPLESS_MAIN(TestArchiveChunks)

#include "tst_archivechunks.moc"
