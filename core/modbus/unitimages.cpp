#include "core/modbus/unitimages.h"

#include "core/modbus/accelerationmap.h"
#include "core/modbus/extendedmap.h"
#include "core/modbus/tiltmap.h"
#include "core/modbus/windmap.h"

#include <QCoreApplication>

#include <algorithm>

namespace gorizont {

QString UnreachableSensors::sentence() const
{
    QStringList names;
    for (const int unit : units) {
        names.append(QString::number(unit));
    }
    return QCoreApplication::translate(
               "Modbus",
               "Modbus TCP: %1 sensors, the first of them N=%2, find no room below register 65536 in unit %3 and are "
               "not served there.")
        .arg(QString::number(numbers.size()), QString::number(numbers.value(0)), names.join(QStringLiteral(", ")));
}

namespace {

/// Unit 4 is none of manual 000: it is there where a weather station is.
bool isServed(const UnitLayout &layout, const QList<LineConfig> &lines)
{
    return &layout != &windMap() || std::any_of(lines.begin(), lines.end(), [](const LineConfig &line) {
        return std::any_of(line.sensors.begin(), line.sensors.end(), [](const SensorConfig &sensor) {
            return sensor.measuresWeather;
        });
    });
}

} // namespace

UnitImages::UnitImages(const ModbusConfig &config)
{
    for (const UnitLayout *layout : {&tiltMap(), &windMap(), &accelerationMap(), &extendedMap()}) {
        if (!isServed(*layout, config.lines)) {
            continue;
        }
        const int limit = layout->limit(layout->base(config.base));
        const SensorSlots slotMap(config.lines, config.rules, layout->member, config.packing, limit);
        m_images.emplace_back(*layout, config.base, slotMap);
        if (!slotMap.unreachable().isEmpty()) {
            m_unreachable.units.append(layout->unit);
            m_unreachable.numbers.append(slotMap.unreachable());
        }
    }
    std::sort(m_unreachable.units.begin(), m_unreachable.units.end());
    QList<int> &numbers = m_unreachable.numbers;
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    for (const LineConfig &line : config.lines) {
        LineStatus status;
        status.port = line.index;
        status.state = line.isOn ? LineState::Opening : LineState::Off;
        m_lines.append(status);
    }
    setChannels();
}

const UnitImage *UnitImages::unit(int unit) const
{
    for (const UnitImage &image : m_images) {
        if (image.layout().unit == unit) {
            return &image;
        }
    }
    return nullptr;
}

const RegisterBlock *UnitImages::inputRegisters(int unit) const
{
    const UnitImage *image = this->unit(unit);
    return image != nullptr ? &image->block() : nullptr;
}

void UnitImages::update(const Reading &reading)
{
    for (UnitImage &image : m_images) {
        image.update(reading);
    }
}

void UnitImages::updateLine(const LineStatus &status)
{
    for (LineStatus &line : m_lines) {
        if (line.port == status.port) {
            line = status;
        }
    }
    setChannels();
}

void UnitImages::setChannels()
{
    const quint32 word = channelWord(m_lines);
    for (UnitImage &image : m_images) {
        image.setChannels(word);
    }
}

} // namespace gorizont
