#include "core/modbus/tiltimage.h"

#include "core/modbus/registervalue.h"

namespace gorizont {

namespace {

constexpr double perArcSecond = 1000.0 / 3600.0; ///< 0.001° in one arc-second
constexpr double perDegreeCelsius = 100;

} // namespace

TiltImage::TiltImage(int base, const SensorSlots &slotMap)
    : m_slots(slotMap)
    , m_block(base, head + perSensor * slotMap.count())
{
    for (int slot = 0; slot < m_slots.count(); ++slot) {
        m_block.setWord(head + perSensor * slot + 3, m_slots.initialWords().at(slot));
    }
}

void TiltImage::update(const Reading &reading)
{
    const std::optional<int> slot = m_slots.slotOf(reading.number);
    if (!slot) {
        return;
    }
    const int at = head + perSensor * *slot;
    if (reading.tilt) {
        m_block.setWord(at, shortRegister(reading.tilt->x, perArcSecond));
        m_block.setWord(at + 1, shortRegister(reading.tilt->y, perArcSecond));
    }
    if (reading.temperature) {
        m_block.setWord(at + 2, shortRegister(*reading.temperature, perDegreeCelsius));
    }
    m_block.setWord(at + 3, reading.status);
}

} // namespace gorizont
