#include "app/tool/and3text.h"

#include "app/tool/output.h"
#include "app/tool/text.h"

namespace gorizont::tool {

namespace {

using Qt::Literals::StringLiterals::operator""_s;
using namespace and3;

QString firmwareText(const std::optional<Firmware> &firmware)
{
    return firmware ? u"%1.%2"_s.arg(firmware->version).arg(firmware->subVersion) : none;
}

QString configurationText(const Configuration &configuration)
{
    const QByteArray bytes(reinterpret_cast<const char *>(configuration.data()), configuration.size());
    return QString::fromLatin1(bytes.toHex(' '));
}

bool isReady(const ComplexRead &read, quint16 bit)
{
    return (read.rawStatus & bit) != 0;
}

/// A quantity that the sensor calls not ready is absent.
QString ready(const ComplexRead &read, quint16 bit, double value, int decimals)
{
    return isReady(read, bit) ? fixed(value, decimals) : none;
}

} // namespace

void insertValues(QJsonObject &object, const ComplexRead &read)
{
    insertNulls(object, {u"tiltX"_s, u"tiltY"_s, u"temperature"_s, u"fanFrequency"_s});
    if (isReady(read, statusbit::TiltReady)) {
        object.insert(u"tiltX"_s, read.tilt.x);
        object.insert(u"tiltY"_s, read.tilt.y);
    }
    if (isReady(read, statusbit::TemperatureReady)) {
        object.insert(u"temperature"_s, read.temperature);
    }
    if (isReady(read, statusbit::FanReady)) {
        object.insert(u"fanFrequency"_s, read.fanFrequency);
    }
    object.insert(u"heaterPower"_s, read.heaterPower);
    object.insert(u"rawStatus"_s, read.rawStatus);
    object.insert(u"rawMode"_s, read.rawMode);
    object.insert(u"samples"_s, static_cast<qint64>(read.samples));
}

void insertSettings(QJsonObject &object, const Settings &settings)
{
    insertNulls(object, {u"firmware"_s, u"build"_s});
    if (settings.firmware) {
        object.insert(u"firmware"_s, firmwareText(settings.firmware));
        object.insert(u"build"_s, settings.firmware->build);
    }
    object.insert(u"configuration"_s, configurationText(settings.configuration));
    insertValues(object, settings.values);
}

QString textOf(const Settings &settings)
{
    const ComplexRead &values = settings.values;
    const QString build = settings.firmware ? QString::number(settings.firmware->build) : none;
    return QStringList{
        Text::tr("Address: %1").arg(settings.address),
        Text::tr("Firmware: %1, build %2").arg(firmwareText(settings.firmware), build),
        Text::tr("Tilt X: %1″").arg(ready(values, statusbit::TiltReady, values.tilt.x, 3)),
        Text::tr("Tilt Y: %1″").arg(ready(values, statusbit::TiltReady, values.tilt.y, 3)),
        Text::tr("Temperature: %1 °C").arg(ready(values, statusbit::TemperatureReady, values.temperature, 2)),
        Text::tr("Fan: %1 1/s").arg(ready(values, statusbit::FanReady, values.fanFrequency, 1)),
        Text::tr("Heater: %1 %").arg(fixed(settings.values.heaterPower, 1)),
        Text::tr("Measurements since the start: %1").arg(settings.values.samples),
        Text::tr("Configuration: %1").arg(configurationText(settings.configuration))}
        .join(u'\n');
}

QString lineOf(const Settings &settings)
{
    const QString build = settings.firmware ? QString::number(settings.firmware->build) : none;
    return u"%1  "_s.arg(settings.address, 3)
        + Text::tr("firmware %1, build %2").arg(firmwareText(settings.firmware), build);
}

QString lineOf(const ComplexRead &values)
{
    return u"X %1″  Y %2″  T %3 °C"_s.arg(
        ready(values, statusbit::TiltReady, values.tilt.x, 3), ready(values, statusbit::TiltReady, values.tilt.y, 3),
        ready(values, statusbit::TemperatureReady, values.temperature, 2));
}

} // namespace gorizont::tool
