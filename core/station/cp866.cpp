#include "core/station/cp866.h"

#include <algorithm>

namespace gorizont::station {

namespace {

/// Codes 80h…FFh.
constexpr QStringView upperHalf = u"АБВГДЕЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯабвгдежзийклмноп"
                                  u"░▒▓│┤╡╢╖╕╣║╗╝╜╛┐└┴┬├─┼╞╟╚╔╩╦╠═╬╧╨╤╥╙╘╒╓╫╪┘┌█▄▌▐▀"
                                  u"рстуфхцчшщъыьэюяЁёЄєЇїЎў°∙·√№¤■\u00A0";
constexpr int upperStart = 0x80;
static_assert(upperHalf.size() == 0x100 - upperStart);

} // namespace

QString decodeCp866(QByteArrayView bytes)
{
    QString text(bytes.size(), Qt::Uninitialized);
    std::transform(bytes.begin(), bytes.end(), text.begin(), [](char byte) {
        const auto code = static_cast<unsigned char>(byte);
        return code < upperStart ? QChar(ushort(code)) : upperHalf[code - upperStart];
    });
    return text;
}

} // namespace gorizont::station
