#include "ui/service/mk14form.h"

#include "ui/service/mk14outputspanel.h"
#include "ui/service/mk14transferpanel.h"
#include "ui/service/mk14valuespanel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QTabWidget>

namespace gorizont {

Mk14Form::Mk14Form(QComboBox *addresses, QWidget *parent)
    : QWidget(parent)
    , m_addresses(addresses)
    , m_tabs(new QTabWidget(this))
    , m_values(new Mk14ValuesPanel(m_tabs))
    , m_outputs(new Mk14OutputsPanel(m_tabs))
    , m_transfer(new Mk14TransferPanel(m_tabs))
{
    m_tabs->setObjectName(QStringLiteral("mk14Tabs"));
    m_tabs->addTab(m_values, tr("Values"));
    m_tabs->addTab(m_outputs, tr("Outputs"));
    m_tabs->addTab(m_transfer, tr("Clock and files"));
    auto *group = new QGroupBox(tr("Exchange"), this);
    auto *exchange = new QFormLayout(group);
    exchange->addRow(tr("Add&ress of the station:"), m_addresses);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(group);
    layout->addWidget(m_tabs, 1);
}

QWidgetList Mk14Form::tabOrder() const
{
    return QWidgetList{m_addresses, m_tabs} + m_values->tabOrder() + m_outputs->tabOrder() + m_transfer->tabOrder();
}

} // namespace gorizont
