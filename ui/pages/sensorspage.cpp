#include "ui/pages/sensorspage.h"

#include "ui/models/sensormodel.h"
#include "ui/pages/tablecolumns.h"
#include "ui/pages/tableview.h"

#include <QHeaderView>
#include <QVBoxLayout>

namespace gorizont {

namespace {

constexpr std::chrono::seconds sortPeriod(3);

} // namespace

SensorsPage::SensorsPage(const SensorRegistry &registry, QWidget *parent)
    : QWidget(parent)
    , m_model(new SensorModel(registry, this))
    , m_view(new TableView(QStringLiteral("sensorsTable"), this))
{
    m_view->setModel(m_model);
    m_view->setTextElideMode(Qt::ElideMiddle);
    m_view->horizontalHeader()->setSectionsMovable(true);
    m_view->horizontalHeader()->setMinimumSectionSize(60);
    m_view->setEmptyText(tr("The configuration file lists no sensors."));
    TableColumns &columns = m_view->columns();
    columns.setDefaultSort(SensorModel::Sensor);
    columns.setSample(SensorModel::Mx, QStringLiteral("-180.000"));
    columns.setSample(SensorModel::My, QStringLiteral("-180.000"));
    columns.setSample(SensorModel::Amax, QStringLiteral("10000.00"));
    columns.setSample(SensorModel::Arms, QStringLiteral("10000.00"));
    columns.setSample(SensorModel::Temperature, QStringLiteral("-100.00"));
    columns.setSample(SensorModel::Fan, QStringLiteral("1000.0"));
    columns.setSample(SensorModel::Power, QStringLiteral("100.0"));
    columns.setSample(SensorModel::Status, QStringLiteral("10 0000 0000 0000"));
    columns.setElastic(SensorModel::Sensor, QStringLiteral("100 АН-Д3 [А1] [100]"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view);
    connect(m_view, &TableView::rowChosen, this, [this](const QModelIndex &index) {
        Q_EMIT chosen(SiteItem::sensor(m_model->sensorAt(index.row())));
    });
}

void SensorsPage::refresh(SteadyTime now)
{
    if (now - m_sortedAt >= sortPeriod) {
        m_sortedAt = now;
        m_model->resort();
    }
    const TableView::Rows rows = m_view->visibleRows();
    m_model->refresh(rows.first, rows.last);
}

} // namespace gorizont
