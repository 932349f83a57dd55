#include "tests/core/archive/postgresserver.h"

#include "tests/core/archive/archivesite.h"

#include <QDir>
#include <QElapsedTimer>
#include <QSqlDatabase>
#include <QTcpServer>
#include <QThread>

#include <csignal>
#include <pwd.h>
#include <unistd.h>

namespace gorizont::test {

namespace {

constexpr int patience = 120'000; // ms, for a machine that is busy

/// The newest one of Debian's; empty: none.
QString binaries()
{
    const QDir versions(QStringLiteral("/usr/lib/postgresql"));
    const QStringList names = versions.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name | QDir::Reversed);
    for (const QString &name : names) {
        const QString folder = versions.filePath(name + QStringLiteral("/bin/"));
        if (QFile::exists(folder + QStringLiteral("postgres")) && QFile::exists(folder + QStringLiteral("initdb"))) {
            return folder;
        }
    }
    return {};
}

/// Who runs the server when root runs the test.
const passwd *otherUser()
{
    const passwd *user = ::getpwnam("postgres");
    return user ? user : ::getpwnam("nobody");
}

int freePort()
{
    QTcpServer server;
    server.listen(QHostAddress::LocalHost);
    return server.serverPort();
}

bool write(const QString &path, const QByteArray &content)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(content) == content.size();
}

} // namespace

PostgresServer::PostgresServer() = default;

PostgresServer::~PostgresServer()
{
    end(SIGQUIT);
}

QString PostgresServer::whyNot()
{
    if (binaries().isEmpty()) {
        return QStringLiteral("There is no PostgreSQL server here (package postgresql).");
    }
    return QSqlDatabase::isDriverAvailable(QStringLiteral("QPSQL"))
        ? QString()
        : QStringLiteral("Qt has no driver for PostgreSQL here (package libqt6sql6-psql).");
}

bool PostgresServer::create()
{
    const QString password = m_folder.filePath(QStringLiteral("password"));
    if (!write(password, "owner\n")) {
        m_error = QStringLiteral("the folder cannot be written");
        return false;
    }
    if (::geteuid() == 0) {
        for (const QString &path : {m_folder.path(), password}) {
            if (::chown(QFile::encodeName(path).constData(), otherUser()->pw_uid, otherUser()->pw_gid) != 0) {
                m_error = QStringLiteral("the folder cannot be given away");
                return false;
            }
        }
    }
    return run(QStringLiteral("initdb"),
               {QStringLiteral("-D"), m_folder.filePath(QStringLiteral("data")), QStringLiteral("-U"),
                QStringLiteral("owner"), QStringLiteral("--pwfile"), password, QStringLiteral("-A"),
                QStringLiteral("scram-sha-256"), QStringLiteral("-E"), QStringLiteral("UTF8"),
                QStringLiteral("--no-locale"), QStringLiteral("-N")})
        && start() && !ask(QStringLiteral("CREATE ROLE gorizont LOGIN PASSWORD 'secret'")).isNull()
        && !ask(QStringLiteral("CREATE DATABASE buildings OWNER gorizont")).isNull();
}

bool PostgresServer::start()
{
    m_port = m_port == 0 ? freePort() : m_port;
    m_server.setProcessChannelMode(QProcess::MergedChannels);
    m_server.setStandardOutputFile(m_folder.filePath(QStringLiteral("log")), QIODevice::Append);
    start(
        m_server, QStringLiteral("postgres"),
        {QStringLiteral("-D"), m_folder.filePath(QStringLiteral("data")), QStringLiteral("-k"), m_folder.path(),
         QStringLiteral("-p"), QString::number(m_port), QStringLiteral("-c"),
         QStringLiteral("listen_addresses=127.0.0.1"), QStringLiteral("-c"), QStringLiteral("fsync=off")});
    QElapsedTimer timer;
    timer.start();
    while (m_server.state() != QProcess::NotRunning && timer.elapsed() < patience) {
        if (!ask(QStringLiteral("SELECT 1")).isNull()) {
            return true;
        }
        m_server.waitForFinished(50);
    }
    QFile log(m_folder.filePath(QStringLiteral("log")));
    m_error = log.open(QIODevice::ReadOnly) ? QString::fromUtf8(log.readAll()) : m_server.errorString();
    return false;
}

void PostgresServer::stop()
{
    end(SIGINT);
}

void PostgresServer::crash()
{
    end(SIGQUIT);
}

void PostgresServer::end(int signal)
{
    if (m_server.state() != QProcess::NotRunning) {
        ::kill(static_cast<pid_t>(m_server.processId()), signal);
        m_server.waitForFinished(patience);
    }
}

QString PostgresServer::ask(const QString &sql)
{
    const QString database = sql.contains(u"site_") ? QStringLiteral("buildings") : QStringLiteral("postgres");
    const bool isGood =
        run(QStringLiteral("psql"),
            {QStringLiteral("-XAtq"), QStringLiteral("-d"),
             QStringLiteral("host=127.0.0.1 port=%1 user=owner password=owner dbname=%2").arg(m_port).arg(database),
             QStringLiteral("-c"), sql});
    return isGood ? QStringLiteral("%1").arg(m_output.trimmed()) : QString();
}

bool PostgresServer::run(const QString &program, const QStringList &arguments)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    start(process, program, arguments);
    const bool isGood =
        process.waitForFinished(patience) && process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
    m_output = QStringLiteral("") + QString::fromUtf8(process.readAll());
    if (!isGood) {
        m_error = m_output;
    }
    return isGood;
}

void PostgresServer::start(QProcess &process, const QString &program, const QStringList &arguments) const
{
    QStringList all{QStringLiteral("--pdeathsig"), QStringLiteral("QUIT")};
    if (::geteuid() == 0) {
        all << QStringLiteral("--reuid") << QString::number(otherUser()->pw_uid) << QStringLiteral("--regid")
            << QString::number(otherUser()->pw_gid) << QStringLiteral("--clear-groups");
    }
    process.setWorkingDirectory(m_folder.path());
    process.start(QStringLiteral("setpriv"), all << binaries() + program << arguments);
}

ArchiveConfig PostgresServer::config(const QString &site, const QString &file) const
{
    ArchiveConfig config = archiveConfig(file);
    config.driver = ArchiveDriver::PostgreSql;
    config.host = QStringLiteral("127.0.0.1");
    config.port = m_port;
    config.database = QStringLiteral("buildings");
    config.user = QStringLiteral("gorizont");
    config.password = QStringLiteral("secret");
    config.site = site;
    return config;
}

} // namespace gorizont::test
