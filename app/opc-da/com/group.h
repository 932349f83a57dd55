#pragma once
#include "app/opc-da/com/session.h"
#include "app/opc-da/com/sink.h"

namespace opcda {

/// What a client set of a group; CloneGroup copies it.
struct GroupSettings
{
    Text name;
    bool isActive = true;
    DWORD rate = 0; ///< ms, as revised
    OPCHANDLE client = 0;
    LONG timeBias = 0; ///< minutes
    float deadband = 0; ///< percent of the scale of an item
    LCID locale = 0;
    DWORD keepAlive = 0; ///< ms, 0: off
};

/// One item in a group.
struct Item
{
    int tag = 0; ///< index in the book
    Text id; ///< as the client wrote it
    bool isActive = true;
    OPCHANDLE client = 0;
    VARTYPE requested = VT_EMPTY;
    std::optional<float> deadband; ///< percent; the group's when not set
    std::optional<TagState> sent; ///< what the client was told last
};

/// The arguments of one callback.
struct Notice
{
    std::vector<OPCHANDLE> handles;
    std::vector<VARIANT> values;
    std::vector<WORD> qualities;
    std::vector<FILETIME> times;
    std::vector<HRESULT> errors;

    Notice() = default;
    Notice(const Notice &) = delete;
    Notice &operator=(const Notice &) = delete;
    ~Notice();
};

/// A group of a client: items, their reading and their subscription. Its methods come on any thread.
class Group final
    : public Object<
          IOPCItemMgt, IOPCGroupStateMgt2, IOPCSyncIO2, IOPCAsyncIO3, IOPCItemDeadbandMgt, IConnectionPointContainer>
{
public:
    /// Under the lock. The items of another group come along when it is cloned.
    Group(std::shared_ptr<Session> session, GroupSettings settings, std::map<OPCHANDLE, Item> items = {});

    // Under the lock of the gate.
    const Text &name() const { return m_settings.name; }
    OPCHANDLE handle() const { return m_handle; }
    DWORD rate() const { return m_settings.rate; }
    bool isHeld() const { return references() > 1; }
    /// Takes the group out of service; what is returned is to be released after the lock.
    ComPtr<IOPCDataCallback> remove();
    /// When the client is to be called next; never, when nobody listens.
    Clock::time_point due() const;
    // These let go of the lock while the client is called.
    void publish(std::unique_lock<std::mutex> &lock, Clock::time_point now);
    void answer(std::unique_lock<std::mutex> &lock, const Session::Reading &reading);
    void tellCancelled(std::unique_lock<std::mutex> &lock, DWORD transaction);

    // IOPCItemMgt
    STDMETHODIMP AddItems(DWORD count, OPCITEMDEF *wanted, OPCITEMRESULT **results, HRESULT **errors) override;
    STDMETHODIMP ValidateItems(
        DWORD count, OPCITEMDEF *wanted, BOOL updatesBlobs, OPCITEMRESULT **results, HRESULT **errors) override;
    STDMETHODIMP RemoveItems(DWORD count, OPCHANDLE *items, HRESULT **errors) override;
    STDMETHODIMP SetActiveState(DWORD count, OPCHANDLE *items, BOOL isActive, HRESULT **errors) override;
    STDMETHODIMP SetClientHandles(DWORD count, OPCHANDLE *items, OPCHANDLE *clients, HRESULT **errors) override;
    STDMETHODIMP SetDatatypes(DWORD count, OPCHANDLE *items, VARTYPE *types, HRESULT **errors) override;
    STDMETHODIMP CreateEnumerator(REFIID wanted, IUnknown **enumerator) override;

    // IOPCGroupStateMgt, IOPCGroupStateMgt2
    STDMETHODIMP GetState(
        DWORD *rate, BOOL *isActive, LPWSTR *name, LONG *timeBias, FLOAT *deadband, DWORD *locale, OPCHANDLE *client,
        OPCHANDLE *server) override;
    STDMETHODIMP SetState(
        DWORD *rate, DWORD *revisedRate, BOOL *isActive, LONG *timeBias, FLOAT *deadband, DWORD *locale,
        OPCHANDLE *client) override;
    STDMETHODIMP SetName(LPCWSTR name) override;
    STDMETHODIMP CloneGroup(LPCWSTR name, REFIID wanted, IUnknown **clone) override;
    STDMETHODIMP SetKeepAlive(DWORD time, DWORD *revisedTime) override;
    STDMETHODIMP GetKeepAlive(DWORD *time) override;

    // IOPCSyncIO, IOPCSyncIO2
    STDMETHODIMP
    Read(OPCDATASOURCE source, DWORD count, OPCHANDLE *items, OPCITEMSTATE **states, HRESULT **errors) override;
    STDMETHODIMP Write(DWORD count, OPCHANDLE *items, VARIANT *values, HRESULT **errors) override;
    STDMETHODIMP ReadMaxAge(
        DWORD count, OPCHANDLE *items, DWORD *maxAges, VARIANT **values, WORD **qualities, FILETIME **times,
        HRESULT **errors) override;
    STDMETHODIMP WriteVQT(DWORD count, OPCHANDLE *items, OPCITEMVQT *values, HRESULT **errors) override;

    // IOPCAsyncIO2, IOPCAsyncIO3
    STDMETHODIMP
    Read(DWORD count, OPCHANDLE *items, DWORD transaction, DWORD *cancelId, HRESULT **errors) override;
    STDMETHODIMP Write(
        DWORD count, OPCHANDLE *items, VARIANT *values, DWORD transaction, DWORD *cancelId, HRESULT **errors) override;
    STDMETHODIMP Refresh2(OPCDATASOURCE source, DWORD transaction, DWORD *cancelId) override;
    STDMETHODIMP Cancel2(DWORD cancelId) override;
    STDMETHODIMP SetEnable(BOOL isEnabled) override;
    STDMETHODIMP GetEnable(BOOL *isEnabled) override;
    STDMETHODIMP ReadMaxAge(
        DWORD count, OPCHANDLE *items, DWORD *maxAges, DWORD transaction, DWORD *cancelId, HRESULT **errors) override;
    STDMETHODIMP WriteVQT(
        DWORD count, OPCHANDLE *items, OPCITEMVQT *values, DWORD transaction, DWORD *cancelId,
        HRESULT **errors) override;
    STDMETHODIMP RefreshMaxAge(DWORD maxAge, DWORD transaction, DWORD *cancelId) override;

    // IOPCItemDeadbandMgt
    STDMETHODIMP SetItemDeadband(DWORD count, OPCHANDLE *items, FLOAT *percents, HRESULT **errors) override;
    STDMETHODIMP GetItemDeadband(DWORD count, OPCHANDLE *items, FLOAT **percents, HRESULT **errors) override;
    STDMETHODIMP ClearItemDeadband(DWORD count, OPCHANDLE *items, HRESULT **errors) override;

    // IConnectionPointContainer
    STDMETHODIMP EnumConnectionPoints(IEnumConnectionPoints **points) override;
    STDMETHODIMP FindConnectionPoint(REFIID wanted, IConnectionPoint **point) override;

private:
    ~Group() override = default;
    void *inherited(REFIID wanted) override;

    bool isGone() const { return m_isRemoved || m_session->isClosed(); }
    TagBook &book() const { return m_session->gate().book(); }
    /// Runs `work` under the lock unless the group has been removed.
    template <class Work> HRESULT locked(Work work)
    {
        return m_session->gate().locked([&]() -> HRESULT { return isGone() ? E_FAIL : work(); });
    }
    /// Runs `work(position, item)` for each handle and gathers the results; S_FALSE when not all are S_OK.
    template <class Work> HRESULT forEach(DWORD count, const OPCHANDLE *items, HRESULT **errors, Work work);

    HRESULT checked(const OPCITEMDEF &wanted, Item &item, OPCITEMRESULT &result) const;
    TagState stateNow(const Item &item, bool fromCache) const;
    void add(Notice &notice, const Item &item, const TagState &state) const;
    void call(std::unique_lock<std::mutex> &lock, Notice &notice, DWORD transaction, bool isReading);
    HRESULT checkHeard(); ///< CONNECT_E_NOCONNECTION when nobody has subscribed
    HRESULT refresh(DWORD transaction, DWORD *cancelId);
    void forget(); ///< every item counts as not yet told
    LCID locale() const { return m_settings.locale ? m_settings.locale : m_session->locale; }

    const std::shared_ptr<Session> m_session;
    const OPCHANDLE m_handle;
    GroupSettings m_settings;
    std::map<OPCHANDLE, Item> m_items; ///< by server handle
    SinkPoint<IOPCDataCallback> m_callbacks;
    bool m_isEnabled = true;
    bool m_isRemoved = false;
    Clock::time_point m_nextDue = Clock::now();
    Clock::time_point m_lastCall = Clock::now();
};

template <class Work> HRESULT Group::forEach(DWORD count, const OPCHANDLE *items, HRESULT **errors, Work work)
{
    if (!cleared(errors) || !items || count == 0)
        return E_INVALIDARG;
    return locked([&]() -> HRESULT {
        TaskArray<HRESULT> results(count);
        bool isAllWell = true;
        for (DWORD i = 0; i < count; ++i) {
            const auto found = m_items.find(items[i]);
            results[i] = found == m_items.end() ? OpcInvalidHandle : work(i, *found);
            isAllWell = isAllWell && results[i] == S_OK;
        }
        results.giveTo(errors);
        return isAllWell ? S_OK : S_FALSE;
    });
}

} // namespace opcda
