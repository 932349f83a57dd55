#pragma once

#include "core/adc24/adc24config.h"
#include "core/adc24/samplering.h"
#include "core/values/reading.h"
#include "core/values/sampleblock.h"

namespace gorizont {

/// What a client of ADC24 can ask for: the newest samples of one axis of one accelerometer. Pure.
/// An answer gives one rate for all its samples, so the ring never hides a gap: after a restart of the sensor, an
/// overrun or a lost link it begins anew, as the binary files do, and the number of samples available says so.
class Adc24Image
{
public:
    explicit Adc24Image(const Adc24Config &config);

    /// Other sensors are ignored.
    void update(const Reading &reading);
    void append(const SampleBlock &block);

    const SampleRing &ring() const { return m_ring; }
    quint16 status() const { return m_status; } ///< manual 000, section 11.2
    double rate() const { return m_rate; } ///< samples a second

private:
    const int m_number;
    const Adc24Axis m_axis;
    SampleRing m_ring;
    quint16 m_status;
    double m_rate = 10;
};

} // namespace gorizont
