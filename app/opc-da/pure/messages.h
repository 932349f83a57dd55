#pragma once
#include "app/opc-da/pure/names.h"

#include <cstdint>
#include <optional>

namespace opcda {

enum class Language { English, Russian };

/// The sentence for an error code of OPC Data Access (C004xxxx, 0004xxxx); nothing for a code that is not one of them.
std::optional<Text> errorText(std::uint32_t code, Language language);

/// The name of a property of an item (identifier of the OPC specification, 5.1.2); empty when there is no such property.
Text propertyName(std::uint32_t property, Language language);

/// What clients are told when the main program ends.
Text shutdownReason(Language language);

} // namespace opcda
