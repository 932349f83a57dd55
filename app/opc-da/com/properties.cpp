// What the properties of a tag are worth.
#include "app/opc-da/com/server.h"
#include "app/opc-da/pure/types.h"

namespace opcda {

namespace {

// Identifiers of the specification, 5.1.2.
enum Property : DWORD {
    CanonicalType = 1,
    CurrentValue = 2,
    Quality = 3,
    Timestamp = 4,
    AccessRights = 5,
    ScanRate = 6,
    EuType = 7,
    EuUnits = 100,
    Description = 101,
    HighEu = 102,
    LowEu = 103
};

void setDate(VARIANT *value, std::int64_t unixMs)
{
    constexpr double DaysTo1970 = 25569; // VT_DATE counts days from 30 December 1899
    constexpr double MsADay = 86400000;
    value->vt = VT_DATE;
    value->date = DaysTo1970 + static_cast<double>(unixMs) / MsADay;
}

void setWord(VARIANT *value, std::uint16_t word)
{
    value->vt = VT_I2;
    value->iVal = static_cast<SHORT>(word);
}

void setLong(VARIANT *value, LONG number)
{
    value->vt = VT_I4;
    value->lVal = number;
}

void setDouble(VARIANT *value, double number)
{
    value->vt = VT_R8;
    value->dblVal = number;
}

constexpr float FeedStep = 50; ///< ms, how often the main program tells what has changed

} // namespace

std::vector<DWORD> propertiesOf(const Tag &tag)
{
    std::vector<DWORD> known{CanonicalType, CurrentValue, Quality, Timestamp,
                             AccessRights,  ScanRate,     EuType,  Description};
    const Scale scale = scaleOf(tag);
    if (!scale.unit.empty())
        known.insert(known.end() - 1, EuUnits);
    if (scale.hasRange())
        known.insert(known.end(), {HighEu, LowEu});
    return known;
}

VARTYPE typeOfProperty(DWORD property, const Tag &tag)
{
    switch (property) {
    case CanonicalType:
    case Quality: return VT_I2;
    case CurrentValue: return canonicalType(tag.type);
    case Timestamp: return VT_DATE;
    case AccessRights:
    case EuType: return VT_I4;
    case ScanRate: return VT_R4;
    case EuUnits:
    case Description: return VT_BSTR;
    case HighEu:
    case LowEu: return VT_R8;
    default: return VT_EMPTY;
    }
}

HRESULT propertyValue(DWORD property, const Tag &tag, const TagState &state, VARIANT *value)
{
    VariantInit(value);
    const std::vector<DWORD> known = propertiesOf(tag);
    if (std::find(known.begin(), known.end(), property) == known.end())
        return OpcInvalidPid;
    const Scale scale = scaleOf(tag);
    switch (property) {
    case CanonicalType: setWord(value, canonicalType(tag.type)); break;
    case CurrentValue: return convert(state.value, VT_EMPTY, 0, value);
    case Quality: setWord(value, state.quality); break;
    case Timestamp: setDate(value, state.time); break;
    case AccessRights: setLong(value, OpcReadable); break;
    case ScanRate:
        value->vt = VT_R4;
        value->fltVal = FeedStep;
        break;
    case EuType: setLong(value, scale.hasRange() ? OPC_ANALOG : OPC_NOENUM); break;
    case EuUnits: *value = variantOf(scale.unit); break;
    case Description: *value = variantOf(tag.description); break;
    case HighEu: setDouble(value, scale.high); break;
    default: setDouble(value, scale.low); break;
    }
    return S_OK;
}

} // namespace opcda
