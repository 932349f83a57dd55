#include "core/station/parameterfile.h"

#include "core/station/recordreader.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace gorizont::station {

namespace {

struct Station
{
    Q_DECLARE_TR_FUNCTIONS(Station)
};

using Range = RecordReader::Range;

/// Places of the fields.
enum Place : quint8 { Name, Unit, ShortName, Code, Number, Type, Averaging, Format, Left, Right, Error, Polynomial };

constexpr int longestAveraging = 86400; ///< s
constexpr int mostNumbers = 99;
constexpr Range values{-1e30, 1e30};

std::optional<OutputFormat> formatOf(const QString &text)
{
    static const QRegularExpression pattern(QStringLiteral("^%(\\d{0,2})(?:\\.(\\d))?f$"));
    const QRegularExpressionMatch match = pattern.match(text);
    OutputFormat format;
    format.width = match.captured(1).toInt();
    format.decimals = match.hasCaptured(2) ? match.captured(2).toInt() : 6; // as in C
    constexpr int widest = 20;
    return match.hasMatch() && format.width <= widest ? std::optional(format) : std::nullopt;
}

/// One line of ACK.PAR.
class ParameterReader
{
public:
    ParameterReader(RecordReader &reader, int line)
        : m_reader(reader)
    {
        m_parameter.line = line;
    }

    ParameterConfig read()
    {
        takeNames();
        m_parameter.averaging =
            std::chrono::seconds(m_reader.integerOrNone(Averaging, Station::tr("averaging"), {0, longestAveraging}, 0));
        takeFormat();
        takeLimits();
        takeConversion();
        return m_parameter;
    }

private:
    void takeNames()
    {
        m_parameter.name = m_reader.text(Name, Station::tr("name"));
        m_parameter.unit = m_reader.text(Unit, Station::tr("unit"));
        m_parameter.shortName = m_reader.text(ShortName, Station::tr("short name"));
        m_parameter.code = m_reader.letter(Code, Station::tr("code"));
        m_parameter.number = m_reader.integer(Number, Station::tr("number"), {1, mostNumbers});
        m_parameter.type = m_reader.letter(Type, Station::tr("type")).toUpper();
    }

    void takeFormat()
    {
        const QString name = Station::tr("format");
        const QString text = m_reader.text(Format, name);
        if (!m_reader.isGood() || text.isEmpty()) {
            return;
        }
        const auto format = formatOf(text);
        if (!format) {
            m_reader.refuse(Format, name, Station::tr("%1 is no format: write it as in %5.1f.").arg(quoted(text)));
            return;
        }
        m_parameter.format = *format;
    }

    void takeLimits()
    {
        m_parameter.limits.left = m_reader.numberOrNone(Left, Station::tr("left limit"), values);
        m_parameter.limits.right = m_reader.numberOrNone(Right, Station::tr("right limit"), values);
        const Limits &limits = m_parameter.limits;
        if (limits.left && limits.right && *limits.left > *limits.right) {
            m_reader.refuse(
                Right, Station::tr("right limit"), Station::tr("The right limit is less than the left one."));
        }
        m_parameter.error = m_reader.numberOrNone(Error, Station::tr("error"), {0, values.maximum});
    }

    void takeConversion()
    {
        const QString name = Station::tr("polynomial");
        qsizetype first = Polynomial;
        if (m_reader.has(first) && m_reader.field(first).text.startsWith(u'/')) {
            takeOrigin(first++);
        }
        m_parameter.conversion.coefficients = m_reader.coefficients(first, name);
        if (m_parameter.conversion.coefficients.isEmpty()) {
            m_reader.refuse(first, name, Station::tr("The polynomial has no coefficients."));
        }
    }

    void takeOrigin(qsizetype place)
    {
        QString text = m_reader.field(place).text.mid(1);
        if (text.endsWith(u'/')) {
            text.chop(1);
        }
        const auto origin = numberOf(text);
        if (!origin) {
            m_reader.refuse(place, Station::tr("x0"), Station::tr("%1 is not a number.").arg(quoted(text)));
            return;
        }
        m_parameter.conversion.origin = *origin;
    }

    RecordReader &m_reader;
    ParameterConfig m_parameter;
};

} // namespace

QString OutputFormat::text(double value) const
{
    return QString::number(value, 'f', decimals).rightJustified(width);
}

QList<ParameterConfig> readParameters(const QString &file, const QByteArray &bytes, Complaints &complaints)
{
    QList<ParameterConfig> parameters;
    for (const Record &record : recordsOf(decodeStationText(bytes))) {
        RecordReader reader(file, record, Station::tr("The parameter is left out."), complaints);
        const ParameterConfig parameter = ParameterReader(reader, record.line).read();
        for (const ParameterConfig &other : std::as_const(parameters)) {
            if (reader.isGood() && other.id() == parameter.id()) {
                reader.refuse(
                    Code, Station::tr("code"),
                    Station::tr("The parameter %1 %2 stands in line %3 already.")
                        .arg(parameter.code)
                        .arg(parameter.number)
                        .arg(other.line));
            }
        }
        if (reader.isGood() && parameters.size() == mostParameters) {
            reader.refuseLine(Station::tr("A station has at most %1 parameters.").arg(mostParameters));
        }
        if (reader.isGood()) {
            parameters.append(parameter);
        }
    }
    return parameters;
}

} // namespace gorizont::station
