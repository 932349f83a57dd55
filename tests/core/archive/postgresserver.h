#pragma once

#include "core/archive/archiveconfig.h"

#include <QProcess>
#include <QTemporaryDir>

namespace gorizont::test {

/// A PostgreSQL server of its own in a folder of its own, on a loopback port, with a database for a user that has no
/// other rights. Ends with the test. It refuses to run for root: then it runs for `postgres` or `nobody`.
class PostgresServer
{
public:
    PostgresServer();
    ~PostgresServer();
    Q_DISABLE_COPY_MOVE(PostgresServer)

    /// Why it cannot be started here; empty: it can.
    static QString whyNot();

    /// Makes folder, user and database. False: see error().
    bool create();
    bool start();
    void stop(); ///< open connections are broken
    void crash(); ///< without any order

    /// What \a sql says, as the owner of the server; rows are lines.
    QString ask(const QString &sql);

    /// For \a site; \a file is where the spool of the site is.
    ArchiveConfig config(const QString &site, const QString &file) const;
    QString error() const { return m_error; }

private:
    bool run(const QString &program, const QStringList &arguments);
    void start(QProcess &process, const QString &program, const QStringList &arguments) const;
    void end(int signal);

    QTemporaryDir m_folder;
    QProcess m_server;
    int m_port = 0;
    QString m_output;
    QString m_error;
};

} // namespace gorizont::test
