// IOPCItemMgt and IOPCItemDeadbandMgt of a group.
#include "app/opc-da/com/group.h"
#include "app/opc-da/pure/engineering.h"
#include "app/opc-da/pure/types.h"

namespace opcda {

HRESULT Group::checked(const OPCITEMDEF &wanted, Item &item, OPCITEMRESULT &result) const
{
    item.id = textOf(wanted.szItemID);
    if (wanted.szAccessPath && *wanted.szAccessPath)
        return OpcUnknownPath;
    if (!isWellFormed(item.id))
        return OpcInvalidItemId;
    const std::optional<int> tag = book().names().find(item.id);
    if (!tag || !book().names().at(*tag).isListed)
        return OpcUnknownItemId;
    result.vtCanonicalDataType = canonicalType(book().names().at(*tag).type);
    result.dwAccessRights = OpcReadable;
    if (!isOffered(wanted.vtRequestedDataType))
        return OpcBadType;
    item.tag = *tag;
    item.isActive = wanted.bActive != FALSE;
    item.client = wanted.hClient;
    item.requested = wanted.vtRequestedDataType;
    return S_OK;
}

HRESULT Group::AddItems(DWORD count, OPCITEMDEF *wanted, OPCITEMRESULT **results, HRESULT **errors)
{
    if (!cleared(results, errors) || !wanted || count == 0)
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        TaskArray<OPCITEMRESULT> answers(count);
        TaskArray<HRESULT> codes(count);
        bool isAllWell = true;
        for (DWORD i = 0; i < count; ++i) {
            Item item;
            codes[i] = checked(wanted[i], item, answers[i]);
            isAllWell = isAllWell && codes[i] == S_OK;
            if (codes[i] != S_OK)
                continue;
            answers[i].hServer = m_session->gate().nextHandle();
            m_items.emplace(answers[i].hServer, std::move(item));
        }
        answers.giveTo(results);
        codes.giveTo(errors);
        return isAllWell ? S_OK : S_FALSE;
    });
}

HRESULT Group::ValidateItems(DWORD count, OPCITEMDEF *wanted, BOOL, OPCITEMRESULT **results, HRESULT **errors)
{
    if (!cleared(results, errors) || !wanted || count == 0)
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        TaskArray<OPCITEMRESULT> answers(count);
        TaskArray<HRESULT> codes(count);
        bool isAllWell = true;
        for (DWORD i = 0; i < count; ++i) {
            Item item;
            codes[i] = checked(wanted[i], item, answers[i]);
            isAllWell = isAllWell && codes[i] == S_OK;
        }
        answers.giveTo(results);
        codes.giveTo(errors);
        return isAllWell ? S_OK : S_FALSE;
    });
}

HRESULT Group::RemoveItems(DWORD count, OPCHANDLE *items, HRESULT **errors)
{
    return forEach(count, items, errors, [this](DWORD, auto &entry) -> HRESULT {
        m_items.erase(OPCHANDLE(entry.first));
        return S_OK;
    });
}

HRESULT Group::SetActiveState(DWORD count, OPCHANDLE *items, BOOL isActive, HRESULT **errors)
{
    return forEach(count, items, errors, [isActive](DWORD, auto &entry) -> HRESULT {
        if (isActive && !entry.second.isActive)
            entry.second.sent.reset(); // who comes back is told where things stand
        entry.second.isActive = isActive != FALSE;
        return S_OK;
    });
}

HRESULT Group::SetClientHandles(DWORD count, OPCHANDLE *items, OPCHANDLE *clients, HRESULT **errors)
{
    if (!clients)
        return cleared(errors), E_INVALIDARG;
    return forEach(count, items, errors, [clients](DWORD i, auto &entry) -> HRESULT {
        entry.second.client = clients[i];
        return S_OK;
    });
}

HRESULT Group::SetDatatypes(DWORD count, OPCHANDLE *items, VARTYPE *types, HRESULT **errors)
{
    if (!types)
        return cleared(errors), E_INVALIDARG;
    return forEach(count, items, errors, [types](DWORD i, auto &entry) -> HRESULT {
        if (!isOffered(types[i]))
            return OpcBadType;
        entry.second.requested = types[i];
        entry.second.sent.reset();
        return S_OK;
    });
}

HRESULT Group::CreateEnumerator(REFIID wanted, IUnknown **enumerator)
{
    if (!cleared(enumerator))
        return E_INVALIDARG;
    ComPtr<ItemEnumerator> list;
    const HRESULT result = locked([&]() -> HRESULT {
        std::vector<ItemAttributes> items;
        for (const auto &[handle, item] : m_items) {
            const Tag &tag = book().names().at(item.tag);
            const Scale scale = scaleOf(tag);
            items.push_back(
                {item.id, item.isActive, item.client, handle, item.requested, canonicalType(tag.type), scale.low,
                 scale.high});
        }
        const bool isEmpty = items.empty();
        list = made<ItemEnumerator>(std::move(items));
        return isEmpty ? S_FALSE : S_OK;
    });
    if (FAILED(result))
        return result;
    const HRESULT found = list->QueryInterface(wanted, reinterpret_cast<void **>(enumerator));
    return FAILED(found) ? found : result;
}

HRESULT Group::SetItemDeadband(DWORD count, OPCHANDLE *items, FLOAT *percents, HRESULT **errors)
{
    if (!percents)
        return cleared(errors), E_INVALIDARG;
    return forEach(count, items, errors, [this, percents](DWORD i, auto &entry) -> HRESULT {
        if (!scaleOf(book().names().at(entry.second.tag)).hasRange())
            return OpcDeadbandNotSupported;
        if (!(percents[i] >= 0 && percents[i] <= 100))
            return E_INVALIDARG;
        entry.second.deadband = percents[i];
        return S_OK;
    });
}

HRESULT Group::GetItemDeadband(DWORD count, OPCHANDLE *items, FLOAT **percents, HRESULT **errors)
try {
    if (!cleared(percents, errors))
        return E_INVALIDARG;
    TaskArray<FLOAT> found(count);
    const HRESULT result = forEach(count, items, errors, [this, &found](DWORD i, auto &entry) -> HRESULT {
        if (!scaleOf(book().names().at(entry.second.tag)).hasRange())
            return OpcDeadbandNotSupported;
        found[i] = entry.second.deadband.value_or(0);
        return entry.second.deadband ? S_OK : OpcDeadbandNotSet;
    });
    if (SUCCEEDED(result))
        found.giveTo(percents);
    return result;
} catch (const std::bad_alloc &) {
    return E_OUTOFMEMORY;
}

HRESULT Group::ClearItemDeadband(DWORD count, OPCHANDLE *items, HRESULT **errors)
{
    return forEach(count, items, errors, [this](DWORD, auto &entry) -> HRESULT {
        if (!scaleOf(book().names().at(entry.second.tag)).hasRange())
            return OpcDeadbandNotSupported;
        if (!entry.second.deadband)
            return OpcDeadbandNotSet;
        entry.second.deadband.reset();
        return S_OK;
    });
}

} // namespace opcda
