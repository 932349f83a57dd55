#pragma once

#include "core/values/vibration.h"

#include <QString>

namespace gorizont {

/// What a vibration module says, in the language of the program: for window, tool and messages. Pure.
namespace vibrationtext {

QString stateText(ChannelState state); ///< `the line of the sensor is shorted`
QString stateText(const VibrationChannel &channel); ///< of a channel that is not in use: that it is off

/// `fault, warning`: what of fault, warning, stop and baseline is raised; empty: nothing.
QString raised(const VibrationMeasurement &measurement);
/// `fault?, stop?`: which of the three the module does not know; empty: none.
QString unknown(const VibrationMeasurement &measurement);

/// `Line of the sensor shorted: channel 0, 2; line of the sensor broken: channel 1`; empty: no channel in use has such a fault.
QString lineFaults(const Vibration &vibration);

/// `70.7107`, `1500.0`: about six digits, a point in every locale.
QString number(double value);

} // namespace vibrationtext

} // namespace gorizont
