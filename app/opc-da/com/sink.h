#pragma once
#include "app/opc-da/com/enumerators.h"
#include "app/opc-da/com/gate.h"

#include <functional>

namespace opcda {

/// Whether a result of a call says that the other process is no longer there.
bool isGone(HRESULT result);

/// Where a client leaves the object it wants to be called at; one at a time. A part of its container and alive with it.
template <class Sink> class SinkPoint final : public IConnectionPoint
{
public:
    SinkPoint(Gate &gate, IConnectionPointContainer *container)
        : m_gate(gate)
        , m_container(container)
    {
    }
    virtual ~SinkPoint() = default;

    /// Under the lock of the gate.
    ComPtr<Sink> sink() const { return m_sink; }
    /// Under the lock; the caller releases what it gets after the lock.
    ComPtr<Sink> taken() { return std::move(m_sink); }
    /// Called under the lock after a client has subscribed or left.
    std::function<void()> changed = [] {};

    HRESULT STDMETHODCALLTYPE QueryInterface(REFIID wanted, void **found) override
    {
        if (!found)
            return E_POINTER;
        const bool isMine = IsEqualIID(wanted, __uuidof(IUnknown)) || IsEqualIID(wanted, __uuidof(IConnectionPoint));
        *found = isMine ? this : nullptr;
        if (!isMine)
            return E_NOINTERFACE;
        AddRef();
        return S_OK;
    }
    ULONG STDMETHODCALLTYPE AddRef() override { return m_container->AddRef(); }
    ULONG STDMETHODCALLTYPE Release() override { return m_container->Release(); }

    HRESULT STDMETHODCALLTYPE GetConnectionInterface(IID *id) override
    {
        if (!id)
            return E_POINTER;
        *id = __uuidof(Sink);
        return S_OK;
    }
    HRESULT STDMETHODCALLTYPE GetConnectionPointContainer(IConnectionPointContainer **container) override
    {
        return container
            ? m_container->QueryInterface(__uuidof(IConnectionPointContainer), reinterpret_cast<void **>(container))
            : E_POINTER;
    }
    HRESULT STDMETHODCALLTYPE Advise(IUnknown *client, DWORD *cookie) override
    {
        if (!client || !cookie)
            return E_POINTER;
        *cookie = 0;
        ComPtr<Sink> sink;
        if (FAILED(client->QueryInterface(__uuidof(Sink), reinterpret_cast<void **>(sink.GetAddressOf()))))
            return CONNECT_E_CANNOTCONNECT;
        return m_gate.locked([&]() -> HRESULT {
            if (m_sink)
                return CONNECT_E_ADVISELIMIT;
            m_sink = sink;
            m_cookie = *cookie = m_gate.nextHandle();
            changed();
            return S_OK;
        });
    }
    HRESULT STDMETHODCALLTYPE Unadvise(DWORD cookie) override
    {
        ComPtr<Sink> left;
        return m_gate.locked([&]() -> HRESULT {
            if (!m_sink || cookie != m_cookie)
                return CONNECT_E_NOCONNECTION;
            left = taken();
            changed();
            return S_OK;
        });
    }
    HRESULT STDMETHODCALLTYPE EnumConnections(IEnumConnections **enumerator) override
    {
        if (!enumerator)
            return E_POINTER;
        *enumerator = nullptr;
        return m_gate.locked([&]() -> HRESULT {
            std::vector<Connection> connections;
            if (m_sink)
                connections.push_back({m_sink, m_cookie});
            *enumerator = made<ConnectionEnumerator>(std::move(connections)).Detach();
            return S_OK;
        });
    }

private:
    Gate &m_gate;
    IConnectionPointContainer *m_container;
    ComPtr<Sink> m_sink;
    DWORD m_cookie = 0;
};

} // namespace opcda
