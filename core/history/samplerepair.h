#pragma once

#include <QStringList>

namespace gorizont {

/// What is left of a program that was killed between X and Y, or lost its power: of every sensor the newest pair (by its
/// name) in \a folder is cut to the shorter, even length; a pair without a sample is removed. Call it before the first
/// pair is opened. Returns the names of the files that were changed or removed.
QStringList repairSampleFiles(const QString &folder);

} // namespace gorizont
