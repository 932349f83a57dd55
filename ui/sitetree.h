#pragma once

#include "core/registry/sensorregistry.h"
#include "ui/models/siteitem.h"

#include <QWidget>

class QAction;
class QTreeView;

namespace gorizont {

class SearchField;
class SiteTreeModel;

/// The panel on the left: the tree of the site with a field to find a node in it. GUI thread.
class SiteTree : public QWidget
{
    Q_OBJECT

public:
    explicit SiteTree(const SensorRegistry &registry, QWidget *parent = nullptr);

    SiteItem selected() const;
    void select(SiteItem item);
    void refresh();
    void startSearch();

Q_SIGNALS:
    void selectionChanged(gorizont::SiteItem item);
    /// Right button or the menu key on a node.
    void menuWanted(gorizont::SiteItem item, const QPoint &globalPosition);

private:
    void addSearch();
    void find(bool isNext);

    SiteTreeModel *m_model;
    SearchField *m_search;
    QAction *m_nothingFound = nullptr;
    QTreeView *m_view;
};

} // namespace gorizont
