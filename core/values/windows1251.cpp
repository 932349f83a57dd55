#include "core/values/windows1251.h"

#include <algorithm>
#include <array>
#include <optional>

namespace gorizont {

namespace {

/// Codes 80h…BFh. Below them is ASCII, above them А…я in the order of Unicode.
constexpr std::array<char16_t, 64> middle{
    0x0402, 0x0403, 0x201A, 0x0453, 0x201E, 0x2026, 0x2020, 0x2021, //
    0x20AC, 0x2030, 0x0409, 0x2039, 0x040A, 0x040C, 0x040B, 0x040F, //
    0x0452, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014, //
    0x0098, 0x2122, 0x0459, 0x203A, 0x045A, 0x045C, 0x045B, 0x045F, //
    0x00A0, 0x040E, 0x045E, 0x0408, 0x00A4, 0x0490, 0x00A6, 0x00A7, //
    0x0401, 0x00A9, 0x0404, 0x00AB, 0x00AC, 0x00AD, 0x00AE, 0x0407, //
    0x00B0, 0x00B1, 0x0406, 0x0456, 0x0491, 0x00B5, 0x00B6, 0x00B7, //
    0x0451, 0x2116, 0x0454, 0x00BB, 0x0458, 0x0405, 0x0455, 0x0457, //
};

constexpr int middleStart = 0x80;
constexpr int lettersStart = 0xC0;

char16_t decoded(unsigned char code)
{
    if (code < middleStart) {
        return code;
    }
    if (code < lettersStart) {
        return middle[static_cast<std::size_t>(code - middleStart)];
    }
    return static_cast<char16_t>(u'А' + (code - lettersStart));
}

std::optional<char> encoded(QChar character)
{
    const char16_t unit = character.unicode();
    if (unit < middleStart) {
        return static_cast<char>(unit);
    }
    if (unit >= u'А' && unit <= u'я') {
        return static_cast<char>(lettersStart + (unit - u'А'));
    }
    const auto *const found = std::find(middle.begin(), middle.end(), unit);
    if (found == middle.end()) {
        return std::nullopt;
    }
    return static_cast<char>(middleStart + (found - middle.begin()));
}

} // namespace

QString decodeWindows1251(QByteArrayView bytes)
{
    QString text(bytes.size(), Qt::Uninitialized);
    std::transform(bytes.begin(), bytes.end(), text.begin(), [](char byte) {
        return QChar(decoded(static_cast<unsigned char>(byte)));
    });
    return text;
}

QByteArray encodeWindows1251(QStringView text)
{
    QByteArray bytes;
    bytes.reserve(text.size());
    for (const QChar character : text) {
        bytes.append(encoded(character).value_or('?'));
    }
    return bytes;
}

bool isEncodableInWindows1251(QStringView text)
{
    return std::all_of(text.begin(), text.end(), [](QChar character) { return encoded(character).has_value(); });
}

} // namespace gorizont
