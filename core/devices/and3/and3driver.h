#pragma once

#include "core/devices/and3/and3answers.h"
#include "core/devices/and3/and3enquiry.h"
#include "core/devices/and3/and3protocol.h"
#include "core/devices/and3/and3ring.h"
#include "core/devices/driver.h"

#include <functional>
#include <memory>
#include <optional>

namespace gorizont::and3 {

/// mm/s² of one raw unit of acceleration, 1/8 arc-second: the tangent of so small an angle times g, with the sign turned
/// over. The manual's 0.006 is this, rounded and without the sign.
double accelerationScale(double gravity);

/// Speaks with one АН-Д3: current values by 201, accelerations from the ring by 203, reboot flag and recording kept in
/// order by 50, what it says of itself by 36. In the thread of its line.
class And3Driver : public Driver
{
public:
    using Clock = std::function<UtcTime()>;

    /// \a clock dates the samples.
    explicit And3Driver(DriverSettings settings, Clock clock = utcNow);

    Result<Measurement> poll(Line &line) override;
    bool hasBacklog() const override;
    Result<QList<SampleBlock>> fetch(Line &line) override;
    void restart() override;

private:
    struct Patience
    {
        std::chrono::milliseconds write;
        std::chrono::milliseconds read;
    };

    Result<QByteArray> ask(Line &line, const Request &request, Patience patience) const;
    Patience forCommands() const { return {settings().timing.writeCommand, settings().timing.readCommand}; }
    Patience forData() const { return {settings().timing.writeData, settings().timing.readData}; }
    quint8 address() const { return static_cast<quint8>(settings().sensor.address); }

    void followRing(const ComplexRead &read, bool hasRebooted, UtcTime now);
    Result<void> keepInOrder(Line &line, const ComplexRead &read);
    Result<void> tell(Line &line, const Request &request) const;
    Result<void> enquire(Line &line);
    Result<QList<SampleBlock>> fetchPackets(Line &line);

    Clock m_clock;
    RingReader m_ring;
    bool m_mayFetch = false; ///< the last exchange went well and the count of measurements is fresh
    bool m_isRebooted = false; ///< as the last poll said
    bool m_isStopped = false; ///< as the last poll said
    bool m_isOutOfStep = false; ///< the last packet did not follow the one before
    Conditions m_toReport; ///< happened since the last good poll; stands in the next one
    Enquiry m_enquiry;
    bool m_wantsEnquiry = false; ///< a question became due by the last poll; it is asked in the free time of the line
};

std::unique_ptr<Driver> makeDriver(DriverSettings settings);

} // namespace gorizont::and3
