#pragma once

#include "core/protocol/scan.h"

#include <QByteArray>
#include <QStringList>

#include <optional>

namespace gorizont::test {

/// What Line::exchange() would return for \a bytes arriving in pieces of \a size bytes (0: in one); nothing if it would
/// go on waiting.
std::optional<QByteArray> answerIn(const ScanFunction &scan, const QByteArray &bytes, qsizetype size = 0);

/// The properties that every scan has for a good \a answer of its own: each prefix is Incomplete, the whole is Complete,
/// also after \a garbage, after a beginning of itself and byte by byte. Returns what does not hold.
QStringList brokenProperties(const ScanFunction &scan, const QByteArray &answer, const QByteArray &garbage);

/// The places (byte.bit) of \a answer whose flip is not refused. Empty: the check sum guards every bit.
QStringList unguardedBits(const ScanFunction &scan, const QByteArray &answer);

} // namespace gorizont::test
