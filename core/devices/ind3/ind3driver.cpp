#include "core/devices/ind3/ind3driver.h"

#include "core/devices/ind3/ind3dialect.h"
#include "core/devices/ind3/ind3modbus.h"
#include "core/devices/ind3/ind3protocol.h"
#include "core/devices/ind3/ind3protocol210.h"
#include "core/protocol/modbusrtu.h"

#include <QCoreApplication>

namespace gorizont::ind3 {

namespace {

using namespace std::chrono_literals;

/// What the three protocols do not share: the question, how to read its answer, and the silence before it.
struct Angles
{
    std::optional<Request> request; ///< empty: the address cannot be asked
    Result<Tilt> (*decode)(QByteArrayView answer) = nullptr;
    std::chrono::microseconds quietBefore{0};
};

Angles anglesIn(Dialect dialect, int address)
{
    switch (dialect) {
    case Dialect::V210: return {v210::readAngles(address), v210::decodeAngles, 0us};
    case Dialect::Modbus: return {modbus::readAngles(address), modbus::decodeAngles, modbusrtu::frameSilence};
    case Dialect::V211: break;
    }
    return {ask(Packet::ReadAngles, address), decodeAngles, 0us};
}

/// One question a turn: the sensor has nothing but its two angles. Thread of the line.
class Ind3Driver : public Driver
{
public:
    explicit Ind3Driver(DriverSettings driverSettings)
        : Driver(std::move(driverSettings))
    {
        const SensorConfig &sensor = settings().sensor;
        const QString option = sensor.options.value(dialectOption);
        const auto dialect = dialectNamed(option);
        if (!dialect) {
            note(
                JournalKind::Error,
                QCoreApplication::translate("Ind3Driver", "The protocol \"%1\" is not known; 2.11 is used")
                    .arg(option));
        }
        m_angles = anglesIn(dialect.value_or(Dialect::V211), sensor.address);
    }

    Result<Measurement> poll(Line &line) override
    {
        if (!m_angles.request) {
            return Fault::Refused;
        }
        const Timing &timing = settings().timing;
        const auto answer = line.exchange(
            {.request = m_angles.request->bytes,
             .scan = m_angles.request->scan,
             .writeTimeout = timing.writeCommand,
             .readTimeout = timing.readCommand,
             .quietBefore = m_angles.quietBefore});
        if (!answer) {
            return answer.fault();
        }
        const auto tilt = m_angles.decode(*answer);
        if (!tilt) {
            return tilt.fault();
        }
        Measurement measurement;
        measurement.tilt = *tilt;
        return measurement;
    }

private:
    Angles m_angles;
};

} // namespace

std::unique_ptr<Driver> makeDriver(DriverSettings settings)
{
    return std::make_unique<Ind3Driver>(std::move(settings));
}

} // namespace gorizont::ind3
