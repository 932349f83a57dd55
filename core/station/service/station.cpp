#include "core/station/service/station.h"

#include "core/station/service/receivedfile.h"
#include "core/station/service/weatheranswer.h"

#include <QDir>
#include <QFile>

#ifdef Q_OS_UNIX
#include <ctime>
#endif

namespace gorizont::station {

namespace {

using namespace std::chrono_literals;

constexpr auto second = 1s;
constexpr auto reloadDelay = 500ms; ///< the dispatcher must get its confirmation first
const QString clockFile = QStringLiteral("clock.txt");

/// False: the system does not allow it.
bool setSystemClock([[maybe_unused]] UtcTime time)
{
#ifdef Q_OS_UNIX
    const auto seconds = std::chrono::floor<std::chrono::seconds>(time).time_since_epoch().count();
    const timespec wanted{static_cast<time_t>(seconds), 0};
    return ::clock_settime(CLOCK_REALTIME, &wanted) == 0;
#else
    return false;
#endif
}

} // namespace

Station::Station(const StationSetup &setup, QObject *parent)
    : QObject(parent)
    , m_setup(setup)
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &Station::tick);
}

Station::~Station()
{
    stop();
}

void Station::start()
{
    m_isRunning = true;
    m_storage = std::make_unique<StationStorage>(m_setup.dataFolder);
    m_storageThread.setObjectName(QStringLiteral("station storage"));
    m_storage->moveToThread(&m_storageThread);
    StationStorage *storage = m_storage.get();
    connect(storage, &StationStorage::told, this, &Station::tellState);
    connect(&m_storageThread, &QThread::finished, storage, &StationStorage::end, Qt::DirectConnection);
    m_storageThread.start();
    QFile kept(QDir(m_setup.dataFolder).filePath(clockFile));
    if (kept.open(QIODevice::ReadOnly)) {
        m_clock.setOffset(readClockOffset(kept.readAll()).value_or(0));
    }
    if (m_setup.hasDoors) {
        m_doors = std::make_unique<Doors>(m_setup.ports, answerer());
        connect(m_doors.get(), &Doors::stateChanged, this, &Station::tellState);
    }
    apply(readPlan(m_setup.configFolder));
    tell(JournalKind::On, tr("Station %1 started").arg(number()));
    m_next = std::chrono::steady_clock::now() + second;
    m_timer.start(second);
}

void Station::stop()
{
    if (!m_isRunning) {
        return;
    }
    m_isRunning = false;
    m_timer.stop();
    m_doors.reset();
    m_gathering.reset();
    m_measuring.reset();
    tell(JournalKind::Off, tr("Station %1 ended").arg(number()));
    m_storageThread.quit();
    m_storageThread.wait();
    m_storage.reset();
}

void Station::reload()
{
    if (m_isRunning) {
        tell(JournalKind::Info, tr("The files of the station are read again."));
        apply(readPlan(m_setup.configFolder));
    }
}

/// What measures and gathers begins anew only when its files say something else: windows of an hour are not lost for nothing.
void Station::apply(StationPlan plan)
{
    const bool isFirst = !m_measuring;
    Q_EMIT protocolAllowed(!plan.config.settings.isProtocolOff);
    for (const StationComplaint &complaint : plan.complaints) {
        tell(complaint.isRemark() ? JournalKind::Info : JournalKind::Error, complaint.text());
    }
    const bool isSame = !isFirst && plan.config == m_plan.config && plan.sources == m_plan.sources;
    m_plan = std::move(plan);
    if (!isSame) {
        const auto tellSource = [this](bool isGood, const QString &text) { tellState(isGood, text); };
        m_measuring.reset(); // its ports must be free
        m_measuring = std::make_unique<Measuring>(
            m_plan, Measuring::Ports{m_setup.ports.directory}, tellSource, std::chrono::steady_clock::now());
        m_measuring->setOutputs(m_outputs);
        m_gathering.reset();
        m_gathering = std::make_unique<Gathering>(m_plan, m_setup.ports);
        connect(m_gathering.get(), &Gathering::stateChanged, this, &Station::tellState);
        m_turns.clear();
        for (const RecordedObject &object : m_plan.records) {
            m_turns.emplace_back(object, PeriodTurn(object.period));
        }
        m_weather = {};
    }
    if (m_doors) {
        m_doors->apply(m_plan.dispatchers, m_setup.listen);
    }
}

/// Seconds that were missed (the computer slept, or was busy) are dropped, not made up for.
void Station::tick()
{
    const SteadyTime steady = std::chrono::steady_clock::now();
    const UtcTime now = utcNow();
    watchClock(now, steady);
    const qint64 clock = m_clock.seconds(now);
    m_measuring->step(steady, clock);
    m_gathering->poll(clock);
    m_weather = m_measuring->pipeline().weather();
    m_gathering->mergeInto(m_weather);
    record(clock);
    Q_EMIT measured(m_weather, clock);
    m_next += second;
    if (m_next <= steady) {
        m_next = steady + second;
    }
    m_timer.start(std::chrono::ceil<std::chrono::milliseconds>(m_next - std::chrono::steady_clock::now()));
}

void Station::watchClock(UtcTime now, SteadyTime steady)
{
    if (const auto step = m_clockWatch.step(now, steady)) {
        tell(
            JournalKind::Info,
            tr("The clock of the computer was set by %1 s.")
                .arg(std::chrono::duration<double>(*step).count(), 0, 'f', 1));
    }
}

