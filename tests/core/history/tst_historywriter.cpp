#include "core/history/historywriter.h"
#include "tests/core/history/failingwrite.h"
#include "tests/core/history/historysupport.h"

#include <QDir>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

/// Port 1 is on: sensor 1 is switched off, sensor 3 is an accelerometer. Port 2 is off: sensor 2, listed first.
HistoryConfig threeSensors(const QString &folder)
{
    SensorConfig switchedOff = tiltSensor(1);
    switchedOff.isOn = false;
    LineConfig first;
    first.index = 1;
    first.isOn = true;
    first.sensors = {switchedOff, accelerometer(3)};
    LineConfig second;
    second.index = 2;
    second.sensors = {tiltSensor(2)};
    HistoryConfig config;
    config.folder = folder;
    config.saveInterval = 20ms;
    config.ringPackets = 2;
    config.lines = {second, first};
    config.zone = moscowZone();
    config.retryInterval = 50ms;
    return config;
}

Reading tiltReading(int number, double x, quint16 status = 0)
{
    Reading reading;
    reading.number = number;
    reading.status = status;
    reading.tilt = Tilt{x, -x};
    return reading;
}

} // namespace

class TestHistoryWriter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { m_writer.reset(); }

    void lineBeforeAnyReadingSaysWhatIsOff();
    void lineHoldsTheLastValues();
    void firstLineComesAfterTheFirstInterval();
    void lateTicksAreDropped();
    void monthRolls();
    void eventGoesToTheMonthItHappenedIn();
    void nothingIsWrittenWithoutCanSave();
    void clockStepIsNoted();
    void packetsAreCounted();
    void pairHoldsSrsBufSizeTimesSrsBufToSavePackets_data();
    void pairHoldsSrsBufSizeTimesSrsBufToSavePackets();
    void impossibleFolderIsToldOnce();
    void fullDiskIsToldOnceAndEventsAreKept();
    void blockLostByOnePairClosesTheOthers();
    void repairIsTold();
    void worksInItsOwnThread();

private:
    void create(const HistoryConfig &config);
    QByteArray file(const char *name) const { return readAll(m_config.folder + u'/' + QLatin1String(name)); }
    QStringList entries() const;

    std::unique_ptr<QTemporaryDir> m_folder;
    HistoryConfig m_config;
    UtcTime m_now;
    std::unique_ptr<HistoryWriter> m_writer;
    std::unique_ptr<QSignalSpy> m_lines;
    QList<JournalEntry> m_entries;
};

void TestHistoryWriter::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_now = moscow("2018-02-07T18:33:03");
    m_entries.clear();
    create(threeSensors(m_folder->filePath(QStringLiteral("History"))));
}

/// The journal of the program: it gives every event back to the writer.
void TestHistoryWriter::create(const HistoryConfig &config)
{
    m_config = config;
    m_writer = std::make_unique<HistoryWriter>(config, [this] { return m_now; });
    m_lines = std::make_unique<QSignalSpy>(m_writer.get(), &HistoryWriter::dataLineWritten);
    connect(m_writer.get(), &HistoryWriter::journal, m_writer.get(), [this](const JournalEntry &entry) {
        m_entries.append(entry);
        m_writer->appendJournal(entry);
    });
}

QStringList TestHistoryWriter::entries() const
{
    QStringList texts;
    for (const JournalEntry &entry : m_entries) {
        texts.append(entry.text);
    }
    return texts;
}

void TestHistoryWriter::lineBeforeAnyReadingSaysWhatIsOff()
{
    m_writer->start();
    QTRY_VERIFY(!m_lines->isEmpty());
    m_writer->stop();
    QCOMPARE(
        m_lines->first().first().toString(),
        u"18:33:03 07.02.18\t3330"
        "\t\t\t\t     0.0\t 0 1111 0000 0000"
        "\t\t\t\t     0.0\t 1 0111 0000 0000"
        "\t\t\t\t     0.0\t 0 0111 0000 0000");
    QVERIFY(file("2018_02_data.txt").startsWith(m_lines->first().first().toString().toLatin1() + "\r\n"));
    QVERIFY(file("2018_02_adata.txt").startsWith("18:33:03 07.02.18\t3330\t\t\t\t\t 0 0111 0000 0000\r\n"));
    QVERIFY(m_entries.isEmpty());
}

