#include "app/opc-da/com/group.h"

#include "app/opc-da/pure/engineering.h"

namespace opcda {

Notice::~Notice()
{
    for (VARIANT &value : values)
        VariantClear(&value);
}

Group::Group(std::shared_ptr<Session> session, GroupSettings settings, std::map<OPCHANDLE, Item> items)
    : m_session(std::move(session))
    , m_handle(m_session->gate().nextHandle())
    , m_settings(std::move(settings))
    , m_items(std::move(items))
    , m_callbacks(m_session->gate(), this)
{
    m_callbacks.changed = [this] {
        forget();
        m_nextDue = m_lastCall = Clock::now();
        m_session->wake();
    };
}

void *Group::inherited(REFIID wanted)
{
    if (IsEqualIID(wanted, __uuidof(IOPCGroupStateMgt)))
        return static_cast<IOPCGroupStateMgt *>(this);
    if (IsEqualIID(wanted, __uuidof(IOPCSyncIO)))
        return static_cast<IOPCSyncIO *>(this);
    if (IsEqualIID(wanted, __uuidof(IOPCAsyncIO2)))
        return static_cast<IOPCAsyncIO2 *>(this);
    return nullptr;
}

ComPtr<IOPCDataCallback> Group::remove()
{
    m_isRemoved = true;
    return m_callbacks.taken();
}

void Group::forget()
{
    for (auto &[handle, item] : m_items)
        item.sent.reset();
}

Clock::time_point Group::due() const
{
    const bool isHeard = m_callbacks.sink() && m_settings.isActive && m_isEnabled;
    if (!isHeard)
        return Clock::time_point::max();
    if (m_settings.keepAlive == 0)
        return m_nextDue;
    return std::min(m_nextDue, m_lastCall + std::chrono::milliseconds(m_settings.keepAlive));
}

TagState Group::stateNow(const Item &item, bool fromCache) const
{
    TagState state = book().state(item.tag);
    if (fromCache && (!m_settings.isActive || !item.isActive))
        state.quality = quality::OutOfService;
    return state;
}

void Group::add(Notice &notice, const Item &item, const TagState &state) const
{
    VARIANT value;
    const HRESULT error = convert(state.value, item.requested, locale(), &value);
    notice.handles.push_back(item.client);
    notice.values.push_back(value);
    notice.qualities.push_back(SUCCEEDED(error) ? state.quality : WORD{0});
    notice.times.push_back(fileTime(state.time));
    notice.errors.push_back(error);
}

void Group::publish(std::unique_lock<std::mutex> &lock, Clock::time_point now)
{
    const bool isKept = now < m_nextDue; // it is the keep-alive that is due
    Notice notice;
    if (!isKept) {
        m_nextDue = std::max(m_nextDue + std::chrono::milliseconds(m_settings.rate), now);
        for (auto &[handle, item] : m_items) {
            const TagState &state = book().state(item.tag);
            if (!item.isActive || (item.sent && item.sent->version == state.version))
                continue;
            const Scale scale = scaleOf(book().names().at(item.tag));
            if (item.sent
                && !isNews(*item.sent, state, item.deadband.value_or(m_settings.deadband), scale.low, scale.high))
                continue;
            item.sent = state;
            add(notice, item, state);
        }
    }
    const bool isAliveDue =
        m_settings.keepAlive > 0 && now >= m_lastCall + std::chrono::milliseconds(m_settings.keepAlive);
    if (!notice.handles.empty() || isAliveDue)
        call(lock, notice, 0, false);
}

void Group::answer(std::unique_lock<std::mutex> &lock, const Session::Reading &reading)
{
    Notice notice;
    for (const OPCHANDLE handle : reading.items) {
        const auto found = m_items.find(handle);
        if (found == m_items.end())
            continue;
        const TagState state = stateNow(found->second, false);
        add(notice, found->second, state);
        if (reading.isRefresh)
            found->second.sent = state;
    }
    call(lock, notice, reading.transaction, !reading.isRefresh);
}

void Group::call(std::unique_lock<std::mutex> &lock, Notice &notice, DWORD transaction, bool isReading)
{
    ComPtr<IOPCDataCallback> sink = m_callbacks.sink();
    if (!sink || isGone())
        return;
    const bool isGoodThroughout = std::all_of(notice.qualities.begin(), notice.qualities.end(), quality::isGood);
    const bool isWithoutError =
        std::all_of(notice.errors.begin(), notice.errors.end(), [](HRESULT e) { return e == S_OK; });
    const auto count = static_cast<DWORD>(notice.handles.size());
    const OPCHANDLE client = m_settings.client;
    m_lastCall = Clock::now();
    m_session->lastUpdate = fileTime(unixMilliseconds());
    if (count == 0) { // arrays of a length of 0 still need an address
        notice.handles.reserve(1);
        notice.values.reserve(1);
        notice.qualities.reserve(1);
        notice.times.reserve(1);
        notice.errors.reserve(1);
    }
    lock.unlock();
    const auto method = isReading ? &IOPCDataCallback::OnReadComplete : &IOPCDataCallback::OnDataChange;
    const HRESULT result = (sink.Get()->*method)(
        transaction, client, isGoodThroughout ? S_OK : S_FALSE, isWithoutError ? S_OK : S_FALSE, count,
        notice.handles.data(), notice.values.data(), notice.qualities.data(), notice.times.data(),
        notice.errors.data());
    lock.lock();
    ComPtr<IOPCDataCallback> lost;
    if (opcda::isGone(result) && m_callbacks.sink() == sink)
        lost = m_callbacks.taken();
    lock.unlock();
    lost.Reset();
    sink.Reset();
    lock.lock();
}

void Group::tellCancelled(std::unique_lock<std::mutex> &lock, DWORD transaction)
{
    ComPtr<IOPCDataCallback> sink = m_callbacks.sink();
    const OPCHANDLE client = m_settings.client;
    lock.unlock();
    if (sink)
        sink->OnCancelComplete(transaction, client);
    sink.Reset();
    lock.lock();
}

HRESULT Group::EnumConnectionPoints(IEnumConnectionPoints **points)
{
    if (!cleared(points))
        return E_POINTER;
    return m_session->gate().locked([&]() -> HRESULT {
        *points = made<PointEnumerator>(std::vector{ComPtr<IConnectionPoint>(&m_callbacks)}).Detach();
        return S_OK;
    });
}

HRESULT Group::FindConnectionPoint(REFIID wanted, IConnectionPoint **point)
{
    if (!cleared(point))
        return E_POINTER;
    if (!IsEqualIID(wanted, __uuidof(IOPCDataCallback)))
        return CONNECT_E_NOCONNECTION;
    return m_callbacks.QueryInterface(__uuidof(IConnectionPoint), reinterpret_cast<void **>(point));
}

} // namespace opcda
