#pragma once

#include "core/values/quantity.h"

#include <QString>

/// The names of quantities, units and columns in files and dialogs. Pure.
namespace gorizont::exportname {

/// `tilt-x`: for the command line and for CSV that programs read; the same in every language.
QString key(Quantity quantity);
/// Empty: no quantity has this key.
std::optional<Quantity> quantityOfKey(const QString &key);
/// `arcsec`: plain ASCII, the same in every language.
QString unitKey(Quantity quantity);

QString quantity(Quantity quantity); ///< `Tilt X`, in the language of the program
QString unit(Quantity quantity); ///< `arc-seconds`, in the language of the program

/// Digits after the decimal mark: one more than the device resolves.
int decimals(Quantity quantity);

} // namespace gorizont::exportname
