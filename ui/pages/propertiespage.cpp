#include "ui/pages/propertiespage.h"

#include "ui/models/propertymodel.h"
#include "ui/pages/tablecolumns.h"
#include "ui/pages/tableview.h"

#include <QVBoxLayout>

namespace gorizont {

PropertiesPage::PropertiesPage(const QString &tableName, Notes notes, QWidget *parent)
    : QWidget(parent)
    , m_model(new PropertyModel(notes == Notes::InColumn, this))
    , m_view(new TableView(tableName, this))
    , m_widestName(34, u'n')
{
    m_view->setModel(m_model);
    TableColumns &columns = m_view->columns();
    columns.setSample(PropertyModel::Name, m_widestName);
    if (notes == Notes::InColumn) {
        columns.setSample(PropertyModel::Value, QString(26, u'n'));
        columns.setElastic(PropertyModel::Note, QString(24, u'n'));
    } else {
        columns.setElastic(PropertyModel::Value, QString(48, u'n'));
    }
    connect(m_model, &PropertyModel::modelReset, this, &PropertiesPage::onNamesChanged);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view);
}

void PropertiesPage::setProperties(const Properties &properties)
{
    m_model->setProperties(properties);
}

void PropertiesPage::onNamesChanged()
{
    mergeHeadings();
    fitNames();
}

/// A name must be read in full; a value that is too long is in the tool tip of its cell.
void PropertiesPage::fitNames()
{
    const QFontMetrics metrics = m_view->fontMetrics();
    const QString before = m_widestName;
    for (const Property &property : m_model->properties()) {
        if (!property.isSection && metrics.horizontalAdvance(property.name) > metrics.horizontalAdvance(m_widestName)) {
            m_widestName = property.name;
        }
    }
    if (m_widestName != before) {
        m_view->columns().setSample(PropertyModel::Name, m_widestName);
        m_view->columns().stretch();
    }
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
