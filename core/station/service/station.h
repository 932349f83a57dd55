#pragma once

#include "core/station/service/doors.h"
#include "core/station/service/gathering.h"
#include "core/station/service/measuring.h"
#include "core/station/service/periodrecords.h"
#include "core/station/service/stationclock.h"
#include "core/station/service/stationstorage.h"
#include "core/values/clockwatch.h"
#include "core/values/journalentry.h"

#include <QObject>
#include <QThread>
#include <QTimer>

#include <memory>
#include <vector>

namespace gorizont::station {

/// Where a station lives and how it is reached.
struct StationSetup
{
    QString configFolder; ///< ACK.*; files that dispatchers send go there
    QString dataFolder; ///< records, the clock that was set
    PortNaming ports;
    QList<ListenAddress> listen; ///< beside the lines of ACK.INI
    bool hasDoors = true; ///< false: only receive() reaches it
    bool maySetClock = false; ///< of the computer; else the station keeps an offset to it
};

/// A weather station АКП (manual 004): measures once a second by a steady clock, answers dispatchers, polls other stations and keeps
/// records. Lives in one thread with an event loop and never waits there.
class Station : public QObject
{
    Q_OBJECT

public:
    explicit Station(const StationSetup &setup, QObject *parent = nullptr);
    ~Station() override;

    /// Reads the files and begins to work.
    void start();
    /// Ends everything, in order; what waits for the disk is written.
    void stop();
    /// Reads the files again: what has changed begins anew, lines that have not keep their clients.
    void reload();

    /// What the station says to a request. Empty: nothing.
    QByteArray answer(const ack::Asked &asked);
    bool isOwn(quint8 address) const;
    Answerer answerer();

    int number() const { return m_plan.config.settings.number; }
    QList<quint16> tcpPorts() const { return m_doors ? m_doors->tcpPorts() : QList<quint16>(); }

Q_SIGNALS:
    void journal(const gorizont::JournalEntry &entry);
    /// Once a second: all parameters with what was gathered.
    void measured(const gorizont::Weather &weather, qint64 clock);
    /// What ACK.PSE says of the protocol file, at the start and after each reload.
    void protocolAllowed(bool isAllowed);

private:
    void apply(StationPlan plan);
    void tick();
    void record(qint64 clock);
    void recordObject(const RecordedObject &object, qint64 clock);
    void watchClock(UtcTime now, SteadyTime steady);
    QByteArray answerOwn(const ack::Asked &asked);
    QByteArray answerGathered(const ack::Asked &asked);
    QByteArray takeTime(const ack::Asked &asked);
    QByteArray takeFile(const ack::Asked &asked);
    void keepClock();
    void tell(JournalKind kind, const QString &text);
    void tellState(bool isGood, const QString &text) { tell(isGood ? JournalKind::Info : JournalKind::Error, text); }

    StationSetup m_setup;
    StationPlan m_plan;
    StationClock m_clock;
    ClockWatch m_clockWatch;
    std::unique_ptr<Measuring> m_measuring;
    std::unique_ptr<Gathering> m_gathering;
    std::unique_ptr<Doors> m_doors;
    std::vector<std::pair<RecordedObject, PeriodTurn>> m_turns;
    Weather m_weather; ///< of the last second, with what was gathered
    quint32 m_outputs = 0;
    QTimer m_timer{this};
    SteadyTime m_next{};
    QThread m_storageThread;
    std::unique_ptr<StationStorage> m_storage;
    bool m_isRunning = false;
};

} // namespace gorizont::station
