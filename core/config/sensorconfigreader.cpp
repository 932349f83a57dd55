#include "core/config/sensorconfigreader.h"

#include "core/config/sectionreader.h"
#include "core/config/sensorkey.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <map>

namespace gorizont {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int mostSensors = 255; ///< on one line: as many as there are addresses

/// What the section of a port holds for one index.
struct SensorKeys
{
    bool isListed = false; ///< there is an address or a name
    QHash<QString, QString> options; ///< what only a driver understands
};

bool isOption(const QString &name)
{
    constexpr std::array<QStringView, 15> known{u"name", u"n",       u"on",      u"adr",   u"snd3",
                                                u"xo",   u"yo",      u"to",      u"invy",  u"rotx",
                                                u"note", u"setdata", u"adjdata", u"place", u"accelon"};
    return std::find(known.begin(), known.end(), name) == known.end();
}

std::map<int, SensorKeys> keysByIndex(const IniFile &file, const QString &section)
{
    std::map<int, SensorKeys> sensors;
    for (const IniFile::Entry &entry : file.entries(section)) {
        const auto key = sensorKey(entry.key);
        if (!key) {
            continue;
        }
        SensorKeys &sensor = sensors[key->index];
        sensor.isListed = sensor.isListed || key->name == u"adr" || key->name == u"name";
        if (isOption(key->name)) {
            sensor.options.insert(key->name, entry.value);
        }
    }
    std::erase_if(sensors, [](const auto &sensor) { return !sensor.second.isListed; });
    return sensors;
}

/// What the type can measure. ИН-Д has no temperature in any of its protocols, whatever its name says.
void setCapabilities(SensorConfig &sensor, bool isAccelOn)
{
    const NameKeywords keywords = readKeywords(sensor.name);
    sensor.type = keywords.type;
    sensor.model = keywords.model;
    sensor.hasThermostat = keywords.hasThermostat;
    const bool isAnD3 = sensor.type == SensorType::AnD3;
    sensor.measuresTilt = isAnD3 || sensor.type == SensorType::InD || sensor.type == SensorType::UsmIsn;
    sensor.measuresWeather = sensor.type == SensorType::Mk14;
    sensor.measuresTemperature = isAnD3 || sensor.type == SensorType::UsmIsn || sensor.measuresWeather;
    sensor.measuresAcceleration = isAnD3 && isAccelOn;
}

void readIdentity(SectionReader &keys, SensorConfig &sensor)
{
    constexpr SectionReader::Range numbers{1, 65535};
    keys.take(u"Name"_s, sensor.name);
    keys.take(
        u"N"_s, sensor.number, numbers,
        QCoreApplication::translate("ServerConfig", "The sensor is listed under a free number."));
    keys.take(u"Place"_s, sensor.place);
    keys.take(u"SND3"_s, sensor.serialNumber);
    keys.take(u"SetData"_s, sensor.installedOn);
    keys.take(u"AdjData"_s, sensor.adjustedOn);
    keys.take(u"Note"_s, sensor.note);
}

void readAxes(SectionReader &keys, SensorConfig &sensor)
{
    constexpr SectionReader::Range arcSeconds{-1296000, 1296000};
    constexpr SectionReader::Range degrees{-360, 360};
    keys.take(u"Xo"_s, sensor.offsetX, arcSeconds);
    keys.take(u"Yo"_s, sensor.offsetY, arcSeconds);
    keys.take(u"To"_s, sensor.offsetT, {-1000, 1000});
    keys.take(u"InvY"_s, sensor.isYInverted);
    keys.take(u"RotX"_s, sensor.rotationX, degrees);
}

/// Another device may live at the default address, so a sensor with a bad one is not polled; neither is one of unknown
/// type. A sensor that is off anyway is nothing to complain about.
void readPolling(SectionReader &keys, SensorConfig &sensor)
{
    const QString isOff = QCoreApplication::translate("ServerConfig", "The sensor is switched off.");
    keys.take(u"On"_s, sensor.isOn);
    const bool isAddressGood = keys.take(u"adr"_s, sensor.address, {1, 255}, isOff);
    const bool isTypeKnown = sensor.type != SensorType::None;
    if (sensor.isOn && !isTypeKnown) {
        keys.complain(
            u"Name"_s,
            QCoreApplication::translate("ServerConfig", "The name of sensor %1 says no type of sensor.")
                .arg(sensor.index),
            isOff);
    }
    if (sensor.isOn && !(isAddressGood && isTypeKnown)) {
        keys.replace(u"On"_s);
        sensor.isOn = false;
    }
}

SensorConfig readSensor(SectionReader &keys, int port, int index, const QHash<QString, QString> &options)
{
    SensorConfig sensor;
    sensor.port = port;
    sensor.index = index;
    readIdentity(keys, sensor);
    bool isAccelOn = true;
    keys.take(u"AccelOn"_s, isAccelOn);
    setCapabilities(sensor, isAccelOn);
    readPolling(keys, sensor);
    readAxes(keys, sensor);
    sensor.options = options;
    return sensor;
}

int announcedSensors(SectionReader &section)
{
    int announced = 0;
    section.take(u"NumOfSensors"_s, announced, {0});
    if (announced > mostSensors) {
        section.complain(
            u"NumOfSensors"_s,
            QCoreApplication::translate("ServerConfig", "NumOfSensors is %1, but at most %2 are possible.")
                .arg(announced)
                .arg(mostSensors),
            QCoreApplication::translate("ServerConfig", "Only the first %1 are used.").arg(mostSensors));
        section.replace(u"NumOfSensors"_s);
    }
    return qMin(announced, mostSensors);
}

/// The first few indices up to \a announced that \a listed lacks.
QString missingIndices(const std::map<int, SensorKeys> &listed, int announced)
{
    constexpr qsizetype most = 10;
    QStringList missing;
    for (int index = 1; index <= announced; ++index) {
        if (listed.contains(index)) {
            continue;
        }
        if (missing.size() == most) {
            missing.append(u"…"_s);
            break;
        }
        missing.append(QString::number(index));
    }
    return missing.join(u", "_s);
}

void complainOfNumber(SectionReader &section, int announced, const std::map<int, SensorKeys> &listed)
{
    const auto beyond = std::distance(listed.upper_bound(announced), listed.end());
    const QString missing = missingIndices(listed, announced);
    if (!missing.isEmpty()) {
        section.complain(
            u"NumOfSensors"_s,
            QCoreApplication::translate("ServerConfig", "NumOfSensors is %1, but these have neither adr nor Name: %2.")
                .arg(QString::number(announced), missing),
            QCoreApplication::translate("ServerConfig", "They are left out."));
    }
    if (beyond > 0) {
        section.complain(
            u"NumOfSensors"_s,
            QCoreApplication::translate("ServerConfig", "NumOfSensors is %1, but %2 more are listed.")
                .arg(announced)
                .arg(beyond),
            QCoreApplication::translate("ServerConfig", "They are ignored."));
    }
}

} // namespace

QList<SensorConfig> readSensors(const IniFile &file, SectionReader &section, int port, Findings &findings)
{
    const int announced = announcedSensors(section);
    const std::map<int, SensorKeys> listed = keysByIndex(file, section.section());
    QList<SensorConfig> sensors;
    for (const auto &[index, found] : listed) {
        if (index > announced) {
            break;
        }
        SectionReader keys(file, section.section(), findings, QString::number(index));
        sensors.append(readSensor(keys, port, index, found.options));
    }
    complainOfNumber(section, announced, listed);
    return sensors;
}

} // namespace gorizont
