#pragma once
#include "app/opc-da/com/windowstext.h"
#include "app/opc-da/pure/messages.h"

#include <array>

namespace opcda {

constexpr LCID English = 0x0409;
constexpr LCID Russian = 0x0419;
constexpr std::array<LCID, 3> OfferedLocales{LOCALE_SYSTEM_DEFAULT, English, Russian};

/// Whether sentences can be given for this locale: English and Russian of any country, and the defaults of the machine.
bool isKnown(LCID locale);
Language languageOf(LCID locale);
/// The sentence for a result code, of OPC, of COM or of Windows; empty when nobody has one.
Text sentenceFor(HRESULT code, LCID locale);

} // namespace opcda
