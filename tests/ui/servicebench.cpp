#include "tests/ui/servicebench.h"

#include <QMutexLocker>

#include <thread>

namespace gorizont::test {

using namespace std::chrono_literals;

/// Its clock is its own: bytes and silence last as long as on a wire, cost no real time, and do not care how busy the
/// machine is.
class ServiceBench::BenchLine : public SimulatedLine
{
public:
    BenchLine(ServiceBench &bench, const LineConfig &config, const SimulatedBus::Options &options)
        : SimulatedLine(config, options, SteadyTime(start), 100ms)
        , m_bench(bench)
    {
    }

    Result<void> open() override
    {
        setLastError(2, QStringLiteral("no such port"));
        return m_bench.isPlugged ? SimulatedLine::open() : Result<void>(Fault::Closed);
    }

protected:
    Result<void> writeAll(QByteArrayView bytes, std::chrono::milliseconds timeout) override
    {
        const QByteArray request = bytes.toByteArray();
        {
            const QMutexLocker lock(&m_bench.m_mutex);
            m_bench.m_sent.append(request);
        }
        if (m_bench.m_options.onRequest) {
            m_bench.m_options.onRequest(request);
        }
        std::this_thread::sleep_for(m_bench.m_options.pace);
        closeIfUnplugged();
        return SimulatedLine::writeAll(bytes, timeout);
    }

    Result<QByteArray> readSome(std::chrono::microseconds timeout) override
    {
        closeIfUnplugged();
        return SimulatedLine::readSome(timeout);
    }

    SteadyTime now() const override { return m_now + std::chrono::milliseconds(m_bench.m_skip); }

    void sleepUntil(SteadyTime time) override { m_now += std::max(time - now(), SteadyTime::duration::zero()); }

private:
    void closeIfUnplugged()
    {
        if (!m_bench.isPlugged) {
            close();
        }
    }

    static constexpr std::chrono::hours start{1};

    ServiceBench &m_bench;
    SteadyTime m_now{start};
};

namespace {

Timing benchTiming()
{
    Timing timing;
    timing.run = 50ms;
    timing.addressChange = 1ms;
    timing.closePause = 100ms;
    timing.reopenPause = 100ms;
    timing.crcErrorPause = 0ms;
    timing.updateInterval = 10ms;
    return timing;
}

} // namespace

SensorConfig serviceSensor(SensorType type, int index, int number, int address, const QString &protocol)
{
    SensorConfig sensor;
    sensor.port = 4;
    sensor.index = index;
    sensor.number = number;
    sensor.address = address;
    sensor.isOn = true;
    sensor.type = type;
    sensor.model = type == SensorType::InD ? QStringLiteral("IN-D3") : QStringLiteral("AN-D3");
    sensor.serialNumber = QString::number(3590 + number);
    sensor.measuresTilt = true;
    if (!protocol.isEmpty()) {
        sensor.options.insert(QStringLiteral("protocol"), protocol);
    }
    return sensor;
}

LineConfig serviceLine(const QList<SensorConfig> &sensors)
{
    LineConfig line;
    line.index = 4;
    line.com = 16;
    line.isOn = true;
    line.sensors = sensors;
    return line;
}

ServiceBench::ServiceBench(const LineConfig &line, const QList<SensorConfig> &connected, const BenchOptions &options)
    : registry({line}, StatusRules())
    , m_line(line)
    , m_timing(benchTiming())
    , m_options(options)
{
    PollingSettings settings;
    settings.line = line;
    settings.timing = m_timing;
    LineConfig real = line;
    real.sensors = connected;
    worker = std::make_unique<LineWorker>(settings, [this, real] {
        SimulatedBus::Options bus;
        bus.faults = m_options.faults;
        return std::make_unique<BenchLine>(*this, real, bus);
    });
    worker->moveToThread(&thread);
    connect(&thread, &QThread::started, worker.get(), &LineWorker::start);
    connect(&thread, &QThread::finished, worker.get(), &LineWorker::stop, Qt::DirectConnection);
    connect(worker.get(), &LineWorker::readingsReady, &registry, &SensorRegistry::update);
    connect(worker.get(), &LineWorker::lineChanged, &registry, &SensorRegistry::updateLine);
    connect(worker.get(), &LineWorker::journal, &journal, &Journal::append);
    connect(&registry, &SensorRegistry::readingsChanged, this, [this](const Readings &batch) {
        for (const Reading &reading : batch) {
            m_answers += reading.isAnswer ? 1 : 0;
        }
    });
    thread.start();
}

ServiceBench::~ServiceBench()
{
    endThread();
}

void ServiceBench::endThread()
{
    worker->interrupt();
    thread.quit();
    thread.wait();
}

ServicePort ServiceBench::port()
{
    return {m_line, m_timing, *worker, registry, journal};
}

bool ServiceBench::isPolled() const
{
    return state() == LineState::Open && m_answers > 0;
}

QList<QByteArray> ServiceBench::sent() const
{
    const QMutexLocker lock(&m_mutex);
    return m_sent;
}

void ServiceBench::forgetSent()
{
    const QMutexLocker lock(&m_mutex);
    m_sent.clear();
}

QStringList ServiceBench::journalTexts(JournalKind kind) const
{
    QStringList texts;
    for (const JournalEntry &entry : journal.entries()) {
        if (entry.kind == kind) {
            texts += entry.text;
        }
    }
    return texts;
}

} // namespace gorizont::test
