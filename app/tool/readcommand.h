#pragma once

#include "app/tool/session.h"

#include <functional>

namespace gorizont::tool {

/// One reading: its text; its keys go into \a object.
using TakeReading = std::function<Result<QString>(QJsonObject &object)>;

/// Takes and prints --count readings, --interval apart. A reading that fails is told and does not end the row; the code
/// at the end says whether all were there.
ExitCode readRepeatedly(Session &session, const TakeReading &take);

} // namespace gorizont::tool
