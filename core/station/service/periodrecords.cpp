#include "core/station/service/periodrecords.h"

#include "core/station/service/stationclock.h"

namespace gorizont::station {

namespace periodrecords {

namespace {

constexpr int rawDigits = 9;
const QString timeFormat = QStringLiteral("yyyy-MM-dd HH:mm:ss");

/// `T01`
QByteArray nameOf(QChar code, int number)
{
    const QByteArray digits = QByteArray::number(number).rightJustified(2, '0');
    return (code.isNull() ? QByteArray("V") : QString(code).toUtf8()) + digits;
}

QByteArray timeOf(qint64 clock)
{
    return StationClock::dateTime(clock).toString(timeFormat).toLatin1();
}

QByteArray textOf(const std::optional<double> &value, const OutputFormat &format)
{
    return value ? format.text(*value).trimmed().toLatin1() : QByteArray("-");
}

} // namespace

QString fileName(qint64 clock, int object)
{
    return StationClock::dateTime(clock).toString(QStringLiteral("yyyy_MM_"))
        + QStringLiteral("obj%1.txt").arg(object, 3, 10, QChar(u'0'));
}

QByteArray heading(const QList<WeatherParameter> &parameters)
{
    QByteArray line(";time");
    for (const WeatherParameter &parameter : parameters) {
        const QByteArray name = nameOf(parameter.code, parameter.number);
        line += '\t' + name + '\t' + name + " min\t" + name + " max";
    }
    return line + "\tdigital\n";
}

QByteArray record(
    qint64 clock, const QList<WeatherParameter> &parameters, const QList<OutputFormat> &formats, quint32 digital)
{
    QByteArray line = timeOf(clock);
    for (qsizetype i = 0; i < parameters.size(); ++i) {
        const WeatherParameter &parameter = parameters.at(i);
        for (const auto &value : {parameter.mean, parameter.minimum, parameter.maximum}) {
            line += '\t' + textOf(value, formats.value(i));
        }
    }
    return line + '\t' + QByteArray::number(digital, 16).rightJustified(8, '0') + '\n';
}

QString safeFileName(qint64 clock)
{
    return StationClock::dateTime(clock).toString(QStringLiteral("yyyy_MM_dd")) + QStringLiteral("_raw.txt");
}

QByteArray safeHeading(const QList<ParameterConfig> &parameters)
{
    QByteArray line(";time");
    for (const ParameterConfig &parameter : parameters) {
        line += '\t' + nameOf(parameter.code, parameter.number);
    }
    return line + '\n';
}

QByteArray safeRecord(qint64 clock, const std::vector<std::optional<double>> &raw)
{
    QByteArray line = timeOf(clock);
    for (const auto &value : raw) {
        line += '\t' + (value ? QByteArray::number(*value, 'g', rawDigits) : QByteArray("-"));
    }
    return line + '\n';
}

} // namespace periodrecords

std::optional<qint64> PeriodTurn::due(qint64 clock)
{
    const qint64 turn = clock / m_period;
    const bool isDue = m_last && turn > *m_last;
    m_last = turn;
    return isDue ? std::optional(turn * m_period) : std::nullopt;
}

} // namespace gorizont::station
