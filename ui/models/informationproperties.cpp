#include "ui/models/informationproperties.h"

#include "ui/models/valuetext.h"

#include <QCoreApplication>

namespace gorizont {

namespace {

/// The translation context of the rows.
struct SensorPage
{
    Q_DECLARE_TR_FUNCTIONS(SensorPage)
};

QString raw(const std::optional<quint32> &value)
{
    return value ? QString::number(*value) : valuetext::absent();
}

} // namespace

Properties informationProperties(const SensorRegistry::Sensor &sensor)
{
    if (sensor.config.type != SensorType::AnD3) {
        return {};
    }
    const DeviceInformation &information = sensor.information;
    const QString source = SensorPage::tr("asked once a minute if CanInfo=1");
    const QString number = SensorPage::tr("a number as the sensor gives it") + u'\n' + source;
    return {
        {SensorPage::tr("Firmware version"),
         information.firmware.isEmpty() ? valuetext::absent() : information.firmware, source},
        {SensorPage::tr("System clock"), raw(information.systemClock), number},
        {SensorPage::tr("Power of the heater"), raw(information.heaterPower), number},
        {SensorPage::tr("Power of the fan"), raw(information.fanPower), number},
        {SensorPage::tr("Address and command of the transducer"), raw(information.innerTransducer), number},
        {SensorPage::tr("Response time of the transducer"), raw(information.responseTime), number},
    };
}

} // namespace gorizont
