#include "ui/vibration/vibrationnames.h"

#include "core/values/vibrationkinds.h"

namespace gorizont::vibrationnames {

QString measurement(int type)
{
    return QStringLiteral("%1 %2").arg(QString::number(type), measurementName(type)).trimmed();
}

QString accelerationUnit(const SensorConfig &sensor)
{
    constexpr int acceleration = 1;
    return MeasurementUnits(sensor).of(acceleration);
}

} // namespace gorizont::vibrationnames
