#pragma once

#include "core/line/line.h"

namespace gorizont::tool {

/// As long as it lives, Ctrl+C and SIGTERM interrupt a line instead of ending the program. One at a time.
class Interruption
{
public:
    explicit Interruption(Line &line);
    ~Interruption();
    Interruption(const Interruption &) = delete;
    Interruption &operator=(const Interruption &) = delete;
};

} // namespace gorizont::tool
