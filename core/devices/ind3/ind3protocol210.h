#pragma once

#include "core/protocol/request.h"
#include "core/values/reading.h"
#include "core/values/result.h"

/// Protocol 2.10, of the oldest ИН-Д2/3. «Обмен данными с измерителем угла наклона версии 2.xx», document version 1.2;
/// spec/ind3.md, section "Protocol 2.10 (old)".
///
///     request   7E 9A KK AA SS 7E
///     answer    data… SS             SS only after more than one byte of data
///
///     KK   packet: 01 read angles, 03 ping
///     AA   address 1…255
///     SS   (100h − sum) & FF, the sum of KK and AA in the request, of the data in the answer
///     data 01: the angle block of ind3values.h · 03: 35
///
/// An answer has neither delimiters nor address: a late answer of another sensor cannot be told from the right one, and
/// a check sum of eight bits lets one of 256 damaged streams through. Prefer 2.11 wherever the firmware has it.
namespace gorizont::ind3::v210 {

/// Empty: the address is out of range.
std::optional<Request> readAngles(int address);
std::optional<Request> ping(int address);

/// \a answer: as the scan found it.
Result<Tilt> decodeAngles(QByteArrayView answer);

} // namespace gorizont::ind3::v210
