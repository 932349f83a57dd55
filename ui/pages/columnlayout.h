#pragma once

#include <QList>
#include <QMap>
#include <Qt>

class QSettings;
class QString;

namespace gorizont {

/// What a user made of the columns of a table. What nobody has touched is not listed and keeps its default, so that
/// another language or font still finds columns of the right width. Value.
struct ColumnLayout
{
    QList<int> order; ///< columns of the model from left to right; empty: as in the model
    QMap<int, int> widths; ///< column of the model → device-independent pixels
    int sortColumn = -1; ///< −1: the default order of the rows
    Qt::SortOrder sortOrder = Qt::AscendingOrder;

    bool operator==(const ColumnLayout &) const = default;
};

/// As kept under the name of the table; empty where nothing or nothing usable is kept for \a columns columns.
ColumnLayout readColumnLayout(const QSettings &settings, const QString &table, int columns);
void writeColumnLayout(QSettings &settings, const QString &table, int columns, const ColumnLayout &layout);

} // namespace gorizont
