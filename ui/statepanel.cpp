#include "ui/statepanel.h"

#include "ui/models/stateproperties.h"
#include "ui/pages/portspage.h"
#include "ui/pages/propertiespage.h"
#include "ui/pages/sensorspage.h"

#include <QScopedValueRollback>

namespace gorizont {

StatePanel::StatePanel(const SensorRegistry &registry, QWidget *parent)
    : QTabWidget(parent)
    , m_registry(registry)
    , m_ports(new PortsPage(registry, this))
    , m_sensors(new SensorsPage(registry, this))
    , m_port(new PropertiesPage(QStringLiteral("portTable"), PropertiesPage::Notes::InToolTips, this))
    , m_sensor(new PropertiesPage(QStringLiteral("sensorTable"), PropertiesPage::Notes::InToolTips, this))
{
    setObjectName(QStringLiteral("stateTabs"));
    setDocumentMode(true);
    addTab(m_ports, tr("Ports"));
    addTab(m_sensors, tr("Sensors"));
    addTab(m_port, tr("Port"));
    addTab(m_sensor, tr("Sensor"));
    connect(m_ports, &PortsPage::chosen, this, &StatePanel::chosen);
    connect(m_sensors, &SensorsPage::chosen, this, &StatePanel::chosen);
    connect(this, &QTabWidget::currentChanged, this, &StatePanel::onTabChanged);
    setItem(SiteItem::server());
}

void StatePanel::onTabChanged()
{
    if (m_item.kind == SiteItem::Kind::Server && !m_isChangingItem) {
        m_isShowingSensors = currentWidget() == m_sensors;
    }
    refresh(true);
}

void StatePanel::setItem(SiteItem item)
{
    const QScopedValueRollback guard(m_isChangingItem, true);
    m_item = item;
    setTabVisible(indexOf(m_ports), item.kind == SiteItem::Kind::Server);
    setTabVisible(indexOf(m_sensors), item.kind == SiteItem::Kind::Server);
    setTabVisible(indexOf(m_port), item.kind == SiteItem::Kind::Line);
    setTabVisible(indexOf(m_sensor), item.kind == SiteItem::Kind::Sensor);
    if (item.kind == SiteItem::Kind::Server) {
        setCurrentWidget(m_isShowingSensors ? static_cast<QWidget *>(m_sensors) : m_ports);
    }
    refresh(true);
}

void StatePanel::refresh(bool hasReadings)
{
    const SteadyTime now = std::chrono::steady_clock::now();
    if (currentWidget() == m_ports) {
        m_ports->refresh(now);
    } else if (currentWidget() == m_sensors) {
        if (hasReadings) {
            m_sensors->refresh(now);
        }
    } else if (m_item.kind == SiteItem::Kind::Line) {
        m_port->setProperties(portProperties(m_registry.lines()[static_cast<std::size_t>(m_item.index)], now));
    } else if (m_item.kind == SiteItem::Kind::Sensor) {
        const SensorRegistry::Sensor &sensor = m_registry.sensors()[static_cast<std::size_t>(m_item.index)];
        const LineState line = m_registry.lines()[static_cast<std::size_t>(sensor.line)].status.state;
        m_sensor->setProperties(sensorProperties(sensor, line, now));
    }
}

void StatePanel::showPorts()
{
    m_isShowingSensors = false;
    if (m_item.kind == SiteItem::Kind::Server) {
        setCurrentWidget(m_ports);
    }
}

void StatePanel::showSensors()
{
    m_isShowingSensors = true;
    if (m_item.kind == SiteItem::Kind::Server) {
        setCurrentWidget(m_sensors);
    }
}

} // namespace gorizont
