#include "core/station/service/gathering.h"

#include <algorithm>

namespace gorizont::station {

namespace {

using namespace std::chrono_literals;

constexpr auto pauseTick = 100ms;

} // namespace

Gathering::Gathering(const StationPlan &plan, const PortNaming &ports, QObject *parent)
    : QObject(parent)
    , m_shift(plan.config.settings.requestShift)
{
    for (const GatheredObject &object : plan.gathered) {
        m_last.insert(object.number, {object.number, false, object.command, {}, {}, {}});
        auto entry = std::make_unique<Entry>();
        entry->object = object;
        entry->gatherer =
            std::make_unique<Gatherer>(object, plan.config.settings.attempts, [line = object.line, ports] {
                return makeLine(line, ports, pauseTick);
            });
        entry->thread = std::make_unique<QThread>();
        entry->thread->setObjectName(QStringLiteral("gather %1").arg(object.number));
        entry->gatherer->moveToThread(entry->thread.get());
        connect(
            entry->gatherer.get(), &Gatherer::gathered, this,
            [this, known = entry.get()](const GatheredWeather &weather) { take(*known, weather); });
        entry->thread->start();
        m_entries.push_back(std::move(entry));
    }
}

Gathering::~Gathering()
{
    for (const auto &entry : m_entries) {
        entry->gatherer->interrupt();
        // The line belongs to that thread and ends with it.
        connect(entry->thread.get(), &QThread::finished, entry->gatherer.release(), &QObject::deleteLater);
        entry->thread->quit();
    }
    for (const auto &entry : m_entries) {
        entry->thread->wait();
    }
}

void Gathering::poll(qint64 clock)
{
    for (const auto &entry : m_entries) {
        const qint64 period = entry->object.period.count();
        const qint64 turn = (clock - m_shift.count()) / period;
        if (turn == entry->lastTurn || entry->isBusy) {
            continue;
        }
        entry->lastTurn = turn;
        entry->isBusy = true;
        Gatherer *gatherer = entry->gatherer.get();
        QMetaObject::invokeMethod(
            gatherer, [gatherer, outputs = m_outputs.value(entry->object.number)] { gatherer->poll(outputs); },
            Qt::QueuedConnection);
    }
}

const GatheredWeather *Gathering::last(int number) const
{
    const auto found = m_last.find(number);
    return found != m_last.end() && found->isAnswer ? &*found : nullptr;
}

void Gathering::take(Entry &entry, const GatheredWeather &weather)
{
    entry.isBusy = false;
    m_last[weather.number] = weather;
    if (entry.isBad == !weather.isAnswer) {
        return;
    }
    entry.isBad = !weather.isAnswer;
    Q_EMIT stateChanged(
        weather.isAnswer,
        weather.isAnswer ? tr("Station %1 answers.").arg(weather.number)
                         : tr("Station %1 does not answer (%2); its parameters have no value.")
                               .arg(weather.number)
                               .arg(weather.problem));
}

void Gathering::mergeInto(Weather &weather) const
{
    for (const auto &entry : m_entries) {
        const GatheredWeather &gathered = m_last[entry->object.number];
        for (const WeatherParameter &from : gathered.weather.parameters) {
            const auto into =
                std::find_if(weather.parameters.begin(), weather.parameters.end(), [&from](const auto &parameter) {
                    return parameter.code == from.code && parameter.number == from.number;
                });
            if (from.code.isNull() || into == weather.parameters.end()) {
                continue;
            }
            WeatherParameter merged = from;
            merged.name = into->name;
            merged.unit = into->unit;
            *into = merged;
        }
    }
}

} // namespace gorizont::station
