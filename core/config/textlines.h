#pragma once

#include <QByteArrayList>
#include <QString>

namespace gorizont {

enum class TextEncoding : quint8 { Utf8, Utf8Bom, Utf16Le, Utf16Be, Windows1251 };

/// BOM → UTF-8 or UTF-16; else valid UTF-8 → UTF-8; else Windows-1251 (spec/gorizont.md, section 1).
TextEncoding detectEncoding(const QByteArray &bytes);

QByteArray byteOrderMark(TextEncoding encoding); ///< empty for encodings without one

/// Cuts \a bytes (without their BOM) behind every CR LF, LF and lone CR. Each piece keeps its line end, so the pieces
/// joined are the bytes again, whatever they are.
QByteArrayList splitLines(const QByteArray &bytes, TextEncoding encoding);

/// Bytes that make no character become U+FFFD.
QString decodeText(QByteArrayView bytes, TextEncoding encoding);
/// Without a BOM. A character that the encoding does not have becomes `?`.
QByteArray encodeText(QStringView text, TextEncoding encoding);

} // namespace gorizont
