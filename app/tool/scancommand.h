#pragma once

#include "app/tool/session.h"

#include <functional>

namespace gorizont::tool {

/// What the scan of a line needs to know of a type.
struct ScanSteps
{
    std::function<Result<void>(int address)> probe;
    std::function<void(int address)> show; ///< prints what was found there
};

/// Looks at every address from --from to --to, and shows each sensor as soon as it is found.
ExitCode scanLine(Session &session, const ScanSteps &steps);

/// A sensor was found, but then did not tell what it is.
void showUnreadable(const Session &session, int address, Fault fault);

} // namespace gorizont::tool
