#include "core/export/export.h"
#include "tests/core/export/keptsite.h"

#include <QPromise>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QThread>
#include <QtTest>

#include <csignal>

#include <sys/resource.h>

using namespace gorizont;
using namespace std::chrono_literals;
using test::reading;
using test::utc;

namespace {

/// From now on no file of this process grows beyond \a bytes, as if the disk were full.
class SmallDisk
{
public:
    explicit SmallDisk(rlim_t bytes)
    {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit small{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallDisk() { setrlimit(RLIMIT_FSIZE, &m_before); }
    Q_DISABLE_COPY_MOVE(SmallDisk)

private:
    rlimit m_before{};
};

} // namespace

/// The export in its own thread: progress, cancel, and what a disk does to it.
class TestExportTask : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        m_request.format = ExportFormat::CsvIso;
        m_request.sensors = {test::inclinometer(2, {})};
        m_request.quantities = {Quantity::TiltX};
        m_request.from = start;
        m_request.to = start + 24h;
        m_request.path = m_folder->filePath(QStringLiteral("out.csv"));
    }

    void runsInItsOwnThread()
    {
        QThread *worker = nullptr;
        ArchiveSource source = site().source();
        source.series = [&worker, inner = source.series](const SeriesQuery &query) {
            worker = QThread::currentThread();
            return inner(query);
        };
        Export task(source);
        QSignalSpy progressed(&task, &Export::progressed);
        QSignalSpy finished(&task, &Export::finished);
        task.start(m_request);
        QVERIFY(task.isRunning());
        QVERIFY(finished.wait());
        QVERIFY(!task.isRunning());
        QVERIFY(worker != nullptr && worker != QThread::currentThread());
        QCOMPARE(progressed.size(), 24);
        QCOMPARE(progressed.last().at(0).toInt(), 100);
        QCOMPARE(progressed.last().at(1).toULongLong(), quint64(24 * 60));
        const auto result = finished.first().first().value<ExportResult>();
        QCOMPARE(result.files, QStringList(m_request.path));
        QCOMPARE(test::contentOf(m_request.path).count('\n'), 24 * 60 + 1);
    }

    /// What stood there before stays as it was, whatever the source is doing at the moment.
    void cancelLeavesNothing()
    {
        writeOld();
        QPromise<QList<Series>> never;
        never.start();
        ArchiveSource source = site().source();
        source.series = [&never, this, inner = source.series](const SeriesQuery &query) {
            return query.from > start + 3h ? never.future() : inner(query);
        };
        Export task(source);
        QSignalSpy progressed(&task, &Export::progressed);
        QSignalSpy finished(&task, &Export::finished);
        task.start(m_request);
        QTRY_COMPARE(progressed.size(), 4);
        task.cancel();
        QVERIFY(finished.wait());
        const auto result = finished.first().first().value<ExportResult>();
        QVERIFY(result.isCancelled);
        QCOMPARE(result.failure, QString());
        QCOMPARE(result.files, QStringList());
        QCOMPARE(entries(), QStringList(QStringLiteral("out.csv")));
        QCOMPARE(test::contentOf(m_request.path), QByteArray("old"));
    }

    void goesWithItsOwner()
    {
        QPromise<QList<Series>> never;
        never.start();
        ArchiveSource source;
        source.series = [&never](const SeriesQuery &) { return never.future(); };
        auto task = std::make_unique<Export>(source);
        task->start(m_request);
        task.reset();
        QCOMPARE(entries(), QStringList());
    }

    void sourceGoes()
    {
        ArchiveSource source;
        source.series = [](const SeriesQuery &) {
            QPromise<QList<Series>> promise;
            promise.start();
            const auto future = promise.future();
            promise.future().cancel();
            promise.finish();
            return future;
        };
        ExportWatch watch;
        QCOMPARE(
            runExport(m_request, source, watch).failure,
            QStringLiteral("The archive was closed or could not be read before the export was complete: try again."));
        QCOMPARE(entries(), QStringList());
    }

    /// At whatever byte the disk is full: one sentence, and what stood there before is untouched.
    void fullDisk()
    {
        writeOld();
        ExportWatch watch;
        const ArchiveSource source = site().source();
        for (const rlim_t bytes : {0, 1, 100, 16384, 30000, 50000}) {
            const SmallDisk disk(bytes);
            const ExportResult result = runExport(m_request, source, watch);
            QVERIFY2(
                result.failure.startsWith(m_request.path + QStringLiteral(" cannot be written (")),
                qPrintable(result.failure));
            QVERIFY(result.failure.endsWith(QStringLiteral("): make room on the disk, or choose another folder.")));
            QCOMPARE(result.files, QStringList());
            QCOMPARE(entries(), QStringList(QStringLiteral("out.csv")));
            QCOMPARE(test::contentOf(m_request.path), QByteArray("old"));
        }
        QCOMPARE(runExport(m_request, source, watch).rows, quint64(24 * 60));
        QVERIFY(test::contentOf(m_request.path).size() > 50000);
    }

    void noSuchFolder()
    {
        m_request.path = m_folder->filePath(QStringLiteral("none/out.csv"));
        ExportWatch watch;
        const ExportResult result = runExport(m_request, site().source(), watch);
        QVERIFY(result.failure.startsWith(m_request.path + QStringLiteral(" cannot be written (")));
    }

private:
    /// A reading a minute.
    test::KeptSite site() const
    {
        Series series{{2, Quantity::TiltX}, {}, {}, {}};
        for (int minute = 0; minute < 24 * 60; ++minute) {
            series.buckets << reading(start + minute * 1min, 12345.678 + minute);
        }
        test::KeptSite kept;
        kept.series = {series};
        return kept;
    }

    void writeOld() const
    {
        QFile file(m_request.path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("old") == 3);
    }

    QStringList entries() const
    {
        return QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }

    const UtcTime start = utc("2018-02-07T00:00:00.000Z");
    std::unique_ptr<QTemporaryDir> m_folder;
    ExportRequest m_request;
};

QTEST_GUILESS_MAIN(TestExportTask)
#include "tst_exporttask.moc"
