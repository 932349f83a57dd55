#include "ui/vibration/vibrationnames.h"

#include "core/devices/lvims/lvimsprotocol.h"

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
    constexpr int acceleration = 1;
    return QCoreApplication::translate("LVims", lvims::kindOf(acceleration)->unit);
}

} // namespace gorizont::vibrationnames
