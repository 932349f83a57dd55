#include "core/archive/archivedatabase.h"

#include "core/archive/archiveschema.h"
#include "core/archive/postgresql.h"

#include <QDir>
#include <QFileInfo>
#include <QSqlError>

#include <atomic>

namespace gorizont {

namespace {

using Qt::Literals::StringLiterals::operator""_s;

QString freshName()
{
    static std::atomic<int> last{0};
    return u"archive %1"_s.arg(++last);
}

/// https://www.sqlite.org/rescode.html, the low byte.
ArchiveFault sqliteFault(int code)
{
    switch (code & 0xFF) {
    case 5: // SQLITE_BUSY
    case 6: // SQLITE_LOCKED
        return ArchiveFault::Busy;
    case 11: // SQLITE_CORRUPT
    case 26: // SQLITE_NOTADB
        return ArchiveFault::Damaged;
    case 13: // SQLITE_FULL
        return ArchiveFault::Full;
    case 3: // SQLITE_PERM
    case 8: // SQLITE_READONLY
    case 14: // SQLITE_CANTOPEN
        return ArchiveFault::Denied;
    default: return ArchiveFault::Other;
    }
}

QString quotedName(const QString &name)
{
    return u'"' + QString(name).replace(u'"', u"\"\""_s) + u'"';
}

} // namespace

ArchiveDatabase::ArchiveDatabase(const ArchiveConfig &config, Access access)
    : m_config(config)
    , m_access(access)
    , m_connection(freshName())
{
}

ArchiveDatabase::~ArchiveDatabase()
{
    close();
}

int ArchiveDatabase::schemaVersion()
{
    return static_cast<int>(archiveMigrations(ArchiveDriver::Sqlite).size());
}

bool ArchiveDatabase::open()
{
    close();
    if (isSqlite() && m_access == Access::Write && !prepareFolder()) {
        return false;
    }
    if (!isSqlite() && !QSqlDatabase::isDriverAvailable(u"QPSQL"_s)) {
        return fail(ArchiveFault::Denied, tr("The driver for PostgreSQL is missing. Install libqt6sql6-psql."));
    }
    m_database = QSqlDatabase::addDatabase(isSqlite() ? u"QSQLITE"_s : u"QPSQL"_s, m_connection);
    if (isSqlite()) {
        m_database.setDatabaseName(m_config.file);
        m_database.setConnectOptions(
            m_access != Access::Write ? u"QSQLITE_BUSY_TIMEOUT=2000;QSQLITE_OPEN_READONLY"_s
                                      : u"QSQLITE_BUSY_TIMEOUT=2000"_s);
    } else {
        m_database.setHostName(m_config.host);
        m_database.setPort(m_config.port);
        m_database.setDatabaseName(m_config.database);
        m_database.setUserName(m_config.user);
        m_database.setPassword(m_config.password);
        m_database.setConnectOptions(postgreSqlOptions());
    }
    m_isOpen = m_database.open();
    if (!m_isOpen) {
        fail(m_database.lastError());
        close();
        return false;
    }
    if (!configure() || (m_access != Access::Salvage && !migrate())) {
        const auto fault = m_fault;
        const QString error = m_error;
        close();
        return fail(fault, error);
    }
    return true;
}

void ArchiveDatabase::close()
{
    m_statements.clear();
    m_isOpen = false;
    if (m_database.isValid()) {
        m_database.close();
        m_database = QSqlDatabase();
        QSqlDatabase::removeDatabase(m_connection);
    }
}

bool ArchiveDatabase::prepareFolder()
{
    const QString folder = QFileInfo(m_config.file).absolutePath();
    return QDir().mkpath(folder)
        || fail(
               ArchiveFault::Denied,
               tr("The folder %1 cannot be created. Check the rights and the name.")
                   .arg(QDir::toNativeSeparators(folder)));
}

bool ArchiveDatabase::configure()
{
    if (!isSqlite()) {
        return configureServer();
    }
    if (m_access != Access::Write) {
        return true;
    }
    // Large pages: chunks are a few thousand bytes, and what is left of a page behind them is lost. FULL: a commit survives a power cut. Freed pages are given back a few at a time, when old data goes.
    return execute(u"PRAGMA page_size=16384"_s) && execute(u"PRAGMA auto_vacuum=INCREMENTAL"_s)
        && execute(u"PRAGMA journal_mode=WAL"_s) && execute(u"PRAGMA synchronous=FULL"_s)
        && execute(u"PRAGMA cache_size=-8192"_s) && execute(u"PRAGMA journal_size_limit=16777216"_s);
}

/// One site is one schema, and one program writes into it at a time.
bool ArchiveDatabase::configureServer()
{
    constexpr int archiveLocks = 0x67727a74;
    const QString schema = quotedName(m_config.site);
    for (const QString &statement : postgreSqlSetup(m_access)) {
        if (!execute(statement)) {
            return false;
        }
    }
    if (m_access == Access::Write) {
        const QVariant isFree = single(u"SELECT pg_try_advisory_lock(?, hashtext(?))"_s, {archiveLocks, m_config.site});
        if (!isFree.toBool()) {
            return isFree.isValid()
                && fail(ArchiveFault::Busy, tr("%1 is in use by another program. Close that program.").arg(name()));
        }
        // Who may use a schema need not have the right to create one.
        const QVariant count = single(u"SELECT count(*) FROM pg_namespace WHERE nspname = ?"_s, {m_config.site});
        if (!count.isValid() || (count.toInt() == 0 && !execute(u"CREATE SCHEMA "_s + schema))) {
            return false;
        }
    }
    return execute(u"SET search_path TO "_s + schema);
}

bool ArchiveDatabase::migrate()
{
    const QString tables = isSqlite() ? u"SELECT count(*) FROM sqlite_master WHERE name = 'meta'"_s
                                      : u"SELECT count(*) FROM information_schema.tables WHERE table_name = 'meta' "
                                        "AND table_schema = current_schema()"_s;
    const QVariant hasMeta = single(tables);
    if (!hasMeta.isValid()) {
        return false;
    }
    const int version = hasMeta.toInt() == 0 ? 0 : single(u"SELECT value FROM meta WHERE name = 'schema'"_s).toInt();
    if (m_fault != ArchiveFault::None) {
        return false;
    }
    const QList<QStringList> &steps = archiveMigrations(m_config.driver);
    if (version > steps.size()) {
        return fail(
            ArchiveFault::TooNew,
            tr("%1 was written by a newer version of the program. Install that one, or name another file.")
                .arg(name()));
    }
    if (version == steps.size() || m_access == Access::Read) {
        return version > 0 || fail(ArchiveFault::Empty, tr("%1 holds no archive.").arg(name()));
    }
    bool isGood = begin();
    for (qsizetype step = version; step < steps.size(); ++step) {
        for (const QString &statement : steps.at(step)) {
            isGood = isGood && execute(statement);
        }
    }
    isGood = isGood && execute(u"DELETE FROM meta WHERE name = 'schema'"_s)
        && execute(u"INSERT INTO meta (name, value) VALUES ('schema', %1)"_s.arg(steps.size())) && commit();
    if (!isGood) {
        rollback();
    }
    return isGood;
}

bool ArchiveDatabase::begin()
{
    return execute(u"BEGIN"_s);
}

bool ArchiveDatabase::commit()
{
    return execute(u"COMMIT"_s);
}

void ArchiveDatabase::rollback()
{
    for (auto &[text, statement] : m_statements) {
        statement.finish();
    }
    QSqlQuery(m_database).exec(u"ROLLBACK"_s);
}

QSqlQuery *ArchiveDatabase::run(const QString &sql, const QVariantList &values)
{
    auto found = m_statements.find(sql);
    if (found == m_statements.end()) {
        QSqlQuery query(m_database);
        query.setForwardOnly(true);
        if (!query.prepare(sql)) {
            fail(query.lastError());
            return nullptr;
        }
        found = m_statements.emplace(sql, std::move(query)).first;
    }
    QSqlQuery &query = found->second;
    for (qsizetype i = 0; i < values.size(); ++i) {
        query.bindValue(static_cast<int>(i), values.at(i));
    }
    if (!query.exec()) {
        fail(query.lastError());
        query.finish();
        return nullptr;
    }
    m_fault = ArchiveFault::None;
    return &query;
}

bool ArchiveDatabase::isWhole(const QSqlQuery *rows)
{
    return rows && (!rows->lastError().isValid() || fail(rows->lastError()));
}

bool ArchiveDatabase::execute(const QString &sql)
{
    QSqlQuery query(m_database);
    return query.exec(sql) || fail(query.lastError());
}

QVariant ArchiveDatabase::single(const QString &sql, const QVariantList &values)
{
    QSqlQuery *query = run(sql, values);
    if (!query) {
        return {};
    }
    QVariant value;
    if (query->next()) {
        value = query->value(0);
    } else {
        isWhole(query);
    }
    query->finish();
    return value;
}

bool ArchiveDatabase::fail(const QSqlError &error)
{
    const auto fault = isSqlite() ? sqliteFault(error.nativeErrorCode().toInt()) : postgreSqlFault(error);
    const QString refusal = isSqlite() ? QString() : postgreSqlRefusal(error);
    if (fault == ArchiveFault::Denied && !refusal.isEmpty()) {
        return fail(
            fault, tr("%1 refuses: %2. Check User, PasswordFile and Database of [Archive].").arg(name(), refusal));
    }
    switch (fault) {
    case ArchiveFault::Busy: return fail(fault, tr("%1 is in use by another program. Close that program.").arg(name()));
    case ArchiveFault::Full:
        return fail(fault, tr("There is no room left for %1. Free some on that disk.").arg(name()));
    case ArchiveFault::Damaged: return fail(fault, tr("%1 is damaged.").arg(name()));
    case ArchiveFault::Denied:
        return fail(fault, tr("%1 cannot be opened for writing. Check the rights and the name.").arg(name()));
    case ArchiveFault::Gone:
        return fail(fault, tr("%1 does not answer. Check the server and the network.").arg(name()));
    default: return fail(fault, tr("%1: %2").arg(name(), error.databaseText().simplified()));
    }
}

bool ArchiveDatabase::fail(ArchiveFault fault, const QString &sentence)
{
    m_fault = fault;
    m_error = sentence;
    return false;
}

QString ArchiveDatabase::name() const
{
    return isSqlite() ? QDir::toNativeSeparators(m_config.file)
                      : u"%1:%2/%3 (%4)"_s.arg(m_config.host).arg(m_config.port).arg(m_config.database, m_config.site);
}

} // namespace gorizont
