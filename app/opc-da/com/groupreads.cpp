// IOPCSyncIO and IOPCSyncIO2 of a group.
#include "app/opc-da/com/group.h"

namespace opcda {

HRESULT Group::Read(OPCDATASOURCE source, DWORD count, OPCHANDLE *items, OPCITEMSTATE **states, HRESULT **errors)
try {
    if (!cleared(states, errors) || (source != OPC_DS_CACHE && source != OPC_DS_DEVICE))
        return E_INVALIDARG;
    TaskArray<OPCITEMSTATE> found(count);
    const HRESULT result = forEach(count, items, errors, [&](DWORD i, auto &entry) -> HRESULT {
        const Item &item = entry.second;
        const TagState state = stateNow(item, source == OPC_DS_CACHE);
        const HRESULT error = convert(state.value, item.requested, locale(), &found[i].vDataValue);
        found[i].hClient = item.client;
        found[i].ftTimeStamp = fileTime(state.time);
        found[i].wQuality = SUCCEEDED(error) ? state.quality : WORD{0};
        return error;
    });
    if (SUCCEEDED(result))
        found.giveTo(states);
    return result;
} catch (const std::bad_alloc &) {
    return E_OUTOFMEMORY;
}

HRESULT Group::ReadMaxAge(
    DWORD count, OPCHANDLE *items, DWORD *maxAges, VARIANT **values, WORD **qualities, FILETIME **times,
    HRESULT **errors)
try {
    if (!cleared(values) || !cleared(qualities) || !cleared(times) || !cleared(errors) || !maxAges)
        return E_INVALIDARG;
    TaskArray<VARIANT> foundValues(count);
    TaskArray<WORD> foundQualities(count);
    TaskArray<FILETIME> foundTimes(count);
    const std::int64_t now = unixMilliseconds();
    const HRESULT result = forEach(count, items, errors, [&](DWORD i, auto &entry) -> HRESULT {
        const Item &item = entry.second;
        // What is too old is asked from the device, and that knows no inactive items.
        const bool fromCache = isYoung(book().state(item.tag).time, now, maxAges[i]);
        const TagState state = stateNow(item, fromCache);
        const HRESULT error = convert(state.value, item.requested, locale(), &foundValues[i]);
        foundTimes[i] = fileTime(state.time);
        foundQualities[i] = SUCCEEDED(error) ? state.quality : WORD{0};
        return error;
    });
    if (FAILED(result))
        return result;
    foundValues.giveTo(values);
    foundQualities.giveTo(qualities);
    foundTimes.giveTo(times);
    return result;
} catch (const std::bad_alloc &) {
    return E_OUTOFMEMORY;
}

HRESULT Group::Write(DWORD count, OPCHANDLE *items, VARIANT *values, HRESULT **errors)
{
    if (!values)
        return cleared(errors), E_INVALIDARG;
    return forEach(count, items, errors, [](DWORD, auto &) -> HRESULT { return OpcBadRights; });
}

HRESULT Group::WriteVQT(DWORD count, OPCHANDLE *items, OPCITEMVQT *values, HRESULT **errors)
{
    if (!values)
        return cleared(errors), E_INVALIDARG;
    return forEach(count, items, errors, [](DWORD, auto &) -> HRESULT { return OpcBadRights; });
}

} // namespace opcda
