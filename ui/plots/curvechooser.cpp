#include "ui/plots/curvechooser.h"

#include "ui/pages/searchfield.h"

#include <QSortFilterProxyModel>
#include <QTreeView>
#include <QVBoxLayout>

namespace gorizont {

CurveChooser::CurveChooser(const SensorRegistry &registry, QWidget *parent)
    : QWidget(parent)
    , m_model(new CurveModel(registry, this))
    , m_found(new QSortFilterProxyModel(this))
    , m_search(new SearchField(QStringLiteral("curveSearch"), tr("Find a sensor"), this))
    , m_view(new QTreeView(this))
{
    m_found->setSourceModel(m_model);
    m_found->setRecursiveFilteringEnabled(true);
    m_found->setAutoAcceptChildRows(true);
    m_found->setFilterCaseSensitivity(Qt::CaseInsensitive);
    m_view->setObjectName(QStringLiteral("curveTree"));
    m_view->setAccessibleName(tr("What is drawn"));
    m_view->setModel(m_found);
    m_view->setHeaderHidden(true);
    m_view->setUniformRowHeights(true);
    m_view->setTextElideMode(Qt::ElideMiddle);
    m_view->setIndentation(16);
    m_view->setFrameShape(QFrame::NoFrame);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    auto *searchLayout = new QVBoxLayout;
    searchLayout->setContentsMargins(6, 6, 6, 6);
    searchLayout->addWidget(m_search);
    layout->addLayout(searchLayout);
    layout->addWidget(m_view);
    if (m_model->rowCount() <= 4) {
        m_view->expandAll();
    }
    connect(m_search, &QLineEdit::textChanged, this, &CurveChooser::find);
    connect(m_search, &SearchField::left, m_view, qOverload<>(&QWidget::setFocus));
    connect(m_model, &CurveModel::chosenChanged, this, &CurveChooser::showChosen);
}

void CurveChooser::find(const QString &text)
{
    m_found->setFilterFixedString(text.trimmed());
    if (!text.trimmed().isEmpty() && m_found->rowCount() <= 20) {
        m_view->expandAll();
    }
}

/// A tick that came from elsewhere is to be seen.
void CurveChooser::showChosen()
{
    for (const SeriesKey &key : m_model->chosen()) {
        m_view->expand(m_found->mapFromSource(m_model->indexOf(key).parent()));
    }
}

} // namespace gorizont