void TestHistoryWriter::lineHoldsTheLastValues()
{
    Reading both = tiltReading(3, 7.25, 0x0018);
    both.temperature = 21.38;
    both.acceleration = AccelStatistics{0, -1, 2, 0, 0, 3, 4};
    LineStatus lost;
    lost.port = 1;
    lost.state = LineState::Lost;
    m_writer->updateReadings({tiltReading(3, 1), tiltReading(99, 1)});
    m_writer->updateReadings({both});
    m_writer->updateLine(lost);
    m_writer->start();
    QTRY_VERIFY(!m_lines->isEmpty());
    QCOMPARE(
        m_lines->first().first().toString(),
        u"18:33:03 07.02.18\t3332"
        "\t\t\t\t     0.0\t 0 1111 0000 0000"
        "\t\t\t\t     0.0\t 1 0111 0000 0000"
        "\t     7.2\t    -7.2\t   21.38\t     0.0\t 0 0000 0001 1000");
    QVERIFY(file("2018_02_adata.txt")
                .startsWith("18:33:03 07.02.18\t3332\t   -1.00\t    2.00\t    3.00\t    4.00\t 0 0000 0001 1000\r\n"));
}

void TestHistoryWriter::firstLineComesAfterTheFirstInterval()
{
    m_config.saveInterval = 100ms;
    create(m_config);
    QElapsedTimer time;
    time.start();
    m_writer->start();
    QVERIFY(m_lines->wait());
    QVERIFY2(time.elapsed() >= 99, qPrintable(QString::number(time.elapsed())));
    QVERIFY(m_lines->wait());
    QVERIFY2(time.elapsed() >= 199, qPrintable(QString::number(time.elapsed())));
    QTRY_VERIFY(m_lines->size() >= 5);
    QVERIFY(m_lines->size() <= time.elapsed() / 100);
}

void TestHistoryWriter::lateTicksAreDropped()
{
    m_writer->start();
    QThread::msleep(300); // fifteen intervals
    QCoreApplication::processEvents();
    QCOMPARE(m_lines->size(), 1);
}

void TestHistoryWriter::monthRolls()
{
    m_now = moscow("2018-01-31T23:59:59.900");
    m_writer->start();
    QTRY_VERIFY(!m_lines->isEmpty());
    m_now = moscow("2018-02-01T00:00:00.000");
    const qsizetype january = m_lines->size();
    QTRY_VERIFY(m_lines->size() > january);
    m_writer->stop();
    QCOMPARE(file("2018_01_data.txt").count('\n'), january);
    QCOMPARE(file("2018_01_adata.txt").count('\n'), january);
    QVERIFY(file("2018_02_data.txt").startsWith("00:00:00 01.02.18\t"));
    QVERIFY(file("2018_02_adata.txt").startsWith("00:00:00 01.02.18\t"));
    QVERIFY(m_entries.isEmpty());
}

void TestHistoryWriter::eventGoesToTheMonthItHappenedIn()
{
    m_writer->appendJournal({JournalKind::On, moscow("2018-02-01T00:00:01"), QStringLiteral("b")});
    m_writer->appendJournal({JournalKind::Off, moscow("2018-01-31T23:59:59"), QStringLiteral("a")});
    m_writer->flush();
    QCOMPARE(file("2018_02_log.txt"), "1 00:00:01 01.02.18   b\r\n");
    QCOMPARE(file("2018_01_log.txt"), "2 23:59:59 31.01.18   a\r\n");
}

void TestHistoryWriter::nothingIsWrittenWithoutCanSave()
{
    m_config.savesFiles = false;
    create(m_config);
    m_writer->appendJournal({JournalKind::On, m_now, QStringLiteral("event")});
    m_writer->appendBlock(samples(3, m_now, 0, 32));
    m_writer->updateReadings({tiltReading(3, 5)});
    m_writer->start();
    QTRY_VERIFY(m_lines->size() >= 2);
    m_writer->stop();
    QVERIFY(m_lines->first().first().toString().contains(u"     5.0\t    -5.0\t"));
    QVERIFY(!QFile::exists(m_config.folder));
}

void TestHistoryWriter::clockStepIsNoted()
{
    m_writer->start();
    QTRY_VERIFY(!m_lines->isEmpty());
    m_now -= 1h;
    QTRY_COMPARE(m_entries.size(), 1);
    QVERIFY2(m_entries.first().text.contains(u"back by 3600."), qPrintable(m_entries.first().text));
    m_now += 90min;
    QTRY_COMPARE(m_entries.size(), 2);
    QVERIFY2(m_entries.last().text.contains(u"forward by 5400."), qPrintable(m_entries.last().text));
    m_writer->stop();
    QCOMPARE(file("2018_02_log.txt").count('\n'), 2);
}

