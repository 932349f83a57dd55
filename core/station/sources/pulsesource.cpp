#include "core/station/sources/pulsesource.h"

#include <QCoreApplication>

namespace gorizont::station {

namespace {

using namespace std::chrono_literals;

WindPulses::Time steadyNow()
{
    return std::chrono::duration_cast<WindPulses::Time>(std::chrono::steady_clock::now().time_since_epoch());
}

} // namespace

PulseSource::PulseSource(std::unique_ptr<ModemPort> port, const WindPulses::Settings &settings, std::size_t wind)
    : m_port(std::move(port))
    , m_settings(settings)
    , m_wind(wind)
{
}

PulseSource::~PulseSource()
{
    stop();
}

QString PulseSource::open()
{
    stop();
    const QString problem = m_port->open();
    if (problem.isEmpty()) {
        m_pulses.emplace(m_settings);
        m_isStopping = false;
        m_isGone = false;
        m_thread = std::thread([this] { count(); });
    }
    return problem;
}

void PulseSource::count()
{
    ModemLines before;
    while (!m_isStopping) {
        const auto lines = m_port->waitForChange();
        if (!lines) {
            break;
        }
        const WindPulses::Time now = steadyNow();
        const std::lock_guard lock(m_mutex);
        if (lines->isReferenceOn && !before.isReferenceOn) {
            m_pulses->addReference(now);
        }
        if (lines->isMainOn && !before.isMainOn) {
            m_pulses->addMain(now);
        }
        before = *lines;
    }
    m_isGone = true;
}

/// The interruption may come just before the wait that it is meant for, so it is repeated.
void PulseSource::stop()
{
    m_isStopping = true;
    if (m_thread.joinable()) {
        while (!m_isGone) {
            m_port->interrupt(m_thread);
            std::this_thread::sleep_for(1ms);
        }
        m_thread.join();
    }
    m_port->close();
}

QString PulseSource::measure(const SampleMoment &, RawSample &sample)
{
    if (m_isGone) {
        return QCoreApplication::translate("gorizont::PulseSource", "the port gives no signals any more");
    }
    const std::lock_guard lock(m_mutex);
    sample.winds[m_wind] = m_pulses->measure(steadyNow());
    return {};
}

} // namespace gorizont::station
