#pragma once

#include "core/devices/ind3/ind3simulatedsensor.h"

/// The three ways a simulated ИН-Д3 hears a line. Each is given one byte at a time and returns the answer when the byte
/// completes a request to the sensor, otherwise nothing. Bytes that make no request are survived.
namespace gorizont::ind3 {

/// Protocol 2.11, as the document describes the receiver: 7E with an empty buffer is ignored, with a filled one it ends
/// the frame.
class Port211
{
public:
    QByteArray hear(char byte, SimulatedSensor &sensor, BuildingMotion::Time now);
    void clear() { m_buffer.clear(); }

private:
    QByteArray m_buffer; ///< since the last delimiter, escapes not yet undone
};

/// Protocol 2.10: a request is six bytes.
class Port210
{
public:
    QByteArray hear(char byte, SimulatedSensor &sensor, BuildingMotion::Time now);
    void clear() { m_buffer.clear(); }

private:
    QByteArray m_buffer; ///< at most the last six bytes
};

/// Modbus RTU, functions 03, 04 and 16.
class PortModbus
{
public:
    QByteArray hear(char byte, SimulatedSensor &sensor, BuildingMotion::Time now);
    void clear() { m_buffer.clear(); }

private:
    QByteArray m_buffer;
    BuildingMotion::Time m_lastByteAt{0};
};

} // namespace gorizont::ind3
