#pragma once

#include <QByteArrayView>

namespace gorizont {

/// CRC-16/CCITT-FALSE: poly 1021, init FFFF, not reflected, no final XOR. check("123456789") = 29B1.
quint16 crc16CcittFalse(QByteArrayView bytes);

/// CRC-16/MODBUS: poly 8005 reflected, init FFFF. check("123456789") = 4B37.
quint16 crc16Modbus(QByteArrayView bytes);

/// XOR of all bytes, 0 for none.
quint8 xorSum(QByteArrayView bytes);

/// Sum of all bytes modulo 256.
quint8 byteSum(QByteArrayView bytes);

} // namespace gorizont
