#include "ui/models/measurementmodel.h"

#include "ui/models/statetext.h"

#include <QFontDatabase>

#include <algorithm>

namespace gorizont {

MeasurementModel::MeasurementModel(const SensorRegistry &registry, int capacity, int removed, QObject *parent)
    : QAbstractTableModel(parent)
    , m_capacity(std::max(1, capacity))
    , m_removed(std::clamp(removed, 1, m_capacity))
{
    for (const SensorRegistry::Sensor &sensor : registry.sensors()) {
        if (sensor.config.measuresTilt) {
            m_sensors += {sensor.config.number, statetext::sensorTitle(sensor.config)};
        }
    }
}

MeasurementModel::Line MeasurementModel::split(const QString &line)
{
    Line result{line, {}};
    while (result.text.endsWith(u'\n') || result.text.endsWith(u'\r')) {
        result.text.chop(1);
    }
    for (qsizetype at = result.text.indexOf(u'\t'); at >= 0; at = result.text.indexOf(u'\t', at + 1)) {
        result.ends += static_cast<int>(at);
    }
    result.ends += static_cast<int>(result.text.size());
    return result;
}

QStringView MeasurementModel::Line::field(int column) const
{
    if (column >= ends.size()) {
        return {};
    }
    const int start = column == 0 ? 0 : ends.at(column - 1) + 1;
    return QStringView(text).mid(start, ends.at(column) - start);
}

void MeasurementModel::append(const QString &line)
{
    if (rowCount() >= m_capacity) {
        beginRemoveRows({}, 0, m_removed - 1);
        m_lines.erase(m_lines.begin(), m_lines.begin() + m_removed);
        endRemoveRows();
    }
    beginInsertRows({}, rowCount(), rowCount());
    m_lines.push_back(split(line));
    endInsertRows();
}

int MeasurementModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

int MeasurementModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : leadingColumns + sensorColumns * static_cast<int>(m_sensors.size());
}

QVariant MeasurementModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    static const QFont fixedFont = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    switch (role) {
    case Qt::DisplayRole: return m_lines[static_cast<std::size_t>(index.row())].field(index.column()).toString();
    case Qt::TextAlignmentRole: return QVariant::fromValue(Qt::AlignVCenter | Qt::AlignRight);
    case Qt::FontRole: return fixedFont;
    default: return {};
    }
}

QVariant MeasurementModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant::fromValue(Qt::AlignVCenter | Qt::AlignRight);
    }
    switch (role) {
    case Qt::DisplayRole: return heading(section);
    case Qt::ToolTipRole: return meaning(section);
    default: return {};
    }
}

QString MeasurementModel::heading(int column) const
{
    if (column < leadingColumns) {
        return column == 0 ? tr("Time") : tr("Ports");
    }
    const int number = m_sensors.value((column - leadingColumns) / sensorColumns).number;
    switch ((column - leadingColumns) % sensorColumns) {
    case 0: return tr("%1: X, ″").arg(number);
    case 1: return tr("%1: Y, ″").arg(number);
    case 2: return tr("%1: T, °C").arg(number);
    case 3: return tr("%1: P, %").arg(number);
    default: return tr("%1: status").arg(number);
    }
}

QString MeasurementModel::meaning(int column) const
{
    if (column == 0) {
        return tr("Time and date of the record");
    }
    if (column == 1) {
        return tr("Status word of the channel, the first port at the right: 0 no errors, 1 cannot be opened, 2 write "
                  "errors, 3 off or not there");
    }
    const QString title = m_sensors.value((column - leadingColumns) / sensorColumns).title;
    switch ((column - leadingColumns) % sensorColumns) {
    case 0: return tr("%1: angle along X, arc-seconds").arg(title);
    case 1: return tr("%1: angle along Y, arc-seconds").arg(title);
    case 2: return tr("%1: temperature, °C; empty if the sensor has none").arg(title);
    case 3: return tr("%1: power of the thermostat's heater, %").arg(title);
    default: return tr("%1: status word, the code and bits 11…0").arg(title);
    }
}

} // namespace gorizont
