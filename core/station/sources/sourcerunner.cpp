#include "core/station/sources/sourcerunner.h"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace gorizont::station {

namespace {

using namespace std::chrono_literals;

constexpr auto shortestSleep = 20ms; ///< faster sources are asked several times in a row
constexpr auto endLimit = 500ms;
constexpr quint64 mostAtOnce = 1000; ///< what a source that was held up does not measure any more

} // namespace

struct SourceRunner::Shared
{
    std::unique_ptr<Source> source; ///< of the thread alone
    std::mutex mutex;
    std::condition_variable changed;
    SampleMean mean; ///< under the mutex, as all below
    QString problem;
    bool isEnding = false;
    bool hasEnded = false;
    std::atomic<quint32> outputs{0};

    void die(const QString &why)
    {
        const std::lock_guard lock(mutex);
        problem = why;
    }

    /// Every step that is due now. False: the source has died.
    bool measureDue(SteadyTime started, quint64 &done)
    {
        const double rate = source->rate();
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - started;
        const auto due = static_cast<quint64>(passed.count() * rate) + 1;
        done = due > mostAtOnce ? std::max(done, due - mostAtOnce) : done;
        for (; done < due; ++done) {
            RawSample sample;
            const std::chrono::duration<double> at(static_cast<double>(done) / rate);
            if (const QString why = source->measure({at, done, outputs}, sample); !why.isEmpty()) {
                die(why);
                return false;
            }
            const std::lock_guard lock(mutex);
            mean.add(sample);
            if (isEnding) {
                return false;
            }
        }
        return true;
    }

    /// False: it is to end.
    bool sleepUntil(SteadyTime time)
    {
        std::unique_lock lock(mutex);
        return !changed.wait_until(lock, time, [this] { return isEnding; });
    }
};

SourceRunner::SourceRunner(std::unique_ptr<Source> source)
    : m_name(source->name())
    , m_shared(std::make_shared<Shared>())
{
    m_shared->source = std::move(source);
    std::thread([shared = m_shared] { run(shared); }).detach();
}

SourceRunner::~SourceRunner()
{
    std::unique_lock lock(m_shared->mutex);
    m_shared->isEnding = true;
    m_shared->changed.notify_all();
    if (!m_isAbandoned) {
        m_shared->changed.wait_for(lock, endLimit, [this] { return m_shared->hasEnded; });
    }
}

void SourceRunner::run(const std::shared_ptr<Shared> &shared)
{
    if (const QString why = shared->source->open(); !why.isEmpty()) {
        shared->die(why);
    } else {
        const SteadyTime started = std::chrono::steady_clock::now();
        const auto period = std::chrono::duration_cast<std::chrono::milliseconds>(
            std::chrono::duration<double>(1 / shared->source->rate()));
        quint64 done = 0;
        SteadyTime next = started;
        while (shared->measureDue(started, done)) {
            next = std::max<SteadyTime>(
                next + std::max<std::chrono::milliseconds>(period, shortestSleep),
                SteadyTime(std::chrono::steady_clock::now()));
            if (!shared->sleepUntil(next)) {
                break;
            }
        }
    }
    shared->source.reset();
    const std::lock_guard lock(shared->mutex);
    shared->hasEnded = true;
    shared->changed.notify_all();
}

std::optional<RawSample> SourceRunner::take()
{
    const std::lock_guard lock(m_shared->mutex);
    return m_shared->mean.take();
}

QString SourceRunner::problem() const
{
    const std::lock_guard lock(m_shared->mutex);
    return m_shared->problem;
}

void SourceRunner::setOutputs(quint32 outputs)
{
    m_shared->outputs = outputs;
}

} // namespace gorizont::station
