#include "ui/models/sensormodel.h"

#include "ui/models/colours.h"
#include "ui/models/icons.h"
#include "ui/models/statetext.h"
#include "ui/models/statusmeaning.h"
#include "ui/models/valuetext.h"
#include "ui/models/vibrationproperties.h"
#include "ui/models/weatherproperties.h"

#include <QFontDatabase>

#include <algorithm>
#include <numeric>

namespace gorizont {

namespace {

QString text(const SensorRegistry::Sensor &sensor, int column)
{
    const Reading &reading = sensor.reading;
    switch (column) {
    case SensorModel::Sensor: return statetext::sensorTitle(sensor.config);
    case SensorModel::Mx:
    case SensorModel::My: {
        const auto tilt = validTilt(reading);
        return tilt ? valuetext::degrees(column == SensorModel::Mx ? tilt->x : tilt->y) : valuetext::absent();
    }
    case SensorModel::Amax:
    case SensorModel::Arms: {
        const auto accel = validAcceleration(reading);
        return accel ? valuetext::fixed(column == SensorModel::Amax ? accel->maximum : accel->rms, 2)
                     : valuetext::absent();
    }
    case SensorModel::Temperature: return valuetext::fixed(validTemperature(reading), 2);
    case SensorModel::Fan: return valuetext::fixed(validFanFrequency(sensor.config, reading), 1);
    case SensorModel::Power: return valuetext::fixed(validHeaterPower(sensor.config, reading), 1);
    case SensorModel::Status: return valuetext::status(reading.status);
    default: return {};
    }
}

/// What a column sorts by; empty: absent.
std::optional<double> sortKey(const SensorRegistry::Sensor &sensor, int column)
{
    const Reading &reading = sensor.reading;
    const auto tilt = validTilt(reading);
    const auto accel = validAcceleration(reading);
    switch (column) {
    case SensorModel::Mx: return tilt ? std::optional(tilt->x) : std::nullopt;
    case SensorModel::My: return tilt ? std::optional(tilt->y) : std::nullopt;
    case SensorModel::Amax: return accel ? std::optional(accel->maximum) : std::nullopt;
    case SensorModel::Arms: return accel ? std::optional(accel->rms) : std::nullopt;
    case SensorModel::Temperature: return validTemperature(reading);
    case SensorModel::Fan: return validFanFrequency(sensor.config, reading);
    case SensorModel::Power: return validHeaterPower(sensor.config, reading);
    case SensorModel::Status: return reading.status;
    default: return sensor.config.number;
    }
}

Qt::Alignment alignment(int column)
{
    return Qt::AlignVCenter | (column == SensorModel::Sensor ? Qt::AlignLeft : Qt::AlignRight);
}

} // namespace

SensorModel::SensorModel(const SensorRegistry &registry, QObject *parent)
    : QAbstractTableModel(parent)
    , m_registry(registry)
    , m_order(registry.sensors().size())
{
    std::iota(m_order.begin(), m_order.end(), 0);
}

int SensorModel::rowOf(int sensor) const
{
    const auto found = std::find(m_order.cbegin(), m_order.cend(), sensor);
    return found == m_order.cend() ? -1 : static_cast<int>(found - m_order.cbegin());
}

void SensorModel::refresh(int first, int last)
{
    const int lastRow = std::min(last, rowCount() - 1);
    if (first >= 0 && first <= lastRow) {
        Q_EMIT dataChanged(index(first, 0), index(lastRow, ColumnCount - 1));
    }
}

int SensorModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_order.size());
}

int SensorModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

Health SensorModel::healthOf(const SensorRegistry::Sensor &sensor) const
{
    return sensorHealth(sensor, m_registry.lines()[static_cast<std::size_t>(sensor.line)].status.state);
}

/// What a cell has no room for; everywhere else what the sensor is and how it does.
QString SensorModel::toolTip(const SensorRegistry::Sensor &sensor, int column) const
{
    const Reading &reading = sensor.reading;
    switch (column) {
    case Mx:
    case My:
        if (const auto tilt = validTilt(reading)) {
            return tr("%1 arc-seconds").arg(valuetext::signedFixed(column == Mx ? tilt->x : tilt->y, 1));
        }
        break;
    case Amax:
    case Arms:
        if (const auto accel = validAcceleration(reading)) {
            const bool isMaximum = column == Amax;
            return tr("along X %1, along Y %2 mm/s²")
                .arg(
                    valuetext::signedFixed(isMaximum ? accel->maximumX : accel->rmsX, 2),
                    valuetext::signedFixed(isMaximum ? accel->maximumY : accel->rmsY, 2));
        }
        break;
    case Status: return statusmeaning::word(reading);
    default: break;
    }
    const SensorRegistry::Line &line = m_registry.lines()[static_cast<std::size_t>(sensor.line)];
    QStringList lines{
        statetext::sensorTitle(sensor.config), sensor.config.name,
        QStringLiteral("%1: %2").arg(line.config.title(), statetext::sensor(sensor, line.status.state))};
    for (const QString &more : {vibrationSummary(reading), weatherSummary(sensor, line.status.state)}) {
        if (!more.isEmpty()) {
            lines.append(more);
        }
    }
    return lines.join(u'\n');
}

