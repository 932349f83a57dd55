#pragma once

#include "ui/models/siteitem.h"

#include "core/registry/sensorregistry.h"

#include <QWidget>

namespace gorizont {

class SensorModel;
class TableView;

/// The tab <Датчики>: all sensors of the server. GUI thread.
class SensorsPage : public QWidget
{
    Q_OBJECT

public:
    explicit SensorsPage(const SensorRegistry &registry, QWidget *parent = nullptr);

    /// Draws the visible rows anew; every few seconds the order too, so that rows do not dance.
    void refresh(SteadyTime now);

Q_SIGNALS:
    void chosen(gorizont::SiteItem item);

private:
    SensorModel *m_model;
    TableView *m_view;
    SteadyTime m_sortedAt{};
};

} // namespace gorizont
