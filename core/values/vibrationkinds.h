#pragma once

#include "core/values/sensorconfig.h"

#include <QStringList>

#include <array>

namespace gorizont {

/// A type of measurement of a vibration module: manual 003, section 2.3; spec/l-vims.md, 6.
struct MeasurementKind
{
    int type = 0; ///< MEAS_TYPE
    const char *name = ""; ///< source text of context LVims
    const char *unit = ""; ///< source text of context LVims; empty: none
};

/// 0…16, at the index of their number; 0: not used.
const std::array<MeasurementKind, 17> &measurementKinds();

/// nullptr: a type that the manual does not have.
const MeasurementKind *measurementKind(int type);

/// `acceleration`, in the language of the program; empty: a type that the manual does not have.
QString measurementName(int type);

/// What the measurements of one module are given in. A module says numbers only: what they are in follows from its
/// coefficients. `MeasUnit{i}=g` names the unit of its accelerations, `MeasUnit{i}=4:mm, 5:1/s` those of types; the numbers
/// stay as they are.
class MeasurementUnits
{
public:
    /// Those of the types.
    MeasurementUnits() = default;
    explicit MeasurementUnits(const SensorConfig &sensor);

    /// In the language of the program; empty: none, or not known.
    QString of(int type) const;
    /// Entries that were not understood, a sentence each.
    QStringList complaints() const { return m_complaints; }

private:
    void take(const QString &entry, const SensorConfig &sensor);

    std::array<QString, 17> m_own; ///< by type; empty: the usual one
    QStringList m_complaints;
};

} // namespace gorizont
