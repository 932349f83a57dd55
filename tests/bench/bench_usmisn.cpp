// A line of 32 УСМ-ИСН at 9600 with the true time of bytes and measurements: the sum of what the devices themselves need ÷ the
// cycle in which all of them are polled; and how long a scan of the addresses 1…255 of that line takes. The clock is that of
// the simulation, so neither takes its real time.
#include "core/devices/addressscan.h"
#include "core/devices/drivercatalog.h"
#include "core/devices/usmisn/usmisnservice.h"
#include "tests/support/simulatedtime.h"

#include <cstdio>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

constexpr int deviceCount = 32;
constexpr int cycles = 3;
constexpr int baudRate = 9600;
constexpr std::chrono::microseconds measuring(1'089'362); ///< 512 measurements at 470 Hz (manual 002, 3.11.2)
constexpr auto freeLine = 12ms; ///< the device waits for a free line and turns around (1.5)

LineConfig siteLine()
{
    LineConfig line;
    line.index = 1;
    line.baudRate = baudRate;
    for (int i = 1; i <= deviceCount; ++i) {
        SensorConfig sensor;
        sensor.type = SensorType::UsmIsn;
        sensor.number = i;
        sensor.address = i;
        sensor.isOn = true;
        sensor.measuresTilt = true;
        line.sensors.append(sensor);
    }
    return line;
}

double seconds(std::chrono::microseconds time)
{
    return std::chrono::duration<double>(time).count();
}

/// As LinePoller does it: one device a turn, SAdrChange between two.
void benchCycle()
{
    const LineConfig config = siteLine();
    test::SimulatedTimeLine line(config, {});
    line.wait(2000ms);
    const Timing timing;
    std::vector<std::unique_ptr<Driver>> drivers;
    for (const SensorConfig &sensor : config.sensors) {
        drivers.push_back(makeDriver({.sensor = sensor, .timing = timing}));
    }
    int answered = 0;
    const auto poll = [&] {
        for (const auto &driver : drivers) {
            line.requireQuiet(timing.addressChange);
            answered += driver->poll(line) ? 1 : 0;
        }
    };
    poll(); // the first time each is also asked for its type
    answered = 0;
    const auto start = line.elapsed();
    const quint64 bytesBefore = line.bytesSent() + line.bytesReceived();
    const int requestsBefore = line.requests();
    for (int i = 0; i < cycles; ++i) {
        poll();
    }
    const double cycle = seconds(line.elapsed() - start) / cycles;
    const auto bytes = static_cast<double>(line.bytesSent() + line.bytesReceived() - bytesBefore);
    const double exchanges = line.requests() - requestsBefore;
    const double own = (bytes * 10 / baudRate + exchanges * seconds(measuring + freeLine)) / cycles;
    std::printf(
        "%d devices: %d of %d turns answered, cycle %.2f s, their own times %.2f s, ratio %.3f\n", deviceCount,
        answered, deviceCount * cycles, cycle, own, own / cycle);
}

void benchScan()
{
    test::SimulatedTimeLine line(siteLine(), {});
    line.wait(2000ms);
    const auto start = line.elapsed();
    const usmisn::Service service{Timing()};
    AddressScan scan;
    while (scan.next() != 0) {
        const auto type = service.probe(line, scan.next());
        scan.record(type ? Result<void>() : Result<void>(type.fault()));
    }
    std::printf(
        "scan of 255 addresses: %lld devices in %.1f s\n", static_cast<long long>(scan.found().size()),
        seconds(line.elapsed() - start));
}

} // namespace

int main()
{
    benchCycle();
    benchScan();
    return 0;
}
