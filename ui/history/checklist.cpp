#include "ui/history/checklist.h"

#include <QCheckBox>
#include <QListWidget>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace gorizont {

CheckList::CheckList(const QString &objectName, const QString &all, QWidget *parent)
    : QWidget(parent)
    , m_all(new QCheckBox(all, this))
    , m_list(new QListWidget(this))
{
    m_all->setObjectName(objectName + QStringLiteral("All"));
    m_all->setChecked(true);
    m_list->setObjectName(objectName);
    m_list->setAccessibleName(all);
    m_list->setTextElideMode(Qt::ElideRight);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // the tool tip has the rest
    connect(m_all, &QCheckBox::clicked, this, [this] { markAll(m_all->checkState() != Qt::Unchecked); });
    connect(m_list, &QListWidget::itemChanged, this, [this] {
        follow();
        Q_EMIT changed();
    });
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_all);
    layout->addWidget(m_list, 1);
}

void CheckList::add(const QString &title, int id)
{
    const QSignalBlocker quiet(m_list);
    auto *item = new QListWidgetItem(title, m_list);
    item->setData(Qt::UserRole, id);
    item->setToolTip(title);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Checked);
}

void CheckList::setChosen(const QList<int> &ids)
{
    const QSignalBlocker quiet(m_list);
    for (int row = 0; row < m_list->count(); ++row) {
        QListWidgetItem *item = m_list->item(row);
        item->setCheckState(ids.contains(item->data(Qt::UserRole).toInt()) ? Qt::Checked : Qt::Unchecked);
    }
    follow();
}

QList<int> CheckList::chosen() const
{
    QList<int> ids;
    for (int row = 0; row < m_list->count(); ++row) {
        const QListWidgetItem *item = m_list->item(row);
        if (item->checkState() == Qt::Checked) {
            ids << item->data(Qt::UserRole).toInt();
        }
    }
    return ids;
}

void CheckList::markAll(bool isMarked)
{
    const QSignalBlocker quiet(m_list);
    for (int row = 0; row < m_list->count(); ++row) {
        m_list->item(row)->setCheckState(isMarked ? Qt::Checked : Qt::Unchecked);
    }
    follow();
    Q_EMIT changed();
}

/// Some: neither marked nor unmarked, and a click marks all.
void CheckList::follow()
{
    const qsizetype count = chosen().size();
    m_all->setTristate(count > 0 && count < m_list->count());
    m_all->setCheckState(count == 0 ? Qt::Unchecked : count < m_list->count() ? Qt::PartiallyChecked : Qt::Checked);
}

} // namespace gorizont