void TestHistoryWriter::packetsAreCounted()
{
    QSignalSpy packets(m_writer.get(), &HistoryWriter::packetsSaved);
    m_writer->appendBlock(samples(3, m_now, 0, 32, false));
    m_writer->appendBlock(samples(3, m_now + 3200ms, 32, 32));
    QTRY_COMPARE(packets.size(), 1); // woken by itself, once
    QCOMPARE(packets.last(), (QVariantList{3, quint64{2}}));
    m_writer->appendBlock(samples(3, m_now + 6400ms, 64, 32));
    QTRY_COMPARE(packets.size(), 2);
    QCOMPARE(packets.last(), (QVariantList{3, quint64{3}}));
    QCOMPARE(file("Bin/18_02_07_18_33_03_3X.wrd").size(), 128); // a pair holds 2 × 32 × 1 samples
    QCOMPARE(file("Bin/18_02_07_18_33_09_3Y.wrd").size(), 64);
}

void TestHistoryWriter::pairHoldsSrsBufSizeTimesSrsBufToSavePackets_data()
{
    QTest::addColumn<int>("ringPackets");
    QTest::addColumn<int>("packetsToSave");
    QTest::addColumn<QList<qint64>>("sizes"); // of the X files, bytes: 32 samples of 2 a packet
    QTest::newRow("2 × 1") << 2 << 1 << QList<qint64>{128, 128, 128, 64};
    QTest::newRow("3 × 1") << 3 << 1 << QList<qint64>{192, 192, 64};
    QTest::newRow("2 × 3") << 2 << 3 << QList<qint64>{384, 64};
}

/// Seven packets of 3.2 s.
void TestHistoryWriter::pairHoldsSrsBufSizeTimesSrsBufToSavePackets()
{
    QFETCH(int, ringPackets);
    QFETCH(int, packetsToSave);
    m_config.ringPackets = ringPackets;
    m_config.packetsToSave = packetsToSave;
    create(m_config);
    for (int packet = 0; packet < 7; ++packet) {
        m_writer->appendBlock(samples(3, m_now + packet * 3200ms, static_cast<qint16>(32 * packet), 32, packet > 0));
        m_writer->flush();
    }
    QList<qint64> sizes;
    const QDir folder(m_config.folder + QStringLiteral("/Bin"), QStringLiteral("*X.wrd"), QDir::Name);
    for (const QFileInfo &file : folder.entryInfoList()) {
        sizes.append(file.size());
    }
    QTEST(sizes, "sizes");
}

void TestHistoryWriter::impossibleFolderIsToldOnce()
{
    writeAll(m_config.folder, "a file");
    m_writer->start();
    QCOMPARE(m_entries.size(), 1);
    QVERIFY(m_entries.first().kind == JournalKind::Error);
    QVERIFY2(m_entries.first().text.contains(m_config.folder), qPrintable(m_entries.first().text));
    QTRY_VERIFY(m_lines->size() >= 10);
    QCOMPARE(m_entries.size(), 1);
    QVERIFY(QFile::remove(m_config.folder));
    QTRY_COMPARE(m_entries.size(), 2);
    QTRY_COMPARE(file("2018_02_log.txt").count('\n'), 2);
    QCOMPARE(m_entries.last().text, u"The history is being saved again.");
    QVERIFY(file("2018_02_log.txt").startsWith("3 18:33:03 07.02.18   " + m_entries.first().text.toUtf8()));
}

void TestHistoryWriter::fullDiskIsToldOnceAndEventsAreKept()
{
    m_writer->start();
    m_writer->appendBlock(samples(3, m_now, 0, 32));
    QTRY_VERIFY(m_lines->size() >= 2);
    {
        const FileSizeLimit full(1);
        m_writer->appendJournal({JournalKind::On, m_now, QStringLiteral("kept")});
        m_writer->appendBlock(samples(3, m_now + 3200ms, 32, 32));
        QTest::qWait(300);
        QCOMPARE(m_entries.size(), 1);
    }
    m_writer->appendBlock(samples(3, m_now + 6400ms, 64, 32));
    QTRY_COMPARE(m_entries.size(), 2);
    QTRY_COMPARE(file("2018_02_log.txt").count('\n'), 3);
    m_writer->stop();
    QVERIFY(file("2018_02_log.txt").startsWith("1 18:33:03 07.02.18   kept\r\n3 "));
    for (const QByteArray &line : file("2018_02_data.txt").chopped(2).split('\n')) {
        QVERIFY2(line.startsWith("18:33:03 07.02.18\t3330\t") && line.contains(" 0 0111 0000 0000"), line);
    }
    QCOMPARE(file("Bin/18_02_07_18_33_03_3Y.wrd").size(), 64);
    QCOMPARE(file("Bin/18_02_07_18_33_09_3Y.wrd").size(), 64);
}

