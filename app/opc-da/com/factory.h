#pragma once
#include "app/opc-da/com/gate.h"
#include "app/opc-da/com/object.h"

namespace opcda {

/// Makes a server object for each client.
class Factory final : public Object<IClassFactory>
{
public:
    explicit Factory(Gate &gate)
        : m_gate(gate)
    {
    }

    STDMETHODIMP CreateInstance(IUnknown *outer, REFIID wanted, void **made) override;
    STDMETHODIMP LockServer(BOOL isLocked) override;

private:
    Gate &m_gate;
};

} // namespace opcda
