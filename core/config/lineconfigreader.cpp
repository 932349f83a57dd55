#include "core/config/lineconfigreader.h"

#include "core/config/sectionreader.h"
#include "core/config/sensorconfigreader.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QUrl>

namespace gorizont {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int mostPorts = 16; ///< the channel word has two bits for each (manual 000, section 11.1)

QString sectionName(int port)
{
    return u"Port%1"_s.arg(port);
}

QString portIsOff()
{
    return QCoreApplication::translate("ServerConfig", "The port is switched off.");
}

/// Empty: \a device can be tried.
QString deviceProblem(const QString &device)
{
    if (device.startsWith(u"tcp://"_s, Qt::CaseInsensitive)) {
        const QUrl url(device);
        if (url.host().isEmpty() || url.port() < 1) {
            return QCoreApplication::translate("ServerConfig", "%1 is not tcp://host:port.").arg(quoted(device));
        }
    } else if (device.compare(u"station:"_s, Qt::CaseInsensitive) == 0) {
        return QCoreApplication::translate("ServerConfig", "The folder of the station is missing behind %1.")
            .arg(quoted(device));
    } else if (device.contains(u"://"_s)) {
        return QCoreApplication::translate("ServerConfig", "%1 is no kind of device that is known.")
            .arg(quoted(device));
    }
    return {};
}

/// A port whose place is not known is not polled: another port may live at the default one.
void readPlace(SectionReader &section, LineConfig &line)
{
    section.take(u"Device"_s, line.device);
    if (!line.device.isEmpty()) {
        line.com = line.index; // without Num it is only a name, which no two ports should share
    }
    const bool isNumGood = section.take(u"Num"_s, line.com, {1}, portIsOff());
    const QString problem = deviceProblem(line.device);
    if (!problem.isEmpty()) {
        section.complain(u"Device"_s, problem, portIsOff());
    }
    if (!problem.isEmpty() || (!isNumGood && line.device.isEmpty())) {
        section.replace(u"On"_s);
        line.isOn = false;
    }
}

LineConfig readLine(const IniFile &file, int port, Findings &findings)
{
    SectionReader section(file, sectionName(port), findings);
    LineConfig line;
    line.index = port;
    section.take(u"Name"_s, line.name);
    section.take(u"BaudRate"_s, line.baudRate, {1});
    section.take(u"DataBits"_s, line.dataBits, {5, 8});
    section.take<Parity>(
        u"Parity"_s, line.parity,
        {{u"N"_s, Parity::None},
         {u"E"_s, Parity::Even},
         {u"O"_s, Parity::Odd},
         {u"M"_s, Parity::Mark},
         {u"S"_s, Parity::Space}});
    section.take<StopBits>(
        u"StopBits"_s, line.stopBits,
        {{u"1"_s, StopBits::One}, {u"1.5"_s, StopBits::OneAndHalf}, {u"2"_s, StopBits::Two}});
    section.take(u"RS485"_s, line.isRs485);
    section.take(u"On"_s, line.isOn);
    readPlace(section, line);
    line.sensors = readSensors(file, section, port, findings);
    return line;
}

int announcedPorts(SectionReader &common)
{
    int announced = 0;
    common.take(u"NumOfPorts"_s, announced, {0});
    if (announced > mostPorts) {
        common.complain(
            u"NumOfPorts"_s,
            QCoreApplication::translate("ServerConfig", "NumOfPorts is %1, but at most %2 are possible.")
                .arg(announced)
                .arg(mostPorts),
            QCoreApplication::translate("ServerConfig", "Only the first %1 are used.").arg(mostPorts));
        common.replace(u"NumOfPorts"_s);
    }
    return qMin(announced, mostPorts);
}

void complainOfIgnoredSections(const IniFile &file, int announced, Findings &findings)
{
    static const QRegularExpression port(u"^port(\\d+)$"_s, QRegularExpression::CaseInsensitiveOption);
    for (const QString &section : file.sections()) {
        const QRegularExpressionMatch match = port.match(section);
        if (!match.hasMatch()) {
            continue;
        }
        const int index = match.captured(1).toInt();
        if (index < 1 || index > announced || section.compare(sectionName(index), Qt::CaseInsensitive) != 0) {
            findings.add(
                {section,
                 {},
                 file.sectionLine(section),
                 QCoreApplication::translate("ServerConfig", "NumOfPorts does not count this section."),
                 QCoreApplication::translate("ServerConfig", "It is ignored.")});
        }
    }
}

} // namespace

QList<LineConfig> readLines(const IniFile &file, Findings &findings)
{
    SectionReader common(file, u"Common"_s, findings);
    const int announced = announcedPorts(common);
    QList<LineConfig> lines;
    for (int port = 1; port <= announced; ++port) {
        if (file.hasSection(sectionName(port))) {
            lines.append(readLine(file, port, findings));
        } else {
            common.complain(
                u"NumOfPorts"_s,
                QCoreApplication::translate("ServerConfig", "There is no section [%1].").arg(sectionName(port)),
                QCoreApplication::translate("ServerConfig", "The port is left out."));
        }
    }
    complainOfIgnoredSections(file, announced, findings);
    return lines;
}

} // namespace gorizont
