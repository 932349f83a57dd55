#pragma once

#include "core/line/openline.h"
#include "core/station/service/gatherer.h"

#include <QHash>
#include <QThread>

#include <vector>

namespace gorizont::station {

/// All other АКП that a station polls, each in a thread of its own, and what they said last. Lives in the thread of the station.
class Gathering : public QObject
{
    Q_OBJECT

public:
    Gathering(const StationPlan &plan, const PortNaming &ports, QObject *parent = nullptr);
    ~Gathering() override;

    /// Asks those whose time has come: every period, shifted by ACK.PSE. \a clock of the station, seconds. One that is still busy
    /// is left alone.
    void poll(qint64 clock);

    bool isObject(int number) const { return m_last.contains(number); }
    /// The last answer; nullptr: none, or it did not answer the last time.
    const GatheredWeather *last(int number) const;
    /// The control word for the next request to an object.
    void setOutputs(int number, quint32 word) { m_outputs[number] = word; }

    /// Puts what was gathered into those parameters of \a weather that ACK.INI names.
    void mergeInto(Weather &weather) const;

Q_SIGNALS:
    /// Whether an object answers; \a text is a sentence for the journal. Once a change.
    void stateChanged(bool isGood, const QString &text);

private:
    struct Entry
    {
        GatheredObject object;
        std::unique_ptr<Gatherer> gatherer;
        std::unique_ptr<QThread> thread;
        qint64 lastTurn = -1; ///< number of the period
        bool isBusy = false;
        bool isBad = false;
    };

    void take(Entry &entry, const GatheredWeather &weather);

    std::chrono::seconds m_shift;
    std::vector<std::unique_ptr<Entry>> m_entries;
    QHash<int, GatheredWeather> m_last; ///< by number
    QHash<int, quint32> m_outputs; ///< by number
};

} // namespace gorizont::station
