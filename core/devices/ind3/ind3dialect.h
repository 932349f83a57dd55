#pragma once

#include <QString>

#include <optional>

namespace gorizont::ind3 {

/// Which of its three protocols a sensor speaks: `Protocol{i}` in the ini.
enum class Dialect : quint8 { V211, V210, Modbus };

inline const QString dialectOption = QStringLiteral("protocol"); ///< key in SensorConfig::options

/// `2.11`, `2.10`, `modbus`; nothing: 2.11. Empty: no such protocol.
inline std::optional<Dialect> dialectNamed(const QString &name)
{
    const QString plain = name.trimmed().toLower().replace(u',', u'.');
    if (plain.isEmpty() || plain == QLatin1String("2.11")) {
        return Dialect::V211;
    }
    if (plain == QLatin1String("2.10")) {
        return Dialect::V210;
    }
    if (plain == QLatin1String("modbus")) {
        return Dialect::Modbus;
    }
    return std::nullopt;
}

} // namespace gorizont::ind3
