#pragma once

#include "core/archive/archivedatabase.h"

class QSqlError;

namespace gorizont {

/// Why the server did not do what it was asked for. Pure.
ArchiveFault postgreSqlFault(const QSqlError &error);

/// What the server said when it did not let the program in; empty: it said nothing, there is no connection.
QString postgreSqlRefusal(const QSqlError &error);

/// Options of a connection on which nothing waits for a server that is gone longer than some seconds.
QString postgreSqlOptions();

/// The statements with which a connection begins, so that the server too forgets the one that is gone.
QStringList postgreSqlSetup(ArchiveDatabase::Access access);

} // namespace gorizont
