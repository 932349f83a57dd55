#pragma once
#include "app/opc-da/pure/addressspace.h"

namespace opcda {

/// What is known of the scale of an analog tag by its short name.
struct Scale
{
    double low = 0; ///< of the range that percent deadbands are taken from
    double high = 0; ///< not above `low`: no range is known and deadbands do not apply
    Text unit;

    bool hasRange() const { return high > low; }
};

/// Angles −3600…3600″, accelerations 0…10000 mm/s², temperature −60…100 °C (figure 11.4 shows the ends of an angle); bits and
/// reserved words have no range.
Scale scaleOf(const Tag &tag);

} // namespace opcda
