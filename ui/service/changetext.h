#pragma once

#include "core/devices/and3/and3service.h"
#include "core/devices/ind3/ind3service.h"

namespace gorizont {

/// What the service windows say about a change of a sensor, while it is made and afterwards. Pure.
namespace changetext {

/// One setting each, in the order in which they are written.
QList<ind3::Changes> oneByOne(const ind3::Changes &all);

QString setting(const ind3::Changes &change); ///< `name “Roof”`; \a change holds one setting
QString outcome(const Result<void> &written); ///< `written`: what became of it, to stand after its name

/// Where a change of address to \a to stopped, and what the sensor has now.
QString failure(const and3::AddressChange &change, int to);

} // namespace changetext

} // namespace gorizont
