#pragma once

#include "core/station/correction.h"
#include "core/station/stationcomplaint.h"

#include <QByteArray>

namespace gorizont::station {

/// Which of the four files of corrections (manual 004, section 3.2).
enum class CorrectionKind : quint8 { Input, Meteo, Correct, Real };

/// Takes one file into \a corrections. A line that cannot be used makes them faulty. A key that is not above the one before it is
/// such a fault, since its line could never apply.
void readCorrection(
    CorrectionKind kind, const QString &file, const QByteArray &bytes, Corrections &corrections,
    Complaints &complaints);

} // namespace gorizont::station
