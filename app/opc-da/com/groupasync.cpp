// IOPCAsyncIO2 and IOPCAsyncIO3 of a group. What the main program has told is the newest there is, so a reading «from the
// device» and one from the cache differ only for inactive items.
#include "app/opc-da/com/group.h"

namespace opcda {

HRESULT Group::checkHeard()
{
    return locked([this]() -> HRESULT { return m_callbacks.sink() ? S_OK : CONNECT_E_NOCONNECTION; });
}

HRESULT Group::Read(DWORD count, OPCHANDLE *items, DWORD transaction, DWORD *cancelId, HRESULT **errors)
{
    if (!cancelId)
        return cleared(errors), E_INVALIDARG;
    *cancelId = 0;
    std::vector<OPCHANDLE> wanted;
    if (const HRESULT heard = checkHeard(); FAILED(heard))
        return cleared(errors), heard;
    const HRESULT result = forEach(count, items, errors, [&wanted](DWORD, auto &entry) -> HRESULT {
        wanted.push_back(entry.first);
        return S_OK;
    });
    if (FAILED(result) || wanted.empty())
        return result;
    const HRESULT queued = locked([&]() -> HRESULT {
        *cancelId = m_session->gate().nextHandle();
        return m_session->enqueue(
            Session::Reading{ComPtr<Group>(this), transaction, *cancelId, false, std::move(wanted)});
    });
    if (FAILED(queued)) {
        CoTaskMemFree(*errors);
        *errors = nullptr;
        return queued;
    }
    return result;
}

HRESULT Group::ReadMaxAge(
    DWORD count, OPCHANDLE *items, DWORD *maxAges, DWORD transaction, DWORD *cancelId, HRESULT **errors)
{
    return maxAges ? Read(count, items, transaction, cancelId, errors) : (cleared(errors), E_INVALIDARG);
}

HRESULT Group::Write(DWORD count, OPCHANDLE *items, VARIANT *values, DWORD, DWORD *cancelId, HRESULT **errors)
{
    if (!cancelId)
        return cleared(errors), E_INVALIDARG;
    *cancelId = 0; // nothing can be written, so no transaction begins
    if (const HRESULT heard = checkHeard(); FAILED(heard))
        return cleared(errors), heard;
    return Write(count, items, values, errors);
}

HRESULT Group::WriteVQT(DWORD count, OPCHANDLE *items, OPCITEMVQT *values, DWORD, DWORD *cancelId, HRESULT **errors)
{
    if (!cancelId)
        return cleared(errors), E_INVALIDARG;
    *cancelId = 0;
    if (const HRESULT heard = checkHeard(); FAILED(heard))
        return cleared(errors), heard;
    return WriteVQT(count, items, values, errors);
}

HRESULT Group::refresh(DWORD transaction, DWORD *cancelId)
{
    if (!cancelId)
        return E_INVALIDARG;
    *cancelId = 0;
    return locked([&]() -> HRESULT {
        if (!m_callbacks.sink())
            return CONNECT_E_NOCONNECTION;
        std::vector<OPCHANDLE> active;
        for (const auto &[handle, item] : m_items) {
            if (item.isActive)
                active.push_back(handle);
        }
        if (!m_settings.isActive || active.empty())
            return E_FAIL;
        *cancelId = m_session->gate().nextHandle();
        return m_session->enqueue(
            Session::Reading{ComPtr<Group>(this), transaction, *cancelId, true, std::move(active)});
    });
}

HRESULT Group::Refresh2(OPCDATASOURCE source, DWORD transaction, DWORD *cancelId)
{
    return source == OPC_DS_CACHE || source == OPC_DS_DEVICE ? refresh(transaction, cancelId) : E_INVALIDARG;
}

HRESULT Group::RefreshMaxAge(DWORD, DWORD transaction, DWORD *cancelId)
{
    return refresh(transaction, cancelId);
}

HRESULT Group::Cancel2(DWORD cancelId)
{
    return locked([&]() -> HRESULT { return m_session->cancel(this, cancelId) ? S_OK : E_FAIL; });
}

HRESULT Group::SetEnable(BOOL isEnabled)
{
    return locked([&]() -> HRESULT {
        if (!m_callbacks.sink())
            return CONNECT_E_NOCONNECTION;
        m_isEnabled = isEnabled != FALSE;
        m_nextDue = m_lastCall = Clock::now();
        m_session->wake();
        return S_OK;
    });
}

HRESULT Group::GetEnable(BOOL *isEnabled)
{
    if (!isEnabled)
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        if (!m_callbacks.sink())
            return CONNECT_E_NOCONNECTION;
        *isEnabled = m_isEnabled;
        return S_OK;
    });
}

} // namespace opcda
