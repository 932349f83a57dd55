#pragma once

#include "ui/models/siteitem.h"

#include "core/registry/sensorregistry.h"

#include <QWidget>

namespace gorizont {

class PortModel;
class TableView;

/// The tab <Порты>: all ports of the server. GUI thread.
class PortsPage : public QWidget
{
    Q_OBJECT

public:
    explicit PortsPage(const SensorRegistry &registry, QWidget *parent = nullptr);

    void refresh(SteadyTime now);

Q_SIGNALS:
    void chosen(gorizont::SiteItem item);

private:
    PortModel *m_model;
    TableView *m_view;
};

} // namespace gorizont
