#pragma once

#include "core/modbus/registerblock.h"
#include "core/modbus/sensorslots.h"
#include "core/values/reading.h"

namespace gorizont {

/// Unit 6, the accelerations (manual 000, section 10.4), always ready to be sent. Pure. Registers from the base:
///
///     0  1   channel word, 32 bits
///     2 + 5·slot:
///     +0     maximum      short, 0.01 mm/s², modulus of the largest vector
///     +1     direction    short, 0.1°, of that vector, 0…3599
///     +2     RMS X        word, 0.01 mm/s²
///     +3     RMS Y        word, 0.01 mm/s²
///     +4     status       word, section 11.2
///
/// What is not valid keeps its last value, 0 if it never had one; the status says so.
class AccelerationImage
{
public:
    static constexpr int head = 2; ///< registers of the channel word
    static constexpr int perSensor = 5; ///< registers
    /// Slots that fit below register 65536.
    static constexpr int limit(int base) { return (RegisterBlock::addressSpace - base - head) / perSensor; }

    AccelerationImage(int base, const SensorSlots &slotMap);

    const RegisterBlock &block() const { return m_block; }
    void setChannels(quint32 word) { m_block.setDword(0, word); }
    /// O(1), in place; the reading of a sensor that is not in the unit is ignored.
    void update(const Reading &reading);

private:
    SensorSlots m_slots;
    RegisterBlock m_block;
};

} // namespace gorizont
