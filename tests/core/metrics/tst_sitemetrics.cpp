#include "core/metrics/metricsboard.h"

#include <QFile>
#include <QTest>

#include <limits>

using namespace gorizont;
using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

namespace {

constexpr SteadyTime start{100h};

/// Two ports of the same COM number, as `Device=` allows; sensor 1 answers, 2 is silent, nothing is known of 3.
SiteSnapshot site()
{
    SiteSnapshot snapshot;
    for (const int index : {1, 2}) {
        LineConfig line;
        line.index = index;
        line.com = 4;
        snapshot.lines.append(line);
    }
    for (const int number : {1, 2, 3}) {
        SensorConfig sensor;
        sensor.number = number;
        sensor.model = number == 1 ? u"AN-D3"_s : u"IN-D3"_s;
        snapshot.lines[number == 1 ? 0 : 1].sensors.append(sensor);
    }
    LineStatus &open = snapshot.statuses[1];
    open.state = LineState::Open;
    open.bytesSent = 1000;
    open.bytesReceived = 5'000'000'000;
    open.failedOpens = 1;
    open.writeErrors = 2;
    open.readErrors = 3;
    open.crcErrors = 4;
    LineStatus &failed = snapshot.statuses[2];
    failed.state = LineState::OpenFailed;
    failed.failedOpens = 7;

    Reading &good = snapshot.readings[1];
    good.answeredAt = start + 1h - 2500ms;
    good.tilt = Tilt{-264, -6644.6};
    good.temperature = 21.38;
    good.heaterPower = 25;
    good.fanFrequency = 40.5;
    good.acceleration = AccelStatistics{7.5, 0, -7.5, 270, 5.3852, 5, 2};
    good.counters = {17, 5, 6};
    good.period = 1002ms;
    good.exchange = 31ms;
    Reading &silent = snapshot.readings[2];
    silent.status = 0x3700;
    silent.tilt = Tilt{1, 2}; // the last known, not valid now
    silent.temperature = 3;
    silent.acceleration = AccelStatistics{};
    silent.counters.readErrors = 12;

    snapshot.started = start;
    snapshot.now = start + 1h;
    return snapshot;
}

QByteArray expectedFile()
{
    QFile file(QStringLiteral(GORIZONT_TEST_DATA "/metrics/site.prom"));
    return file.open(QIODevice::ReadOnly) ? file.readAll().replace("VERSION", GORIZONT_VERSION) : QByteArray();
}

} // namespace

class TestSiteMetrics : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void wholeSite();
    void numbers_data();
    void numbers();
    void textIsEscaped();
    void familyWithoutSamplesIsLeftOut();
    void boardKeepsTheLast();
};

void TestSiteMetrics::wholeSite()
{
    const QByteArrayList actual = expositionText(siteMetrics(site())).split('\n');
    const QByteArrayList expected = expectedFile().split('\n');
    for (qsizetype i = 0; i < qMin(actual.size(), expected.size()); ++i) {
        QCOMPARE(actual.at(i), expected.at(i));
    }
    QCOMPARE(actual.size(), expected.size());
}

void TestSiteMetrics::numbers_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("whole") << 1000000.0 << QByteArray("1000000");
    QTest::newRow("large") << 5e9 << QByteArray("5000000000");
    QTest::newRow("fraction") << 0.1 << QByteArray("0.1");
    QTest::newRow("negative") << -6644.6 << QByteArray("-6644.6");
    QTest::newRow("zero") << 0.0 << QByteArray("0");
    QTest::newRow("very large") << 1e300 << QByteArray("1e+300");
    QTest::newRow("not a number") << std::numeric_limits<double>::quiet_NaN() << QByteArray("NaN");
    QTest::newRow("infinite") << std::numeric_limits<double>::infinity() << QByteArray("+Inf");
    QTest::newRow("infinite below") << -std::numeric_limits<double>::infinity() << QByteArray("-Inf");
}

void TestSiteMetrics::numbers()
{
    QFETCH(const double, value);
    QFETCH(const QByteArray, text);
    const MetricFamily family{"n", MetricFamily::Type::Gauge, u"h"_s, {{{}, value}}};
    QCOMPARE(expositionText({family}), "# HELP n h\n# TYPE n gauge\nn " + text + '\n');
}

void TestSiteMetrics::textIsEscaped()
{
    const MetricFamily family{
        "n", MetricFamily::Type::Counter, u"a\\b\n\"c\""_s, {{{{"l", u"\"COM\\4\"\nЦ"_s}, {"m", QString()}}, 1}}};
    QCOMPARE(
        QString::fromUtf8(expositionText({family})),
        u"# HELP n a\\\\b\\n\"c\"\n# TYPE n counter\nn{l=\"\\\"COM\\\\4\\\"\\nЦ\",m=\"\"} 1\n"_s);
}

void TestSiteMetrics::familyWithoutSamplesIsLeftOut()
{
    QCOMPARE(expositionText({{"n", MetricFamily::Type::Gauge, u"h"_s, {}}}), QByteArray());
}

void TestSiteMetrics::boardKeepsTheLast()
{
    MetricsBoard board(site().lines);
    Reading reading;
    reading.number = 1;
    reading.counters.answers = 1;
    board.put(Readings{reading});
    reading.counters.answers = 2;
    board.put(Readings{reading});
    LineStatus status;
    status.port = 1;
    status.bytesSent = 9;
    board.put(status);
    board.put(u"x"_s, {{"x_total", MetricFamily::Type::Counter, u"h"_s, {{{}, 1}}}});
    board.put(u"x"_s, {{"x_total", MetricFamily::Type::Counter, u"h"_s, {{{}, 2}}}});
    const QByteArray text = expositionText(board.families(SteadyTime::clock::now()));
    QVERIFY2(text.contains("gorizont_sensor_answers_total{port=\"COM4\",sensor=\"1\",type=\"AN-D3\"} 2\n"), text);
    QVERIFY2(text.contains("gorizont_port_sent_bytes_total{port=\"COM4\",index=\"1\"} 9\n"), text);
    QVERIFY2(text.contains("\nx_total 2\n"), text);
    QVERIFY(!text.contains("sensor=\"2\""));
}

QTEST_APPLESS_MAIN(TestSiteMetrics)
#include "tst_sitemetrics.moc"
