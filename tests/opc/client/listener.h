#pragma once
#include "app/opc-da/com/object.h"
#include "tests/opc/client/opcclient.h"

#include <map>
#include <mutex>

namespace opctest {

/// A client's ear: keeps what the gateway says.
class Listener final : public Object<IOPCDataCallback>
{
public:
    struct Call
    {
        enum Kind { Change, ReadComplete, WriteComplete, CancelComplete };
        Kind kind;
        DWORD transaction;
        OPCHANDLE group;
        HRESULT quality;
        HRESULT error;
        std::map<OPCHANDLE, ReadItem> items; ///< by client handle
    };

    std::vector<Call> calls();
    void clear();
    /// How many calls of a kind have come.
    std::size_t count(Call::Kind kind);
    /// What was told last of an item; false when nothing was.
    bool last(OPCHANDLE client, ReadItem &item);
    /// Every call takes this long, ms.
    std::atomic<DWORD> slowness = 0;
    std::atomic<bool> keepsCalls = true;
    std::atomic<long long> values = 0; ///< told altogether

    STDMETHODIMP OnDataChange(
        DWORD transaction, OPCHANDLE group, HRESULT quality, HRESULT error, DWORD count, OPCHANDLE *items,
        VARIANT *values, WORD *qualities, FILETIME *times, HRESULT *errors) override;
    STDMETHODIMP OnReadComplete(
        DWORD transaction, OPCHANDLE group, HRESULT quality, HRESULT error, DWORD count, OPCHANDLE *items,
        VARIANT *values, WORD *qualities, FILETIME *times, HRESULT *errors) override;
    STDMETHODIMP
    OnWriteComplete(
        DWORD transaction, OPCHANDLE group, HRESULT error, DWORD count, OPCHANDLE *items, HRESULT *errors) override;
    STDMETHODIMP OnCancelComplete(DWORD transaction, OPCHANDLE group) override;

private:
    HRESULT take(
        Call call, DWORD count, const OPCHANDLE *items, const VARIANT *told, const WORD *qualities,
        const FILETIME *times, const HRESULT *errors);

    std::mutex m_mutex;
    std::vector<Call> m_calls;
    std::map<OPCHANDLE, ReadItem> m_last;
};

/// A subscription of a group, ended by unadvise() or left to the end of the group.
struct Subscription
{
    ComPtr<Listener> listener = made<Listener>();
    ComPtr<IConnectionPoint> point;
    DWORD cookie = 0;
    HRESULT result = E_FAIL;

    explicit Subscription(IOPCItemMgt *group);
    HRESULT unadvise();
};

} // namespace opctest
