#pragma once

#include <QString>

/// Why an export came to nothing, each a sentence that says what to do. Pure.
namespace gorizont::exportsentence {

QString nothingChosen();
QString noAccelerometer();
QString emptyRange();
QString nothingFound();
QString wrongCodes(); ///< of miniSEED
QString noLocation(int number); ///< no miniSEED code for this sensor
QString sourceGone();
QString cannotWrite(const QString &path, const QString &reason);

} // namespace gorizont::exportsentence
