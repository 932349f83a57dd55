#include "ui/statepanel.h"

#include "ui/models/stateproperties.h"
#include "ui/pages/clientspage.h"
#include "ui/pages/portspage.h"
#include "ui/pages/propertiespage.h"
#include "ui/pages/sensorspage.h"

#include <QScopedValueRollback>

namespace gorizont {

StatePanel::StatePanel(const SensorRegistry &registry, bool showsClients, QWidget *parent)
    : QTabWidget(parent)
    , m_registry(registry)
    , m_ports(new PortsPage(registry, this))
    , m_sensors(new SensorsPage(registry, this))
    , m_clients(showsClients ? new ClientsPage(this) : nullptr)
    , m_serverPage(m_ports)
    , m_port(new PropertiesPage(QStringLiteral("portTable"), PropertiesPage::Notes::InToolTips, this))
    , m_sensor(new PropertiesPage(QStringLiteral("sensorTable"), PropertiesPage::Notes::InToolTips, this))
{
    setObjectName(QStringLiteral("stateTabs"));
    setDocumentMode(true);
    addTab(m_ports, tr("Ports"));
    addTab(m_sensors, tr("Sensors"));
    if (m_clients) {
        addTab(m_clients, tr("Clients"));
    }
    addTab(m_port, tr("Port"));
    addTab(m_sensor, tr("Sensor"));
    connectPages();
    setItem(SiteItem::server());
}

void StatePanel::connectPages()
{
    connect(m_ports, &PortsPage::chosen, this, &StatePanel::chosen);
    connect(m_sensors, &SensorsPage::chosen, this, &StatePanel::chosen);
    if (m_clients) {
        connect(m_clients, &ClientsPage::dismissed, this, &StatePanel::clientDismissed);
    }
    connect(this, &QTabWidget::currentChanged, this, &StatePanel::onTabChanged);
}

QWidgetList StatePanel::serverPages() const
{
    QWidgetList pages{m_ports, m_sensors};
    if (m_clients) {
        pages += m_clients;
    }
    return pages;
}

void StatePanel::addWidePage(QWidget *page, const QString &title)
{
    m_widePages.append(page);
    addTab(page, title);
}

void StatePanel::showWidePage(QWidget *page)
{
    setCurrentWidget(page);
    page->setFocus(Qt::ShortcutFocusReason);
}

void StatePanel::leaveWidePage()
{
    if (isWide()) {
        setCurrentWidget(pageOfItem());
    }
}

void StatePanel::onTabChanged()
{
    if (!m_isChangingItem && serverPages().contains(currentWidget())) {
        m_serverPage = currentWidget();
    }
    Q_EMIT wideChanged(isWide());
    refresh(true);
}

QWidget *StatePanel::pageOfItem() const
{
    switch (m_item.kind) {
    case SiteItem::Kind::Line: return m_port;
    case SiteItem::Kind::Sensor: return m_sensor;
    case SiteItem::Kind::Server: break;
    }
    return m_serverPage;
}

void StatePanel::setItem(SiteItem item)
{
    const QScopedValueRollback guard(m_isChangingItem, true);
    m_item = item;
    // The new tab first: a tab that is hidden while it is seen hands over to its neighbour.
    setTabVisible(indexOf(pageOfItem()), true);
    if (!isWide()) {
        setCurrentWidget(pageOfItem());
    }
    for (QWidget *page : serverPages()) {
        setTabVisible(indexOf(page), item.kind == SiteItem::Kind::Server);
    }
    setTabVisible(indexOf(m_port), item.kind == SiteItem::Kind::Line);
    setTabVisible(indexOf(m_sensor), item.kind == SiteItem::Kind::Sensor);
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
    } else if (m_clients && currentWidget() == m_clients) {
        m_clients->refresh(utcNow());
    } else if (isWide()) {
        return;
    } else if (m_item.kind == SiteItem::Kind::Line) {
        m_port->setProperties(portProperties(m_registry.lines()[static_cast<std::size_t>(m_item.index)], now));
    } else if (m_item.kind == SiteItem::Kind::Sensor) {
        const SensorRegistry::Sensor &sensor = m_registry.sensors()[static_cast<std::size_t>(m_item.index)];
        const LineState line = m_registry.lines()[static_cast<std::size_t>(sensor.line)].status.state;
        m_sensor->setProperties(sensorProperties(sensor, line, now));
    }
}

void StatePanel::setClients(const QString &service, const QList<ClientInfo> &clients)
{
    if (m_clients) {
        m_clients->setClients(service, clients);
    }
}

void StatePanel::showServerPage(QWidget *page)
{
    m_serverPage = page;
    if (m_item.kind == SiteItem::Kind::Server) {
        setCurrentWidget(page);
    }
}

void StatePanel::showServerTab(int place)
{
    showServerPage(serverPages().value(place, m_ports));
}

void StatePanel::showPorts()
{
    showServerPage(m_ports);
}

void StatePanel::showSensors()
{
    showServerPage(m_sensors);
}

void StatePanel::showClients()
{
    if (m_clients) {
        showServerPage(m_clients);
    }
}

} // namespace gorizont
