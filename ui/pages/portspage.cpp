#include "ui/pages/portspage.h"

#include "ui/models/portmodel.h"
#include "ui/pages/roworder.h"
#include "ui/pages/tablecolumns.h"
#include "ui/pages/tableview.h"

#include <QHeaderView>
#include <QVBoxLayout>

namespace gorizont {

PortsPage::PortsPage(const SensorRegistry &registry, QWidget *parent)
    : QWidget(parent)
    , m_model(new PortModel(registry, this))
    , m_view(new TableView(QStringLiteral("portsTable"), this))
{
    auto *order = new RowOrder(m_model, PortModel::SortRole, this);
    m_view->setModel(order);
    m_view->horizontalHeader()->setSectionsMovable(true);
    m_view->setEmptyText(tr("The configuration file lists no ports."));
    TableColumns &columns = m_view->columns();
    columns.setDefaultSort(PortModel::Port);
    columns.setSample(PortModel::Port, QStringLiteral("COM256"));
    columns.setSample(PortModel::Uptime, QStringLiteral("10000:00:00"));
    columns.setSample(PortModel::Sent, QStringLiteral("1000000000000"));
    columns.setSample(PortModel::Received, QStringLiteral("1000000000000"));
    columns.setSample(PortModel::Attempts, QStringLiteral("100000"));
    columns.setElastic(PortModel::State, QString(24, u'n'));
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
