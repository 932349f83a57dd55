// IOPCBrowseServerAddressSpace and IOPCItemIO of the server object.
#include "app/opc-da/com/server.h"
#include "app/opc-da/pure/types.h"

namespace opcda {

HRESULT Server::findItem(const wchar_t *id, int &tag) const
{
    const Text name = textOf(id);
    if (!isWellFormed(name))
        return OpcInvalidItemId;
    const std::optional<int> found = book().names().find(name);
    if (!found || !book().names().at(*found).isListed)
        return OpcUnknownItemId;
    tag = *found;
    return S_OK;
}

HRESULT Server::QueryOrganization(OPCNAMESPACETYPE *organization)
{
    if (!organization)
        return E_INVALIDARG;
    *organization = OPC_NS_HIERARCHIAL;
    return S_OK;
}

HRESULT Server::ChangeBrowsePosition(OPCBROWSEDIRECTION direction, LPCWSTR name)
{
    const Text wanted = textOf(name);
    return locked([&]() -> HRESULT {
        Text &position = m_session->browsePosition;
        if (direction == OPC_BROWSE_UP) {
            if (position.empty())
                return E_FAIL;
            position = book().names().above(position);
            return S_OK;
        }
        if ((direction != OPC_BROWSE_DOWN && direction != OPC_BROWSE_TO)
            || (direction == OPC_BROWSE_DOWN && wanted.empty()))
            return E_INVALIDARG;
        const Text target = direction == OPC_BROWSE_DOWN ? joined(position, wanted) : wanted;
        if (!book().names().branch(target))
            return E_INVALIDARG;
        position = target;
        return S_OK;
    });
}

HRESULT Server::BrowseOPCItemIDs(OPCBROWSETYPE kind, LPCWSTR filter, VARTYPE type, DWORD rights, IEnumString **names)
{
    if (!cleared(names) || kind < OPC_BRANCH || kind > OPC_FLAT || (rights & ~(OpcReadable | OpcWriteable)))
        return E_INVALIDARG;
    const Text pattern = textOf(filter);
    return locked([&]() -> HRESULT {
        std::vector<Text> found;
        const auto add = [&](const Text &name, int tag) {
            const bool isReadable = rights == 0 || (rights & OpcReadable);
            if (isReadable && passesFilter(book().names().at(tag).type, type) && matches(pattern, name))
                found.push_back(name);
        };
        const AddressSpace::Branch *here = book().names().branch(m_session->browsePosition);
        if (!here) { // it went with a change of the main program's configuration
            m_session->browsePosition.clear();
            here = book().names().branch({});
        }
        if (kind == OPC_BRANCH) {
            std::copy_if(
                here->branches.begin(), here->branches.end(), std::back_inserter(found),
                [&](const Text &name) { return matches(pattern, name); });
        } else if (kind == OPC_LEAF) {
            for (const auto &[name, tag] : here->leaves)
                add(name, tag);
        } else {
            for (const int tag : book().names().below(here->id))
                add(book().names().at(tag).id, tag);
        }
        const bool isEmpty = found.empty();
        *names = made<StringEnumerator>(std::move(found)).Detach();
        return isEmpty ? S_FALSE : S_OK;
    });
}

HRESULT Server::GetItemID(LPWSTR name, LPWSTR *id)
{
    if (!cleared(id))
        return E_INVALIDARG;
    const Text wanted = textOf(name);
    return locked([&]() -> HRESULT {
        const AddressSpace &names = book().names();
        const Text &position = m_session->browsePosition;
        const Text whole = wanted.empty() ? position : joined(position, wanted);
        const auto isThere = [&names](const Text &candidate) {
            return names.find(candidate) || names.branch(candidate);
        };
        // A flat list gives whole names; they are taken as they are.
        if (!isThere(whole) && !isThere(wanted))
            return OpcUnknownItemId;
        *id = taskText(isThere(whole) ? whole : wanted);
        return S_OK;
    });
}

HRESULT Server::BrowseAccessPaths(LPCWSTR, IEnumString **paths)
{
    cleared(paths);
    return E_NOTIMPL; // items have no access paths; the specification answers this so
}

HRESULT Server::Read(
    DWORD count, LPCWSTR *ids, DWORD *maxAges, VARIANT **values, WORD **qualities, FILETIME **times, HRESULT **errors)
{
    if (!cleared(values) || !cleared(qualities) || !cleared(times) || !cleared(errors) || !ids || !maxAges
        || count == 0)
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        TaskArray<VARIANT> foundValues(count);
        TaskArray<WORD> foundQualities(count);
        TaskArray<FILETIME> foundTimes(count);
        TaskArray<HRESULT> codes(count);
        bool isAllWell = true;
        for (DWORD i = 0; i < count; ++i) {
            int tag = 0;
            codes[i] = findItem(ids[i], tag);
            isAllWell = isAllWell && codes[i] == S_OK;
            if (codes[i] != S_OK)
                continue;
            const TagState &state = book().state(tag);
            convert(state.value, VT_EMPTY, 0, &foundValues[i]);
            foundQualities[i] = state.quality;
            foundTimes[i] = fileTime(state.time);
        }
        foundValues.giveTo(values);
        foundQualities.giveTo(qualities);
        foundTimes.giveTo(times);
        codes.giveTo(errors);
        return isAllWell ? S_OK : S_FALSE;
    });
}

HRESULT Server::WriteVQT(DWORD count, LPCWSTR *ids, OPCITEMVQT *values, HRESULT **errors)
{
    if (!cleared(errors) || !ids || !values || count == 0)
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        TaskArray<HRESULT> codes(count);
        for (DWORD i = 0; i < count; ++i) {
            int tag = 0;
            const HRESULT found = findItem(ids[i], tag);
            codes[i] = FAILED(found) ? found : OpcBadRights;
        }
        codes.giveTo(errors);
        return S_FALSE;
    });
}

} // namespace opcda
