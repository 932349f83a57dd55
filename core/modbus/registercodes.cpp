#include "core/modbus/registercodes.h"

#include "core/modbus/extendedcodes.h"
#include "core/modbus/markdowntable.h"
#include "core/modbus/vibrationmap.h"
#include "core/values/statustext.h"
#include "core/values/vibrationkinds.h"

#include <QCoreApplication>

#include <array>

namespace gorizont {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(RegisterMap)
};

QString title(const QString &text)
{
    return QStringLiteral("### %1\n\n").arg(text);
}

/// Manual 000, section 11.2, low byte and validity.
QString statusBits()
{
    MarkdownTable table({Text::tr("Bit"), Text::tr("If it is set")});
    const std::array<std::pair<int, QString>, 10> rows{{
        {11, Text::tr("the sensor is switched off")},
        {10, Text::tr("tilt is not valid or not ready")},
        {9, Text::tr("temperature is not valid or not ready")},
        {8, Text::tr("accelerations are not valid or not ready")},
        {7, Text::tr("samples of accelerations were lost")},
        {6, Text::tr("packets of samples do not follow each other")},
        {5, Text::tr("the sensor has restarted")},
        {4, Text::tr("the thermostat has not settled")},
        {3, Text::tr("the heater is at its minimum")},
        {2, Text::tr("the heater is at its maximum")},
    }};
    for (const auto &[bit, meaning] : rows) {
        table.add({QString::number(bit), meaning});
    }
    return table.text();
}

QString statusCodes()
{
    MarkdownTable table({Text::tr("Bits 15…12"), Text::tr("Meaning")});
    for (int code = 0; code <= static_cast<int>(StatusCode::Thermostat); ++code) {
        table.add({QString::number(code, 16).toUpper(), statusText(static_cast<StatusCode>(code))});
    }
    return table.text();
}

QString channelCodes()
{
    MarkdownTable table({Text::tr("Two bits"), Text::tr("The port")});
    table.add({QStringLiteral("0"), Text::tr("has no errors, or there is none")});
    table.add({QStringLiteral("1"), Text::tr("cannot be opened")});
    table.add({QStringLiteral("2"), Text::tr("was lost, or takes no bytes")});
    table.add({QStringLiteral("3"), Text::tr("is switched off")});
    return table.text();
}

template <typename Bit> QString bits(std::span<const Bit> rows)
{
    MarkdownTable table({Text::tr("Bit"), Text::tr("If it is set")});
    for (const Bit &row : rows) {
        table.add({QString::number(row.bit), Text::tr(row.meaning)});
    }
    return table.text();
}

QString types()
{
    MarkdownTable table({Text::tr("Code"), Text::tr("Sensors")});
    for (const TypeCode &type : extendedTypes()) {
        table.add({QString::number(type.code), Text::tr(type.models)});
    }
    return table.text();
}

QString measurementTypes()
{
    MarkdownTable table({Text::tr("Code"), Text::tr("Meaning"), Text::tr("Unit, if MeasUnit does not say another")});
    for (const MeasurementKind &kind : measurementKinds()) {
        table.add({QString::number(kind.type), measurementName(kind.type), MeasurementUnits().of(kind.type)});
    }
    return table.text();
}

} // namespace

QString registerCodes()
{
    return QStringLiteral("## %1\n\n").arg(Text::tr("Words and codes")) + title(Text::tr("Status word of the sensor"))
        + statusCodes() + statusBits() + title(Text::tr("Channel word: port i in bits 2(i−1) and 2(i−1)+1"))
        + channelCodes() + title(Text::tr("Unit 1: flags")) + bits(extendedFlags())
        + title(Text::tr("Unit 1: quantities")) + bits(extendedQuantities()) + title(Text::tr("Unit 1: type")) + types()
        + title(Text::tr("Unit 1: flags of a channel of L-VIMS")) + bits(channelFlags())
        + title(Text::tr("Unit 1: flags of a measurement of L-VIMS")) + bits(measurementFlags())
        + title(Text::tr("Unit 1: type of a measurement of L-VIMS")) + measurementTypes();
}

} // namespace gorizont
