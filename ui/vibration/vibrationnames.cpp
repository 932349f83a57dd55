#include "ui/vibration/vibrationnames.h"

#include "core/devices/lvims/lvimsprotocol.h"
#include "ui/plots/plottext.h"

#include <QCoreApplication>

namespace gorizont::vibrationnames {

QString measurement(int type)
{
    const lvims::MeasurementKind *kind = lvims::kindOf(type);
    return kind ? QStringLiteral("%1 %2").arg(QString::number(type), QCoreApplication::translate("LVims", kind->name))
                : QString::number(type);
}

QString accelerationUnit(const SensorConfig &)
{
    return plottext::unitOf(ValueAxis::Acceleration, TiltUnit::Degrees);
}

} // namespace gorizont::vibrationnames
