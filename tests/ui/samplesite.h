#pragma once

#include "core/config/serverconfig.h"
#include "core/registry/sensorregistry.h"

namespace gorizont::test {

/// A small site: COM4 with an АН-Д3 (N 1, address 12) and an ИН-Д3 (N 2, address 24), COM9 with an ИН-Д3 (N 3, address 5)
/// and a sensor that is off (N 4, address 6), COM2 off, without sensors.
ServerConfig sampleConfig();

/// What the sensor N 1 answers: the numbers of the samples in spec/gorizont.md, section 8.
Reading sampleReading(SteadyTime now);

/// An answer of an ИН-Д3: tilt in arc-seconds, nothing else is valid.
Reading tiltReading(int number, double x, double y, SteadyTime now);

LineStatus openLine(int port, SteadyTime since);

} // namespace gorizont::test
