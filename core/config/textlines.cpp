#include "core/config/textlines.h"

#include "core/values/windows1251.h"

#include <QtEndian>

namespace gorizont {

namespace {

qsizetype unitSize(TextEncoding encoding)
{
    return encoding == TextEncoding::Utf16Le || encoding == TextEncoding::Utf16Be ? 2 : 1;
}

char16_t unitAt(QByteArrayView bytes, qsizetype offset, TextEncoding encoding)
{
    switch (encoding) {
    case TextEncoding::Utf16Le: return qFromLittleEndian<char16_t>(bytes.data() + offset);
    case TextEncoding::Utf16Be: return qFromBigEndian<char16_t>(bytes.data() + offset);
    case TextEncoding::Utf8:
    case TextEncoding::Utf8Bom:
    case TextEncoding::Windows1251: break;
    }
    return static_cast<unsigned char>(bytes.at(offset));
}

QString decodeUtf16(QByteArrayView bytes, TextEncoding encoding)
{
    QString text;
    text.reserve(bytes.size() / 2 + 1);
    for (qsizetype at = 0; at + 2 <= bytes.size(); at += 2) {
        text.append(QChar(unitAt(bytes, at, encoding)));
    }
    if (bytes.size() % 2 != 0) {
        text.append(QChar::ReplacementCharacter);
    }
    return text;
}

QByteArray encodeUtf16(QStringView text, TextEncoding encoding)
{
    QByteArray bytes(text.size() * 2, Qt::Uninitialized);
    if (encoding == TextEncoding::Utf16Le) {
        qToLittleEndian<char16_t>(text.utf16(), text.size(), bytes.data());
    } else {
        qToBigEndian<char16_t>(text.utf16(), text.size(), bytes.data());
    }
    return bytes;
}

} // namespace

TextEncoding detectEncoding(const QByteArray &bytes)
{
    for (const TextEncoding encoding : {TextEncoding::Utf8Bom, TextEncoding::Utf16Le, TextEncoding::Utf16Be}) {
        if (bytes.startsWith(byteOrderMark(encoding))) {
            return encoding;
        }
    }
    return bytes.isValidUtf8() ? TextEncoding::Utf8 : TextEncoding::Windows1251;
}

QByteArray byteOrderMark(TextEncoding encoding)
{
    switch (encoding) {
    case TextEncoding::Utf8Bom: return QByteArrayLiteral("\xEF\xBB\xBF");
    case TextEncoding::Utf16Le: return QByteArrayLiteral("\xFF\xFE");
    case TextEncoding::Utf16Be: return QByteArrayLiteral("\xFE\xFF");
    case TextEncoding::Utf8:
    case TextEncoding::Windows1251: break;
    }
    return {};
}

QByteArrayList splitLines(const QByteArray &bytes, TextEncoding encoding)
{
    const qsizetype unit = unitSize(encoding);
    const qsizetype size = bytes.size();
    QByteArrayList lines;
    qsizetype start = 0;
    for (qsizetype at = 0; at + unit <= size; at += unit) {
        const char16_t character = unitAt(bytes, at, encoding);
        const qsizetype next = at + unit;
        const bool isBeforeLf = next + unit <= size && unitAt(bytes, next, encoding) == u'\n';
        if (character == u'\n' || (character == u'\r' && !isBeforeLf)) {
            lines.append(bytes.mid(start, next - start));
            start = next;
        }
    }
    if (start < size) {
        lines.append(bytes.mid(start));
    }
    return lines;
}

QString decodeText(QByteArrayView bytes, TextEncoding encoding)
{
    switch (encoding) {
    case TextEncoding::Utf16Le:
    case TextEncoding::Utf16Be: return decodeUtf16(bytes, encoding);
    case TextEncoding::Windows1251: return decodeWindows1251(bytes);
    case TextEncoding::Utf8:
    case TextEncoding::Utf8Bom: break;
    }
    return QString::fromUtf8(bytes);
}

QByteArray encodeText(QStringView text, TextEncoding encoding)
{
    switch (encoding) {
    case TextEncoding::Utf16Le:
    case TextEncoding::Utf16Be: return encodeUtf16(text, encoding);
    case TextEncoding::Windows1251: return encodeWindows1251(text);
    case TextEncoding::Utf8:
    case TextEncoding::Utf8Bom: break;
    }
    return text.toUtf8();
}

} // namespace gorizont
