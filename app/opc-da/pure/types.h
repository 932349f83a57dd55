#pragma once
#include "app/opc-da/pure/addressspace.h"

#include <cstdint>

namespace opcda {

/// The VARTYPE a tag has by itself: VT_BOOL (11) or VT_R8 (5).
std::uint16_t canonicalType(TagType type);

/// Whether a client may ask for a value as this VARTYPE: empty (the canonical one), whole numbers, floats, currency, date,
/// text, bool, decimal. Arrays, references and objects are refused.
bool isOffered(std::uint16_t variantType);

/// Whether a filter of browsing on a VARTYPE lets a tag pass; 0 lets all pass.
bool passesFilter(TagType type, std::uint16_t wanted);

} // namespace opcda
