#pragma once

#include "core/line/line.h"
#include "core/protocol/ackmessages.h"
#include "core/station/service/stationplan.h"
#include "core/station/stationpipeline.h"

#include <QObject>

#include <functional>
#include <memory>

namespace gorizont::station {

/// What another АКП said.
struct GatheredWeather
{
    int number = 0; ///< of the object
    bool isAnswer = false; ///< false: it did not answer; the rest is empty
    int command = 0; ///< that was asked
    Weather weather;
    WindExtras extras;
    QString problem; ///< why there is no answer, in a few words
};

/// Asks \a object once, at most \a attempts times, over an open \a line.
Result<ack::Answer> askObject(Line &line, const GatheredObject &object, quint32 outputs, int attempts);

/// Polls one АКП. Lives in a thread of its own, where it may wait for the line; only interrupt() is called from others.
class Gatherer : public QObject
{
    Q_OBJECT

public:
    using MakeLine = std::function<std::unique_ptr<Line>()>;

    /// \a makeLine is called in the thread of the line.
    Gatherer(const GatheredObject &object, int attempts, MakeLine makeLine);
    ~Gatherer() override;

    /// Asks once and tells what came. To be called in its thread.
    void poll(quint32 outputs);
    /// Ends the running and every later wait. Thread-safe.
    void interrupt();

Q_SIGNALS:
    void gathered(const gorizont::station::GatheredWeather &weather);

private:
    QString openLine();

    GatheredObject m_object;
    int m_attempts;
    MakeLine m_makeLine;
    std::unique_ptr<Line> m_line;
    std::atomic<Line *> m_interruptible{nullptr};
    std::atomic_bool m_isInterrupted{false};
};

} // namespace gorizont::station

Q_DECLARE_METATYPE(gorizont::station::GatheredWeather)
