#pragma once

#include <QChar>
#include <QList>

#include <optional>

namespace gorizont::station {

/// A table of polynomials by intervals of a key (manual 004, section 3.2, files INPUT, METEO, CORRECT and the first form of REAL).
struct CorrectionTable
{
    struct Row
    {
        double below = 0; ///< the row applies to keys less than this
        QList<double> coefficients; ///< a0 … a9; none: nothing is added
        bool operator==(const Row &) const = default;
    };
    QList<Row> rows; ///< in ascending `below`

    bool isEmpty() const { return rows.isEmpty(); }
    /// The polynomial, at \a x, of the first row whose `below` is greater than \a key; 0 beyond the last row.
    double at(double key, double x) const;
    bool operator==(const CorrectionTable &) const = default;
};

/// A correction that depends on the temperature and on the measured value (file REAL): a table by temperature of polynomials of
/// the value, or a polynomial of the value whose coefficients are polynomials of the temperature.
struct RealCorrection
{
    CorrectionTable table;
    QList<QList<double>> byTemperature; ///< rows c0, c1, …: the coefficients of each ci; used when not empty

    bool isEmpty() const { return table.isEmpty() && byTemperature.isEmpty(); }
    double at(double temperature, double x) const;
    bool operator==(const RealCorrection &) const = default;
};

/// A parameter by its code and number.
struct ParameterId
{
    QChar code;
    int number = 1;
    bool operator==(const ParameterId &) const = default;
};

/// All corrections of one parameter.
struct Corrections
{
    CorrectionTable input; ///< INPUT: by temperature, added to the measured value
    std::optional<ParameterId> inputThermometer; ///< `~f01`; empty: the usual thermometer
    CorrectionTable meteo; ///< METEO: by temperature, added to the physical value
    CorrectionTable correct; ///< CORRECT: by the measured value, added to the physical value
    RealCorrection real; ///< REAL: by both, added to the physical value
    bool isFaulty = false; ///< a line cannot be used: the parameter gets no values, for they would be wrong

    bool isEmpty() const { return input.isEmpty() && meteo.isEmpty() && correct.isEmpty() && real.isEmpty(); }
    bool operator==(const Corrections &) const = default;
};

/// What is added to \a raw before the polynomial. Empty \a temperature: nothing.
double inputCorrection(const Corrections &corrections, std::optional<double> temperature);

/// What is added to the physical value: CORRECT(raw) + METEO(t) + REAL(t, raw), with \a raw as it was measured, before INPUT.
/// Empty \a temperature: CORRECT alone.
double physicalCorrection(const Corrections &corrections, std::optional<double> temperature, double raw);

} // namespace gorizont::station
