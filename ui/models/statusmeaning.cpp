#include "ui/models/statusmeaning.h"

#include "core/values/statustext.h"

#include <QCoreApplication>
#include <QStringList>

#include <array>

namespace gorizont::statusmeaning {

namespace {

/// The translation context of the meanings.
struct StatusBits
{
    Q_DECLARE_TR_FUNCTIONS(StatusBits)
};

struct Bit
{
    int bit;
    const char *meaning;
};

/// Manual 000, section 11.2; bits 1 and 0 are reserved.
constexpr std::array<Bit, 10> bits{{
    {11, QT_TRANSLATE_NOOP("StatusBits", "polling is off")},
    {10, QT_TRANSLATE_NOOP("StatusBits", "angles are not valid or not ready")},
    {9, QT_TRANSLATE_NOOP("StatusBits", "temperature is not valid or not ready")},
    {8, QT_TRANSLATE_NOOP("StatusBits", "accelerations are not valid or not ready")},
    {7, QT_TRANSLATE_NOOP("StatusBits", "the exchange buffer of accelerations overran")},
    {6, QT_TRANSLATE_NOOP("StatusBits", "synchronisation error")},
    {5, QT_TRANSLATE_NOOP("StatusBits", "the microcontroller has restarted")},
    {4, QT_TRANSLATE_NOOP("StatusBits", "the thermostat has not settled")},
    {3, QT_TRANSLATE_NOOP("StatusBits", "heating of the thermostat at minimum (fast cooling)")},
    {2, QT_TRANSLATE_NOOP("StatusBits", "heating of the thermostat at maximum (fast heating)")},
}};

/// spec/and3.md, raw status; bits 7, 14 and 15 are reserved.
constexpr std::array<Bit, 13> rawBits{{
    {13, QT_TRANSLATE_NOOP("StatusBits", "the thermostat is on")},
    {12, QT_TRANSLATE_NOOP("StatusBits", "searching for its address")},
    {11, QT_TRANSLATE_NOOP("StatusBits", "error of the thermostat")},
    {10, QT_TRANSLATE_NOOP("StatusBits", "error of the fan")},
    {9, QT_TRANSLATE_NOOP("StatusBits", "temperature out of range")},
    {8, QT_TRANSLATE_NOOP("StatusBits", "temperature cannot be read")},
    {6, QT_TRANSLATE_NOOP("StatusBits", "the transducer is out of range")},
    {5, QT_TRANSLATE_NOOP("StatusBits", "CRC errors of the transducer")},
    {4, QT_TRANSLATE_NOOP("StatusBits", "the transducer does not answer")},
    {3, QT_TRANSLATE_NOOP("StatusBits", "data of the fan are ready")},
    {2, QT_TRANSLATE_NOOP("StatusBits", "temperature is ready")},
    {1, QT_TRANSLATE_NOOP("StatusBits", "angles are ready")},
    {0, QT_TRANSLATE_NOOP("StatusBits", "the restart was acknowledged")},
}};

template <std::size_t size> void addBits(QStringList &lines, const std::array<Bit, size> &meanings, quint16 status)
{
    for (const Bit &bit : meanings) {
        if (status & (1 << bit.bit)) {
            lines += StatusBits::tr("bit %1: %2").arg(bit.bit).arg(StatusBits::tr(bit.meaning));
        }
    }
}

} // namespace

QString word(quint16 status)
{
    Reading reading;
    reading.status = status;
    return word(reading);
}

QString word(const Reading &reading)
{
    const auto code = static_cast<int>(statusCode(reading.status));
    QStringList lines{StatusBits::tr("code %1: %2").arg(code).arg(statusText(reading))};
    addBits(lines, bits, reading.status);
    return lines.join(u'\n');
}

QString legend()
{
    QStringList lines{StatusBits::tr("Status word of the sensor: the code of the error, then bits 11…0")};
    addBits(lines, bits, 0x0FFF);
    return lines.join(u'\n');
}

QString rawWord(const SensorConfig &sensor, const Reading &reading)
{
    if (sensor.type != SensorType::AnD3) {
        return {};
    }
    constexpr quint16 ofThermostat = 1 << 11 | 1 << 10;
    constexpr quint16 recordingStopped = 1 << 6;
    const quint16 status = reading.rawStatus.value_or(0);
    QStringList lines;
    addBits(lines, rawBits, status);
    if ((status & ofThermostat) && !sensor.hasThermostat) {
        lines += StatusBits::tr("bits 11 and 10 do not count: the sensor has no thermostat");
    }
    if (reading.rawMode.value_or(0) & recordingStopped) {
        lines += StatusBits::tr("mode, bit 6: the recording of accelerations is stopped");
    }
    return lines.join(u'\n');
}

} // namespace gorizont::statusmeaning
