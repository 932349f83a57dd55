#pragma once

#include "core/config/serverconfig.h"
#include "core/registry/sensorregistry.h"

#include <QWidget>

namespace gorizont {

class MeasurementModel;

/// The tab <Измерения>: the last lines of `_data`. GUI thread.
class MeasurementsPage : public QWidget
{
    Q_OBJECT

public:
    MeasurementsPage(const SensorRegistry &registry, const ServerConfig &config, QWidget *parent = nullptr);

    void append(const QString &line);

private:
    MeasurementModel *m_model;
};

} // namespace gorizont
