// IOPCGroupStateMgt and IOPCGroupStateMgt2 of a group.
#include "app/opc-da/com/group.h"

namespace opcda {

HRESULT Group::GetState(
    DWORD *rate, BOOL *isActive, LPWSTR *name, LONG *timeBias, FLOAT *deadband, DWORD *locale, OPCHANDLE *client,
    OPCHANDLE *server)
{
    if (!rate || !isActive || !cleared(name) || !timeBias || !deadband || !locale || !client || !server)
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        *name = taskText(m_settings.name);
        *rate = m_settings.rate;
        *isActive = m_settings.isActive;
        *timeBias = m_settings.timeBias;
        *deadband = m_settings.deadband;
        *locale = m_settings.locale;
        *client = m_settings.client;
        *server = m_handle;
        return S_OK;
    });
}

HRESULT Group::SetState(
    DWORD *rate, DWORD *revisedRate, BOOL *isActive, LONG *timeBias, FLOAT *deadband, DWORD *locale, OPCHANDLE *client)
{
    if (!revisedRate || (deadband && !(*deadband >= 0 && *deadband <= 100)))
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        if (rate)
            m_settings.rate = opcda::revisedRate(*rate);
        *revisedRate = m_settings.rate;
        if (isActive) {
            if (*isActive && !m_settings.isActive)
                forget(); // who comes back is told where things stand
            m_settings.isActive = *isActive != FALSE;
        }
        m_settings.timeBias = timeBias ? *timeBias : m_settings.timeBias;
        m_settings.deadband = deadband ? *deadband : m_settings.deadband;
        m_settings.locale = locale ? *locale : m_settings.locale;
        m_settings.client = client ? *client : m_settings.client;
        m_nextDue = m_lastCall = Clock::now();
        m_session->wake();
        return rate && *rate != m_settings.rate ? OpcUnsupportedRate : S_OK;
    });
}

HRESULT Group::SetName(LPCWSTR name)
{
    const Text wanted = textOf(name);
    if (wanted.empty())
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        const Group *owner = m_session->groupByName(wanted);
        if (owner && owner != this)
            return OpcDuplicateName;
        m_settings.name = wanted;
        return S_OK;
    });
}

HRESULT Group::CloneGroup(LPCWSTR name, REFIID wanted, IUnknown **clone)
{
    if (!cleared(clone))
        return E_INVALIDARG;
    ComPtr<Group> copy; // goes after the lock when it is not wanted
    return locked([&]() -> HRESULT {
        GroupSettings settings = m_settings;
        settings.name = textOf(name);
        settings.isActive = false; // the specification wants a clone to begin inactive
        if (settings.name.empty())
            settings.name = m_session->freeName();
        else if (m_session->groupByName(settings.name))
            return OpcDuplicateName;
        std::map<OPCHANDLE, Item> items;
        for (const auto &[handle, item] : m_items) {
            Item &twin = items[m_session->gate().nextHandle()] = item;
            twin.sent.reset();
        }
        copy = made<Group>(m_session, std::move(settings), std::move(items));
        const HRESULT found = copy->QueryInterface(wanted, reinterpret_cast<void **>(clone));
        if (SUCCEEDED(found))
            m_session->groups.emplace(copy->handle(), copy);
        return found;
    });
}

HRESULT Group::SetKeepAlive(DWORD time, DWORD *revisedTime)
{
    if (!revisedTime)
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        m_settings.keepAlive = *revisedTime = revisedKeepAlive(time);
        m_session->wake();
        return time == *revisedTime ? S_OK : OpcUnsupportedRate;
    });
}

HRESULT Group::GetKeepAlive(DWORD *time)
{
    if (!time)
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        *time = m_settings.keepAlive;
        return S_OK;
    });
}

} // namespace opcda
