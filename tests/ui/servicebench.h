#pragma once

#include "core/simulation/simulatedline.h"
#include "ui/service/servicedialog.h"

#include <QMutex>
#include <QThread>

#include <atomic>

namespace gorizont::test {

/// How long to wait for what is certain to come, ms: the machine may be busy.
constexpr int patience = 60000;

/// What is different on one bench from the next.
struct BenchOptions
{
    FaultPlan faults = {};
    std::chrono::milliseconds pace{0}; ///< how long a request lasts for whoever watches, on top of no time at all
    std::function<void(const QByteArray &)> onRequest = {}; ///< in the thread of the line, before the bytes are sent
};

SensorConfig serviceSensor(SensorType type, int index, int number, int address, const QString &protocol = {});
/// [Port4], COM16.
LineConfig serviceLine(const QList<SensorConfig> &sensors);

/// A port with simulated sensors: worker in its thread, registry and journal as in the program.
class ServiceBench : public QObject
{
public:
    /// \a line: what the ini says; \a connected: what is really there.
    ServiceBench(const LineConfig &line, const QList<SensorConfig> &connected, const BenchOptions &options = {});
    ~ServiceBench() override;

    ServicePort port();
    LineState state() const { return registry.lineStatuses().constFirst().state; }
    bool isPolled() const; ///< open, and an answer came since forgetAnswers()
    void forgetAnswers() { m_answers = 0; }
    void endThread();

    QList<QByteArray> sent() const; ///< requests since forgetSent()
    void forgetSent();
    void skip(std::chrono::milliseconds time) { m_skip += time.count(); } ///< on the clock of the line

    /// What \a look finds at the device that stands at \a index, seen in the thread of the line.
    template <typename Device, typename Look> auto device(int index, Look look);

    QStringList journalTexts(JournalKind kind) const;

    std::atomic_bool isPlugged{true};
    SensorRegistry registry;
    Journal journal;
    QThread thread;
    std::unique_ptr<LineWorker> worker;

private:
    class BenchLine;

    LineConfig m_line;
    Timing m_timing;
    BenchOptions m_options;
    mutable QMutex m_mutex; ///< guards m_sent
    QList<QByteArray> m_sent;
    std::atomic<qint64> m_skip{0}; ///< ms
    int m_answers = 0;
};

template <typename Device, typename Look> auto ServiceBench::device(int index, Look look)
{
    using Seen = std::invoke_result_t<Look, const Device &>;
    QPromise<Seen> promise;
    promise.start();
    worker->submit([&](Line &line) {
        const auto &bus = dynamic_cast<SimulatedLine &>(line).bus();
        promise.addResult(look(dynamic_cast<const Device &>(*bus.devices().at(static_cast<std::size_t>(index)))));
        promise.finish();
    });
    QFuture<Seen> future = promise.future();
    future.waitForFinished();
    return future.result();
}

} // namespace gorizont::test
