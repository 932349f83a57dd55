#include "core/devices/ind3/ind3modbus.h"

#include "core/protocol/modbusrtu.h"

#include <cmath>
#include <limits>

namespace gorizont::ind3::modbus {

namespace {

constexpr int angleCount = 4;
constexpr int settingsCount = 8;
constexpr int offsetsCount = 8;
constexpr double partsInSecond = 1000;

std::optional<Request> makeRequest(int address, const QModbusRequest &pdu)
{
    return isAddress(address) ? std::optional(modbusrtu::request(address, pdu)) : std::nullopt;
}

std::optional<Request> setRegister(int address, quint16 which, std::optional<int> value)
{
    return value ? makeRequest(address, modbusrtu::writeRegisters(which, {static_cast<quint16>(*value)}))
                 : std::nullopt;
}

bool appendAngle(QList<quint16> &registers, double angle)
{
    const double parts = std::round(angle * partsInSecond);
    if (!(std::abs(parts) <= std::numeric_limits<qint32>::max())) { // NaN too
        return false;
    }
    const auto word = static_cast<quint32>(static_cast<qint32>(parts));
    registers.append({static_cast<quint16>(word >> 16), static_cast<quint16>(word)});
    return true;
}

double angleAt(const QList<quint16> &registers, qsizetype at)
{
    return static_cast<qint32>(modbusrtu::doubleWord(registers, at)) / partsInSecond;
}

/// Y stands before X.
Tilt tiltAt(const QList<quint16> &registers, qsizetype at)
{
    return {angleAt(registers, at + 2), angleAt(registers, at)};
}

Result<QList<quint16>> decodeRegisters(QByteArrayView answer, int count)
{
    const auto registers = modbusrtu::registers(answer);
    return registers && registers->size() != count ? Fault::BadReply : registers;
}

/// One tilt and nothing else.
Result<Tilt> decodeTilt(QByteArrayView answer)
{
    const auto registers = decodeRegisters(answer, angleCount);
    return registers ? Result(tiltAt(*registers, 0)) : Result<Tilt>(registers.fault());
}

} // namespace

std::optional<Request> readAngles(int address)
{
    return makeRequest(address, modbusrtu::readInputRegisters(reg::TiltY, angleCount));
}

std::optional<Request> readSettings(int address)
{
    return makeRequest(address, modbusrtu::readHoldingRegisters(reg::Baud, settingsCount));
}

std::optional<Request> readOffsets(int address)
{
    return makeRequest(address, modbusrtu::readHoldingRegisters(reg::OffsetY, offsetsCount));
}

std::optional<Request> readOwnOffset(int address)
{
    return makeRequest(address, modbusrtu::readHoldingRegisters(reg::OffsetY, angleCount));
}

std::optional<Request> setBaud(int address, int baud)
{
    return setRegister(address, reg::Baud, codeOfBaud(baud));
}

std::optional<Request> setProtocol(int address, bool isModbus)
{
    return setRegister(address, reg::Protocol, isModbus ? 1 : 0);
}

std::optional<Request> setPeriod(int address, std::chrono::milliseconds period)
{
    return setRegister(address, reg::Period, codeOfPeriod(period));
}

std::optional<Request> setTicks(int address, int ticks)
{
    return setRegister(address, reg::Ticks, codeOfTicks(ticks));
}

std::optional<Request> setAddress(int address, int newAddress)
{
    return setRegister(address, reg::Address, isAddress(newAddress) ? std::optional(newAddress) : std::nullopt);
}

std::optional<Request> setOffset(int address, const Tilt &offset)
{
    QList<quint16> values;
    if (!appendAngle(values, offset.y) || !appendAngle(values, offset.x)) {
        return std::nullopt;
    }
    return makeRequest(address, modbusrtu::writeRegisters(reg::OffsetY, values));
}

Result<Tilt> decodeAngles(QByteArrayView answer)
{
    return decodeTilt(answer);
}

Result<Tilt> decodeOwnOffset(QByteArrayView answer)
{
    return decodeTilt(answer);
}

Result<Settings> decodeSettings(QByteArrayView answer)
{
    const auto registers = decodeRegisters(answer, settingsCount);
    if (!registers) {
        return registers.fault();
    }
    const auto at = [&registers](quint16 which) { return registers->at(which - reg::Baud); };
    const auto baud = baudOfCode(at(reg::Baud));
    const auto period = periodOfCode(at(reg::Period));
    const auto ticks = ticksOfCode(at(reg::Ticks));
    if (!baud || !period || !ticks || at(reg::Protocol) > 1) {
        return Fault::BadReply;
    }
    return Settings{
        *baud,
        at(reg::Protocol) == 1,
        *period,
        *ticks,
        {at(reg::Revision)},
        at(reg::Address),
        modbusrtu::doubleWord(*registers, reg::SerialNumber - reg::Baud)};
}

Result<Offsets> decodeOffsets(QByteArrayView answer)
{
    const auto registers = decodeRegisters(answer, offsetsCount);
    if (!registers) {
        return registers.fault();
    }
    return Offsets{tiltAt(*registers, 0), tiltAt(*registers, reg::FactoryOffsetY - reg::OffsetY)};
}

} // namespace gorizont::ind3::modbus
