#include "ui/pages/roworder.h"

namespace gorizont {

RowOrder::RowOrder(QAbstractItemModel *source, int sortRole, QObject *parent)
    : QSortFilterProxyModel(parent)
{
    setSortRole(sortRole);
    setSourceModel(source);
}

bool RowOrder::lessThan(const QModelIndex &left, const QModelIndex &right) const
{
    const QVariant a = left.data(sortRole());
    const QVariant b = right.data(sortRole());
    if (!a.isValid() || !b.isValid()) {
        return sortOrder() == Qt::AscendingOrder ? a.isValid() && !b.isValid() : b.isValid() && !a.isValid();
    }
    return QVariant::compare(a, b) == QPartialOrdering::Less;
}

} // namespace gorizont
