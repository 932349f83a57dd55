#include "ui/infopanel.h"

#include "ui/models/settingsproperties.h"
#include "ui/pages/journalpage.h"
#include "ui/pages/measurementspage.h"
#include "ui/pages/propertiespage.h"

#include <utility>

namespace gorizont {

InfoPanel::InfoPanel(
    const SensorRegistry &registry, const Journal &journal, const ServerConfig &config, QWidget *parent)
    : QTabWidget(parent)
    , m_registry(registry)
    , m_config(config)
    , m_settings(new PropertiesPage(QStringLiteral("settingsTable"), PropertiesPage::Notes::InColumn, this))
    , m_measurements(new MeasurementsPage(registry, config, this))
{
    setObjectName(QStringLiteral("infoTabs"));
    setDocumentMode(true);
    addTab(m_settings, tr("Settings"));
    addTab(m_measurements, tr("Measurements"));
    addTab(new JournalPage(journal, this), tr("Journal"));
    setItem(SiteItem::server());
}

void InfoPanel::setItem(SiteItem item)
{
    m_item = item;
    const auto index = static_cast<std::size_t>(item.index);
    switch (item.kind) {
    case SiteItem::Kind::Server: m_settings->setProperties(serverSettings(m_config, m_gateways)); break;
    case SiteItem::Kind::Line:
        m_settings->setProperties(lineSettings(m_config, m_registry.lines()[index].config));
        break;
    case SiteItem::Kind::Sensor:
        m_settings->setProperties(sensorSettings(m_config, m_registry.sensors()[index].config));
        break;
    }
}

void InfoPanel::setGateways(int count)
{
    if (std::exchange(m_gateways, count) != count && m_item == SiteItem::server()) {
        setItem(m_item);
    }
}

void InfoPanel::appendMeasurement(const QString &line)
{
    m_measurements->append(line);
}

} // namespace gorizont
