#pragma once

#include "core/values/quantity.h"
#include "core/values/series.h"

#include <QString>

namespace gorizont {

/// In what angles are drawn and read: as the tables show them, or as small changes are spoken of.
enum class TiltUnit : quint8 { Degrees, ArcSeconds };

/// Quantities of one unit share an axis.
enum class ValueAxis : quint8 { Tilt, Temperature, Power, Frequency, Acceleration, Direction, Displacement, Wind, Pressure, Humidity };

/// How quantities are named, counted and written in plots. Pure.
namespace plottext {

ValueAxis axisOf(Quantity quantity);

/// What is drawn = value × scale.
double scaleOf(Quantity quantity, TiltUnit unit);

/// `"`, `°`, `mm/s²`
QString unitOf(ValueAxis axis, TiltUnit unit);
/// `Tilt, °`
QString axisTitle(ValueAxis axis, TiltUnit unit);

/// `Mx`, `Amax X`: as the headings of the tables.
QString quantity(Quantity quantity);
/// `1 АН-Д3 [Этаж 2] Mx`
QString curve(const SensorConfig &sensor, Quantity quantity);

/// A drawn value with the digits its unit deserves; `—` without one.
QString value(std::optional<double> drawn, ValueAxis axis, TiltUnit unit);
/// The same with its sign.
QString signedValue(std::optional<double> drawn, ValueAxis axis, TiltUnit unit);

/// Local time: `22.11.2026 06:18:54`
QString moment(UtcTime time);
/// `1 d 02:03:04`
QString duration(std::chrono::microseconds time);

} // namespace plottext

} // namespace gorizont
