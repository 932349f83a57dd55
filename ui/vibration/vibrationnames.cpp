#include "ui/vibration/vibrationnames.h"

#include "core/values/vibrationkinds.h"

namespace gorizont::vibrationnames {

QString measurement(int type)
{
    const QString name = measurementName(type);
    return name.isEmpty() ? QString::number(type) : QStringLiteral("%1 %2").arg(QString::number(type), name);
}

QString accelerationUnit(const SensorConfig &sensor)
{
    constexpr int acceleration = 1; // MEAS_TYPE
    return MeasurementUnits(sensor).of(acceleration);
}

} // namespace gorizont::vibrationnames
