#pragma once

#include <QList>
#include <QString>

class QHeaderView;
class QAbstractItemModel;

namespace gorizont {

/// What is copied from a table: lines of TAB-separated fields, columns as they stand on the screen, hidden ones left
/// out. Pure.
namespace tabletext {

QString cell(const QString &text); ///< one field: nothing in it ends the field or the line
QString headings(const QHeaderView &header);
QString rows(const QHeaderView &header, const QList<int> &rows);

} // namespace tabletext

} // namespace gorizont
