#include "core/modbus/registerdocument.h"

#include "core/modbus/markdowntable.h"
#include "core/modbus/registercodes.h"
#include "core/modbus/registerexample.h"
#include "core/values/statustext.h"

#include <QCoreApplication>

#include <algorithm>

namespace gorizont {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(RegisterMap)
};

/// A part with more fields than this has a table for each sensor, the others one for all.
constexpr std::size_t fewFields = 8;

QString heading(int level, const QString &text)
{
    return QStringLiteral("%1 %2\n\n").arg(QString(level, QLatin1Char('#')), text);
}

QString paragraph(const QString &text)
{
    return text.isEmpty() ? QString() : text + QStringLiteral("\n\n");
}

QString lineTitle(const QList<LineConfig> &lines, int port)
{
    const auto line = std::ranges::find(lines, port, &LineConfig::index);
    return line != lines.end() ? line->title() : QString();
}

/// `АН-Д3 № 1 (COM10, address 1) · place`
QString fullName(const QList<LineConfig> &lines, const SensorConfig &sensor)
{
    const auto line = std::ranges::find(lines, sensor.port, &LineConfig::index);
    const QString title = sensorTitle(sensor, line != lines.end() ? *line : LineConfig()).trimmed();
    return markdownEscaped(sensor.place.isEmpty() ? title : title + QStringLiteral(" · ") + sensor.place);
}

QString introduction(const ServerConfig &server, const UnitImages &images)
{
    const QString site = server.name.isEmpty() ? QString() : QStringLiteral(" · ") + markdownEscaped(server.name);
    QString text = heading(1, Text::tr("Modbus register map"))
        + paragraph(QStringLiteral("Gorizont Server %1%2").arg(QStringLiteral(GORIZONT_VERSION), site));
    if (!server.servesModbus) {
        text += paragraph(Text::tr("The server is switched off in this configuration (CanModbus=0)."));
    }
    QStringList points{
        Text::tr("Modbus TCP, port %1. Nothing can be written.").arg(server.modbusPort),
        server.modbusPacking == ModbusPacking::ByNumber
            ? Text::tr("ModbusPacking=ByNumber: in every unit slot 0 is N=1, slot 1 is N=2 and so on. Slots without a "
                       "sensor are not listed; they hold the status word 0F00h and nothing else.")
            : Text::tr(
                "ModbusPacking=ByType: the sensors of a unit follow each other in ascending N, switched-off ones "
                "included. Their places change only when sensors are added to the ini or taken out."),
        Text::tr("A register is given as in the request, counted from 0, and as programs give it that count from 1 and "
                 "put the kind of register in front: 30001 is register 0 read with function 04, 40001 the same with "
                 "function 03. Behind 39999 there are five digits: 310000."),
        Text::tr("A request reads any part of a unit, at most 125 registers. Exceptions: 0B no such unit, 01 function, "
                 "03 quantity, 02 registers that do not exist."),
        Text::tr("Order of the bytes on the wire: A is the high byte of the value."),
    };
    if (!images.unreachable().isEmpty()) {
        points.append(images.unreachable().sentence());
    }
    for (const QString &point : points) {
        text += QStringLiteral("- %1\n").arg(point);
    }
    return text + QLatin1Char('\n');
}

/// Empty: \a sensor has no place in \a unit.
QString firstRegister(const UnitImage &unit, const SensorConfig &sensor)
{
    const std::optional<int> slot = unit.slotMap().slotOf(sensor.number);
    if (!slot || unit.slotMap().at(*slot).sensor != sensor) {
        return QStringLiteral("—");
    }
    const SlotPart &part = unit.layout().parts.back();
    return QString::number(unit.block().base() + part.start + part.stride * *slot);
}

QString sensorList(const QList<LineConfig> &lines, const UnitImages &images)
{
    QStringList titles{Text::tr("N"),       Text::tr("Sensor"), Text::tr("Port"),
                       Text::tr("Address"), Text::tr("Place"),  Text::tr("On")};
    for (const UnitImage &unit : images.units()) {
        titles.append(Text::tr("From register, unit %1").arg(unit.layout().unit));
    }
    QList<std::pair<SensorConfig, bool>> sensors;
    for (const LineConfig &line : lines) {
        for (const SensorConfig &sensor : line.sensors) {
            sensors.append({sensor, sensor.isOn && line.isOn});
        }
    }
    std::ranges::stable_sort(sensors, {}, [](const auto &entry) { return entry.first.number; });
    MarkdownTable table(titles);
    for (const auto &[sensor, isOn] : sensors) {
        QStringList cells{QString::number(sensor.number), modelInRussian(sensor.model),
                          lineTitle(lines, sensor.port),  QString::number(sensor.address),
                          markdownEscaped(sensor.place),  isOn ? Text::tr("yes") : Text::tr("no")};
        for (const UnitImage &unit : images.units()) {
            cells.append(firstRegister(unit, sensor));
        }
        table.add(cells);
    }
    return heading(2, Text::tr("Sensors")) + table.text();
}

