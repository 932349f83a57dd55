#pragma once

#include <QChar>
#include <QList>
#include <QString>

#include <optional>

namespace gorizont {

/// What a weather station says of one of its parameters (manual 004, section 4.2). Which values there are depends on the command
/// that asked; one that is not valid is empty. All but the voltages are in the unit of the parameter.
struct WeatherParameter
{
    QChar code; ///< U, T, P, H, A, M, … of ACK.PAR
    int number = 1; ///< among those of the same code
    QString name; ///< empty: not known
    QString unit; ///< empty: not known

    std::optional<double> mean; ///< over the averaging interval of the station
    std::optional<double> instant; ///< of the last seconds
    std::optional<double> minimum;
    std::optional<double> maximum;
    std::optional<double> voltage; ///< measured, before any conversion: V or Hz, mean
    std::optional<double> voltageInstant; ///< V or Hz
    std::optional<double> maxPeriod; ///< the maximum since the last request
    std::optional<double> deviation; ///< σ
    bool operator==(const WeatherParameter &) const = default;
};

/// It began or ended to rain.
struct PrecipitationEvent
{
    bool isStart = false;
    qint64 time = 0; ///< seconds since 1970 by the clock of the station, as it sent them
    bool operator==(const PrecipitationEvent &) const = default;
};

/// What a weather station measures. Copies share their lists.
struct Weather
{
    quint32 digital = 0; ///< its digital inputs, bit 0 the first
    QList<WeatherParameter> parameters; ///< in the order of ACK.PAR
    QList<PrecipitationEvent> events; ///< newest first
    bool operator==(const Weather &) const = default;

    /// The first parameter with \a code (and \a number); nullptr: there is none.
    const WeatherParameter *find(QChar code, int number = 1) const
    {
        for (const WeatherParameter &parameter : parameters) {
            if (parameter.code == code && parameter.number == number) {
                return &parameter;
            }
        }
        return nullptr;
    }
};

/// The codes that every station uses alike (manual 004, sections 4.2 and 5.3).
namespace weathercode {
inline constexpr QChar supply{u'U'}; ///< V
inline constexpr QChar temperature{u'T'}; ///< °C
inline constexpr QChar pressure{u'P'}; ///< mm Hg
inline constexpr QChar humidity{u'H'}; ///< %
inline constexpr QChar windDirection{u'A'}; ///< degrees
inline constexpr QChar windSpeed{u'M'}; ///< m/s, mean of the modulus
inline constexpr QChar windVector{u'W'}; ///< m/s, modulus of the mean vector
} // namespace weathercode

} // namespace gorizont
