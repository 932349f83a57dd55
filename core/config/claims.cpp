#include "core/config/claims.h"

#include "core/config/sectionreader.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>

namespace gorizont {

using namespace Qt::Literals::StringLiterals;

namespace {

QString sectionOf(int port)
{
    return u"Port%1"_s.arg(port);
}

SectionReader readerOf(const IniFile &file, const SensorConfig &sensor, Findings &findings)
{
    return {file, sectionOf(sensor.port), findings, QString::number(sensor.index)};
}

/// The same text for all spellings of one port; empty for `sim:`, of which there may be many.
QString portIdentity(const LineConfig &line)
{
    static const QRegularExpression com(u"^COM(\\d+)$"_s, QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression ttyS(u"^/dev/ttyS(\\d+)$"_s);
    if (line.device.isEmpty()) {
        return u"COM%1"_s.arg(line.com);
    }
    if (line.device.startsWith(u"sim:"_s, Qt::CaseInsensitive)) {
        return {};
    }
    if (const auto match = ttyS.match(line.device); match.hasMatch()) {
        return u"COM%1"_s.arg(match.captured(1).toInt() + 1);
    }
    const bool isPath = line.device.startsWith(u'/');
    return isPath ? line.device : line.device.toUpper();
}

void settlePorts(QList<LineConfig> &lines, const IniFile &file, Findings &findings)
{
    QHash<QString, int> owners;
    for (LineConfig &line : lines) {
        const QString identity = portIdentity(line);
        if (!line.isOn || identity.isEmpty()) {
            continue;
        }
        const auto owner = owners.constFind(identity);
        if (owner == owners.constEnd()) {
            owners.insert(identity, line.index);
            continue;
        }
        SectionReader section(file, sectionOf(line.index), findings);
        section.complain(
            line.device.isEmpty() ? u"Num"_s : u"Device"_s,
            QCoreApplication::translate("ServerConfig", "%1 is the port of [%2] already.")
                .arg(line.device.isEmpty() ? identity : quoted(line.device), sectionOf(*owner)),
            QCoreApplication::translate("ServerConfig", "The port is switched off."));
        section.replace(u"On"_s);
        line.isOn = false;
    }
}

/// Gives every sensor a site number of its own.
class Numbering
{
public:
    Numbering(const IniFile &file, Findings &findings)
        : m_file(file)
        , m_findings(findings)
    {
    }

    void run(QList<LineConfig> &lines)
    {
        collect(lines);
        claimGivenNumbers(true);
        claimGivenNumbers(false);
        for (Candidate &candidate : m_candidates) {
            if (candidate.sensor->number == 0) {
                takeRunningIndex(candidate);
            }
        }
        for (Candidate &loser : m_losers) {
            takeFreeNumber(loser);
        }
    }

private:
    struct Candidate
    {
        SensorConfig *sensor = nullptr;
        bool isPolled = false;
        int runningIndex = 0; ///< among all sensors of the site, 1…
    };

    void collect(QList<LineConfig> &lines)
    {
        int runningIndex = 0;
        for (LineConfig &line : lines) {
            for (SensorConfig &sensor : line.sensors) {
                m_candidates.append({&sensor, line.isOn && sensor.isOn, ++runningIndex});
                m_highest = qMax(m_highest, sensor.number);
            }
        }
        m_highest = qMax(m_highest, runningIndex);
    }

    void claimGivenNumbers(bool isPolled)
    {
        for (const Candidate &candidate : m_candidates) {
            if (candidate.isPolled != isPolled || candidate.sensor->number == 0) {
                continue;
            }
            if (m_owners.contains(candidate.sensor->number)) {
                m_losers.append(candidate);
            } else {
                m_owners.insert(candidate.sensor->number, candidate.sensor);
            }
        }
    }

    void takeRunningIndex(const Candidate &candidate)
    {
        SensorConfig &sensor = *candidate.sensor;
        sensor.number = candidate.runningIndex;
        if (const SensorConfig *owner = m_owners.value(sensor.number)) {
            const QString problem = belongsTo(*owner);
            sensor.number = ++m_highest;
            readerOf(m_file, sensor, m_findings).complain(u"N"_s, problem, listedAs(sensor.number));
        }
        m_owners.insert(sensor.number, &sensor);
    }

    void takeFreeNumber(const Candidate &loser)
    {
        SensorConfig &sensor = *loser.sensor;
        const QString problem = belongsTo(*m_owners.value(sensor.number));
        sensor.number = ++m_highest;
        SectionReader keys = readerOf(m_file, sensor, m_findings);
        keys.complain(u"N"_s, problem, loser.isPolled ? offAndListedAs(sensor.number) : listedAs(sensor.number));
        keys.replace(u"N"_s);
        if (loser.isPolled) {
            keys.replace(u"On"_s);
            sensor.isOn = false;
        }
    }

    static QString belongsTo(const SensorConfig &owner)
    {
        return QCoreApplication::translate("ServerConfig", "Number %1 belongs to sensor %2 of [%3].")
            .arg(QString::number(owner.number), QString::number(owner.index), sectionOf(owner.port));
    }

    static QString listedAs(int number)
    {
        return QCoreApplication::translate("ServerConfig", "The sensor is listed as number %1.").arg(number);
    }

    static QString offAndListedAs(int number)
    {
        return QCoreApplication::translate("ServerConfig", "The sensor is switched off and listed as number %1.")
            .arg(number);
    }

    const IniFile &m_file;
    Findings &m_findings;
    QList<Candidate> m_candidates;
    QList<Candidate> m_losers;
    QHash<int, const SensorConfig *> m_owners;
    int m_highest = 0; ///< of all numbers in use
};

void settleAddresses(LineConfig &line, const IniFile &file, Findings &findings)
{
    QHash<int, int> owners;
    for (SensorConfig &sensor : line.sensors) {
        if (!sensor.isOn) {
            continue;
        }
        const auto owner = owners.constFind(sensor.address);
        if (owner == owners.constEnd()) {
            owners.insert(sensor.address, sensor.index);
            continue;
        }
        SectionReader keys = readerOf(file, sensor, findings);
        keys.complain(
            u"adr"_s,
            QCoreApplication::translate("ServerConfig", "Address %1 is that of sensor %2 on this port already.")
                .arg(sensor.address)
                .arg(*owner),
            QCoreApplication::translate("ServerConfig", "Sensor %1 is switched off.").arg(sensor.index));
        keys.replace(u"On"_s);
        sensor.isOn = false;
    }
}

} // namespace

void settleClaims(QList<LineConfig> &lines, const IniFile &file, Findings &findings)
{
    settlePorts(lines, file, findings);
    Numbering(file, findings).run(lines);
    for (LineConfig &line : lines) {
        if (line.isOn) {
            settleAddresses(line, file, findings);
        }
    }
}

} // namespace gorizont
