#include "core/devices/lvims/lvimsdriver.h"
#include "core/values/vibrationkinds.h"

#include <QCoreApplication>

namespace gorizont::lvims {

namespace {

class OptionText
{
    Q_DECLARE_TR_FUNCTIONS(LVimsDriver)
};

/// Empty: the option is absent, or not a number from \a least to \a most.
std::optional<int> readOption(
    const SensorConfig &sensor, const QString &key, int least, int most, QStringList &complaints)
{
    const QString text = sensor.options.value(key).trimmed();
    if (text.isEmpty()) {
        return std::nullopt;
    }
    bool isNumber = false;
    const int number = text.toInt(&isNumber);
    if (isNumber && number >= least && number <= most) {
        return number;
    }
    complaints.append(OptionText::tr("%1%2 is \"%3\", but takes %4…%5. Its usual value is used.")
                          .arg(key)
                          .arg(sensor.index)
                          .arg(text)
                          .arg(least)
                          .arg(most));
    return std::nullopt;
}

} // namespace

Options Options::from(const SensorConfig &sensor)
{
    Options options;
    const auto unit = readOption(sensor, QStringLiteral("unit"), 0, 255, options.complaints);
    const auto function = readOption(sensor, QStringLiteral("readfunction"), 3, 4, options.complaints);
    const auto code = readOption(sensor, QStringLiteral("percentcode"), 1, 65535, options.complaints);
    options.address.unit = static_cast<quint8>(unit.value_or(1));
    options.address.readFunction = static_cast<modbustcp::ReadFunction>(function.value_or(3));
    options.capture = CapturePlan::from(sensor);
    options.complaints += MeasurementUnits(sensor).complaints();
    options.fullScale = code ? std::optional<double>(*code) : std::nullopt;
    return options;
}

} // namespace gorizont::lvims
