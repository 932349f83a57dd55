#pragma once

#include "core/registry/sensorregistry.h"

#include <QString>

namespace gorizont {

/// What the bits of the status words mean, one line each, for tool tips. Pure.
namespace statusmeaning {

/// The code and every bit that is set in the word of manual 000, section 11.2.
QString word(quint16 status);
/// The same; the code of a vibration module says which lines are shorted or broken.
QString word(const Reading &reading);

/// The code's place and all bits 11…0: the legend of the column.
QString legend();

/// Every bit that is set in the sensor's own status word (spec/and3.md); empty for sensors without one.
QString rawWord(const SensorConfig &sensor, const Reading &reading);

} // namespace statusmeaning

} // namespace gorizont
