#pragma once

#include "core/registry/sensorregistry.h"
#include "ui/models/siteitem.h"

#include <QTabWidget>

namespace gorizont {

class PortsPage;
class PropertiesPage;
class SensorsPage;

/// The panel at the top right: readings and states of what is selected. A tab exists only while its element is selected
/// (manual 000, sections 4.1 – 4.5). GUI thread.
class StatePanel : public QTabWidget
{
    Q_OBJECT

public:
    explicit StatePanel(const SensorRegistry &registry, QWidget *parent = nullptr);

    void setItem(SiteItem item);

    /// Draws the tab that is seen. \a hasReadings: values have changed since the last call.
    void refresh(bool hasReadings);

    /// Of the two tabs of the server, also while something else is selected.
    bool isShowingSensors() const { return m_isShowingSensors; }
    void showPorts();
    void showSensors();

Q_SIGNALS:
    void chosen(gorizont::SiteItem item);

private:
    void onTabChanged();

    const SensorRegistry &m_registry;
    SiteItem m_item;
    bool m_isShowingSensors = false; ///< the tab of the server seen last
    bool m_isChangingItem = false; ///< tabs come and go: it is not the user who chooses one
    PortsPage *m_ports;
    SensorsPage *m_sensors;
    PropertiesPage *m_port;
    PropertiesPage *m_sensor;
};

} // namespace gorizont
