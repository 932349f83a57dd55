#include "ui/pages/measurementspage.h"

#include "ui/models/measurementmodel.h"
#include "ui/pages/tableview.h"

#include <QFontDatabase>
#include <QHeaderView>
#include <QVBoxLayout>

namespace gorizont {

MeasurementsPage::MeasurementsPage(const SensorRegistry &registry, const ServerConfig &config, QWidget *parent)
    : QWidget(parent)
    , m_model(new MeasurementModel(registry, config.memoCount, config.memoDelete, this))
{
    auto *view = new TableView(QStringLiteral("measurementsTable"), this);
    view->setModel(m_model);
    const QFontMetrics metrics(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    constexpr int margins = 24;
    const int time = metrics.horizontalAdvance(QStringLiteral("18:33:03 07.02.18")) + margins;
    const int value = metrics.horizontalAdvance(QStringLiteral("-264000.0")) + margins;
    const int status = metrics.horizontalAdvance(QStringLiteral("10 0000 0001 0100")) + margins;
    view->horizontalHeader()->setDefaultSectionSize(value);
    view->setColumnWidth(0, time);
    for (int column = 6; column < m_model->columnCount(); column += 5) {
        view->setColumnWidth(column, status);
    }
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
