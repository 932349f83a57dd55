#include "app/opc-da/com/factory.h"

#include "app/opc-da/com/server.h"

namespace opcda {

HRESULT Factory::CreateInstance(IUnknown *outer, REFIID wanted, void **target)
try {
    if (!cleared(target))
        return E_POINTER;
    if (outer)
        return CLASS_E_NOAGGREGATION;
    return made<Server>(m_gate)->QueryInterface(wanted, target);
} catch (const std::bad_alloc &) {
    return E_OUTOFMEMORY;
}

HRESULT Factory::LockServer(BOOL isLocked)
{
    m_gate.lock(isLocked != FALSE);
    return S_OK;
}

} // namespace opcda
