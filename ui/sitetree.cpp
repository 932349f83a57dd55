#include "ui/sitetree.h"

#include "ui/models/icons.h"
#include "ui/models/sitetreemodel.h"
#include "ui/pages/searchfield.h"

#include <QAction>
#include <QTreeView>
#include <QVBoxLayout>

namespace gorizont {

SiteTree::SiteTree(const SensorRegistry &registry, QWidget *parent)
    : QWidget(parent)
    , m_model(new SiteTreeModel(registry, this))
    , m_search(new SearchField(QStringLiteral("treeSearch"), tr("Find a sensor (Ctrl+F)"), this))
    , m_view(new QTreeView(this))
{
    addSearch();
    m_view->setObjectName(QStringLiteral("siteTree"));
    m_view->setModel(m_model);
    m_view->setHeaderHidden(true);
    m_view->setUniformRowHeights(true);
    m_view->setTextElideMode(Qt::ElideMiddle); // number and address at the ends tell sensors apart
    m_view->setIconSize(icons::treeSize());
    m_view->setIndentation(16);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setExpandsOnDoubleClick(true);
    m_view->setDragDropMode(QAbstractItemView::DragOnly);
    m_view->expandToDepth(m_model->rowCount(m_model->indexOf(SiteItem::server())) <= 4 ? 1 : 0);
    setFocusProxy(m_view);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    auto *searchLayout = new QVBoxLayout;
    searchLayout->setContentsMargins(6, 6, 6, 6);
    searchLayout->addWidget(m_search);
    layout->addLayout(searchLayout);
    layout->addWidget(m_view);

    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex &current) {
        Q_EMIT selectionChanged(m_model->itemAt(current));
    });
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_view, &QWidget::customContextMenuRequested, this, [this](const QPoint &position) {
        if (const QModelIndex index = m_view->indexAt(position); index.isValid()) {
            Q_EMIT menuWanted(m_model->itemAt(index), m_view->viewport()->mapToGlobal(position));
        }
    });
}

void SiteTree::addSearch()
{
    m_nothingFound = m_search->addAction(icons::state(Health::Warning), QLineEdit::LeadingPosition);
    m_nothingFound->setObjectName(QStringLiteral("nothingFound"));
    m_nothingFound->setToolTip(tr("Nothing found"));
    m_nothingFound->setVisible(false);
    connect(m_search, &QLineEdit::textEdited, this, [this] { find(false); });
    connect(m_search, &QLineEdit::returnPressed, this, [this] { find(true); });
    connect(m_search, &SearchField::left, m_view, qOverload<>(&QWidget::setFocus));
}

SiteItem SiteTree::selected() const
{
    return m_model->itemAt(m_view->currentIndex());
}

void SiteTree::select(SiteItem item)
{
    const QModelIndex index = m_model->indexOf(item);
    m_view->setCurrentIndex(index);
    m_view->scrollTo(index);
}

void SiteTree::refresh()
{
    m_model->refresh();
}

void SiteTree::startSearch()
{
    m_search->setFocus(Qt::ShortcutFocusReason);
    m_search->selectAll();
}

/// From the current node on, and round the end to the start; \a isNext leaves out the current one.
void SiteTree::find(bool isNext)
{
    const QString wanted = m_search->text().trimmed();
    m_nothingFound->setVisible(false);
    if (wanted.isEmpty()) {
        return;
    }
    const QModelIndexList found = m_model->match(
        m_model->indexOf(SiteItem::server()), Qt::DisplayRole, wanted, -1,
        Qt::MatchContains | Qt::MatchRecursive | Qt::MatchWrap);
    m_nothingFound->setVisible(found.isEmpty());
    if (found.isEmpty()) {
        return;
    }
    const qsizetype current = found.indexOf(m_view->currentIndex());
    const qsizetype chosen = current < 0 ? 0 : (current + (isNext ? 1 : 0)) % found.size();
    select(m_model->itemAt(found.at(chosen)));
}

} // namespace gorizont
