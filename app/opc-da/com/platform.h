#pragma once
// Windows before the interfaces, without the macros that clash with C++.
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <winsock2.h>

#include <windows.h>

#include <objbase.h>
#include <ocidl.h>
#include <oleauto.h>
#include <olectl.h>
#include <shellapi.h>
#include <wrl/client.h>

#include <gorizontopc.h>

namespace opcda {

using Microsoft::WRL::ComPtr;

// Result codes of OPC Data Access, [OPC DA 3.00] 6.
constexpr HRESULT opcError(unsigned long code)
{
    return static_cast<HRESULT>(code);
}
constexpr HRESULT OpcInvalidHandle = opcError(0xC0040001);
constexpr HRESULT OpcBadType = opcError(0xC0040004);
constexpr HRESULT OpcBadRights = opcError(0xC0040006);
constexpr HRESULT OpcUnknownItemId = opcError(0xC0040007);
constexpr HRESULT OpcInvalidItemId = opcError(0xC0040008);
constexpr HRESULT OpcUnknownPath = opcError(0xC004000A);
constexpr HRESULT OpcDuplicateName = opcError(0xC004000C);
constexpr HRESULT OpcUnsupportedRate = opcError(0x0004000D);
constexpr HRESULT OpcInUse = opcError(0x0004000F);
constexpr HRESULT OpcInvalidPid = opcError(0xC0040203);
constexpr HRESULT OpcDeadbandNotSet = opcError(0xC0040400);
constexpr HRESULT OpcDeadbandNotSupported = opcError(0xC0040401);
constexpr HRESULT OpcInvalidContinuationPoint = opcError(0xC0040403);

constexpr DWORD OpcReadable = 1;
constexpr DWORD OpcWriteable = 2;

} // namespace opcda