/// While nothing is tried, the blocks of a healthy pair are lost too: the pair must not go on as if they were there.
void TestHistoryWriter::blockLostByOnePairClosesTheOthers()
{
    m_config.lines.last().sensors.append(accelerometer(4));
    m_config.ringPackets = 100;
    m_config.retryInterval = 200ms;
    create(m_config);
    m_writer->appendBlock(samples(3, m_now, 0, 32));
    m_writer->flush();
    {
        const FailingWrite full(QStringLiteral("_4Y.wrd"), 0);
        m_writer->appendBlock(samples(4, m_now, 0, 32));
        m_writer->flush();
    }
    m_writer->appendBlock(samples(3, m_now + 3200ms, 32, 32));
    m_writer->flush();
    QTest::qWait(250);
    m_writer->appendBlock(samples(3, m_now + 6400ms, 64, 32));
    m_writer->flush();
    QCOMPARE(file("Bin/18_02_07_18_33_03_3X.wrd").size(), 64);
    QCOMPARE(file("Bin/18_02_07_18_33_09_3X.wrd").size(), 64);
    QCOMPARE(QDir(m_config.folder + QStringLiteral("/Bin")).entryList(QDir::Files).size(), 4);
    QCOMPARE(m_entries.size(), 2);
    QVERIFY2(m_entries.first().text.contains(u"18_02_07_18_33_03_4Y.wrd"), qPrintable(m_entries.first().text));
}

void TestHistoryWriter::repairIsTold()
{
    QVERIFY(QDir().mkpath(m_config.folder + QStringLiteral("/Bin")));
    writeAll(m_config.folder + QStringLiteral("/2018_02_data.txt"), "18:33:02 07.02.18\t3330\r\n18:33:0");
    writeAll(m_config.folder + QStringLiteral("/Bin/18_02_07_18_00_00_3X.wrd"), QByteArray(128, 'x'));
    writeAll(m_config.folder + QStringLiteral("/Bin/18_02_07_18_00_00_3Y.wrd"), QByteArray(64, 'x'));
    m_writer->start();
    QCOMPARE(m_entries.size(), 2);
    QVERIFY(entries().first().startsWith(u"18_02_07_18_00_00_3X.wrd"));
    QVERIFY(entries().last().startsWith(u"2018_02_data.txt"));
    QTRY_VERIFY(m_lines->size() >= 2);
    QCOMPARE(m_entries.size(), 2);
    QVERIFY(file("2018_02_data.txt").startsWith("18:33:02 07.02.18\t3330\r\n18:33:03 07.02.18\t3330\t"));
    QCOMPARE(file("Bin/18_02_07_18_00_00_3X.wrd").size(), 64);
}

void TestHistoryWriter::worksInItsOwnThread()
{
    QThread thread;
    auto *writer = new HistoryWriter(m_config, [] { return moscow("2018-02-07T18:33:03"); });
    QSignalSpy lines(writer, &HistoryWriter::dataLineWritten);
    writer->moveToThread(&thread);
    connect(&thread, &QThread::started, writer, &HistoryWriter::start);
    connect(&thread, &QThread::finished, writer, &QObject::deleteLater);
    thread.start();
    for (int i = 0; i < 50; ++i) {
        writer->updateReadings({tiltReading(3, i)});
        writer->appendJournal({JournalKind::Info, m_now, QString::number(i)});
        writer->appendBlock(samples(3, m_now + i * 100ms, static_cast<qint16>(i), 1));
        QThread::msleep(1);
    }
    const qsizetype before = lines.size();
    QTRY_VERIFY(lines.size() >= before + 2); // the second one began after the last reading came
    QMetaObject::invokeMethod(writer, &HistoryWriter::stop, Qt::BlockingQueuedConnection);
    thread.quit();
    QVERIFY(thread.wait(5000));
    QCOMPARE(file("2018_02_log.txt").count('\n'), 50);
    QCOMPARE(file("Bin/18_02_07_18_33_03_3X.wrd").size(), 100);
    QVERIFY(file("2018_02_data.txt").contains("    49.0\t   -49.0\t"));
}

QTEST_GUILESS_MAIN(TestHistoryWriter)
#include "tst_historywriter.moc"
