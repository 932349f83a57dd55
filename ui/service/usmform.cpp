#include "ui/service/usmform.h"

#include "ui/service/usmdevicepanel.h"
#include "ui/service/usmrecorderpanel.h"
#include "ui/service/usmrecordspanel.h"
#include "ui/service/usmsettingspanel.h"
#include "ui/service/usmtext.h"

#include <QComboBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>

namespace gorizont {

UsmForm::UsmForm(QComboBox *addresses, QWidget *parent)
    : QWidget(parent)
    , m_addresses(addresses)
    , m_tabs(new QTabWidget(this))
    , m_device(new UsmDevicePanel(m_tabs))
    , m_settings(new UsmSettingsPanel(m_tabs))
    , m_recorder(new UsmRecorderPanel(m_tabs))
    , m_records(new UsmRecordsPanel(m_tabs))
{
    m_tabs->setObjectName(QStringLiteral("usmTabs"));
    m_tabs->addTab(m_device, tr("Device"));
    m_tabs->addTab(m_settings, tr("Address and port"));
    m_tabs->addTab(m_recorder, tr("Recorder"));
    m_tabs->addTab(m_records, tr("Records"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(makeExchange());
    layout->addWidget(m_tabs, 1);
    connect(m_serials, &QLineEdit::textChanged, this, [this] { setMayFind(m_mayFind); });
    connect(m_serials, &QLineEdit::returnPressed, m_find, &QPushButton::click);
    connect(m_find, &QPushButton::clicked, this, &UsmForm::findWanted);
}

QGroupBox *UsmForm::makeExchange()
{
    auto *group = new QGroupBox(tr("Exchange"), this);
    m_addresses->setParent(group);
    m_serials = new QLineEdit(group);
    m_serials->setObjectName(QStringLiteral("serialEdit"));
    m_serials->setToolTip(tr("One or several serial numbers with blanks between them. Up to 3 s each."));
    m_find = new QPushButton(tr("&Find"), group);
    m_find->setObjectName(QStringLiteral("findSerial"));
    m_find->setAutoDefault(false);
    auto *address = new QLabel(tr("Add&ress on the line:"), group);
    address->setBuddy(m_addresses);
    auto *serial = new QLabel(tr("Find by serial n&umber:"), group);
    serial->setBuddy(m_serials);
    auto *grid = new QGridLayout(group);
    grid->addWidget(address, 0, 0);
    grid->addWidget(m_addresses, 0, 1);
    grid->addWidget(serial, 1, 0);
    grid->addWidget(m_serials, 1, 1);
    grid->addWidget(m_find, 1, 2);
    grid->setColumnStretch(1, 1);
    return group;
}

QList<quint32> UsmForm::serials() const
{
    return usmtext::serials(m_serials->text());
}

void UsmForm::setMayFind(bool mayFind)
{
    m_mayFind = mayFind;
    m_serials->setEnabled(mayFind);
    m_find->setEnabled(mayFind && !serials().isEmpty());
}

QWidgetList UsmForm::tabOrder() const
{
    return QWidgetList{m_addresses, m_serials, m_find, m_tabs} + m_device->tabOrder() + m_settings->tabOrder()
        + m_recorder->tabOrder() + m_records->tabOrder();
}

} // namespace gorizont
