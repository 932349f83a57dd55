#pragma once

#include "core/config/serverconfig.h"
#include "core/registry/journal.h"
#include "core/registry/sensorregistry.h"
#include "ui/models/siteitem.h"

#include <QTabWidget>

namespace gorizont {

class MeasurementsPage;
class PropertiesPage;

/// The panel at the bottom right: <Настройки>, <Измерения>, <Журнал> (manual 000, sections 4.6 – 4.10). GUI thread.
class InfoPanel : public QTabWidget
{
    Q_OBJECT

public:
    InfoPanel(
        const SensorRegistry &registry, const Journal &journal, const ServerConfig &config, QWidget *parent = nullptr);

    void setItem(SiteItem item);
    void appendMeasurement(const QString &line);
    /// How many gateways of OPC DA are connected.
    void setGateways(int count);

private:
    const SensorRegistry &m_registry;
    const ServerConfig m_config;
    SiteItem m_item = SiteItem::server();
    int m_gateways = 0;
    PropertiesPage *m_settings;
    MeasurementsPage *m_measurements;
};

} // namespace gorizont
