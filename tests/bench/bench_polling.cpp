// Polls a second on a simulated line with real byte timing ÷ the limit that the bytes and the mandatory silences give.
// TmRun=1 and SIdle=0, so that nothing but the program itself stands between two polls.
#include "core/engine/lineworker.h"
#include "core/simulation/simulatedline.h"

#include <QCoreApplication>
#include <QThread>
#include <QTimer>

#include <cstdio>

using namespace gorizont;
using namespace std::chrono_literals;

namespace {

struct Case
{
    const char *title;
    SensorType type;
    int baudRate;
    int requestBytes;
    std::chrono::milliseconds silence; ///< that the device itself needs between two exchanges
};

/// Every request of both devices has six bytes; what an answer takes is read off the line itself, because ИН-Д3 escapes.
constexpr Case cases[] = {
    {"IN-D3 at 9600", SensorType::InD, 9600, 6, 0ms},
    {"IN-D3 at 115200", SensorType::InD, 115200, 6, 0ms},
    {"AN-D3 at 115200", SensorType::AnD3, 115200, 6, 10ms},
};
constexpr int sensorCount = 8;
constexpr auto duration = 5s;

PollingSettings settings(const Case &which)
{
    PollingSettings settings;
    settings.line.index = 1;
    settings.line.baudRate = which.baudRate;
    settings.line.isOn = true;
    for (int i = 1; i <= sensorCount; ++i) {
        SensorConfig sensor;
        sensor.number = i;
        sensor.index = i;
        sensor.address = i;
        sensor.isOn = true;
        sensor.type = which.type;
        sensor.measuresTilt = true;
        settings.line.sensors.append(sensor);
    }
    settings.timing.run = 1ms;
    settings.timing.idle = 0ms;
    settings.timing.addressChange = 0ms;
    return settings;
}

/// What had happened when the line last told its counters, which it does at the end of a cycle.
struct Counted
{
    qint64 polls = 0;
    LineStatus line;
    double seconds = 0; ///< since the line was opened
};

Counted run(const Case &which)
{
    const PollingSettings chosen = settings(which);
    LineWorker worker(chosen, [&] {
        SimulatedBus::Options options;
        options.responseDelay = 0ms;
        return std::make_unique<SimulatedLine>(chosen.line, options, std::chrono::steady_clock::now(), 100ms);
    });
    QThread thread;
    worker.moveToThread(&thread);
    QObject context;
    Counted counted;
    qint64 polls = 0;
    QObject::connect(&thread, &QThread::started, &worker, &LineWorker::start);
    QObject::connect(&thread, &QThread::finished, &worker, &LineWorker::stop, Qt::DirectConnection);
    QObject::connect(&worker, &LineWorker::readingsReady, &context, [&](const Readings &batch) {
        for (const Reading &reading : batch) {
            polls += reading.isAnswer ? 1 : 0;
        }
    });
    QObject::connect(&worker, &LineWorker::lineChanged, &context, [&](const LineStatus &status) {
        const auto open =
            status.openedAt ? std::chrono::steady_clock::now() - *status.openedAt : SteadyTime::duration(0);
        counted = {polls, status, std::chrono::duration<double>(open).count()};
    });
    QTimer::singleShot(duration, qApp, &QCoreApplication::quit);
    thread.start();
    QCoreApplication::exec();
    worker.interrupt();
    thread.quit();
    thread.wait();
    return counted;
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    for (const Case &which : cases) {
        const Counted counted = run(which);
        // The time that the bytes which really passed needed, and the silence before every exchange.
        const double bytes = static_cast<double>(counted.line.bytesSent + counted.line.bytesReceived);
        const double exchanges = static_cast<double>(counted.line.bytesSent) / which.requestBytes;
        const double wire = bytes * 10 / which.baudRate;
        const double silence = exchanges * std::chrono::duration<double>(which.silence).count();
        std::printf(
            "%-16s %7.1f polls/s, limit %7.1f, ratio %.3f\n", which.title,
            static_cast<double>(counted.polls) / counted.seconds, static_cast<double>(counted.polls) / (wire + silence),
            (wire + silence) / counted.seconds);
    }
    return 0;
}