QVariant SensorModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    static const QFont fixedFont = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    const SensorRegistry::Sensor &sensor = sensorOf(sensorAt(index.row()));
    switch (role) {
    case Qt::DisplayRole: return text(sensor, index.column());
    case Qt::TextAlignmentRole: return QVariant::fromValue(alignment(index.column()));
    case Qt::DecorationRole: return index.column() == Sensor ? QVariant(icons::state(healthOf(sensor))) : QVariant();
    case Qt::FontRole: return index.column() == Status ? QVariant(fixedFont) : QVariant();
    case Qt::ForegroundRole: return healthOf(sensor) == Health::Off ? QVariant(colours::mutedText()) : QVariant();
    case Qt::ToolTipRole: return toolTip(sensor, index.column());
    default: return {};
    }
}

QVariant SensorModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant::fromValue(alignment(section));
    }
    if (role == Qt::ToolTipRole) {
        switch (section) {
        case Sensor: return tr("Logical name of the sensor: number, type, place, address");
        case Mx: return tr("Angle along X, degrees");
        case My: return tr("Angle along Y, degrees");
        case Amax: return tr("Maximum acceleration, mm/s²");
        case Arms: return tr("Root mean square of the acceleration, mm/s²");
        case Temperature: return tr("Temperature, °C");
        case Fan: return tr("Frequency of the thermostat's fan, revolutions per second");
        case Power: return tr("Power of the thermostat's heater, %");
        case Status: return statusmeaning::legend();
        default: return {};
        }
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case Sensor: return tr("Sensor");
    case Mx: return tr("Mx, °");
    case My: return tr("My, °");
    case Amax: return tr("Amax, mm/s²");
    case Arms: return tr("Arms, mm/s²");
    case Temperature: return tr("T, °C");
    case Fan: return tr("Frequency, rev/s");
    case Power: return tr("P, %");
    case Status: return tr("Status");
    default: return {};
    }
}

void SensorModel::sort(int column, Qt::SortOrder order)
{
    m_sortColumn = column < 0 ? static_cast<int>(Sensor) : column;
    m_sortOrder = column < 0 ? Qt::AscendingOrder : order;
    resort();
}

void SensorModel::resort()
{
    std::vector<int> order = sortedOrder();
    if (order != m_order) {
        setOrder(std::move(order));
    }
}

std::vector<int> SensorModel::sortedOrder() const
{
    std::vector<std::optional<double>> keys;
    keys.reserve(m_order.size());
    for (const SensorRegistry::Sensor &sensor : m_registry.sensors()) {
        keys.push_back(sortKey(sensor, m_sortColumn));
    }
    std::vector<int> order(m_order.size());
    std::iota(order.begin(), order.end(), 0);
    const bool isDescending = m_sortOrder == Qt::DescendingOrder;
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        const std::optional<double> &left = keys[static_cast<std::size_t>(a)];
        const std::optional<double> &right = keys[static_cast<std::size_t>(b)];
        if (!left || !right) {
            return left.has_value() && !right.has_value();
        }
        return isDescending ? *left > *right : *left < *right;
    });
    return order;
}

void SensorModel::setOrder(std::vector<int> order)
{
    Q_EMIT layoutAboutToBeChanged({}, VerticalSortHint);
    const QModelIndexList before = persistentIndexList();
    std::vector<int> rowOfSensor(order.size());
    for (std::size_t row = 0; row < order.size(); ++row) {
        rowOfSensor[static_cast<std::size_t>(order[row])] = static_cast<int>(row);
    }
    QModelIndexList after;
    after.reserve(before.size());
    for (const QModelIndex &index : before) {
        after += createIndex(rowOfSensor[static_cast<std::size_t>(sensorAt(index.row()))], index.column());
    }
    m_order = std::move(order);
    changePersistentIndexList(before, after);
    Q_EMIT layoutChanged({}, VerticalSortHint);
}

} // namespace gorizont
