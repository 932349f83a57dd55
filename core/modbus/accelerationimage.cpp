#include "core/modbus/accelerationimage.h"

#include "core/modbus/registervalue.h"

namespace gorizont {

namespace {

constexpr double perMillimetre = 100; ///< 0.01 mm/s² in 1 mm/s²
constexpr double perDegree = 10;

/// 359.96° rounds to 360.0°, which is 0: a direction stays below a full turn.
quint16 directionRegister(double degrees)
{
    const quint16 tenths = shortRegister(degrees, perDegree);
    return tenths == 3600 ? 0 : tenths;
}

} // namespace

AccelerationImage::AccelerationImage(int base, const SensorSlots &slotMap)
    : m_slots(slotMap)
    , m_block(base, head + perSensor * slotMap.count())
{
    for (int slot = 0; slot < m_slots.count(); ++slot) {
        m_block.setWord(head + perSensor * slot + 4, m_slots.initialWords().at(slot));
    }
}

void AccelerationImage::update(const Reading &reading)
{
    const std::optional<int> slot = m_slots.slotOf(reading.number);
    if (!slot) {
        return;
    }
    const int at = head + perSensor * *slot;
    if (reading.acceleration) {
        m_block.setWord(at, shortRegister(reading.acceleration->maximum, perMillimetre));
        m_block.setWord(at + 1, directionRegister(reading.acceleration->direction));
        m_block.setWord(at + 2, wordRegister(reading.acceleration->rmsX, perMillimetre));
        m_block.setWord(at + 3, wordRegister(reading.acceleration->rmsY, perMillimetre));
    }
    m_block.setWord(at + 4, reading.status);
}

} // namespace gorizont
