#include "core/station/recordreader.h"

#include <QCoreApplication>

#include <cmath>

namespace gorizont::station {

namespace {

struct Station
{
    Q_DECLARE_TR_FUNCTIONS(Station)
};

bool isLatin(QChar letter)
{
    return (letter >= u'A' && letter <= u'Z') || (letter >= u'a' && letter <= u'z');
}

QString outOfRange(const QString &text, RecordReader::Range range)
{
    return Station::tr("%1 is not between %2 and %3.")
        .arg(quoted(text), QString::number(range.minimum), QString::number(range.maximum));
}

} // namespace

RecordReader::RecordReader(const QString &file, const Record &record, const QString &action, Complaints &complaints)
    : m_file(file)
    , m_record(record)
    , m_action(action)
    , m_complaints(complaints)
{
    if (record.isQuoteOpen) {
        refuse(record.fields.size() - 1, {}, Station::tr("The text has no closing double quote."));
    }
}

bool RecordReader::has(qsizetype index) const
{
    return index < size() && !field(index).isNone();
}

bool RecordReader::isThere(qsizetype index, const QString &name)
{
    if (index >= size()) {
        refuse(index, name, Station::tr("The field is missing."));
    }
    return m_isGood;
}

QString RecordReader::text(qsizetype index, const QString &name)
{
    return isThere(index, name) && has(index) ? field(index).text : QString();
}

double RecordReader::number(qsizetype index, const QString &name, Range range)
{
    if (!isThere(index, name)) {
        return range.minimum;
    }
    const auto value = numberOf(field(index).text);
    if (!value) {
        refuse(index, name, Station::tr("%1 is not a number.").arg(quoted(field(index).text)));
        return range.minimum;
    }
    if (*value < range.minimum || *value > range.maximum) {
        refuse(index, name, outOfRange(field(index).text, range));
        return range.minimum;
    }
    return *value;
}

std::optional<double> RecordReader::numberOrNone(qsizetype index, const QString &name, Range range)
{
    if (!isThere(index, name) || !has(index)) {
        return {};
    }
    return number(index, name, range);
}

int RecordReader::integer(qsizetype index, const QString &name, Range range)
{
    const double value = number(index, name, range);
    if (m_isGood && value != std::floor(value)) {
        refuse(index, name, Station::tr("%1 is not a whole number.").arg(quoted(field(index).text)));
    }
    return m_isGood ? static_cast<int>(value) : static_cast<int>(range.minimum);
}

int RecordReader::integerOrNone(qsizetype index, const QString &name, Range range, int none)
{
    return isThere(index, name) && !has(index) ? none : integer(index, name, range);
}

bool RecordReader::flag(qsizetype index, const QString &name)
{
    return integerOrNone(index, name, {0, 65535}, 0) != 0;
}

QChar RecordReader::letter(qsizetype index, const QString &name)
{
    if (!isThere(index, name)) {
        return {};
    }
    const QString text = latinised(field(index).text);
    if (text.size() != 1 || !isLatin(text.front())) {
        refuse(index, name, Station::tr("%1 is not one Latin letter.").arg(quoted(field(index).text)));
        return {};
    }
    return text.front();
}

QList<double> RecordReader::coefficients(qsizetype index, const QString &name)
{
    constexpr Range any{-1e30, 1e30};
    QList<double> values;
    for (qsizetype at = index; at < size() && m_isGood; ++at) {
        if (values.size() == mostCoefficients) {
            refuse(at, name, Station::tr("A polynomial has at most %1 coefficients.").arg(mostCoefficients));
            break;
        }
        values.append(number(at, name, any));
    }
    return values;
}

void RecordReader::refuse(qsizetype index, const QString &name, const QString &problem)
{
    if (m_isGood) {
        const qsizetype place = index < 0 ? 0 : m_record.firstField + index + 1;
        m_complaints.add({m_file, m_record.line, static_cast<int>(place), name, problem, m_action});
    }
    m_isGood = false;
}

void RecordReader::refuseLine(const QString &problem)
{
    refuse(-1, {}, problem);
}

std::optional<ParameterId> parameterIdOf(QStringView text)
{
    const QString plain = latinised(text.toString());
    if (plain.isEmpty() || plain.size() > 3 || !isLatin(plain.front())) {
        return {};
    }
    if (plain.size() == 1) {
        return ParameterId{plain.front(), 1};
    }
    bool isNumber = false;
    const uint number = QStringView(plain).mid(1).toUInt(&isNumber);
    if (!isNumber || number < 1) {
        return {};
    }
    return ParameterId{plain.front(), static_cast<int>(number)};
}

} // namespace gorizont::station
