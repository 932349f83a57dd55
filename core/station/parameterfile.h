#pragma once

#include "core/station/correction.h"
#include "core/station/polynomial.h"
#include "core/station/stationcomplaint.h"

#include <QByteArray>

#include <chrono>

namespace gorizont::station {

constexpr qsizetype mostParameters = 255; ///< LEN of an answer is a byte (manual 004, section 3.6)

/// `%n.df` of ACK.PAR.
struct OutputFormat
{
    int width = 0; ///< least number of characters, 0…20
    int decimals = 2; ///< 0…9
    /// \a value with a decimal point, padded with blanks on the left.
    QString text(double value) const;
    bool operator==(const OutputFormat &) const = default;
};

/// A line of ACK.PAR (manual 004, section 3.2).
struct ParameterConfig
{
    QString name; ///< empty: none
    QString unit; ///< empty: none
    QString shortName; ///< empty: none
    QChar code; ///< a Latin letter as written; a Cyrillic one that looks like it counts as it
    int number = 1; ///< 1…99, among those of the same code
    QChar type = u'A'; ///< how it is measured; only `A`, analogue, is documented, others are kept
    std::chrono::seconds averaging{0}; ///< 0: the interval of ACK.PSE
    OutputFormat format;
    Limits limits; ///< of the physical value
    std::optional<double>
        error; ///< ≥ 0, unit of the parameter; empty: no gate. Of M: left + error is where direction counts
    Conversion conversion;
    int line = 0; ///< of ACK.PAR, 1…

    ParameterId id() const { return {code, number}; }
    /// Has the code \a letter, in any case.
    bool isA(QChar letter) const { return code.toUpper() == letter; }
    bool operator==(const ParameterConfig &) const = default;
};

/// ACK.PAR: the lines that are good, in their order. A code and number that stood before is a fault.
QList<ParameterConfig> readParameters(const QString &file, const QByteArray &bytes, Complaints &complaints);

} // namespace gorizont::station
