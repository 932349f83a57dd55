#pragma once

#include "core/values/reading.h"
#include "core/values/sensorconfig.h"

namespace gorizont {

/// From the axes of a device to those of the site: Y turned over if InvY, then both turned by RotX.
/// Computed once for a sensor; accelerations use it without offsets (spec/gorizont.md, section 2).
class AxisTransform
{
public:
    explicit AxisTransform(const SensorConfig &sensor);

    Tilt operator()(double x, double y) const
    {
        const double turned = m_isYInverted ? -y : y;
        return {x * m_cos + turned * m_sin, -x * m_sin + turned * m_cos};
    }

private:
    double m_sin;
    double m_cos;
    bool m_isYInverted;
};

/// Tilt with axes and offsets applied, arc-seconds.
Tilt correctedTilt(const Tilt &measured, const AxisTransform &transform, const SensorConfig &sensor);

} // namespace gorizont
