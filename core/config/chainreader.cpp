#include "core/config/chainreader.h"

#include "core/config/sectionreader.h"

#include <QCoreApplication>
#include <QMap>
#include <QRegularExpression>
#include <QSet>

namespace gorizont {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr SectionReader::Range lengths{0.001, 1000}; ///< m

QString leftOut()
{
    return QCoreApplication::translate("ServerConfig", "The chain is left out.");
}

QSet<int> tiltSensors(const QList<LineConfig> &lines)
{
    QSet<int> numbers;
    for (const LineConfig &line : lines) {
        for (const SensorConfig &sensor : line.sensors) {
            if (sensor.measuresTilt) {
                numbers.insert(sensor.number);
            }
        }
    }
    return numbers;
}

/// Empty: the sensor can stand in the chain.
QString problemOf(int number, const QSet<int> &sensors, const QSet<int> &taken)
{
    if (!sensors.contains(number)) {
        return QCoreApplication::translate("ServerConfig", "The site has no tilt sensor with number %1.").arg(number);
    }
    if (taken.contains(number)) {
        return QCoreApplication::translate("ServerConfig", "Sensor %1 stands in a chain already.").arg(number);
    }
    return {};
}

class ChainReader
{
public:
    ChainReader(const IniFile &file, Findings &findings, const QSet<int> &sensors)
        : m_file(file)
        , m_findings(findings)
        , m_sensors(sensors)
    {
    }

    std::optional<ChainConfig> read(int index, const QString &name)
    {
        SectionReader section(m_file, name, m_findings);
        ChainConfig chain;
        chain.index = index;
        section.take(u"Name"_s, chain.name);
        QSet<int> taken = m_taken;
        for (int i = 1; section.has(u"N%1"_s.arg(i)); ++i) {
            const auto link = readLink(section, i, taken);
            if (!link) {
                return {};
            }
            taken.insert(link->number);
            chain.links.append(*link);
        }
        if (chain.links.isEmpty()) {
            section.complain(
                u"N1"_s, QCoreApplication::translate("ServerConfig", "The chain has no links."), leftOut());
            return {};
        }
        m_taken = taken;
        return chain;
    }

private:
    std::optional<ChainLink> readLink(SectionReader &section, int i, const QSet<int> &taken)
    {
        const QString number = u"N%1"_s.arg(i);
        const QString length = u"L%1"_s.arg(i);
        ChainLink link;
        if (!section.take(number, link.number, {1}, leftOut())) {
            return {};
        }
        const QString problem = problemOf(link.number, m_sensors, taken);
        if (!problem.isEmpty()) {
            section.complain(number, problem, leftOut());
            return {};
        }
        if (!section.has(length)) {
            section.complain(
                length,
                QCoreApplication::translate("ServerConfig", "The length L%1 of link %1, in metres, is missing.").arg(i),
                leftOut());
            return {};
        }
        if (!section.take(length, link.length, lengths, leftOut())) {
            return {};
        }
        return link;
    }

    const IniFile &m_file;
    Findings &m_findings;
    const QSet<int> m_sensors;
    QSet<int> m_taken;
};

} // namespace

QList<ChainConfig> readChains(const IniFile &file, const QList<LineConfig> &lines, Findings &findings)
{
    static const QRegularExpression pattern(u"^chain(\\d{1,6})$"_s, QRegularExpression::CaseInsensitiveOption);
    QMap<int, QString> sections;
    for (const QString &section : file.sections()) {
        if (const QRegularExpressionMatch match = pattern.match(section); match.hasMatch()) {
            sections.insert(match.captured(1).toInt(), section);
        }
    }
    ChainReader reader(file, findings, tiltSensors(lines));
    QList<ChainConfig> chains;
    for (auto section = sections.cbegin(); section != sections.cend(); ++section) {
        if (const auto chain = reader.read(section.key(), section.value())) {
            chains.append(*chain);
        }
    }
    return chains;
}

} // namespace gorizont
