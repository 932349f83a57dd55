#include "ui/pages/portspage.h"

#include "ui/models/portmodel.h"
#include "ui/pages/tableview.h"

#include <QHeaderView>
#include <QSortFilterProxyModel>
#include <QVBoxLayout>

namespace gorizont {

namespace {

/// Numbers in order of size, not of spelling; what has no number by its text.
class PortOrder : public QSortFilterProxyModel
{
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

protected:
    bool lessThan(const QModelIndex &left, const QModelIndex &right) const override
    {
        const QString a = left.data().toString();
        const QString b = right.data().toString();
        switch (left.column()) {
        case PortModel::Port: return left.row() < right.row();
        case PortModel::Sent:
        case PortModel::Received:
        case PortModel::Attempts: return a.toULongLong() < b.toULongLong();
        case PortModel::Uptime: return a.size() != b.size() ? a.size() < b.size() : a < b;
        default: return a.localeAwareCompare(b) < 0;
        }
    }
};

} // namespace

PortsPage::PortsPage(const SensorRegistry &registry, QWidget *parent)
    : QWidget(parent)
    , m_model(new PortModel(registry, this))
    , m_view(new TableView(QStringLiteral("portsTable"), this))
{
    auto *order = new PortOrder(this);
    order->setSourceModel(m_model);
    m_view->setModel(order);
    m_view->setSortingEnabled(true);
    m_view->sortByColumn(PortModel::Port, Qt::AscendingOrder);
    m_view->setColumnSample(PortModel::Port, QStringLiteral("COM256"));
    m_view->setColumnSample(PortModel::Uptime, QStringLiteral("10000:00:00"));
    m_view->setColumnSample(PortModel::Sent, QStringLiteral("1000000000000"));
    m_view->setColumnSample(PortModel::Received, QStringLiteral("1000000000000"));
    m_view->setColumnSample(PortModel::Attempts, QStringLiteral("100000"));
    m_view->setElasticColumn(PortModel::State, QString(24, u'n'));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view);
    connect(m_view, &TableView::rowChosen, this, [this, order](const QModelIndex &index) {
        Q_EMIT chosen(SiteItem::line(order->mapToSource(index).row()));
    });
}

void PortsPage::refresh(SteadyTime now)
{
    m_model->refresh(now);
}

} // namespace gorizont
