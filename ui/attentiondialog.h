#pragma once

#include "core/registry/sensorregistry.h"
#include "ui/models/siteitem.h"

#include <QDialog>

class QBoxLayout;
class QLabel;
class QPushButton;
class QSortFilterProxyModel;

namespace gorizont {

class AlarmWatch;
class AttentionModel;
class TableView;

/// «Сообщения для диспетчера»: what nobody has accepted yet, beside the window it belongs to. Enter or a double click
/// selects the element in the tree, Space or Delete accepts. GUI thread.
class AttentionDialog : public QDialog
{
    Q_OBJECT

public:
    /// Registry and alarms outlive the dialog.
    AttentionDialog(const SensorRegistry &registry, AlarmWatch &alarms, QWidget *parent = nullptr);

Q_SIGNALS:
    void chosen(gorizont::SiteItem item);

protected:
    void showEvent(QShowEvent *event) override;

private:
    void buildTable();
    QPushButton *addButton(QBoxLayout *layout, const QString &title, const QString &objectName);
    void refresh();
    void updateButtons();
    void acceptSelected();
    void acceptAll();
    SiteItem itemAt(const QModelIndex &index) const;

    const SensorRegistry &m_registry;
    AlarmWatch &m_alarms;
    AttentionModel *m_model;
    QSortFilterProxyModel *m_sorted;
    TableView *m_view;
    QLabel *m_summary;
    QPushButton *m_accept = nullptr;
    QPushButton *m_acceptAll = nullptr;
};

} // namespace gorizont
