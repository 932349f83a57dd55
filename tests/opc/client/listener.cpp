#include "tests/opc/client/listener.h"

namespace opctest {

std::vector<Listener::Call> Listener::calls()
{
    const std::scoped_lock lock(m_mutex);
    return m_calls;
}

void Listener::clear()
{
    const std::scoped_lock lock(m_mutex);
    m_calls.clear();
    m_last.clear();
}

std::size_t Listener::count(Call::Kind kind)
{
    const std::scoped_lock lock(m_mutex);
    std::size_t found = 0;
    for (const Call &call : m_calls)
        found += call.kind == kind ? 1 : 0;
    return found;
}

bool Listener::last(OPCHANDLE client, ReadItem &item)
{
    const std::scoped_lock lock(m_mutex);
    const auto found = m_last.find(client);
    if (found == m_last.end())
        return false;
    item = found->second;
    return true;
}

HRESULT Listener::take(
    Call call, DWORD count, const OPCHANDLE *items, const VARIANT *told, const WORD *qualities, const FILETIME *times,
    const HRESULT *errors)
{
    for (DWORD i = 0; i < count; ++i) {
        ReadItem item = told ? readItem(told[i]) : ReadItem();
        item.error = errors[i];
        item.quality = qualities ? qualities[i] : WORD{0};
        item.client = items[i];
        item.time = times ? times[i] : FILETIME{};
        call.items[items[i]] = item;
    }
    Sleep(slowness);
    values += count;
    const std::scoped_lock lock(m_mutex);
    for (const auto &[client, item] : call.items)
        m_last[client] = item;
    if (keepsCalls)
        m_calls.push_back(std::move(call));
    return S_OK;
}

HRESULT Listener::OnDataChange(
    DWORD transaction, OPCHANDLE group, HRESULT quality, HRESULT error, DWORD count, OPCHANDLE *items, VARIANT *told,
    WORD *qualities, FILETIME *times, HRESULT *errors)
{
    return take({Call::Change, transaction, group, quality, error, {}}, count, items, told, qualities, times, errors);
}

HRESULT Listener::OnReadComplete(
    DWORD transaction, OPCHANDLE group, HRESULT quality, HRESULT error, DWORD count, OPCHANDLE *items, VARIANT *told,
    WORD *qualities, FILETIME *times, HRESULT *errors)
{
    return take(
        {Call::ReadComplete, transaction, group, quality, error, {}}, count, items, told, qualities, times, errors);
}

HRESULT Listener::OnWriteComplete(
    DWORD transaction, OPCHANDLE group, HRESULT error, DWORD count, OPCHANDLE *items, HRESULT *errors)
{
    return take(
        {Call::WriteComplete, transaction, group, S_OK, error, {}}, count, items, nullptr, nullptr, nullptr, errors);
}

HRESULT Listener::OnCancelComplete(DWORD transaction, OPCHANDLE group)
{
    return take(
        {Call::CancelComplete, transaction, group, S_OK, S_OK, {}}, 0, nullptr, nullptr, nullptr, nullptr, nullptr);
}

Subscription::Subscription(IOPCItemMgt *group)
{
    const auto container = as<IConnectionPointContainer>(group);
    if (container && SUCCEEDED(container->FindConnectionPoint(__uuidof(IOPCDataCallback), point.GetAddressOf())))
        result = point->Advise(listener.Get(), &cookie);
}

HRESULT Subscription::unadvise()
{
    return point ? point->Unadvise(cookie) : E_FAIL;
}

} // namespace opctest
