#pragma once
#include "app/opc-da/com/platform.h"
#include "app/opc-da/pure/commandline.h"

namespace opcda {

enum class Scope { Machine, User };

/// Writes all that COM and OPC clients need to find this program, and the settings of the command line; what it does not name
/// stays as it was registered before. Interfaces get the proxy beside this program only where they have none. Notes every key
/// that was not there before. A Windows error code, 0 when all is well.
LONG registerServer(Scope scope, const CommandLine &line);

/// Takes away what registration noted, in the opposite order; a key that others have filled since then stays.
LONG unregisterServer(Scope scope);

} // namespace opcda
