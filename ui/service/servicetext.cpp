#include "ui/service/servicetext.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace gorizont::servicetext {

namespace {

class ServiceText
{
    Q_DECLARE_TR_FUNCTIONS(gorizont::ServiceText)
};

} // namespace

QString fault(Fault fault)
{
    switch (fault) {
    case Fault::Timeout: return ServiceText::tr("no answer");
    case Fault::Checksum: return ServiceText::tr("the answers are damaged");
    case Fault::BadReply: return ServiceText::tr("the answer is not the expected one");
    case Fault::Refused: return ServiceText::tr("refused");
    case Fault::Closed: return ServiceText::tr("the port is gone");
    case Fault::Cancelled: break;
    }
    return ServiceText::tr("broken off");
}

QString deviceName(SensorType type)
{
    switch (type) {
    case SensorType::AnD3: return modelInRussian(QStringLiteral("AN-D3"));
    case SensorType::UsmIsn: return modelInRussian(QStringLiteral("USM-ISN"));
    case SensorType::LVims: return QStringLiteral("L-VIMS");
    case SensorType::Mk14: return modelInRussian(QStringLiteral("MK-14"));
    default: break;
    }
    return modelInRussian(QStringLiteral("IN-D3"));
}

bool hasAddresses(SensorType type)
{
    return type != SensorType::LVims;
}

QString menuTitle(SensorType type, const QString &port)
{
    if (type == SensorType::Mk14) {
        return port.isEmpty() ? ServiceText::tr("Settings of the weather station %1").arg(deviceName(type))
                              : ServiceText::tr("Settings of the weather station %1 on %2").arg(deviceName(type), port);
    }
    if (type == SensorType::LVims) {
        return port.isEmpty() ? ServiceText::tr("Settings of the module L-VIMS")
                              : ServiceText::tr("Settings of the module L-VIMS on %1").arg(port);
    }
    return port.isEmpty() ? ServiceText::tr("Settings of %1 sensors").arg(deviceName(type))
                          : ServiceText::tr("Settings of %1 sensors on %2").arg(deviceName(type), port);
}

QString iniReminder(const LineConfig &line, SensorType type, int from, int to)
{
    const auto isIt = [=](const SensorConfig &sensor) { return sensor.type == type && sensor.address == from; };
    const auto sensor = std::find_if(line.sensors.begin(), line.sensors.end(), isIt);
    if (sensor == line.sensors.end()) {
        return ServiceText::tr(
                   "No sensor of the configuration file has this address; add one to [Port%1] so that it is "
                   "polled.")
            .arg(line.index);
    }
    return ServiceText::tr("Write adr%2=%3 into [Port%1] of the configuration file and start the program again: until "
                           "then it polls address %4.")
        .arg(line.index)
        .arg(sensor->index)
        .arg(to)
        .arg(from);
}

int numberAt(const LineConfig &line, SensorType type, int address)
{
    for (const SensorConfig &sensor : line.sensors) {
        if (sensor.type == type && (hasAddresses(type) ? sensor.address : sensor.index) == address) {
            return sensor.number;
        }
    }
    return 0;
}

QString addressTitle(const LineConfig &line, int address)
{
    for (const SensorConfig &sensor : line.sensors) {
        if (sensor.address == address) {
            return ServiceText::tr("%1 (N %2 in the ini)").arg(address).arg(sensor.number);
        }
    }
    return QString::number(address);
}

std::optional<double> number(const QString &text)
{
    bool isNumber = false;
    const double value = text.trimmed().replace(u',', u'.').toDouble(&isNumber);
    return isNumber && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace gorizont::servicetext
