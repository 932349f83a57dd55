#pragma once

#include "ui/pages/columnlayout.h"

#include <QFont>
#include <QObject>
#include <QSet>

#include <optional>

class QHeaderView;
class QTableView;

namespace gorizont {

/// The columns of a table: their default widths, the one that takes what the others leave, and what the user made of
/// them. Cells are never measured. GUI thread.
class TableColumns : public QObject
{
    Q_OBJECT

public:
    static constexpr int sideMargin = 6; ///< between a text and the edge of its cell or heading, pixels

    explicit TableColumns(QTableView *table);

    /// The font of the cells where a model without rows cannot tell it; before the samples.
    void setCellFont(const QFont &font) { m_cellFont = font; }

    /// Default width of a column: its heading and the widest text it is going to hold. May be told again.
    void setSample(int column, const QString &widest);

    /// The same for all columns that get no sample of their own; \a like is one of them.
    void setCommonSample(int like, const QString &widest);

    /// Column \a column takes what the others leave, but never less than \a least needs: then the table scrolls.
    void setElastic(int column, const QString &least);

    /// The table is sorted by clicks on headings, by this column until then.
    void setDefaultSort(int column, Qt::SortOrder order = Qt::AscendingOrder);

    /// Call when the width of the table has changed.
    void stretch();

    ColumnLayout layout() const;
    void setLayout(const ColumnLayout &layout); ///< what it does not list becomes as it was made
    void restore() { setLayout({}); }

private:
    QHeaderView *header() const;
    int sampleWidth(int column, const QString &widest) const;
    void onResized(int column);

    QTableView *m_table;
    std::optional<QFont> m_cellFont; ///< empty: the model tells it
    QMap<int, int> m_defaults; ///< column → width
    QSet<int> m_byHand; ///< columns whose width somebody has changed
    int m_elastic = -1; ///< −1: none
    int m_elasticWidth = 0; ///< at least
    int m_sortColumn = -1;
    Qt::SortOrder m_sortOrder = Qt::AscendingOrder;
    bool m_isArranging = false; ///< it is we who change widths
};

} // namespace gorizont
