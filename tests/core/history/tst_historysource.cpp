#include "core/history/historysource.h"
#include "core/history/seriesbuilder.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

#include <cmath>
#include <numbers>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

/// 2018-02-07 15:33:03 UTC: 18:33:03 in a zone of + 3 hours.
const UtcTime start{1'518'017'583s};

SensorConfig sensor(int number, bool hasTilt, bool hasAcceleration)
{
    SensorConfig config;
    config.number = number;
    config.measuresTilt = hasTilt;
    config.measuresTemperature = hasTilt;
    config.measuresAcceleration = hasAcceleration;
    return config;
}

} // namespace

/// Old files answer as an archive does.
class TestHistorySource : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("Bin")));
        m_history = {
            m_folder->path(),
            {sensor(7, true, true), sensor(2, true, false)}, // columns stand in ascending N
            QTimeZone(3 * 3600),
            9.81347};
    }

    void fullRate()
    {
        write(
            "2018_02_data.txt",
            "18:33:03 07.02.18\t3300\t  -264.0\t -6644.6\t   20.00\t     0.0\t 0 0000 0000 0000"
            "\t -3599.5\t -3599.5\t   21.38\t     0.0\t 0 0000 0001 1000\r\n"
            "torn \xcf\xf0\r\n"
            "18:33:04 07.02.18\t3300\t  -265.0\t -6644.6\t   20.00\t     0.0\t 3 0111 0000 0000"
            "\t -3600.5\t -3599.5\t   21.39\t     0.0\t 0 0000 0001 1000\r\n"
            "18:33:05 07.02.18\t3300\t  -266.0\t -6644.6\t   20.00\t     0.0\t 0 0000 0000 0000"
            "\t -3601.5\t -3599.5\t   21.40\t     0.0\t 0 0000 00");
        const QList<Series> answer =
            ask({{7, Quantity::TiltX}, {2, Quantity::TiltX}, {7, Quantity::Temperature}, {9, Quantity::TiltX}}, start,
                start + 3s, 0);
        QCOMPARE(answer.size(), 4);
        QCOMPARE(answer.at(0).key, (SeriesKey{7, Quantity::TiltX}));
        QCOMPARE(
            answer.at(0).buckets, (QList<SeriesBucket>{value(0s, -3599.5), value(1s, -3600.5)})); // the last is torn
        QCOMPARE(answer.at(1).buckets, (QList<SeriesBucket>{value(0s, -264), value(2s, -266)}));
        QCOMPARE(answer.at(2).buckets, (QList<SeriesBucket>{value(0s, 21.38), value(1s, 21.39)}));
        QCOMPARE(answer.at(0).gaps, (QList<TimeSpan>{{start + 2s, start + 3s}}));
        QCOMPARE(answer.at(1).gaps, (QList<TimeSpan>{{start + 1s, start + 2s}})); // its status said: no answer
        QVERIFY(answer.at(3).buckets.isEmpty());
        QCOMPARE(answer.at(3).gaps, (QList<TimeSpan>{{start, start + 3s}}));
    }

    /// A month of another number of sensors is of another site, or of another time of this one.
    void filesOfOtherSensorsAreNotRead()
    {
        write("2018_02_data.txt", "18:33:03 07.02.18\t3300\t  -264.0\t -6644.6\t\t     0.0\t 0 0000 0000 0000\r\n");
        QVERIFY(ask({{2, Quantity::TiltX}}, start, start + 1s, 0).first().buckets.isEmpty());
        const HistoryOverview overview = overviewOf(m_history);
        QCOMPARE(overview.foreign, 1);
        QVERIFY(!overview.span);
    }

    /// Two hours of seconds over the end of a month, with half an hour missing.
    void bucketsAndGaps()
    {
        const UtcTime midnight = UtcTime(std::chrono::sys_days(2018y / 3 / 1)) - 3h;
        QByteArray february;
        QByteArray march;
        for (int second = -3600; second < 3600; ++second) {
            if (second < -2400 || second >= -600) {
                const QTime time = QTime(0, 0).addSecs(second < 0 ? second + 86400 : second);
                (second < 0 ? february : march) += time.toString(u"hh:mm:ss").toLatin1()
                    + (second < 0 ? " 28.02.18" : " 01.03.18") + "\t3300"
                    + QByteArray::fromStdString("\t1\t2\t3\t0\t 0 0000 0000 0000\t" + std::to_string(second)
                                                + "\t2\t3\t0\t 0 0000 0000 0000\r\n");
            }
        }
        write("2018_02_data.txt", february);
        write("2018_03_data.txt", march);
        const Series series = ask({{7, Quantity::TiltX}}, midnight - 1h, midnight + 1h, 120).first();
        QCOMPARE(series.step, std::chrono::microseconds(1min));
        QCOMPARE(series.buckets.size(), 90);
        QCOMPARE(series.buckets.first(), (SeriesBucket{midnight - 1h, -3600, -3570.5, -3541, 60, 60}));
        QCOMPARE(series.buckets.last(), (SeriesBucket{midnight + 59min, 3540, 3569.5, 3599, 60, 60}));
        QCOMPARE(series.gaps, (QList<TimeSpan>{{midnight - 40min, midnight - 10min}}));
        const Series part = ask({{7, Quantity::TiltX}}, midnight + 10s, midnight + 12s, 0).first(); // by bisection
        QCOMPARE(part.buckets.size(), 2);
        QCOMPARE(part.buckets.first().mean, 10.0);
        QCOMPARE(overviewOf(m_history).span, (TimeSpan{midnight - 1h, midnight + 1h - 1s}));
    }

    void accelerations()
    {
        write(
            "2018_02_adata.txt",
            "18:33:03 07.02.18\t3300\t   -3.00\t   -4.00\t    5.00\t   12.00\t 0 0000 0000 0000\r\n");
        const QList<Series> answer =
            ask({{7, Quantity::AccelMaximum}, {7, Quantity::AccelRmsY}}, start - 1s, start + 1s, 0);
        QCOMPARE(answer.at(0).buckets, QList<SeriesBucket>{value(0s, 5)});
        QCOMPARE(answer.at(1).buckets, QList<SeriesBucket>{value(0s, 12)});
    }

    /// int16 little-endian, 1/8 arc-second, opposite in sign: 8000 is 1000″ of 9813.47 mm/s².
    void samples()
    {
        write("Bin/18_02_07_18_33_03_7X.wrd", QByteArray::fromHex("401fc0e00000"));
        write("Bin/18_02_07_18_33_03_7Y.wrd", QByteArray::fromHex("000001"));
        write("Bin/readme.txt", "no samples");
        const QList<Series> answer = ask({{7, Quantity::SampleX}, {7, Quantity::SampleY}}, start - 1s, start + 1s, 0);
        const double expected = 1000.0 / 3600 * std::numbers::pi / 180 * 9813.47;
        QCOMPARE(answer.at(0).buckets.size(), 3);
        QVERIFY(std::abs(answer.at(0).buckets.at(0).mean + expected) < 1e-9);
        QVERIFY(std::abs(answer.at(0).buckets.at(1).mean - expected) < 1e-9);
        QCOMPARE(answer.at(0).buckets.at(2).from, start + 200ms);
        QCOMPARE(answer.at(1).buckets.size(), 1); // half a sample is none
        QCOMPARE(ask({{7, Quantity::SampleX}}, start + 100ms, start + 200ms, 0).first().buckets.size(), 1);
        QCOMPARE(overviewOf(m_history).span, (TimeSpan{start, start + 300ms}));
    }

    void noFiles()
    {
        QVERIFY(!overviewOf(m_history).span);
        m_history.path += QStringLiteral("/none");
        QVERIFY(!overviewOf(m_history).span);
        QVERIFY(ask({{7, Quantity::TiltX}, {7, Quantity::SampleX}}, start, start + 1h, 100).first().buckets.isEmpty());
    }

    void steps()
    {
        QCOMPARE(stepFor(2h, 120, 1s), std::chrono::microseconds(1min));
        QCOMPARE(stepFor(2h, 121, 1s), std::chrono::microseconds(30s));
        QCOMPARE(stepFor(2h, 7200, 1s), std::chrono::microseconds(0));
        QCOMPARE(stepFor(2h, 120, 60s), std::chrono::microseconds(0)); // a bucket would hold one value
        QCOMPARE(stepFor(2h, 0, 1s), std::chrono::microseconds(0));
        QCOMPARE(stepFor(8760h, 300, 1s), std::chrono::microseconds(24h));
    }

private:
    static SeriesBucket value(std::chrono::microseconds after, double number)
    {
        return {start + after, number, number, number, 1, 1};
    }

    void write(const char *name, const QByteArray &bytes) const
    {
        QFile file(m_folder->filePath(QLatin1String(name)));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }

    QList<Series> ask(const QList<SeriesKey> &keys, UtcTime from, UtcTime to, int width) const
    {
        QFuture<QList<Series>> future = historySource(m_history)({keys, from, to, width});
        future.waitForFinished();
        return future.result();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    HistoryFolder m_history;
};

QTEST_GUILESS_MAIN(TestHistorySource)
#include "tst_historysource.moc"
