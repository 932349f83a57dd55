#include "app/opc-da/com/sink.h"

#include <initializer_list>

namespace opcda {

bool isGone(HRESULT result)
{
    const auto ofWindows = [](DWORD code) { return static_cast<HRESULT>(0x80070000u | code); };
    for (const HRESULT lost :
         {RPC_E_DISCONNECTED, RPC_E_SERVER_DIED, RPC_E_SERVER_DIED_DNE, RPC_E_CONNECTION_TERMINATED,
          CO_E_OBJNOTCONNECTED, RPC_E_INVALID_OBJECT, ofWindows(RPC_S_SERVER_UNAVAILABLE), ofWindows(RPC_S_CALL_FAILED),
          ofWindows(RPC_S_CALL_FAILED_DNE), ofWindows(RPC_S_COMM_FAILURE), ofWindows(RPC_S_UNKNOWN_IF)}) {
        if (result == lost)
            return true;
    }
    return false;
}

} // namespace opcda
