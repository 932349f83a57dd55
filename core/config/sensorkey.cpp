#include "core/config/sensorkey.h"

namespace gorizont {

namespace {

bool isAsciiDigit(QChar character)
{
    return character >= u'0' && character <= u'9';
}

qsizetype indexPosition(const QString &lower)
{
    const QString serialNumber = QStringLiteral("snd3");
    qsizetype position = lower.size();
    while (position > 0 && isAsciiDigit(lower.at(position - 1))) {
        --position;
    }
    const bool isSerialNumber = position == serialNumber.size() - 1 && lower.startsWith(serialNumber);
    return isSerialNumber ? serialNumber.size() : position;
}

} // namespace

std::optional<SensorKey> sensorKey(const QString &key)
{
    const QString lower = key.toLower();
    const qsizetype position = indexPosition(lower);
    const QString digits = lower.mid(position);
    const int index = digits.toInt();
    if (position == 0 || index < 1 || digits.startsWith(u'0') || lower == QStringLiteral("rs485")) {
        return std::nullopt;
    }
    return SensorKey{lower.left(position), index};
}

} // namespace gorizont
