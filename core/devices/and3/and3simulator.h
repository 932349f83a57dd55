#pragma once

#include "core/devices/and3/and3simulatedring.h"
#include "core/devices/simulateddevice.h"
#include "core/values/sensorconfig.h"

#include <array>
#include <memory>
#include <optional>

namespace gorizont::and3 {

/// An АН-Д3 just switched on: its ring is empty and its reboot flag is up. Written from spec/and3.md beside the codec,
/// not with it, so that the two check each other.
class And3Simulator : public SimulatedDevice
{
public:
    And3Simulator(const SensorConfig &sensor, quint64 seed);

    QByteArray receive(QByteArrayView bytes, Time now) override;
    void reboot(Time now) override;
    void overrunRing(Time now) override;

private:
    using Configuration = std::array<quint8, 32>;

    QByteArray obey(quint8 op, quint8 b1, quint8 b2, Time now);
    QByteArray reply(quint8 op, const QByteArray &data = {}) const;
    QByteArray information(quint8 kind, Time now) const;
    QByteArray changeMode(quint8 bit, quint8 value, Time now);
    QByteArray complexRead(Time now) const;
    QByteArray packets(int firstCell, int count, Time now) const;
    QByteArray configuration(quint8 kind) const;
    QByteArray setByte(quint8 index, quint8 value);
    quint16 rawStatus() const;
    quint16 modeWord() const;

    BuildingMotion m_motion;
    SimulatedRing m_ring;
    bool m_hasThermostat;
    bool m_isRebootAcknowledged = false;
    std::optional<Time> m_resetAt; ///< silent until then
    Time m_bootedAt{0};
    Configuration m_current{};
    Configuration m_temporary{};
    Configuration m_nonVolatile{};
    QByteArray m_heard; ///< bytes that are not a whole request yet
};

std::unique_ptr<SimulatedDevice> makeSimulator(const SensorConfig &sensor, quint64 seed);

} // namespace gorizont::and3
