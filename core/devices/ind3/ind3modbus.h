#pragma once

#include "core/devices/ind3/ind3values.h"
#include "core/protocol/request.h"
#include "core/values/result.h"

/// The register map of ИН-Д3 in Modbus RTU: the manufacturer's Modbus address map; spec/ind3.md, section "Modbus RTU".
/// Registers count from 0; int32 stands high word first; angles are arc-seconds × 1000.
///
///      0–1,  2–3    int32   tilt Y, tilt X                   R    function 04
///     20            u16     speed code 1…8                   RW   from here on functions 03 and 16
///     21            u16     protocol: 0 Gorizont, 1 Modbus   RW
///     22, 23        u16     averaging period code, averaging ticks code   RW
///     24            u16     software revision                R
///     25            u16     address                          RW
///     26–27         u32     factory number                   R
///     30–31, 32–33  int32   offset Y, offset X               RW
///     34–35, 36–37  int32   factory offset Y, X              R
///     38            u16     enters the boot loader: never written by this program
namespace gorizont::ind3::modbus {

namespace reg {
constexpr quint16 TiltY = 0;
constexpr quint16 Baud = 20;
constexpr quint16 Protocol = 21;
constexpr quint16 Period = 22;
constexpr quint16 Ticks = 23;
constexpr quint16 Revision = 24;
constexpr quint16 Address = 25;
constexpr quint16 SerialNumber = 26;
constexpr quint16 OffsetY = 30;
constexpr quint16 FactoryOffsetY = 34;
constexpr quint16 BootLoader = 38;
} // namespace reg

/// Registers 20–27. Codes that the map does not have are a BadReply.
struct Settings
{
    int baud = 0; ///< baud
    bool isModbus = true;
    std::chrono::milliseconds period{0};
    int ticks = 0;
    ind3::Revision revision;
    int address = 0;
    quint32 serialNumber = 0;
    bool operator==(const Settings &) const = default;
};

/// Registers 30–37, arc-seconds.
struct Offsets
{
    Tilt own;
    Tilt factory;
    bool operator==(const Offsets &) const = default;
};

/// Requests. Empty: a value is out of range.
std::optional<Request> readAngles(int address);
std::optional<Request> readSettings(int address);
std::optional<Request> readOffsets(int address);
/// Registers 30–33. Its answer is shorter than that of readSettings(): a late one cannot be taken for the other.
std::optional<Request> readOwnOffset(int address);
std::optional<Request> setBaud(int address, int baud);
std::optional<Request> setProtocol(int address, bool isModbus);
std::optional<Request> setPeriod(int address, std::chrono::milliseconds period);
std::optional<Request> setTicks(int address, int ticks);
/// The map does not say which address answers; by the standard it is the one that was asked.
std::optional<Request> setAddress(int address, int newAddress);
std::optional<Request> setOffset(int address, const Tilt &offset);

/// Refused: the sensor answered with an exception. BadReply: it is the answer to something else. Whether a setting was
/// taken over, modbusrtu::confirmation() tells.
Result<Tilt> decodeAngles(QByteArrayView answer);
Result<Settings> decodeSettings(QByteArrayView answer);
Result<Offsets> decodeOffsets(QByteArrayView answer);
Result<Tilt> decodeOwnOffset(QByteArrayView answer); ///< arc-seconds

} // namespace gorizont::ind3::modbus