void Station::record(qint64 clock)
{
    if (m_plan.config.settings.keepsSafeCopies) {
        m_storage->add(
            {QStringLiteral("SAFE/") + periodrecords::safeFileName(clock),
             periodrecords::safeHeading(m_plan.config.parameters),
             periodrecords::safeRecord(clock, m_measuring->lastSecond().raw)});
    }
    for (auto &[object, turn] : m_turns) {
        if (const auto end = turn.due(clock)) {
            recordObject(object, *end);
        }
    }
}

void Station::recordObject(const RecordedObject &object, qint64 clock)
{
    QList<WeatherParameter> parameters;
    QList<OutputFormat> formats;
    quint32 digital = m_weather.digital;
    if (object.isGathered) {
        const GatheredWeather *gathered = m_gathering->last(object.number);
        if (!gathered) {
            return; // how many values it would have sent is not known
        }
        parameters = gathered->weather.parameters;
        digital = gathered->weather.digital;
        for (const WeatherParameter &parameter : parameters) {
            const int index = m_plan.config.indexOf({parameter.code, parameter.number});
            formats.append(index >= 0 ? m_plan.config.parameters.at(index).format : OutputFormat());
        }
    }
    for (const int index : object.parameters) {
        parameters.append(m_weather.parameters.value(index));
        formats.append(m_plan.config.parameters.at(index).format);
    }
    m_storage->add(
        {periodrecords::fileName(clock, object.number), periodrecords::heading(parameters),
         periodrecords::record(clock, parameters, formats, digital)});
}

Answerer Station::answerer()
{
    return {
        [this](quint8 address) { return isOwn(address); }, [this](const ack::Asked &asked) { return answer(asked); }};
}

bool Station::isOwn(quint8 address) const
{
    return address == number() || (m_gathering && m_gathering->isObject(address));
}

QByteArray Station::answer(const ack::Asked &asked)
{
    if (!m_isRunning || !isOwn(asked.address)) {
        return {};
    }
    if (asked.address != number()) {
        // Clock and files of a gathered station are set on its own line only.
        return asked.command == ack::transferCommand ? QByteArray() : answerGathered(asked);
    }
    if (asked.isTime()) {
        return takeTime(asked);
    }
    return asked.isFile() ? takeFile(asked) : answerOwn(asked);
}

QByteArray Station::answerOwn(const ack::Asked &asked)
{
    if (m_outputs != asked.digital) {
        m_outputs = asked.digital;
        m_measuring->setOutputs(m_outputs);
    }
    StationPipeline &pipeline = m_measuring->pipeline();
    const qsizetype sent = std::min<qsizetype>(pipeline.sentParameters(), ack::mostParameters);
    const ack::Answer answer = answerOf(asked.command, m_weather, sent, pipeline.windExtras());
    pipeline.requested(std::chrono::steady_clock::now());
    return ack::encodeAnswer(asked.address, asked.command, answer);
}

/// As that station said the last time; what its command did not bring has no value.
QByteArray Station::answerGathered(const ack::Asked &asked)
{
    m_gathering->setOutputs(asked.address, asked.digital);
    const GatheredWeather *gathered = m_gathering->last(asked.address);
    if (!gathered) {
        return ack::encodeConfirmation(asked.address, 0);
    }
    const ack::Answer answer =
        answerOf(asked.command, gathered->weather, gathered->weather.parameters.size(), gathered->extras);
    return ack::encodeAnswer(asked.address, asked.command, answer);
}

QByteArray Station::takeTime(const ack::Asked &asked)
{
    const auto wanted = static_cast<qint64>(asked.digital);
    const qint64 before = m_clock.seconds(utcNow());
    const bool isSystemSet = m_setup.maySetClock && setSystemClock(m_clock.wallTime(wanted));
    if (isSystemSet) {
        m_clock.setOffset(0);
    } else {
        m_clock.set(wanted, utcNow());
    }
    keepClock();
    tell(
        JournalKind::Info,
        tr("A dispatcher has set the clock to %1, by %2 s.")
            .arg(StationClock::dateTime(wanted).toString(QStringLiteral("dd.MM.yyyy HH:mm:ss")))
            .arg(wanted - before));
    return ack::encodeConfirmation(asked.address, m_weather.digital);
}

void Station::keepClock()
{
    m_storage->keep(clockFile, clockOffsetText(m_clock.offset()));
}

QByteArray Station::takeFile(const ack::Asked &asked)
{
    const ReceivedFile received = storeReceivedFile(m_setup.configFolder, asked.fileName, asked.file);
    if (!received.problem.isEmpty()) {
        tell(
            JournalKind::Error, tr("The file %1 of a dispatcher was refused: %2").arg(received.name, received.problem));
        return {};
    }
    tell(
        JournalKind::Info, tr("A dispatcher has sent the file %1; the one before is kept as .bak.").arg(received.name));
    QTimer::singleShot(reloadDelay, this, &Station::reload);
    return ack::encodeConfirmation(asked.address, m_weather.digital);
}

void Station::tell(JournalKind kind, const QString &text)
{
    Q_EMIT journal({kind, utcNow(), text});
}

} // namespace gorizont::station
