#pragma once

#include "core/net/clientinfo.h"
#include "core/registry/sensorregistry.h"
#include "ui/models/siteitem.h"

#include <QTabWidget>

namespace gorizont {

class ClientsPage;
class PortsPage;
class PropertiesPage;
class SensorsPage;

/// The panel at the top right: readings and states of what is selected. A tab exists only while its element is selected
/// (manual 000, sections 4.1 – 4.5). GUI thread.
class StatePanel : public QTabWidget
{
    Q_OBJECT

public:
    /// \a showsClients: with the tab <Клиенты>.
    StatePanel(const SensorRegistry &registry, bool showsClients, QWidget *parent = nullptr);

    /// A tab that is there whatever is selected, stays while something else is selected, and wants the whole height of
    /// the window. It draws itself.
    void addWidePage(QWidget *page, const QString &title);
    /// With the keyboard.
    void showWidePage(QWidget *page);
    QWidgetList widePages() const { return m_widePages; }
    /// Back from a wide page to the tab of what is selected.
    void leaveWidePage();
    bool isWide() const { return m_widePages.contains(currentWidget()); }

    void setItem(SiteItem item);

    /// Draws the tab that is seen. \a hasReadings: values have changed since the last call.
    void refresh(bool hasReadings);

    /// Place of the tab of the server that is or will be seen, also while something else is selected.
    int serverTab() const { return indexOf(m_serverPage); }
    void showServerTab(int place); ///< no place of a tab of the server: the first one
    void showPorts();
    void showSensors();
    void showClients();

    /// All clients of \a service as they are now.
    void setClients(const QString &service, const QList<ClientInfo> &clients);

Q_SIGNALS:
    void wideChanged(bool isWide);
    void chosen(gorizont::SiteItem item);
    /// The user wants this connection to be cut off.
    void clientDismissed(const QString &service, const QHostAddress &address, quint16 port);

private:
    void onTabChanged();
    QWidgetList serverPages() const;
    QWidget *pageOfItem() const;
    void showServerPage(QWidget *page);
    void connectPages();

    const SensorRegistry &m_registry;
    SiteItem m_item;
    bool m_isChangingItem = false; ///< tabs come and go: it is not the user who chooses one
    PortsPage *m_ports;
    SensorsPage *m_sensors;
    ClientsPage *m_clients; ///< null: not shown
    QWidget *m_serverPage; ///< the one of the server seen last
    PropertiesPage *m_port;
    PropertiesPage *m_sensor;
    QWidgetList m_widePages;
};

} // namespace gorizont
