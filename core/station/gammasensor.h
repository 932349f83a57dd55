#pragma once

#include "core/station/gammafile.h"

namespace gorizont::station {

/// Counts the pulses of a gamma sensor gate by gate and looks after its daily self-check (manual 004, section 5.2; spec/mk14.md).
/// Called once a second; no clock inside.
class GammaSensor
{
public:
    struct Check
    {
        qint64 pulsesClosed = 0; ///< in the gate before the blinker opened
        qint64 pulsesOpen = 0; ///< in the gate with the blinker
        bool isGood() const { return pulsesOpen > pulsesClosed; }
        bool operator==(const Check &) const = default;
    };
    struct Second
    {
        std::optional<double>
            frequency; ///< Hz: of the last gate without the blinker; empty: none has ended yet. The raw value
        bool isBlinkerOn = false; ///< what the output is to be until the next second
        std::optional<Check> check; ///< a self-check has just ended
        bool operator==(const Second &) const = default;
    };

    explicit GammaSensor(const GammaConfig &config);

    /// \a pulses of the second that ends now; \a minute of the day by the clock of the station.
    Second step(qint64 pulses, std::chrono::minutes minute);

private:
    void closeGate(Second &second);

    GammaConfig m_config;
    std::chrono::seconds m_inGate{0};
    qint64 m_pulses = 0;
    std::optional<qint64> m_closedPulses; ///< of the last gate without the blinker
    std::optional<std::chrono::minutes> m_minute; ///< of the second before
    bool m_isCheckDue = false;
    bool m_isBlinkerOn = false;
};

} // namespace gorizont::station
