#pragma once
#include "app/opc-da/com/platform.h"

#include <atomic>

namespace opcda {

/// Counts references and answers for the given interfaces. Lives as long as somebody holds it, on any thread.
template <class First, class... Rest> class Object : public First, public Rest...
{
public:
    Object() = default;
    Object(const Object &) = delete;
    Object &operator=(const Object &) = delete;

    HRESULT STDMETHODCALLTYPE QueryInterface(REFIID wanted, void **found) override
    {
        if (!found)
            return E_POINTER;
        *found = IsEqualIID(wanted, __uuidof(IUnknown)) || IsEqualIID(wanted, __uuidof(First))
            ? static_cast<First *>(this)
            : nullptr;
        (offer<Rest>(wanted, found), ...);
        if (!*found)
            *found = inherited(wanted);
        if (!*found)
            return E_NOINTERFACE;
        AddRef();
        return S_OK;
    }
    ULONG STDMETHODCALLTYPE AddRef() override { return ++m_references; }
    ULONG STDMETHODCALLTYPE Release() override
    {
        const ULONG left = --m_references;
        if (left == 0)
            delete this;
        return left;
    }

protected:
    virtual ~Object() = default;

    /// A reference for whoever knows the object without holding it; null when it is being deleted already.
    ComPtr<IUnknown> held()
    {
        ComPtr<IUnknown> self;
        ULONG known = m_references;
        while (known > 0 && !m_references.compare_exchange_weak(known, known + 1)) {
        }
        if (known > 0)
            *self.GetAddressOf() = static_cast<First *>(this);
        return self;
    }

    /// The interface of this object that another of its interfaces derives from; null when it has no such one.
    virtual void *inherited(REFIID) { return nullptr; }
    ULONG references() const { return m_references; }

private:
    template <class Interface> void offer(REFIID wanted, void **found)
    {
        if (IsEqualIID(wanted, __uuidof(Interface)))
            *found = static_cast<Interface *>(this);
    }

    std::atomic<ULONG> m_references = 1;
};

/// A new object in the caller's hands.
template <class Made, class... Arguments> ComPtr<Made> made(Arguments &&...arguments)
{
    ComPtr<Made> object;
    *object.GetAddressOf() = new Made(std::forward<Arguments>(arguments)...); // Attach() of mingw-w64 would add a reference
    return object;
}

} // namespace opcda
