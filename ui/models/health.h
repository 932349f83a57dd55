#pragma once

#include "core/registry/sensorregistry.h"

#include <array>

namespace gorizont {

/// What an operator sees of a node at a glance: one colour and one shape each. From the best to the worst.
enum class Health : quint8 { Off, Good, Unknown, Service, Warning, Error };

constexpr std::size_t healthKinds = 6;

/// How many sensors are in which state.
struct HealthCounts
{
    std::array<int, healthKinds> sensors{};

    int operator[](Health health) const { return sensors[static_cast<std::size_t>(health)]; }
    bool operator==(const HealthCounts &) const = default;
};

Health lineHealth(LineState state);
Health sensorHealth(const SensorRegistry::Sensor &sensor, LineState line);

/// A port that works while its sensors do not is a warning, so that a collapsed tree hides nothing.
Health portHealth(LineState state, Health worstSensor);

/// Codes 2…B of manual 000, section 11.2. Code 1, a port that the ini switches off, is the operator's own wish.
bool isCritical(quint16 status);

/// Walks over all sensors once; cheap enough for a timer.
HealthCounts countHealth(const SensorRegistry &registry);

/// Of all ports, as in portHealth().
Health siteHealth(const SensorRegistry &registry);

} // namespace gorizont
