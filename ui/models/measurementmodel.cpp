#include "ui/models/measurementmodel.h"

#include <QFontDatabase>

#include <algorithm>

namespace gorizont {

namespace {

constexpr int leadingColumns = 2; ///< time and channel word
constexpr int sensorColumns = 5; ///< X, Y, T, heater power, status

} // namespace

MeasurementModel::MeasurementModel(const SensorRegistry &registry, int capacity, int removed, QObject *parent)
    : QAbstractTableModel(parent)
    , m_capacity(std::max(1, capacity))
    , m_removed(std::clamp(removed, 1, m_capacity))
{
    for (const SensorRegistry::Sensor &sensor : registry.sensors()) {
        if (sensor.config.measuresTilt) {
            m_numbers += sensor.config.number;
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
    return parent.isValid() ? 0 : leadingColumns + sensorColumns * static_cast<int>(m_numbers.size());
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
    if (role != Qt::DisplayRole) {
        return {};
    }
    if (section < leadingColumns) {
        return section == 0 ? tr("Time") : tr("Ports");
    }
    const int number = m_numbers.value((section - leadingColumns) / sensorColumns);
    switch ((section - leadingColumns) % sensorColumns) {
    case 0: return tr("%1: X, ″").arg(number);
    case 1: return tr("%1: Y, ″").arg(number);
    case 2: return tr("%1: T, °C").arg(number);
    case 3: return tr("%1: P, %").arg(number);
    default: return tr("%1: status").arg(number);
    }
}

} // namespace gorizont
