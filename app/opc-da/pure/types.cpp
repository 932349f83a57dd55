#include "app/opc-da/pure/types.h"

#include <algorithm>
#include <array>

namespace opcda {

namespace {
// Numbers of VARTYPE, [MS-OAUT] 2.2.7; the pure half does not see the headers of Windows.
constexpr std::uint16_t Empty = 0;
constexpr std::uint16_t R8 = 5;
constexpr std::uint16_t Bool = 11;
// I2 I4 R4 R8 CY DATE BSTR BOOL DECIMAL I1 UI1 UI2 UI4 I8 UI8 INT UINT
constexpr std::array<std::uint16_t, 17> Offered{2, 3, 4, R8, 6, 7, 8, Bool, 14, 16, 17, 18, 19, 20, 21, 22, 23};
} // namespace

std::uint16_t canonicalType(TagType type)
{
    return type == TagType::Bool ? Bool : R8;
}

bool isOffered(std::uint16_t variantType)
{
    return variantType == Empty || std::find(Offered.begin(), Offered.end(), variantType) != Offered.end();
}

bool passesFilter(TagType type, std::uint16_t wanted)
{
    return wanted == Empty || wanted == canonicalType(type);
}

} // namespace opcda
