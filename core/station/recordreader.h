#pragma once

#include "core/station/correction.h"
#include "core/station/polynomial.h"
#include "core/station/stationcomplaint.h"
#include "core/station/stationtext.h"

namespace gorizont::station {

/// Takes the fields of one line. The first that cannot be used is complained about, and the line is not good from then on: one
/// complaint a line. An index counts from 0; \a name is what the user calls the field.
class RecordReader
{
public:
    struct Range
    {
        double minimum;
        double maximum;
    };

    /// \a action: one sentence, what is done with a line that is not good.
    RecordReader(const QString &file, const Record &record, const QString &action, Complaints &complaints);

    bool isGood() const { return m_isGood; }
    qsizetype size() const { return m_record.fields.size(); }
    /// Whether there is such a field and it is not a dash.
    bool has(qsizetype index) const;
    const Field &field(qsizetype index) const { return m_record.fields.at(index); }

    QString text(qsizetype index, const QString &name); ///< a dash: empty
    double number(qsizetype index, const QString &name, Range range);
    std::optional<double> numberOrNone(qsizetype index, const QString &name, Range range); ///< a dash: empty
    int integer(qsizetype index, const QString &name, Range range);
    int integerOrNone(qsizetype index, const QString &name, Range range, int none); ///< a dash: \a none
    bool flag(qsizetype index, const QString &name); ///< a number other than 0; a dash: false
    QChar letter(qsizetype index, const QString &name); ///< one Latin letter, or a Cyrillic one that looks like it
    /// The numbers from \a index to the end of the line, at most ten.
    QList<double> coefficients(qsizetype index, const QString &name);

    void refuse(qsizetype index, const QString &name, const QString &problem);
    void refuseLine(const QString &problem);

private:
    bool isThere(qsizetype index, const QString &name);

    QString m_file;
    const Record &m_record;
    QString m_action;
    Complaints &m_complaints;
    bool m_isGood = true;
};

/// `f01`, `P1`, `G`: a Latin letter and a number 1…99, 1 when it is not given.
std::optional<ParameterId> parameterIdOf(QStringView text);

} // namespace gorizont::station
