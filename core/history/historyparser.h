#pragma once

#include "core/values/reading.h"

#include <QByteArrayView>
#include <QDateTime>
#include <QVarLengthArray>

#include <array>
#include <optional>

namespace gorizont {

/// Reads what historyformat.h writes, and what the original program wrote (spec/gorizont.md, sections 3 and 4). Pure.

/// The five fields of one sensor: `_data` X, Y (arc-seconds), T (°C), heater (%); `_adata` Xmax, Ymax, Xrms, Yrms (mm/s²).
struct HistoryGroup
{
    std::array<std::optional<double>, 4> values; ///< empty: the field is empty, or no number
    quint16 status = 0;
    bool operator==(const HistoryGroup &) const = default;
};

/// One record, its sensors not read yet. It points into the text it was made of.
class HistoryRow
{
public:
    /// Empty: the line is no record: half a time, bytes of another encoding, something that somebody typed.
    static std::optional<HistoryRow> parse(QByteArrayView line);

    QDate date() const { return m_date; }
    QTime time() const { return m_time; }

    /// Whole groups; the last of a torn line is none.
    qsizetype groups() const;
    /// Empty: there is no such group, or its status word is damaged, so that nobody knows what its values are worth.
    std::optional<HistoryGroup> group(qsizetype index) const;

private:
    QDate m_date;
    QTime m_time;
    QVarLengthArray<QByteArrayView, 160> m_fields; ///< behind the word of channels
};

/// `10 0000 0001 0100`; empty: damaged or torn.
std::optional<quint16> parseStatusDigits(QByteArrayView text);

/// What a group of `_data` or of `_adata` says, as the sensor once said it; direction and moduli follow from the components.
Reading tiltReading(const HistoryGroup &group);
Reading accelerationReading(const HistoryGroup &group);

/// `16_03_29_22_46_09_1X.wrd`
struct SampleFileName
{
    QDateTime start; ///< local, without a zone
    int number = 0; ///< N
    char axis = 'X'; ///< X or Y
};
std::optional<SampleFileName> parseSampleFileName(const QString &name);

} // namespace gorizont
