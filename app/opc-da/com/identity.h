#pragma once
#include "app/opc-da/com/platform.h"

namespace opcda {

/// Who this server is to COM. Never given to another program, never changed.
constexpr CLSID ServerClsid{0x7b0f5c1e, 0x9a34, 0x4c0d, {0x8e, 0x61, 0x2d, 0x6f, 0x0b, 0x93, 0xa7, 0x14}};
inline constexpr wchar_t ServerClsidText[] = L"{7B0F5C1E-9A34-4C0D-8E61-2D6F0B93A714}";
inline constexpr wchar_t AppIdText[] = L"{C2E84D67-51F9-4B7A-9D03-8A1C5E70F2B6}";
/// The class of gorizont-opc-proxy.dll, given to it by its build.
inline constexpr wchar_t ProxyClsidText[] = L"{" GORIZONT_PROXY_CLSID L"}";
inline constexpr wchar_t ProgId[] = L"OPC.DA.GorizontServer";
inline constexpr wchar_t ServerDescription[] = L"Gorizont Server OPC DA";

} // namespace opcda
