#include "core/modbus/unitimages.h"

#include <algorithm>

namespace gorizont {

UnitImages::UnitImages(const ModbusConfig &config)
    : UnitImages(
        config,
        {config.lines, config.rules, &SensorConfig::measuresTilt, config.packing, TiltImage::limit(config.base)},
        {config.lines, config.rules, &SensorConfig::measuresAcceleration, config.packing,
         AccelerationImage::limit(config.base)})
{
}

UnitImages::UnitImages(const ModbusConfig &config, const SensorSlots &tilts, const SensorSlots &accelerations)
    : m_tilt(config.base, tilts)
    , m_acceleration(config.base, accelerations)
    , m_unreachable(tilts.unreachable() + accelerations.unreachable())
{
    for (const LineConfig &line : config.lines) {
        LineStatus status;
        status.port = line.index;
        status.state = line.isOn ? LineState::Opening : LineState::Off;
        m_lines.append(status);
    }
    setChannels();
    std::sort(m_unreachable.begin(), m_unreachable.end());
    m_unreachable.erase(std::unique(m_unreachable.begin(), m_unreachable.end()), m_unreachable.end());
}

const RegisterBlock *UnitImages::inputRegisters(int unit) const
{
    switch (unit) {
    case tiltUnit: return &m_tilt.block();
    case accelerationUnit: return &m_acceleration.block();
    default: return nullptr;
    }
}

void UnitImages::update(const Reading &reading)
{
    m_tilt.update(reading);
    m_acceleration.update(reading);
}

void UnitImages::updateLine(const LineStatus &status)
{
    for (LineStatus &line : m_lines) {
        if (line.port == status.port) {
            line = status;
        }
    }
    setChannels();
}

void UnitImages::setChannels()
{
    const quint32 word = channelWord(m_lines);
    m_tilt.setChannels(word);
    m_acceleration.setChannels(word);
}

QList<int> UnitImages::unreachable() const
{
    return m_unreachable;
}

} // namespace gorizont
