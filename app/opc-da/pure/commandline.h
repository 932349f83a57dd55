#pragma once
#include "app/opc-da/pure/names.h"

#include <cstdint>
#include <optional>

namespace opcda {

/// What the program was started for. Words begin with `/` or `-`, letters of either case; values follow `=` or `:`.
struct CommandLine
{
    enum class Action { Serve, Register, Unregister, Wrong };

    Action action = Action::Serve; ///< COM starts the program with -Embedding, which is to serve
    bool isPerUser = false; ///< /PerUser: for this user, without rights of an administrator
    std::optional<std::uint16_t> port;
    std::optional<Text> hash;
    std::optional<Text> tagsFile;
};

CommandLine parseCommandLine(const std::vector<Text> &words);

} // namespace opcda
