#include "app/opc-da/com/enumerators.h"

#include "app/opc-da/com/variants.h"

namespace opcda {

namespace {

/// Low and high end of the scale, as the specification wants them for an analog item.
VARIANT range(double low, double high)
{
    VARIANT value;
    VariantInit(&value);
    SAFEARRAY *ends = SafeArrayCreateVector(VT_R8, 0, 2);
    if (!ends)
        throw std::bad_alloc();
    LONG index = 0;
    SafeArrayPutElement(ends, &index, &low);
    index = 1;
    SafeArrayPutElement(ends, &index, &high);
    value.vt = VT_ARRAY | VT_R8;
    value.parray = ends;
    return value;
}

OPCITEMATTRIBUTES handed(const ItemAttributes &item)
{
    OPCITEMATTRIBUTES attributes{};
    attributes.szAccessPath = taskText({});
    attributes.szItemID = taskText(item.id);
    attributes.bActive = item.isActive;
    attributes.hClient = item.client;
    attributes.hServer = item.server;
    attributes.dwAccessRights = OpcReadable;
    attributes.vtRequestedDataType = item.requested;
    attributes.vtCanonicalDataType = item.canonical;
    attributes.dwEUType = item.high > item.low ? OPC_ANALOG : OPC_NOENUM;
    if (item.high > item.low)
        attributes.vEUInfo = range(item.low, item.high);
    return attributes;
}

} // namespace

ItemEnumerator::ItemEnumerator(std::vector<ItemAttributes> items, std::size_t position)
    : m_items(std::move(items))
    , m_position(position)
{
}

HRESULT ItemEnumerator::Next(ULONG wanted, OPCITEMATTRIBUTES **items, ULONG *fetched)
try {
    if (!cleared(items) || !fetched)
        return E_POINTER;
    *fetched = 0;
    const auto count = static_cast<ULONG>(std::min<std::size_t>(wanted, m_items.size() - m_position));
    TaskArray<OPCITEMATTRIBUTES> array(count);
    for (ULONG i = 0; i < count; ++i)
        array[i] = handed(m_items[m_position++]);
    array.giveTo(items);
    *fetched = count;
    return count == wanted ? S_OK : S_FALSE;
} catch (const std::bad_alloc &) {
    return E_OUTOFMEMORY;
}

HRESULT ItemEnumerator::Skip(ULONG count)
{
    const std::size_t left = m_items.size() - m_position;
    m_position += std::min<std::size_t>(count, left);
    return count <= left ? S_OK : S_FALSE;
}

HRESULT ItemEnumerator::Reset()
{
    m_position = 0;
    return S_OK;
}

HRESULT ItemEnumerator::Clone(IEnumOPCItemAttributes **copy)
try {
    if (!cleared(copy))
        return E_POINTER;
    *copy = made<ItemEnumerator>(m_items, m_position).Detach();
    return S_OK;
} catch (const std::bad_alloc &) {
    return E_OUTOFMEMORY;
}

} // namespace opcda
