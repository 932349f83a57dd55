#include "core/adc24/adc24image.h"

#include <algorithm>

namespace gorizont {

namespace {

constexpr quint64 samplesPerPacket = 32;

}

Adc24Image::Adc24Image(const Adc24Config &config)
    : m_number(config.number)
    , m_axis(config.axis)
    , m_ring(samplesPerPacket * static_cast<quint64>(std::max(config.ringPackets, 1)))
    , m_status(config.initialWord)
{
}

void Adc24Image::update(const Reading &reading)
{
    if (reading.number == m_number) {
        m_status = reading.status;
    }
}

void Adc24Image::append(const SampleBlock &block)
{
    if (block.number != m_number) {
        return;
    }
    if (!block.followsPrevious || block.rate != m_rate) {
        m_ring.clear();
    }
    m_rate = block.rate;
    m_ring.append(m_axis == Adc24Axis::X ? block.x : block.y, std::min(block.x.size(), block.y.size()));
}

} // namespace gorizont
