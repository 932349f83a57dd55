#include "core/archive/postgresql.h"

#include <QRegularExpression>
#include <QSqlError>

namespace gorizont {

using Qt::Literals::StringLiterals::operator""_s;

/// https://www.postgresql.org/docs/15/errcodes-appendix.html, the classes.
ArchiveFault postgreSqlFault(const QSqlError &error)
{
    const QString code = error.nativeErrorCode();
    if (error.type() == QSqlError::ConnectionError) {
        return postgreSqlRefusal(error).isEmpty() ? ArchiveFault::Gone : ArchiveFault::Denied;
    }
    if (code.isEmpty() || code.startsWith(u"08") || code.startsWith(u"57P")) {
        return ArchiveFault::Gone;
    }
    return code == u"53100"         ? ArchiveFault::Full
        : code.startsWith(u"42501") ? ArchiveFault::Denied
                                    : ArchiveFault::Other;
}

/// The server writes in its own language; only it puts two blanks after the colon of "FATAL:".
QString postgreSqlRefusal(const QSqlError &error)
{
    static const QRegularExpression pattern(uR"((?:^|\s)\S+:  (\S[^\n]*))"_s);
    static const QRegularExpression passing(u"the database system is|terminating connection|too many clients"_s);
    const QString text = error.databaseText();
    const QRegularExpressionMatch match = pattern.match(text);
    return match.hasMatch() && !passing.match(text).hasMatch() ? match.captured(1).trimmed() : QString();
}

QString postgreSqlOptions()
{
    return u"connect_timeout=2;tcp_user_timeout=10000;keepalives_idle=10;keepalives_interval=5;keepalives_count=3;"
           "application_name=gorizont"_s;
}

QStringList postgreSqlSetup(ArchiveDatabase::Access access)
{
    QStringList statements{
        u"SET client_min_messages TO warning"_s, u"SET tcp_keepalives_idle TO 10"_s,
        u"SET tcp_keepalives_interval TO 5"_s, u"SET tcp_keepalives_count TO 3"_s};
    if (access == ArchiveDatabase::Access::Write) {
        statements.append(u"SET synchronous_commit TO on"_s);
    } else {
        // All statements of one answer see the same rows.
        statements.append(u"SET SESSION CHARACTERISTICS AS TRANSACTION ISOLATION LEVEL REPEATABLE READ"_s);
        // A question that takes longer keeps old rows alive on the server, and those who ask the next one waiting.
        statements.append(u"SET statement_timeout TO '60s'"_s);
    }
    return statements;
}

} // namespace gorizont
