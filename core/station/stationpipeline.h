#pragma once

#include "core/station/parameterjudge.h"
#include "core/station/parameterwindows.h"
#include "core/station/precipitation.h"
#include "core/station/stationconfig.h"
#include "core/values/timing.h"
#include "core/values/weather.h"

#include <vector>

namespace gorizont::station {

/// What the sources measured in one second.
struct RawSecond
{
    SteadyTime time{}; ///< when it ended
    qint64 clock = 0; ///< the same by the clock of the station, seconds since 1970: of precipitation events
    /// By the index of the parameter: the mean of the second, before any conversion (V, Hz, or the state of a digital input; of a gamma
    /// sensor the frequency of its last gate). Empty, or not in the list: nothing was measured. A parameter on a digital input
    /// that has no value here gets 0 or 1 from `digital`.
    std::vector<std::optional<double>> raw;
    std::optional<quint32> digital; ///< the digital inputs; empty: not read, the last ones stay
};

/// What the answer to command 8 has behind the means.
struct WindExtras
{
    std::optional<double> directionDeviation; ///< degrees, of the first A
    std::optional<double> speedDeviation; ///< m/s, of the first M
    std::optional<double> speedMaximum; ///< m/s, of the first M, since the last request
    bool operator==(const WindExtras &) const = default;
};

/// The work of a station once a second (manual 004, section 5; spec/mk14.md, "Processing"): raw means in, the state of every parameter
/// out. No clock, no threads, no I/O inside; the cost of a step does not depend on the length of any window.
class StationPipeline
{
public:
    explicit StationPipeline(const StationConfig &config);

    /// To be called for every second, also for one in which nothing was measured.
    void step(const RawSecond &second);

    /// A request for data came: after the hold of ACK.PSE the maximum since the last request begins anew. A request within the
    /// hold changes nothing.
    void requested(SteadyTime time);

    /// Parameters as in ACK.PAR, then a wind W for each pair of A and M that ACK.PAR names no W for. Valid until the next step().
    const Weather &weather() const { return m_weather; }
    /// How many of weather().parameters go into answers: those of ACK.PAR, the first ones.
    qsizetype sentParameters() const { return m_config.parameters.size(); }
    WindExtras windExtras() const;

    /// Of the last second, by the index of the parameter; of a wind W always Missing.
    Verdict verdict(int parameter) const { return m_tracks.at(static_cast<std::size_t>(parameter)).judged.verdict; }
    /// Of the last second, whatever the verdict; empty: Missing.
    std::optional<double> physical(int parameter) const
    {
        return m_tracks.at(static_cast<std::size_t>(parameter)).judged.physical;
    }

private:
    /// All that is known of one parameter.
    struct Track
    {
        ParameterJudge judge;
        RawWindows rawWindows;
        ParameterWindows windows;
        int inputThermometer = -1; ///< index; -1: none
        int digitalBit = -1; ///< of DIG; -1: on no digital input
        bool isSupply = false;
        bool isFaulty = false; ///< its corrections are: no values
        bool wasMeasured = false; ///< in any second
        int speed = -1; ///< of a direction or a wind: the index of M; -1: there is none
        int direction = -1; ///< of a speed or a wind: the index of A; -1: there is none

        std::optional<double> raw{}; ///< of this second
        Judged judged{}; ///< of this second
        std::optional<double> lastGood{}; ///< of any second
    };

    void addTrack(int parameter);
    void addWinds();
    void joinWind(int speed, int direction, int wind);
    void placeDigitalInputs();
    WindowSettings windowSettings(const ParameterConfig &parameter, int index) const;
    Track &track(int index) { return m_tracks[static_cast<std::size_t>(index)]; }
    const Track &track(int index) const { return m_tracks[static_cast<std::size_t>(index)]; }

    void takeRaw(const RawSecond &second);
    void judgeSupply();
    void judge(int index);
    void judgeDirections();
    void endPeriod(SteadyTime time);
    void push();
    bool isCalm(const Track &direction) const;
    std::optional<double> temperature(int thermometer) const;

    const StationConfig m_config;
    bool m_isTest;
    int m_thermometer;
    QList<int> m_order; ///< of processing, without the supply voltages and the winds
    QList<int> m_supplies; ///< parameters with the code U
    bool m_isSupplyBad = false;
    std::optional<int> m_precipitationBit;
    PrecipitationWatch m_precipitation;
    std::optional<SteadyTime> m_periodEnd; ///< the maximum since the last request begins anew behind it
    std::vector<Track> m_tracks; ///< as m_weather.parameters
    Weather m_weather;
};

} // namespace gorizont::station
