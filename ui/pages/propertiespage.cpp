#include "ui/pages/propertiespage.h"

#include "ui/models/propertymodel.h"
#include "ui/pages/tableview.h"

#include <QHeaderView>
#include <QVBoxLayout>

namespace gorizont {

PropertiesPage::PropertiesPage(const QString &tableName, Notes notes, QWidget *parent)
    : QWidget(parent)
    , m_model(new PropertyModel(notes == Notes::InColumn, this))
    , m_view(new TableView(tableName, this))
{
    m_view->setModel(m_model);
    const int character = fontMetrics().averageCharWidth();
    m_view->setColumnWidth(PropertyModel::Name, character * 42);
    m_view->setColumnWidth(PropertyModel::Value, character * 44);
    m_view->horizontalHeader()->setStretchLastSection(true);
    connect(m_model, &PropertyModel::modelReset, this, &PropertiesPage::mergeHeadings);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view);
}

void PropertiesPage::setProperties(const Properties &properties)
{
    m_model->setProperties(properties);
}

void PropertiesPage::mergeHeadings()
{
    m_view->clearSpans();
    for (int row = 0; row < m_model->rowCount(); ++row) {
        if (m_model->properties().at(row).isSection) {
            m_view->setSpan(row, 0, 1, m_model->columnCount());
        }
    }
}

} // namespace gorizont
