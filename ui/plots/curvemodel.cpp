#include "ui/plots/curvemodel.h"

#include "ui/models/statetext.h"
#include "ui/plots/plottext.h"

#include <algorithm>

namespace gorizont {

namespace {

constexpr quintptr ofSensor = 0; ///< internal id of a sensor; of a quantity: the row of its sensor + 1

} // namespace

CurveModel::CurveModel(const SensorRegistry &registry, QObject *parent)
    : QAbstractItemModel(parent)
{
    for (const SensorRegistry::Sensor &sensor : registry.sensors()) {
        const QList<Quantity> quantities = quantitiesOf(sensor.config);
        if (!quantities.isEmpty()) {
            m_sensors.push_back({statetext::sensorTitle(sensor.config), sensor.config.number, quantities});
        }
    }
}

void CurveModel::setChosen(const QList<SeriesKey> &keys)
{
    QList<SeriesKey> known;
    for (const SeriesKey &key : keys) {
        if (isKnown(key) && !known.contains(key) && known.size() < mostCurves) {
            known.append(key);
        }
    }
    if (known == m_chosen) {
        return;
    }
    const QList<SeriesKey> changed = known + std::exchange(m_chosen, known);
    for (const SeriesKey &key : changed) {
        const QModelIndex index = indexOf(key);
        Q_EMIT dataChanged(index, index, {Qt::CheckStateRole});
    }
    Q_EMIT chosenChanged();
}

void CurveModel::addSensor(int number)
{
    const auto found = std::find_if(m_sensors.cbegin(), m_sensors.cend(), [number](const Sensor &sensor) {
        return sensor.number == number;
    });
    if (found == m_sensors.cend()) {
        return;
    }
    const qsizetype first = found->quantities.contains(Quantity::TiltX) ? 2 : 1;
    QList<SeriesKey> keys = m_chosen;
    for (const Quantity quantity : found->quantities.first(std::min(first, found->quantities.size()))) {
        keys.append({number, quantity});
    }
    setChosen(keys);
}

bool CurveModel::isKnown(const SeriesKey &key) const
{
    return std::any_of(m_sensors.cbegin(), m_sensors.cend(), [&key](const Sensor &sensor) {
        return sensor.number == key.number && sensor.quantities.contains(key.quantity);
    });
}

QModelIndex CurveModel::indexOf(const SeriesKey &key) const
{
    for (std::size_t row = 0; row < m_sensors.size(); ++row) {
        const qsizetype place = m_sensors[row].quantities.indexOf(key.quantity);
        if (m_sensors[row].number == key.number && place >= 0) {
            return createIndex(static_cast<int>(place), 0, row + 1);
        }
    }
    return {};
}

std::optional<SeriesKey> CurveModel::keyOf(const QModelIndex &index) const
{
    if (!index.isValid() || index.internalId() == ofSensor) {
        return {};
    }
    const Sensor &sensor = m_sensors.at(index.internalId() - 1);
    return SeriesKey{sensor.number, sensor.quantities.at(index.row())};
}

QModelIndex CurveModel::index(int row, int column, const QModelIndex &parent) const
{
    if (!hasIndex(row, column, parent)) {
        return {};
    }
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : ofSensor);
}

QModelIndex CurveModel::parent(const QModelIndex &child) const
{
    return keyOf(child) ? createIndex(static_cast<int>(child.internalId()) - 1, 0, ofSensor) : QModelIndex();
}

int CurveModel::rowCount(const QModelIndex &parent) const
{
    if (!parent.isValid()) {
        return static_cast<int>(m_sensors.size());
    }
    return keyOf(parent) ? 0 : static_cast<int>(m_sensors[static_cast<std::size_t>(parent.row())].quantities.size());
}

int CurveModel::columnCount(const QModelIndex &) const
{
    return 1;
}

QVariant CurveModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const std::optional<SeriesKey> key = keyOf(index);
    if (role == Qt::CheckStateRole && key) {
        return m_chosen.contains(*key) ? Qt::Checked : Qt::Unchecked;
    }
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) {
        return {};
    }
    return key ? plottext::quantity(key->quantity) : m_sensors[static_cast<std::size_t>(index.row())].title;
}

bool CurveModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    const std::optional<SeriesKey> key = keyOf(index);
    if (role != Qt::CheckStateRole || !key) {
        return false;
    }
    QList<SeriesKey> keys = m_chosen;
    keys.removeAll(*key);
    if (value.toInt() == Qt::Checked) {
        keys.append(*key);
    }
    setChosen(keys);
    return m_chosen == keys;
}

Qt::ItemFlags CurveModel::flags(const QModelIndex &index) const
{
    if (!index.isValid()) {
        return Qt::NoItemFlags;
    }
    const Qt::ItemFlags common = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return keyOf(index) ? common | Qt::ItemIsUserCheckable | Qt::ItemNeverHasChildren : common;
}

} // namespace gorizont
