#include "core/export/exportrun.h"
#include "core/export/seedcodes.h"
#include "tests/core/export/keptsite.h"

#include <QTemporaryDir>
#include <QtTest>

#include <libmseed.h>

using namespace gorizont;
using namespace std::chrono_literals;
using test::utc;

namespace {

/// One stretch without a gap, as the reader of libmseed sees it.
struct Trace
{
    QString channel;
    qint64 start = 0; ///< µs
    QList<qint32> samples;
};

QList<Trace> tracesOf(const QString &path)
{
    QByteArray name = QFile::encodeName(path);
    MSTraceGroup *group = nullptr;
    if (ms_readtraces(&group, name.data(), 0, -1, -1, 1, 1, 1, 0) != MS_NOERROR) {
        qFatal("libmseed does not read %s", name.constData());
    }
    mst_groupsort(group, 0);
    QList<Trace> traces;
    for (const MSTrace *trace = group->traces; trace; trace = trace->next) {
        const auto *samples = static_cast<const qint32 *>(trace->datasamples);
        const QStringList codes{
            QString::fromLatin1(trace->network), QString::fromLatin1(trace->station),
            QString::fromLatin1(trace->location), QString::fromLatin1(trace->channel)};
        traces << Trace{codes.join(u'.'), trace->starttime, QList<qint32>(samples, samples + trace->numsamples)};
    }
    mst_freegroup(&group);
    return traces;
}

SampleBlock block(int number, UtcTime start, bool follows, const QList<qint16> &x, const QList<qint16> &y)
{
    return {number, start, 10, -0.00594713, follows, x, y};
}

/// \a count blocks of 32 samples without a gap; the values jump over the whole range.
QList<SampleBlock> stream(int number, UtcTime start, int count)
{
    QList<SampleBlock> blocks;
    quint32 state = 12345;
    const auto next = [&state] {
        state = state * 1664525U + 1013904223U;
        const auto value = static_cast<qint16>(state >> 16);
        return state % 5 == 0 ? value : static_cast<qint16>(value / 1000);
    };
    for (int i = 0; i < count; ++i) {
        SampleBlock one = block(number, start + i * 3200ms, i > 0, {}, {});
        for (int sample = 0; sample < 32; ++sample) {
            one.x << next();
            one.y << next();
        }
        blocks << one;
    }
    return blocks;
}

QList<qint32> samplesOf(const QList<SampleBlock> &blocks, bool isX)
{
    QList<qint32> samples;
    for (const SampleBlock &one : blocks) {
        for (const qint16 sample : isX ? one.x : one.y) {
            samples << sample;
        }
    }
    return samples;
}

} // namespace

