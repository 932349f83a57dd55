#include "ui/pages/tablecolumns.h"

#include <QHeaderView>
#include <QScopedValueRollback>
#include <QTableView>

#include <algorithm>

namespace gorizont {

TableColumns::TableColumns(QTableView *table)
    : QObject(table)
    , m_table(table)
{
    connect(header(), &QHeaderView::sectionResized, this, &TableColumns::onResized);
}

QHeaderView *TableColumns::header() const
{
    return m_table->horizontalHeader();
}

void TableColumns::setSample(int column, const QString &widest)
{
    const QScopedValueRollback guard(m_isArranging, true);
    m_defaults[column] = sampleWidth(column, widest);
    if (!m_byHand.contains(column)) {
        header()->resizeSection(column, m_defaults.value(column));
    }
}

void TableColumns::setCommonSample(int like, const QString &widest)
{
    const QScopedValueRollback guard(m_isArranging, true);
    header()->setDefaultSectionSize(sampleWidth(like, widest));
}

void TableColumns::setElastic(int column, const QString &least)
{
    m_elastic = column;
    m_elasticWidth = sampleWidth(column, least);
    stretch();
}

void TableColumns::setDefaultSort(int column, Qt::SortOrder order)
{
    m_sortColumn = column;
    m_sortOrder = order;
    m_table->setSortingEnabled(true);
    m_table->sortByColumn(column, order);
}

void TableColumns::onResized(int column)
{
    if (m_isArranging) {
        return;
    }
    m_byHand.insert(column);
    stretch();
}

void TableColumns::stretch()
{
    if (m_elastic < 0 || m_byHand.contains(m_elastic)) {
        return;
    }
    const QScopedValueRollback guard(m_isArranging, true);
    const int others = header()->length() - header()->sectionSize(m_elastic);
    header()->resizeSection(m_elastic, std::max(m_elasticWidth, m_table->viewport()->width() - others));
}

int TableColumns::sampleWidth(int column, const QString &widest) const
{
    constexpr int margins = 2 * (sideMargin + 1);
    const QAbstractItemModel *model = m_table->model();
    const int sortMark = m_table->style()->pixelMetric(QStyle::PM_HeaderMarkSize) + margins;
    const QString heading = model->headerData(column, Qt::Horizontal).toString();
    const QFontMetrics metrics = m_table->fontMetrics();
    const QFont cellFont = m_cellFont.value_or(model->index(0, column).data(Qt::FontRole).value<QFont>());
    const int headingWidth =
        header()->fontMetrics().horizontalAdvance(heading) + (m_table->isSortingEnabled() ? sortMark : 0);
    const int cellWidth = std::max(metrics.horizontalAdvance(widest), QFontMetrics(cellFont).horizontalAdvance(widest));
    const bool hasIcon = !model->index(0, column).data(Qt::DecorationRole).isNull();
    const int iconWidth =
        hasIcon ? m_table->style()->pixelMetric(QStyle::PM_SmallIconSize, nullptr, m_table) + margins : 0;
    return std::max(headingWidth, cellWidth + iconWidth) + margins;
}

ColumnLayout TableColumns::layout() const
{
    ColumnLayout layout;
    for (int place = 0; place < header()->count(); ++place) {
        layout.order += header()->logicalIndex(place);
    }
    if (std::is_sorted(layout.order.cbegin(), layout.order.cend())) {
        layout.order = {}; // clear() would keep the memory, and Qt compares that with an empty list by memcmp() on null
    }
    for (const int column : m_byHand) {
        layout.widths.insert(column, header()->sectionSize(column));
    }
    const int sorted = header()->sortIndicatorSection();
    const Qt::SortOrder order = header()->sortIndicatorOrder();
    if (m_sortColumn >= 0 && (sorted != m_sortColumn || order != m_sortOrder)) {
        layout.sortColumn = sorted;
        layout.sortOrder = order;
    }
    return layout;
}

void TableColumns::setLayout(const ColumnLayout &layout)
{
    const QScopedValueRollback guard(m_isArranging, true);
    for (int place = 0; place < header()->count(); ++place) {
        header()->moveSection(header()->visualIndex(layout.order.value(place, place)), place);
    }
    m_byHand.clear();
    for (int column = 0; column < header()->count(); ++column) {
        const int width = layout.widths.value(column);
        if (width > 0) {
            m_byHand.insert(column);
        }
        header()->resizeSection(column, width > 0 ? width : m_defaults.value(column, header()->defaultSectionSize()));
    }
    stretch();
    if (m_sortColumn >= 0) {
        const bool isSorted = layout.sortColumn >= 0;
        m_table->sortByColumn(isSorted ? layout.sortColumn : m_sortColumn, isSorted ? layout.sortOrder : m_sortOrder);
    }
}

} // namespace gorizont
