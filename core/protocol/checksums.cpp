#include "core/protocol/checksums.h"

#include <array>

namespace gorizont {

namespace {

constexpr std::array<quint16, 256> makeCcittTable()
{
    std::array<quint16, 256> table{};
    for (unsigned i = 0; i < 256; ++i) {
        unsigned crc = i << 8;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc & 0x8000) ? (crc << 1) ^ 0x1021 : crc << 1;
        }
        table[i] = static_cast<quint16>(crc);
    }
    return table;
}

constexpr std::array<quint16, 256> makeModbusTable()
{
    std::array<quint16, 256> table{};
    for (unsigned i = 0; i < 256; ++i) {
        unsigned crc = i;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc & 1) ? (crc >> 1) ^ 0xA001 : crc >> 1;
        }
        table[i] = static_cast<quint16>(crc);
    }
    return table;
}

constexpr auto ccittTable = makeCcittTable();
constexpr auto modbusTable = makeModbusTable();

} // namespace

quint16 crc16CcittFalse(QByteArrayView bytes)
{
    quint16 crc = 0xFFFF;
    for (const char c : bytes) {
        crc = static_cast<quint16>((crc << 8) ^ ccittTable[(crc >> 8) ^ static_cast<quint8>(c)]);
    }
    return crc;
}

quint16 crc16Modbus(QByteArrayView bytes)
{
    quint16 crc = 0xFFFF;
    for (const char c : bytes) {
        crc = static_cast<quint16>((crc >> 8) ^ modbusTable[(crc ^ static_cast<quint8>(c)) & 0xFF]);
    }
    return crc;
}

quint8 xorSum(QByteArrayView bytes)
{
    quint8 sum = 0;
    for (const char c : bytes) {
        sum ^= static_cast<quint8>(c);
    }
    return sum;
}

quint8 byteSum(QByteArrayView bytes)
{
    quint8 sum = 0;
    for (const char c : bytes) {
        sum = static_cast<quint8>(sum + static_cast<quint8>(c));
    }
    return sum;
}

} // namespace gorizont
