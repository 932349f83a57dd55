#pragma once

class QSettings;
class QWidget;

namespace gorizont {

/// The columns of all tables within \a part, kept under the names of the tables.
void keepTables(QSettings &settings, const QWidget &part);
void restoreTables(const QSettings &settings, const QWidget &part);

/// How the splitters within \a part are divided, kept under their names; one without a name is left out.
void keepSplitters(QSettings &settings, const QWidget &part);
void restoreSplitters(const QSettings &settings, const QWidget &part);

} // namespace gorizont
