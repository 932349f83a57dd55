#pragma once

#include "core/modbus/modbusconfig.h"
#include "core/values/reading.h"

#include <QByteArray>

namespace gorizont::test {

/// A site of four ports. Site numbers 1 (ИН-Д3, port 1), 2 (АН-Д3, port 1), 4 (ИН-Д3, switched off, port 1),
/// 6 (АН-Д3 on port 2, which is off).
inline ModbusConfig modbusSite(ModbusPacking packing = ModbusPacking::ByType, int base = 0)
{
    const auto sensor = [](int port, int number, bool isOn, bool hasAcceleration) {
        SensorConfig config;
        config.port = port;
        config.number = number;
        config.isOn = isOn;
        config.type = hasAcceleration ? SensorType::AnD3 : SensorType::InD;
        config.measuresTilt = true;
        config.measuresTemperature = hasAcceleration;
        config.measuresAcceleration = hasAcceleration;
        return config;
    };
    const auto line = [](int index, bool isOn, const QList<SensorConfig> &sensors) {
        LineConfig config;
        config.index = index;
        config.isOn = isOn;
        config.sensors = sensors;
        return config;
    };
    ModbusConfig config;
    config.port = 0;
    config.desk.bind = QStringLiteral("127.0.0.1");
    config.packing = packing;
    config.base = base;
    // Out of order on purpose: the blocks go by ascending N.
    config.lines = {
        line(1, true, {sensor(1, 4, false, false), sensor(1, 2, true, true), sensor(1, 1, true, false)}),
        line(2, false, {sensor(2, 6, true, true)}), line(3, true, {}), line(5, true, {})};
    return config;
}

/// Sensor 1 of the sample line in spec/gorizont.md, section 3: −264.0″ −6644.6″, no temperature, ` 0 0011 0011 1000`.
inline Reading sampleTilt()
{
    Reading reading;
    reading.number = 1;
    reading.status = 0x0338;
    reading.tilt = Tilt{-264.0, -6644.6};
    return reading;
}

/// Sensor 2 of the same line: −3599.5″ −3599.5″ 21.38 °C ` 0 0000 0001 1000`, with the accelerations of section 8:
/// `7.67 270.0 (2.19|0.00 2.19)`.
inline Reading sampleAcceleration()
{
    Reading reading;
    reading.number = 2;
    reading.status = 0x0018;
    reading.tilt = Tilt{-3599.5, -3599.5};
    reading.temperature = 21.38;
    AccelStatistics statistics;
    statistics.maximum = 7.67;
    statistics.maximumY = -7.67;
    statistics.direction = 270.0;
    statistics.rms = 2.19;
    statistics.rmsY = 2.19;
    reading.acceleration = statistics;
    return reading;
}

inline LineStatus lineStatus(int port, LineState state)
{
    LineStatus status;
    status.port = port;
    status.state = state;
    return status;
}

// The blocks of this site after sampleTilt(), sampleAcceleration(), port 3 OpenFailed and port 5 Lost, by hand:
//
// channel word   port 1: 0, port 2 off: 3 << 2 = 0Ch, port 3 not opened: 1 << 4 = 10h, port 5 lost: 2 << 8 = 200h
//                sum 0000021Ch, low byte first: 1C 02 00 00
// N=1  X   −264.0″  ÷ 3.6 =   −73.33 →   −73 = FFB7h → B7 FF
//      Y  −6644.6″  ÷ 3.6 = −1845.72 → −1846 = F8CAh → CA F8
//      T   never measured → 0                         → 00 00      status 0338h → 38 03
// N=2  X, Y −3599.5″ ÷ 3.6 = −999.86 → −1000 = FC18h → 18 FC
//      T   21.38 × 100 = 2138 = 085Ah → 5A 08                      status 0018h → 18 00
//      max  7.67 × 100 =  767 = 02FFh → FF 02    direction 270.0 × 10 = 2700 = 0A8Ch → 8C 0A
//      RMS  0.00 → 00 00, 2.19 × 100 = 219 = 00DBh → DB 00
// N=4  switched off: zeros, 0F00h → 00 0F        N=6  port off: zeros, 1700h → 00 17
inline QByteArray tiltBlock()
{
    return QByteArray::fromHex("1C020000"
                               "B7FFCAF800003803"
                               "18FC18FC5A081800"
                               "000000000000000F"
                               "0000000000000017");
}

inline QByteArray accelerationBlock()
{
    return QByteArray::fromHex("1C020000"
                               "FF028C0A0000DB001800"
                               "00000000000000000017");
}

} // namespace gorizont::test
