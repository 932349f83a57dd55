#include "ui/plots/cursorpanel.h"

#include "ui/pages/tablecolumns.h"
#include "ui/pages/tableview.h"

#include <QLabel>
#include <QVBoxLayout>

namespace gorizont {

CursorPanel::CursorPanel(QWidget *parent)
    : QWidget(parent)
    , m_model(new CursorModel(this))
    , m_moments(new QLabel(this))
    , m_view(new TableView(QStringLiteral("cursorTable"), this))
{
    m_moments->setObjectName(QStringLiteral("cursorMoments"));
    m_moments->setContentsMargins(6, 2, 6, 2);
    m_moments->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_moments->setWordWrap(true);
    m_view->setModel(m_model);
    m_view->setEmptyText(tr("Nothing is drawn."));
    m_view->setTextElideMode(Qt::ElideMiddle);
    m_view->setIconSize(QSize(28, 12));
    setColumns();
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_moments);
    layout->addWidget(m_view, 1);
}

void CursorPanel::setColumns()
{
    TableColumns &columns = m_view->columns();
    for (const int column :
         {CursorModel::AtA, CursorModel::AtB, CursorModel::Difference, CursorModel::Mean, CursorModel::SlopeAnHour,
          CursorModel::SlopeADay, CursorModel::Minimum, CursorModel::Maximum}) {
        columns.setSample(column, QStringLiteral("+10000.0000"));
    }
    columns.setSample(CursorModel::Completeness, QStringLiteral("100.0"));
    columns.setElastic(CursorModel::Curve, QStringLiteral("100 АН-Д3 [А1] Amax X, mm/s²"));
}

void CursorPanel::setRows(const QList<CursorModel::Row> &rows, TiltUnit unit)
{
    m_model->setRows(rows, unit);
}

void CursorPanel::setMoments(UtcTime first, UtcTime second)
{
    const std::chrono::microseconds distance = second > first ? second - first : first - second;
    m_moments->setText(tr("A: %1   B: %2   Between them: %3")
                           .arg(plottext::moment(first), plottext::moment(second), plottext::duration(distance)));
}

} // namespace gorizont
