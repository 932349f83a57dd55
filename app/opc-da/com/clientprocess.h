#pragma once
#include "app/opc-da/com/platform.h"

namespace opcda {

/// The id of the local process whose call this thread serves; 0 when it is on another machine, cannot be told, or no call runs.
DWORD callingProcess();

} // namespace opcda
