#include "tests/core/archive/archivesite.h"

#include <QDir>
#include <QProcess>
#include <QTcpServer>
#include <QTest>

#include <unistd.h>

using namespace gorizont;
using namespace gorizont::test;
using namespace std::chrono_literals;

namespace {

/// A server of its own in a folder of its own, on this computer only. It refuses to be root.
class PostgresServer
{
public:
    bool create()
    {
        const QStringList versions =
            QDir(QStringLiteral("/usr/lib/postgresql")).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
        if (versions.isEmpty()) {
            return false;
        }
        m_programs = QStringLiteral("/usr/lib/postgresql/%1/bin/").arg(versions.last());
        QTcpServer probe;
        probe.listen(QHostAddress::LocalHost);
        m_port = probe.serverPort();
        probe.close();
        const QString owner = ::geteuid() == 0 ? QStringLiteral("postgres:") : QString();
        return (owner.isEmpty() || QProcess::execute(QStringLiteral("chown"), {owner, m_folder.path()}) == 0)
            && run(QStringLiteral("initdb"),
                   {QStringLiteral("-D"), data(), QStringLiteral("-A"), QStringLiteral("trust"), QStringLiteral("-U"),
                    QStringLiteral("tower"), QStringLiteral("-N")});
    }
    ~PostgresServer() { stop(); }

    bool start()
    {
        const QString options = QStringLiteral("-p %1 -h 127.0.0.1 -k %2 -F").arg(m_port).arg(m_folder.path());
        return run(
            QStringLiteral("pg_ctl"),
            {QStringLiteral("-D"), data(), QStringLiteral("-w"), QStringLiteral("-l"),
             m_folder.filePath(QStringLiteral("log")), QStringLiteral("-o"), options, QStringLiteral("start")});
    }
    bool stop()
    {
        return run(
            QStringLiteral("pg_ctl"),
            {QStringLiteral("-D"), data(), QStringLiteral("-w"), QStringLiteral("-m"), QStringLiteral("immediate"),
             QStringLiteral("stop")});
    }

    ArchiveConfig config(const QString &site) const
    {
        ArchiveConfig config = archiveConfig({});
        config.driver = ArchiveDriver::PostgreSql;
        config.host = QStringLiteral("127.0.0.1");
        config.port = m_port;
        config.database = QStringLiteral("postgres");
        config.user = QStringLiteral("tower");
        config.site = site;
        return config;
    }

private:
    QString data() const { return m_folder.filePath(QStringLiteral("data")); }
    bool run(const QString &program, const QStringList &arguments)
    {
        QProcess process;
        process.setWorkingDirectory(QStringLiteral("/"));
        process.setStandardOutputFile(QProcess::nullDevice());
        process.setStandardErrorFile(QProcess::nullDevice());
        if (::geteuid() == 0) {
            process.start(
                QStringLiteral("runuser"),
                QStringList{
                    QStringLiteral("-u"), QStringLiteral("postgres"), QStringLiteral("--"), m_programs + program}
                    + arguments);
        } else {
            process.start(m_programs + program, arguments);
        }
        return process.waitForFinished(60'000) && process.exitCode() == 0;
    }

    QTemporaryDir m_folder;
    QString m_programs;
    quint16 m_port = 0;
};

} // namespace

class TestArchivePostgres : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void keepsEveryReadingOfTwoSites();
    void waitsForAServerThatIsAway();

private:
    PostgresServer m_server;
};

void TestArchivePostgres::initTestCase()
{
    if (!m_server.create()) {
        QSKIP("There is no PostgreSQL server here, or it cannot make its files.");
    }
    QVERIFY(m_server.start());
}

void TestArchivePostgres::keepsEveryReadingOfTwoSites()
{
    ArchiveBench one(m_server.config(QStringLiteral("tower 1")));
    ArchiveBench two(m_server.config(QStringLiteral("tower 2")));
    one.open(noon);
    two.open(noon);
    for (int second = 1; second <= 1300; ++second) {
        one.read(1, noon + second * 1s, second);
        if (second % 20 == 0) {
            one.writer->flush();
        }
    }
    two.read(1, noon + 1s, -256);
    one.writer->appendJournal({JournalKind::Info, noon, QStringLiteral("мост"), 1, 2});
    one.writer->appendBlock(sampleBlock(noon, 5, 32));
    one.close();
    two.close();
    const Buckets all = one.fullRate({1, Quantity::TiltX}, noon, noon + 1h);
    QCOMPARE(all.size(), 1300);
    QCOMPARE(all.at(77).mean, 78 / 256.0);
    QCOMPARE(one.ask({1, Quantity::TiltX}, noon, noon + 20min, 20).buckets.at(3).count, 60U);
    ArchiveQuery query(one.config);
    QCOMPARE(query.events(noon, noon + 1h, 5).value(0).text, QStringLiteral("мост"));
    QCOMPARE(query.blocks(3, noon, noon + 1h).value(0).x, sampleBlock(noon, 5, 32).x);
    QCOMPARE(two.fullRate({1, Quantity::TiltX}, noon, noon + 1h), (Buckets{{noon + 1s, -1, -1, -1, 1, 1}}));
    QCOMPARE(one.sentences, QStringList());
}

/// Nothing is lost and nothing comes twice.
void TestArchivePostgres::waitsForAServerThatIsAway()
{
    ArchiveBench bench(m_server.config(QStringLiteral("away")));
    bench.open(noon);
    for (int second = 1; second <= 900; ++second) {
        bench.read(1, noon + second * 1s, second);
        if (second == 300) {
            bench.writer->flush();
            QVERIFY(m_server.stop());
        }
        if (second == 700) {
            QVERIFY(m_server.start());
        }
        if (second % 50 == 0) {
            bench.writer->flush();
        }
    }
    bench.close();
    QCOMPARE(bench.sentences.size(), 2);
    QVERIFY2(bench.sentences.first().contains(QStringLiteral("does not answer")), qPrintable(bench.sentences.first()));
    const Buckets all = bench.fullRate({1, Quantity::TiltX}, noon, noon + 1h);
    QCOMPARE(all.size(), 900);
    for (qsizetype i = 0; i < all.size(); ++i) {
        QVERIFY(all.at(i).from == noon + (i + 1) * 1s);
    }
}

QTEST_GUILESS_MAIN(TestArchivePostgres)

#include "tst_archivepostgres.moc"
