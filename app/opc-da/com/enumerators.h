#pragma once
#include "app/opc-da/com/object.h"
#include "app/opc-da/com/taskmemory.h"

#include <algorithm>
#include <vector>

namespace opcda {

// How each kind of element is handed to a client.
inline void hand(const Text &element, LPOLESTR *target)
{
    *target = taskText(element);
}
inline void hand(const ComPtr<IUnknown> &element, IUnknown **target)
{
    element.CopyTo(target);
}
inline void hand(const ComPtr<IConnectionPoint> &element, IConnectionPoint **target)
{
    element.CopyTo(target);
}

/// A subscription as an enumerator shows it.
struct Connection
{
    ComPtr<IUnknown> sink;
    DWORD cookie;
};
inline void hand(const Connection &element, CONNECTDATA *target)
{
    target->dwCookie = element.cookie;
    element.sink.CopyTo(&target->pUnk);
}

/// A list as it was when the client asked, walked through by Next, Skip, Reset and Clone.
template <class Interface, class Element, class Handed> class Enumerator final : public Object<Interface>
{
public:
    explicit Enumerator(std::vector<Element> elements, std::size_t position = 0)
        : m_elements(std::move(elements))
        , m_position(position)
    {
    }

    HRESULT STDMETHODCALLTYPE Next(ULONG wanted, Handed *targets, ULONG *fetched) override
    try {
        if (!targets || (!fetched && wanted != 1))
            return E_POINTER;
        ULONG given = 0;
        while (given < wanted && m_position < m_elements.size())
            hand(m_elements[m_position++], &targets[given++]);
        if (fetched)
            *fetched = given;
        return given == wanted ? S_OK : S_FALSE;
    } catch (const std::bad_alloc &) {
        return E_OUTOFMEMORY;
    }
    HRESULT STDMETHODCALLTYPE Skip(ULONG count) override
    {
        const std::size_t left = m_elements.size() - m_position;
        m_position += std::min<std::size_t>(count, left);
        return count <= left ? S_OK : S_FALSE;
    }
    HRESULT STDMETHODCALLTYPE Reset() override
    {
        m_position = 0;
        return S_OK;
    }
    HRESULT STDMETHODCALLTYPE Clone(Interface **copy) override
    try {
        if (!copy)
            return E_POINTER;
        *copy = made<Enumerator>(m_elements, m_position).Detach();
        return S_OK;
    } catch (const std::bad_alloc &) {
        return E_OUTOFMEMORY;
    }

private:
    const std::vector<Element> m_elements;
    std::size_t m_position;
};

using StringEnumerator = Enumerator<IEnumString, Text, LPOLESTR>;
using UnknownEnumerator = Enumerator<IEnumUnknown, ComPtr<IUnknown>, IUnknown *>;
using PointEnumerator = Enumerator<IEnumConnectionPoints, ComPtr<IConnectionPoint>, IConnectionPoint *>;
using ConnectionEnumerator = Enumerator<IEnumConnections, Connection, CONNECTDATA>;

/// What CreateEnumerator of a group tells of an item.
struct ItemAttributes
{
    Text id;
    bool isActive = true;
    OPCHANDLE client = 0;
    OPCHANDLE server = 0;
    VARTYPE requested = VT_EMPTY;
    VARTYPE canonical = VT_EMPTY;
    double low = 0;
    double high = 0;
};

/// The items of a group; Next allocates its array itself, unlike the enumerators of COM.
class ItemEnumerator final : public Object<IEnumOPCItemAttributes>
{
public:
    explicit ItemEnumerator(std::vector<ItemAttributes> items, std::size_t position = 0);

    HRESULT STDMETHODCALLTYPE Next(ULONG wanted, OPCITEMATTRIBUTES **items, ULONG *fetched) override;
    HRESULT STDMETHODCALLTYPE Skip(ULONG count) override;
    HRESULT STDMETHODCALLTYPE Reset() override;
    HRESULT STDMETHODCALLTYPE Clone(IEnumOPCItemAttributes **copy) override;

private:
    const std::vector<ItemAttributes> m_items;
    std::size_t m_position;
};

} // namespace opcda
