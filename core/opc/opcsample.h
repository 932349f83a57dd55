#pragma once

#include "core/opc/opctag.h"
#include "core/values/linestatus.h"
#include "core/values/sensorconfig.h"

namespace gorizont {

/// How far anything that \a sensor said last can be trusted, by its switch, its line and its status word; Good: what it said is
/// of now. Pure.
OpcQuality opcQuality(const SensorConfig &sensor, const LineStatus &line, const Reading &reading);

/// What comes after \a previous when sensor and line are as they are since \a time. While \a overall is not Good, the value stays
/// what it was. Pure.
OpcSample opcNext(
    const OpcSample &previous, OpcQuality overall, const OpcFieldValue &field, const Reading &reading, UtcTime time);

} // namespace gorizont