/// 30001, 310000.
QString counted(char kind, int address)
{
    const int digits = address < 9999 ? 4 : 5;
    return QLatin1Char(kind) + QStringLiteral("%1").arg(address + 1, digits, 10, QLatin1Char('0'));
}

QStringList fieldTitles(const UnitLayout &layout)
{
    QStringList titles{Text::tr("Register"), QStringLiteral("3x")};
    if (layout.isHolding) {
        titles.append(QStringLiteral("4x"));
    }
    return titles + QStringList{Text::tr("Registers"), Text::tr("Field"), Text::tr("Type"),   Text::tr("Order"),
                                Text::tr("Scale"),     Text::tr("Unit"),  Text::tr("Meaning")};
}

template <typename State> QStringList fieldCells(const UnitImage &unit, const RegisterField<State> &field, int start)
{
    static const QStringList types{
        QStringLiteral("int16"), QStringLiteral("uint16"), QStringLiteral("uint32"), QStringLiteral("uint64"),
        QStringLiteral("float32")};
    const int address = unit.block().base() + start + field.offset;
    QStringList cells{QString::number(address), counted('3', address)};
    if (unit.layout().isHolding) {
        cells.append(counted('4', address));
    }
    const QString unitText = *field.unit != '\0' ? Text::tr(field.unit) : QString();
    return cells
        + QStringList{
            QString::number(registerCount(field.type)),
            QStringLiteral("`%1`").arg(QLatin1String(field.name)),
            types.at(static_cast<qsizetype>(field.type)),
            byteOrder(field.type, unit.layout().order),
            QString::number(1 / field.scale),
            unitText,
            Text::tr(field.meaning)};
}

QString slotTables(const UnitImage &unit, const SlotPart &part, const QList<LineConfig> &lines)
{
    const bool isShort = part.fields.size() <= fewFields;
    const QStringList titles = fieldTitles(unit.layout());
    QString text = *part.meaning != '\0' ? heading(3, Text::tr(part.meaning)) : QString();
    MarkdownTable common(titles + QStringList{Text::tr("Sensor")});
    for (int slot = 0; slot < unit.slotMap().count(); ++slot) {
        if (unit.slotMap().at(slot).isHole()) {
            continue;
        }
        const QString name = fullName(lines, unit.slotMap().at(slot).sensor);
        MarkdownTable own(titles);
        for (const SlotField &field : part.fields) {
            const QStringList cells = fieldCells(unit, field, part.start + part.stride * slot);
            isShort ? common.add(cells + QStringList{name}) : own.add(cells);
        }
        text += isShort ? QString() : heading(4, name) + own.text();
    }
    return isShort ? text + common.text() : text;
}

/// A table for every sensor that has an area.
QString areaTables(const UnitImage &unit, const QList<LineConfig> &lines)
{
    QString text;
    for (int slot = 0; slot < unit.slotMap().count(); ++slot) {
        if (unit.areaAt(slot) == 0) {
            continue;
        }
        MarkdownTable own(fieldTitles(unit.layout()));
        for (const SlotField &field : unit.layout().areas->fields) {
            own.add(fieldCells(unit, field, unit.areaAt(slot) - unit.block().base()));
        }
        text += heading(4, fullName(lines, unit.slotMap().at(slot).sensor)) + own.text();
    }
    return text.isEmpty() ? text : heading(3, Text::tr(unit.layout().areas->meaning)) + text;
}

QString orderText(RegisterOrder order)
{
    return order == RegisterOrder::LowByteFirst
        ? Text::tr(
            "All numbers low byte first, in the registers too: where usual Modbus has 1234h, there is 3412h. Swap "
            "the bytes of every register, and the registers of the channel word.")
        : Text::tr("All numbers high byte first, of several registers the high one first, as Modbus is usually read.");
}

QString unitText(const UnitImage &unit, const ModbusConfig &config)
{
    const UnitLayout &layout = unit.layout();
    const RegisterBlock &block = unit.block();
    QString text = heading(2, Text::tr("Unit %1. %2").arg(QString::number(layout.unit), Text::tr(layout.title)));
    text += paragraph(Text::tr("Function %1; registers %2…%3.")
                          .arg(
                              layout.isHolding ? Text::tr("03 or 04") : QStringLiteral("04"),
                              QString::number(block.base()), QString::number(block.base() + block.count() - 1)));
    text += paragraph(orderText(layout.order)) + paragraph(Text::tr(layout.remark));
    MarkdownTable head(fieldTitles(layout));
    for (const HeadField &field : layout.head) {
        head.add(fieldCells(unit, field, 0));
    }
    text += head.text() + registerExample(config, unit);
    for (const SlotPart &part : layout.parts) {
        text += slotTables(unit, part, config.lines);
    }
    return text + areaTables(unit, config.lines);
}

} // namespace

QString registerDocument(const ServerConfig &server)
{
    const ModbusConfig config = modbusConfig(server);
    const UnitImages images(config);
    QString text = introduction(server, images) + sensorList(config.lines, images);
    for (const UnitImage &unit : images.units()) {
        text += unitText(unit, config);
    }
    return text + registerCodes();
}

} // namespace gorizont
