#pragma once

#include <QSortFilterProxyModel>

namespace gorizont {

/// The rows of a table as clicks on headings sort them: by the values of the sort role, numbers in order of size, and
/// what is absent last in either direction. GUI thread.
class RowOrder : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    /// An invalid value of \a sortRole: absent.
    RowOrder(QAbstractItemModel *source, int sortRole, QObject *parent);

protected:
    bool lessThan(const QModelIndex &left, const QModelIndex &right) const override;
};

} // namespace gorizont