/// miniSEED files against the SEED manual and against the reader of libmseed, which is not ours.
class TestSeedExport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        m_request.format = ExportFormat::MiniSeed;
        m_request.sensors = {
            test::accelerometer(1, QStringLiteral("Этаж 2")), test::inclinometer(2, {}), test::accelerometer(103, {})};
        m_request.from = start - 1h;
        m_request.to = start + 24h;
        m_request.seed = SeedCodes();
        m_request.seed.station = QStringLiteral("TOWER");
        m_request.path = m_folder->filePath(QStringLiteral("site.mseed"));
    }

    /// Chapter 8 of the manual: fixed section, blockette 1000; appendix B: the first frame of Steim-2 holds the first
    /// and the last sample.
    void headerByTheManual()
    {
        const ExportResult result = run({block(1, start, false, {5, 7, 4, -4}, {-1, 0, 1, 2})});
        QCOMPARE(result.failure, QString());
        QCOMPARE(result.rows, quint64(4));
        const QByteArray file = test::contentOf(m_request.path);
        QCOMPARE(file.size(), 2 * 4096);
        QCOMPARE(file.left(20), QByteArray("000001D TOWER01BN1XX"));
        QCOMPARE(file.mid(20, 10).toHex(' '), QByteArray("07 e2 00 26 0f 21 03 00 09 c4")); // 2018, day 38, 15:33:03.25
        QCOMPARE(file.mid(30, 2).toHex(), QByteArray("0004"));
        QCOMPARE(file.mid(32, 4).toHex(' '), QByteArray("00 0a 00 01")); // 10 samples a second
        QCOMPARE(file.mid(39, 1).toHex(), QByteArray("01")); // one blockette
        QCOMPARE(file.mid(44, 4).toHex(' '), QByteArray("00 40 00 30")); // data at 64, blockettes at 48
        QCOMPARE(file.mid(48, 8).toHex(' '), QByteArray("03 e8 00 00 0b 01 0c 00")); // Steim-2, big-endian, 2^12
        QCOMPARE(file.mid(64 + 4, 8).toHex(' '), QByteArray("00 00 00 05 ff ff ff fc"));
        QCOMPARE(file.mid(4096 + 8, 12), QByteArray("TOWER01BN2XX"));
        QCOMPARE(file.mid(4096 + 64 + 4, 8).toHex(' '), QByteArray("ff ff ff ff 00 00 00 02"));
    }

    void everySampleIsThere()
    {
        const QList<SampleBlock> blocks = stream(1, start, 2000) + stream(103, start + 2s, 300);
        QCOMPARE(run(blocks).rows, quint64(2300 * 32));
        const QList<Trace> traces = tracesOf(m_request.path);
        QCOMPARE(traces.size(), 4);
        const QStringList channels{
            QStringLiteral("XX.TOWER.01.BN1"), QStringLiteral("XX.TOWER.01.BN2"), QStringLiteral("XX.TOWER.A3.BN1"),
            QStringLiteral("XX.TOWER.A3.BN2")};
        for (int i = 0; i < 4; ++i) {
            const bool isFirst = i < 2;
            QCOMPARE(traces.at(i).channel, channels.at(i));
            QCOMPARE(traces.at(i).start, (start + (isFirst ? 0s : 2s)).time_since_epoch().count());
            QCOMPARE(traces.at(i).samples, samplesOf(isFirst ? blocks.first(2000) : blocks.last(300), i % 2 == 0));
        }
    }

    /// What is missing, a clock that was set, and a stream that does not follow although no time is missing.
    void gapsAreGaps()
    {
        QList<SampleBlock> blocks = stream(1, start, 10);
        blocks.remove(4);
        blocks[4].followsPrevious = false;
        for (qsizetype i = 7; i < blocks.size(); ++i) {
            blocks[i].start += 1h;
        }
        QCOMPARE(run(blocks).failure, QString());
        const QList<Trace> traces = tracesOf(m_request.path);
        QCOMPARE(traces.size(), 6);
        const QList<qint64> sizes{4 * 32, 3 * 32, 2 * 32};
        const QList<UtcTime> starts{start, start + 5 * 3200ms, start + 8 * 3200ms + 1h};
        for (int i = 0; i < 3; ++i) {
            QCOMPARE(traces.at(i).channel, QStringLiteral("XX.TOWER.01.BN1"));
            QCOMPARE(traces.at(i).start, starts.at(i).time_since_epoch().count());
            QCOMPARE(traces.at(i).samples.size(), sizes.at(i));
        }
    }

    /// The range cuts blocks: the first sample at its beginning is there, the one at its end is not.
    void rangeIsExact()
    {
        const QList<SampleBlock> blocks = stream(1, start, 4);
        m_request.from = start + 1s;
        m_request.to = start + 7s;
        QCOMPARE(run(blocks).rows, quint64(60));
        const QList<Trace> traces = tracesOf(m_request.path);
        QCOMPARE(traces.first().start, m_request.from.time_since_epoch().count());
        QCOMPARE(traces.first().samples, samplesOf(blocks, true).mid(10, 60));
    }

    void notesTellTheScale()
    {
        QList<SampleBlock> blocks = stream(1, start, 3);
        blocks[2].scale = -0.006;
        const ExportResult result = run(blocks);
        QCOMPARE(result.files, QStringList({m_request.path, m_request.path + QStringLiteral(".txt")}));
        QCOMPARE(
            test::contentOf(result.files.last()),
            test::contentOf(QStringLiteral(GORIZONT_TEST_DATA "/export/notes.txt")));
    }

    void refusals_data()
    {
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("no accelerometer")
            << "sensor"
            << "None of the chosen sensors is an accelerometer: miniSEED holds only their "
               "samples.";
        QTest::newRow("number")
            << "number"
            << "miniSEED has no location code for the sensor 1036: give it a number from 1 to 1035.";
        QTest::newRow("codes") << "codes"
                               << "The miniSEED codes are wrong: the network has 1 or 2, the station 1 to 5 and a "
                                  "channel 3 capital Latin letters or digits, and the two channels differ.";
    }
    void refusals()
    {
        QFETCH(QString, what);
        QFETCH(QString, sentence);
        if (what == u"sensor") {
            m_request.sensors = {test::inclinometer(2, {})};
        } else if (what == u"number") {
            m_request.sensors = {test::accelerometer(1036, {})};
        } else {
            m_request.seed.station = QStringLiteral("башня");
        }
        QCOMPARE(run(stream(1, start, 1)).failure, sentence);
        QVERIFY(QDir(m_folder->path()).isEmpty());
    }

    void codes()
    {
        QCOMPARE(seedStation(QStringLiteral("Высотное здание")), QStringLiteral("VYSOT"));
        QCOMPARE(seedStation(QStringLiteral("ж/д мост №1")), QStringLiteral("ZHDMO"));
        QCOMPARE(seedStation(QStringLiteral("A-1")), QStringLiteral("A1"));
        QCOMPARE(seedStation(QStringLiteral("—")), QStringLiteral("SITE"));
        QCOMPARE(seedLocation(0), QString());
        QCOMPARE(seedLocation(7), QStringLiteral("07"));
        QCOMPARE(seedLocation(99), QStringLiteral("99"));
        QCOMPARE(seedLocation(100), QStringLiteral("A0"));
        QCOMPARE(seedLocation(359), QStringLiteral("Z9"));
        QCOMPARE(seedLocation(360), QStringLiteral("AA"));
        QCOMPARE(seedLocation(1035), QStringLiteral("ZZ"));
        QCOMPARE(seedLocation(1036), QString());
    }

private:
    ExportResult run(const QList<SampleBlock> &blocks)
    {
        test::KeptSite site;
        site.blocks = blocks;
        ExportWatch watch;
        return runExport(m_request, site.source(), watch);
    }

    const UtcTime start = utc("2018-02-07T15:33:03.250Z");
    std::unique_ptr<QTemporaryDir> m_folder;
    ExportRequest m_request;
};

QTEST_GUILESS_MAIN(TestSeedExport)
#include "tst_seedexport.moc"
