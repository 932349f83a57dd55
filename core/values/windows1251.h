#pragma once

#include <QByteArray>
#include <QString>

namespace gorizont {

/// Windows-1251, the encoding of the original program's files. Qt knows it only when it was built with ICU, so it
/// stands here. The one code without a character, 98h, is U+0098 and back, so that every byte survives.
QString decodeWindows1251(QByteArrayView bytes);

/// A character that Windows-1251 does not have becomes `?`.
QByteArray encodeWindows1251(QStringView text);

bool isEncodableInWindows1251(QStringView text);

} // namespace gorizont
