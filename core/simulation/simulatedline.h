#pragma once

#include "core/line/line.h"
#include "core/simulation/simulatedbus.h"

namespace gorizont {

/// A Line whose other end is a SimulatedBus, with the real time that bytes take on a wire. Drivers do not know.
class SimulatedLine : public Line
{
public:
    /// \a started: when the simulated site was switched on; lines of one site share it.
    SimulatedLine(
        const LineConfig &config, const SimulatedBus::Options &options, SteadyTime started,
        std::chrono::milliseconds pauseTick);

    Result<void> open() override;
    void close() override;
    bool isOpen() const override { return m_isOpen; }
    std::optional<PortSettings> port() const override { return m_bus.port(); }
    Result<void> setPort(const PortSettings &port) override;

    /// What the bytes of this line cost, for benchmarks.
    const SimulatedBus &bus() const { return m_bus; }

protected:
    Result<void> writeAll(QByteArrayView bytes, std::chrono::milliseconds timeout) override;
    Result<QByteArray> readSome(std::chrono::microseconds timeout) override;

private:
    SimulatedBus m_bus;
    const PortSettings m_configured;
    SteadyTime m_started;
    QList<SimulatedBus::Piece> m_arriving;
    bool m_isOpen = false;
};

} // namespace gorizont
