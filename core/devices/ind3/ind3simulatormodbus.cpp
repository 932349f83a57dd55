#include "core/devices/ind3/ind3simulatorports.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gorizont::ind3 {

namespace {

using namespace std::chrono_literals;

/// What was left of something else is forgotten after this. A request may be delayed on its way in the middle (the host
/// is no real-time system), so it is more than the 3.5 characters of the standard, and less than any answer is waited for.
constexpr BuildingMotion::Time forgetAfter = 50ms;

constexpr qsizetype longestFrame = 256; ///< of the standard; what does not end by then is noise

constexpr int registerCount = 39;
constexpr int baudRegister = 20;
constexpr int protocolRegister = 21;
constexpr int periodRegister = 22;
constexpr int ticksRegister = 23;
constexpr int addressRegister = 25;
constexpr int offsetRegister = 30;
constexpr int bootLoaderRegister = 38;

enum ModbusException { IllegalFunction = 1, IllegalAddress = 2, IllegalValue = 3 };

int byte(const QByteArray &bytes, qsizetype at)
{
    return static_cast<unsigned char>(bytes.at(at));
}

int word(const QByteArray &bytes, qsizetype at)
{
    return byte(bytes, at) * 256 + byte(bytes, at + 1);
}

void appendWord(QByteArray &bytes, int value)
{
    bytes.append(static_cast<char>(value / 256)).append(static_cast<char>(value % 256));
}

/// Bit by bit, as the standard explains it. 0 over a frame with its check sum.
int crcOf(const QByteArray &bytes)
{
    unsigned crc = 0xFFFF;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) {
            const bool isOdd = crc % 2 != 0;
            crc /= 2;
            if (isOdd) {
                crc ^= 0xA001;
            }
        }
    }
    return static_cast<int>(crc);
}

using Registers = std::array<quint16, registerCount>;

void putAngle(Registers &registers, std::size_t at, double angle)
{
    const double limited = std::clamp(std::round(angle * 1000), -2147483648.0, 2147483647.0);
    const auto parts = static_cast<quint32>(static_cast<qint32>(limited));
    registers[at] = static_cast<quint16>(parts / 65536);
    registers[at + 1] = static_cast<quint16>(parts % 65536);
}

double angleAt(const Registers &registers, std::size_t at)
{
    return static_cast<qint32>(registers[at] * 65536U + registers[at + 1]) / 1000.0;
}

Registers registersOf(const SimulatedSensor &sensor, BuildingMotion::Time now)
{
    Registers registers{};
    putAngle(registers, 0, sensor.angle(0, now));
    putAngle(registers, 2, sensor.angle(1, now));
    registers[baudRegister] = static_cast<quint16>(sensor.baudCode);
    registers[protocolRegister] = 1;
    registers[periodRegister] = static_cast<quint16>(sensor.periodCode);
    registers[ticksRegister] = static_cast<quint16>(sensor.ticksCode);
    registers[24] = sensor.revision;
    registers[addressRegister] = static_cast<quint16>(sensor.address);
    registers[26] = static_cast<quint16>(sensor.serialNumber / 65536);
    registers[27] = static_cast<quint16>(sensor.serialNumber % 65536);
    putAngle(registers, offsetRegister, sensor.offset[0]);
    putAngle(registers, offsetRegister + 2, sensor.offset[1]);
    putAngle(registers, 34, sensor.factoryOffset[0]);
    putAngle(registers, 36, sensor.factoryOffset[1]);
    return registers;
}

bool isReadable(int function, int which)
{
    return function == 4 ? which < 4 : (which >= 20 && which <= 27) || (which >= 30 && which <= 37);
}

bool isWritable(int which)
{
    return (which >= baudRegister && which <= ticksRegister) || which == addressRegister
        || (which >= offsetRegister && which < offsetRegister + 4) || which == bootLoaderRegister;
}

bool areAcceptable(const Registers &registers)
{
    return registers[baudRegister] >= 1 && registers[baudRegister] <= 8 && registers[protocolRegister] <= 1
        && registers[periodRegister] <= 3 && registers[ticksRegister] <= 6 && registers[addressRegister] >= 1
        && registers[addressRegister] <= 255;
}

