#include "core/devices/and3/and3answers.h"

#include "core/protocol/bytes.h"

#include <algorithm>

namespace gorizont::and3 {

namespace {

constexpr qsizetype complexReadSize = 18;
constexpr qsizetype informationSize = 4;

} // namespace

std::optional<ComplexRead> parseComplexRead(QByteArrayView answer)
{
    const QByteArrayView data = dataOf(answer);
    if (data.size() != complexReadSize) {
        return std::nullopt;
    }
    ComplexRead read;
    read.tilt.x = *readLittle<qint16>(data, 0) / 8.0;
    read.tilt.y = *readLittle<qint16>(data, 2) / 8.0;
    read.temperature = *readLittle<qint16>(data, 4) / 250.0;
    read.fanFrequency = *readLittle<quint16>(data, 6) / 8.0;
    read.heaterPower = *readLittle<quint16>(data, 8) / 10.0;
    read.rawStatus = *readLittle<quint16>(data, 10);
    read.samples = *readLittle<quint32>(data, 12);
    read.rawMode = *readLittle<quint16>(data, 16);
    return read;
}

std::optional<quint32> parseInformation(QByteArrayView answer)
{
    const QByteArrayView data = dataOf(answer);
    return data.size() == informationSize ? readLittle<quint32>(data, 0) : std::nullopt;
}

std::optional<Firmware> parseFirmware(QByteArrayView answer)
{
    const QByteArrayView data = dataOf(answer);
    if (data.size() != informationSize) {
        return std::nullopt;
    }
    return Firmware{.version = byteAt(data, 2), .subVersion = byteAt(data, 1), .build = byteAt(data, 0)};
}

std::optional<Configuration> parseConfiguration(QByteArrayView answer)
{
    const QByteArrayView data = dataOf(answer);
    Configuration configuration{};
    if (data.size() != static_cast<qsizetype>(configuration.size())) {
        return std::nullopt;
    }
    std::copy(data.begin(), data.end(), configuration.begin());
    return configuration;
}

Conditions conditionsOf(quint16 rawStatus)
{
    struct Row
    {
        int bit;
        bool isWhenSet;
        Condition condition;
    };
    static constexpr std::array<Row, 10> rows{{
        {0, false, Condition::Rebooted},
        {1, false, Condition::TiltNotReady},
        {2, false, Condition::TemperatureNotReady},
        {4, true, Condition::TransducerSilent},
        {5, true, Condition::TransducerCrc},
        {6, true, Condition::TransducerRange},
        {8, true, Condition::TemperatureReadError},
        {9, true, Condition::TemperatureRange},
        {10, true, Condition::FanError},
        {11, true, Condition::ThermostatError},
    }};
    Conditions conditions;
    for (const Row &row : rows) {
        conditions.setFlag(row.condition, ((rawStatus >> row.bit) & 1) == (row.isWhenSet ? 1 : 0));
    }
    return conditions;
}

} // namespace gorizont::and3
