#include "ui/pages/endfollower.h"

#include <QScrollBar>
#include <QTableView>

#include <algorithm>

namespace gorizont {

EndFollower::EndFollower(QTableView *table)
    : QObject(table)
    , m_table(table)
{
    QScrollBar *bar = table->verticalScrollBar();
    connect(bar, &QScrollBar::rangeChanged, this, [this](int, int maximum) { onRangeChanged(maximum); });
    connect(bar, &QScrollBar::valueChanged, this, [this, bar](int value) { m_isFollowing = value >= bar->maximum(); });
    connect(
        table->model(), &QAbstractItemModel::rowsAboutToBeRemoved, this,
        [this](const QModelIndex &, int first, int last) { onRowsRemoved(first, last - first + 1); });
    table->scrollToBottom();
}

void EndFollower::onRangeChanged(int maximum)
{
    if (m_isFollowing) {
        m_table->verticalScrollBar()->setValue(maximum);
    }
}

void EndFollower::onRowsRemoved(int first, int count)
{
    if (!m_isFollowing && first == 0) {
        QScrollBar *bar = m_table->verticalScrollBar();
        bar->setValue(std::max(0, bar->value() - count)); // one step of the bar is one row
    }
}

} // namespace gorizont
