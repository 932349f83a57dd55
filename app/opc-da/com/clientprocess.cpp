#include "app/opc-da/com/clientprocess.h"

#include <rpc.h>

namespace opcda {

DWORD callingProcess()
{
    // Not in every rpcrt4: looked up, not linked.
    using Inquire = RPC_STATUS(RPC_ENTRY *)(RPC_BINDING_HANDLE, unsigned long *);
    static const auto inquire = reinterpret_cast<Inquire>(
        reinterpret_cast<void *>(GetProcAddress(GetModuleHandleW(L"rpcrt4.dll"), "I_RpcBindingInqLocalClientPID")));
    unsigned long process = 0;
    if (!inquire || inquire(nullptr, &process) != RPC_S_OK || process == GetCurrentProcessId())
        return 0;
    return process;
}

} // namespace opcda
