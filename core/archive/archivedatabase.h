#pragma once

#include "core/archive/archiveconfig.h"

#include <QCoreApplication>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QVariantList>

#include <map>

namespace gorizont {

/// Why the store did not do what it was asked for.
enum class ArchiveFault : quint8 {
    None,
    Busy, ///< another program holds it
    Full, ///< no room on the disk
    Damaged, ///< what is in it makes no sense
    Denied, ///< it cannot be opened or written
    Gone, ///< the server does not answer
    TooNew, ///< written by a newer version of the program
    Empty, ///< there is no archive in it yet
    Other,
};

/// One connection to the archive's database, with its statements. Lives on the thread that opens it.
class ArchiveDatabase
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::ArchiveDatabase)

public:
    enum class Access : quint8 {
        Write,
        Read,
        Salvage, ///< reads a file that may be damaged
    };

    ArchiveDatabase(const ArchiveConfig &config, Access access);
    ~ArchiveDatabase();
    Q_DISABLE_COPY_MOVE(ArchiveDatabase)

    /// Write: creates the file, and brings the tables to the version that this program knows.
    bool open();
    void close();
    bool isOpen() const { return m_isOpen; }

    bool begin();
    bool commit();
    void rollback();

    /// The statement, executed with \a values; it stays prepared. Null: it failed.
    QSqlQuery *run(const QString &sql, const QVariantList &values = {});
    /// After the last row of \a rows, which run() returned: no error ended them. False: see fault().
    bool isWhole(const QSqlQuery *rows);
    /// A statement of which nothing is kept.
    bool execute(const QString &sql);
    /// The first column of the first row; invalid: there is none, or it failed, see fault().
    QVariant single(const QString &sql, const QVariantList &values = {});

    ArchiveFault fault() const { return m_fault; } ///< of the last statement
    QString error() const { return m_error; } ///< one sentence, of the last failure
    const ArchiveConfig &config() const { return m_config; }
    bool isSqlite() const { return m_config.driver == ArchiveDriver::Sqlite; }

    /// The version of the tables that this program writes.
    static int schemaVersion();

private:
    bool prepareFolder();
    bool configure();
    bool configureServer();
    bool migrate();
    bool fail(const QSqlError &error);
    bool fail(ArchiveFault fault, const QString &sentence);
    QString name() const;

    const ArchiveConfig m_config;
    const Access m_access;
    const QString m_connection;
    QSqlDatabase m_database;
    std::map<QString, QSqlQuery> m_statements; ///< by their text
    bool m_isOpen = false;
    ArchiveFault m_fault = ArchiveFault::None;
    QString m_error;
};

} // namespace gorizont
