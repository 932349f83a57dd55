#pragma once

#include "core/devices/buildingmotion.h"
#include "core/devices/ind3/ind3dialect.h"

#include <QByteArray>

namespace gorizont::ind3 {

/// What a simulated ИН-Д3 is and remembers, whatever protocol it is asked in. It shares no line of code with the codecs,
/// so that a mistake of theirs meets no twin here.
struct SimulatedSensor
{
    BuildingMotion motion;
    int address = 1;
    Dialect dialect = Dialect::V211;
    quint32 serialNumber = 0;
    quint16 revision = 4144; ///< type 2, revision 48, as on the picture of manual 000, section 8.7
    QByteArray name = QByteArrayLiteral("NO NAME"); ///< Windows-1251
    int baudCode = 4; ///< 9600; kept, a simulated line has no speed
    int ticksCode = 5; ///< 32; kept, the motion has the noise of an averaged sensor already
    int periodCode = 2; ///< 50 ms; kept likewise
    double offset[2] = {0, 0}; ///< Y, X, arc-seconds; subtracted from what it measures
    double factoryOffset[2] = {0, 0}; ///< Y, X, arc-seconds
    quint8 selfTest = 0; ///< 0 good; 0x10 program, 0x11 settings, 0x12 both check sums wrong
    bool isInBootLoader = false; ///< register 38 was written: silent until it restarts

    double angle(int axis, BuildingMotion::Time now) const ///< \a axis: 0 Y, 1 X; arc-seconds
    {
        return (axis == 0 ? motion.tiltY(now) : motion.tiltX(now)) - offset[axis];
    }
};

/// Six bytes, Y before X: fraction, low byte, then sign, unit and high bits.
QByteArray angleBytes(double y, double x);

/// The same back to arc-seconds; \a bytes has three.
double angleOfBytes(const QByteArray &bytes);

} // namespace gorizont::ind3