void takeOver(const Registers &registers, SimulatedSensor &sensor)
{
    sensor.baudCode = registers[baudRegister];
    sensor.dialect = registers[protocolRegister] == 1 ? Dialect::Modbus : Dialect::V211;
    sensor.periodCode = registers[periodRegister];
    sensor.ticksCode = registers[ticksRegister];
    sensor.address = registers[addressRegister];
    sensor.offset[0] = angleAt(registers, offsetRegister);
    sensor.offset[1] = angleAt(registers, offsetRegister + 2);
    sensor.isInBootLoader = registers[bootLoaderRegister] != 0;
}

QByteArray withCrc(QByteArray frame)
{
    const int crc = crcOf(frame);
    frame.append(static_cast<char>(crc % 256)).append(static_cast<char>(crc / 256));
    return frame;
}

QByteArray exceptionAnswer(const QByteArray &request, ModbusException code)
{
    return withCrc(request.left(1) + static_cast<char>(byte(request, 1) + 0x80) + static_cast<char>(code));
}

QByteArray answerRead(const QByteArray &request, const SimulatedSensor &sensor, BuildingMotion::Time now)
{
    const int first = word(request, 2);
    const int count = word(request, 4);
    if (count < 1 || count > 125) {
        return exceptionAnswer(request, IllegalValue);
    }
    const Registers registers = registersOf(sensor, now);
    QByteArray answer = request.left(2) + static_cast<char>(2 * count);
    for (int which = first; which < first + count; ++which) {
        if (!isReadable(byte(request, 1), which)) {
            return exceptionAnswer(request, IllegalAddress);
        }
        appendWord(answer, registers[static_cast<std::size_t>(which)]);
    }
    return withCrc(answer);
}

/// Answered from the address that was asked, also when it changes.
QByteArray answerWrite(const QByteArray &request, SimulatedSensor &sensor, BuildingMotion::Time now)
{
    const int first = word(request, 2);
    const int count = word(request, 4);
    if (count < 1 || count > 123 || byte(request, 6) != 2 * count) {
        return exceptionAnswer(request, IllegalValue);
    }
    Registers registers = registersOf(sensor, now);
    for (int i = 0; i < count; ++i) {
        if (!isWritable(first + i)) {
            return exceptionAnswer(request, IllegalAddress);
        }
        const auto which = static_cast<std::size_t>(first) + static_cast<std::size_t>(i);
        registers[which] = static_cast<quint16>(word(request, 7 + 2 * i));
    }
    if (!areAcceptable(registers)) {
        return exceptionAnswer(request, IllegalValue);
    }
    takeOver(registers, sensor);
    return withCrc(request.left(6));
}

/// 0: cannot be told yet.
qsizetype requestLength(const QByteArray &buffer)
{
    if (buffer.size() < 4) {
        return 0;
    }
    const int function = byte(buffer, 1);
    if (function >= 1 && function <= 6) {
        return 8;
    }
    if (function == 15 || function == 16) {
        return buffer.size() < 7 ? 0 : 9 + byte(buffer, 6);
    }
    return crcOf(buffer) == 0 ? buffer.size() : 0;
}

/// On a line that is shared with other protocols nothing separates their requests from ours but the address.
void forgetForeign(QByteArray &buffer, int address)
{
    const qsizetype start = buffer.indexOf(static_cast<char>(address));
    buffer.remove(0, start < 0 ? buffer.size() : start);
}

} // namespace

QByteArray PortModbus::hear(char heard, SimulatedSensor &sensor, BuildingMotion::Time now)
{
    if (now - m_lastByteAt > forgetAfter) {
        m_buffer.clear();
    }
    m_lastByteAt = now;
    m_buffer = m_buffer.right(longestFrame - 1) + heard;
    forgetForeign(m_buffer, sensor.address);
    for (qsizetype length = requestLength(m_buffer); length > 0 && length <= m_buffer.size();
         length = requestLength(m_buffer)) {
        const QByteArray request = m_buffer.left(length);
        m_buffer.remove(0, crcOf(request) == 0 ? length : 1);
        forgetForeign(m_buffer, sensor.address);
        if (crcOf(request) != 0) {
            continue;
        }
        switch (byte(request, 1)) {
        case 3:
        case 4: return answerRead(request, sensor, now);
        case 16: return answerWrite(request, sensor, now);
        default: return exceptionAnswer(request, IllegalFunction);
        }
    }
    return {};
}

} // namespace gorizont::ind3
