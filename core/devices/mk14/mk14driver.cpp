#include "core/devices/mk14/mk14driver.h"

#include "core/devices/mk14/mk14exchange.h"
#include "core/devices/mk14/mk14options.h"
#include "core/devices/mk14/mk14values.h"

#include <QCoreApplication>
#include <QSet>

#include <map>

namespace gorizont::mk14 {

namespace {

using namespace std::chrono_literals;

class DriverText
{
    Q_DECLARE_TR_FUNCTIONS(Mk14Driver)
};

constexpr auto afterFailure = 50ms; ///< an answer does not name its question, so a late one must have gone by
constexpr int manyFailures = 5; ///< of one command in a row while others are answered

/// Asks one data command a turn. Thread of the line.
class Mk14Driver : public Driver
{
public:
    explicit Mk14Driver(DriverSettings driverSettings)
        : Driver(std::move(driverSettings))
        , m_options(Options::from(settings().sensor))
        , m_count(static_cast<int>(m_options.parameters.size()))
    {
        for (const QString &complaint : m_options.complaints) {
            note(JournalKind::Error, complaint);
        }
    }

    Result<Measurement> poll(Line &line) override
    {
        const int command = m_options.commands.at(m_turn++ % m_options.commands.size());
        const auto answer = answerTo(command, line);
        if (!answer) {
            m_weather = {};
            m_quiet = afterFailure;
            countFailure(command, answer.fault());
            return answer.fault();
        }
        m_quiet = 0ms;
        m_failures.erase(command);
        m_hasAnswered = true;
        take(command, *answer);
        return measurement();
    }

    void restart() override
    {
        m_turn = 0;
        m_weather = {};
        m_failures.clear();
        m_hasAnswered = false;
    }

private:
    Result<ack::Answer> answerTo(int command, Line &line) const
    {
        const int address = settings().sensor.address;
        const ack::Question question{static_cast<quint8>(address), static_cast<quint8>(command), m_count};
        const quint32 outputs = line.standingWord(address).value_or(m_options.outputs);
        return ask(line, question, outputs, settings().timing, m_quiet);
    }

    void take(int command, const ack::Answer &answer)
    {
        if (answer.parameters.isEmpty()) {
            m_weather = {};
            m_weather.digital = answer.digital;
        } else {
            put(m_weather, command, answer, m_options.parameters);
            compareCount(static_cast<int>(answer.parameters.size()));
        }
        if (m_hasData != !answer.parameters.isEmpty()) {
            m_hasData = !m_hasData;
            note(
                m_hasData ? JournalKind::On : JournalKind::Info,
                m_hasData ? DriverText::tr("The station has data again.")
                          : DriverText::tr("The station answers, but has no data. It may just have been switched on."));
        }
    }

    void compareCount(int count)
    {
        const auto listed = static_cast<int>(m_options.parameters.size());
        if (count != m_count && count != listed) {
            note(
                JournalKind::Error,
                DriverText::tr(
                    "The station sends %1 parameters, but %2 are listed. Its values are named by their place. "
                    "Make Params%3 or ParFile%3 agree with the station's ACK.PAR.")
                    .arg(count)
                    .arg(listed)
                    .arg(settings().sensor.index));
        }
        m_count = count;
    }

    Measurement measurement() const
    {
        Measurement measurement;
        measurement.weather = m_weather;
        measurement.temperature = temperatureIn(m_weather);
        measurement.conditions.setFlag(Condition::TransducerSilent, isSupplyBad(m_weather));
        return measurement;
    }

    /// An older station may not know every command.
    void countFailure(int command, Fault fault)
    {
        if (isLineFault(fault) || !m_hasAnswered) {
            return;
        }
        if (++m_failures[command] == manyFailures && m_failures.size() < commandsInUse()) {
            note(
                JournalKind::Error,
                DriverText::tr("The station does not answer CMD %1, but others it does. Leave it out in Cmd%2.")
                    .arg(command)
                    .arg(settings().sensor.index));
        }
    }

    std::size_t commandsInUse() const
    {
        return static_cast<std::size_t>(QSet<int>(m_options.commands.begin(), m_options.commands.end()).size());
    }

    Options m_options;
    int m_count; ///< parameters of the last answer; before it: of the list
    qsizetype m_turn = 0;
    std::chrono::milliseconds m_quiet{0}; ///< to be kept before the next question
    std::map<int, int> m_failures; ///< in a row, by command
    bool m_hasAnswered = false;
    bool m_hasData = true;
    Weather m_weather;
};

} // namespace

std::unique_ptr<Driver> makeDriver(DriverSettings settings)
{
    return std::make_unique<Mk14Driver>(std::move(settings));
}

} // namespace gorizont::mk14
