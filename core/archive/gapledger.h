#pragma once

#include "core/values/gap.h"
#include "core/values/lineconfig.h"
#include "core/values/linestatus.h"
#include "core/values/reading.h"

#include <QHash>

#include <map>
#include <optional>

namespace gorizont {

/// Follows every sensor and says when it gave no valid value, and why. A gap reaches from the last valid value to the
/// next one; where the reason changes on the way there are two, one after the other. Pure.
class GapLedger
{
public:
    struct Rules
    {
        std::chrono::microseconds shortest{3'000'000}; ///< what is shorter is not a gap
        std::chrono::microseconds silence{10'000'000}; ///< without a sign of a sensor, or five of its periods
    };

    GapLedger(const QList<LineConfig> &lines, const Rules &rules);
    explicit GapLedger(const QList<LineConfig> &lines)
        : GapLedger(lines, Rules())
    {
    }

    /// The program starts. \a knownUntil: N → up to when the archive knows of the sensor; absent: not at all.
    void start(UtcTime now, const QHash<int, UtcTime> &knownUntil);
    void stop(UtcTime now);

    void add(const Reading &reading);
    void add(const LineStatus &status, UtcTime now);
    /// The clock was set when it showed \a before, and showed \a after then.
    void clockStepped(UtcTime before, UtcTime after);
    /// Valid values of \a number in this time were measured and not saved.
    void addLost(int number, const TimeSpan &span);
    /// Nothing may have come for a while.
    void tick(UtcTime now);

    /// New gaps and new ends of open ones since the last call.
    QList<Gap> takeChanges();

private:
    struct Sensor
    {
        int port = 0;
        bool isOn = false;
        QList<Quantity> quantities;
        std::optional<UtcTime> validAt; ///< up to when all is well
        std::optional<UtcTime> seenAt; ///< the last sign of it
        std::chrono::microseconds period{0};
        quint64 crcErrors = 0;
        std::optional<Gap> gap;
        bool isGapTold = false;
        bool isReasonCertain = false;
    };

    void begin(int number, Sensor &sensor, GapReason reason, bool isCertain, UtcTime at);
    void end(Sensor &sensor, UtcTime at);
    std::optional<GapReason> certainReason(const Reading &reading, const Sensor &sensor) const;

    const Rules m_rules;
    std::map<int, Sensor> m_sensors; ///< by N
    QHash<int, LineState> m_lines; ///< by port
    QList<Gap> m_changes;
    UtcTime m_startedAt;
};

} // namespace gorizont
