#include "core/values/geometry.h"

#include <cmath>
#include <numbers>

namespace gorizont {

AxisTransform::AxisTransform(const SensorConfig &sensor)
    : m_sin(std::sin(sensor.rotationX * std::numbers::pi / 180))
    , m_cos(std::cos(sensor.rotationX * std::numbers::pi / 180))
    , m_isYInverted(sensor.isYInverted)
{
}

Tilt correctedTilt(const Tilt &measured, const AxisTransform &transform, const SensorConfig &sensor)
{
    const Tilt turned = transform(measured.x, measured.y);
    return {turned.x - sensor.offsetX, turned.y - sensor.offsetY};
}

} // namespace gorizont
