#include "ui/pages/measurementspage.h"

#include "ui/models/measurementmodel.h"
#include "ui/pages/tablecolumns.h"
#include "ui/pages/tableview.h"

#include <QFontDatabase>
#include <QVBoxLayout>

namespace gorizont {

namespace {

QString seconds(std::chrono::milliseconds time)
{
    return QString::number(std::chrono::duration<double>(time).count());
}

} // namespace

MeasurementsPage::MeasurementsPage(const SensorRegistry &registry, const ServerConfig &config, QWidget *parent)
    : QWidget(parent)
    , m_model(new MeasurementModel(registry, config.memoCount, config.memoDelete, this))
{
    auto *view = new TableView(QStringLiteral("measurementsTable"), this);
    view->setModel(m_model);
    // The columns do not move: a copied row is a line of the file.
    TableColumns &columns = view->columns();
    columns.setCellFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    columns.setCommonSample(2, QStringLiteral("-264000.0"));
    columns.setSample(0, QStringLiteral("18:33:03 07.02.18"));
    columns.setSample(1, QStringLiteral("3333333333333333"));
    for (int column = m_model->columnCount() - 1; column > 1; column -= MeasurementModel::sensorColumns) {
        columns.setSample(column, QStringLiteral("10 0000 0001 0100"));
    }
    view->setEmptyText(tr("No measurement yet: a line comes every %1 s.").arg(seconds(config.timing.save)));
    view->followEnd();
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(view);
}

void MeasurementsPage::append(const QString &line)
{
    m_model->append(line);
}

} // namespace gorizont
