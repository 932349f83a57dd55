#include "ui/models/sitetreemodel.h"

#include "ui/models/colours.h"
#include "ui/models/icons.h"
#include "ui/models/statetext.h"

#include <algorithm>

namespace gorizont {

namespace {

/// The internal id holds the item itself: two bits of kind, the rest the index.
quintptr idOf(SiteItem item)
{
    return static_cast<quintptr>(item.index) << 2 | static_cast<quintptr>(item.kind);
}

} // namespace

SiteTreeModel::SiteTreeModel(const SensorRegistry &registry, QObject *parent)
    : QAbstractItemModel(parent)
    , m_registry(registry)
    , m_rowOfSensor(registry.sensors().size(), 0)
    , m_sensorHealth(registry.sensors().size(), Health::Off)
    , m_lineHealth(registry.lines().size(), Health::Off)
{
    for (const SensorRegistry::Line &line : registry.lines()) {
        for (std::size_t row = 0; row < line.sensors.size(); ++row) {
            m_rowOfSensor[static_cast<std::size_t>(line.sensors[row])] = static_cast<int>(row);
        }
    }
    refresh();
}

SiteItem SiteTreeModel::itemAt(const QModelIndex &index) const
{
    if (!index.isValid()) {
        return SiteItem::server();
    }
    return {static_cast<SiteItem::Kind>(index.internalId() & 3), static_cast<int>(index.internalId() >> 2)};
}

QModelIndex SiteTreeModel::indexOf(SiteItem item) const
{
    switch (item.kind) {
    case SiteItem::Kind::Server: return createIndex(0, 0, idOf(item));
    case SiteItem::Kind::Line: return createIndex(item.index, 0, idOf(item));
    case SiteItem::Kind::Sensor:
        return createIndex(m_rowOfSensor.at(static_cast<std::size_t>(item.index)), 0, idOf(item));
    }
    return {};
}

QModelIndex SiteTreeModel::index(int row, int column, const QModelIndex &parent) const
{
    if (!hasIndex(row, column, parent)) {
        return {};
    }
    if (!parent.isValid()) {
        return indexOf(SiteItem::server());
    }
    const SiteItem item = itemAt(parent);
    return item.kind == SiteItem::Kind::Server
        ? indexOf(SiteItem::line(row))
        : indexOf(SiteItem::sensor(lineOf(item.index).sensors[static_cast<std::size_t>(row)]));
}

QModelIndex SiteTreeModel::parent(const QModelIndex &child) const
{
    if (!child.isValid()) {
        return {};
    }
    const SiteItem item = itemAt(child);
    switch (item.kind) {
    case SiteItem::Kind::Server: return {};
    case SiteItem::Kind::Line: return indexOf(SiteItem::server());
    case SiteItem::Kind::Sensor: return indexOf(SiteItem::line(sensorOf(item.index).line));
    }
    return {};
}

int SiteTreeModel::rowCount(const QModelIndex &parent) const
{
    if (!parent.isValid()) {
        return 1;
    }
    const SiteItem item = itemAt(parent);
    switch (item.kind) {
    case SiteItem::Kind::Server: return static_cast<int>(m_registry.lines().size());
    case SiteItem::Kind::Line: return static_cast<int>(lineOf(item.index).sensors.size());
    case SiteItem::Kind::Sensor: break;
    }
    return 0;
}

int SiteTreeModel::columnCount(const QModelIndex &) const
{
    return 1;
}

QVariant SiteTreeModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const SiteItem item = itemAt(index);
    switch (role) {
    case Qt::DisplayRole: return title(item);
    case Qt::ToolTipRole: return toolTip(item);
    case Qt::DecorationRole: break;
    case Qt::ForegroundRole: return shownHealth(item) == Health::Off ? QVariant(colours::mutedText()) : QVariant();
    default: return {};
    }
    switch (item.kind) {
    case SiteItem::Kind::Server: return icons::tree(icons::Node::Server, m_serverHealth);
    case SiteItem::Kind::Line: return icons::tree(icons::Node::Port, shownHealth(item));
    case SiteItem::Kind::Sensor: return icons::tree(icons::nodeOf(sensorOf(item.index).config.type), shownHealth(item));
    }
    return {};
}

Qt::ItemFlags SiteTreeModel::flags(const QModelIndex &index) const
{
    const bool isDraggable = index.isValid() && itemAt(index).kind != SiteItem::Kind::Server;
    return QAbstractItemModel::flags(index) | (isDraggable ? Qt::ItemIsDragEnabled : Qt::NoItemFlags);
}

QMimeData *SiteTreeModel::mimeData(const QModelIndexList &indexes) const
{
    QStringList numbers;
    for (const QModelIndex &index : indexes) {
        const SiteItem item = itemAt(index);
        if (item.kind == SiteItem::Kind::Sensor) {
            numbers += QString::number(sensorOf(item.index).config.number);
        } else if (item.kind == SiteItem::Kind::Line) {
            for (const int sensor : lineOf(item.index).sensors) {
                numbers += QString::number(sensorOf(sensor).config.number);
            }
        }
    }
    auto *data = new QMimeData;
    data->setData(sensorsFormat(), numbers.join(u' ').toLatin1());
    return data;
}

QList<int> SiteTreeModel::sensorsOf(const QMimeData &data)
{
    QList<int> numbers;
    for (const QByteArray &number : data.data(sensorsFormat()).split(' ')) {
        bool isNumber = false;
        const int value = number.toInt(&isNumber);
        if (isNumber) {
            numbers.append(value);
        }
    }
    return numbers;
}

Health SiteTreeModel::shownHealth(SiteItem item) const
{
    switch (item.kind) {
    case SiteItem::Kind::Server: return m_serverHealth;
    case SiteItem::Kind::Line: return m_lineHealth.at(static_cast<std::size_t>(item.index));
    case SiteItem::Kind::Sensor: return m_sensorHealth.at(static_cast<std::size_t>(item.index));
    }
    return Health::Off;
}

QString SiteTreeModel::title(SiteItem item) const
{
    switch (item.kind) {
    case SiteItem::Kind::Server: return tr("Server");
    case SiteItem::Kind::Line: return lineOf(item.index).config.title();
    case SiteItem::Kind::Sensor: return statetext::sensorTitle(sensorOf(item.index).config);
    }
    return {};
}

/// The whole title first: a narrow tree leaves out its middle.
QString SiteTreeModel::toolTip(SiteItem item) const
{
    QStringList lines{title(item)};
    switch (item.kind) {
    case SiteItem::Kind::Server: lines += statetext::health(m_serverHealth); break;
    case SiteItem::Kind::Line:
        lines += lineOf(item.index).config.name;
        lines += statetext::line(lineOf(item.index).status.state);
        break;
    case SiteItem::Kind::Sensor:
        lines += sensorOf(item.index).config.name;
        lines += statetext::sensor(sensorOf(item.index), lineOf(sensorOf(item.index).line).status.state);
        break;
    }
    lines.removeAll(QString());
    return lines.join(u'\n');
}

void SiteTreeModel::refresh()
{
    Health worst = Health::Off;
    for (std::size_t i = 0; i < m_lineHealth.size(); ++i) {
        const int line = static_cast<int>(i);
        const Health health = portHealth(lineOf(line).status.state, refreshSensors(line));
        worst = std::max(worst, health);
        if (std::exchange(m_lineHealth[i], health) != health) {
            announce(indexOf(SiteItem::line(line)), indexOf(SiteItem::line(line)));
        }
    }
    if (std::exchange(m_serverHealth, worst) != worst) {
        announce(indexOf(SiteItem::server()), indexOf(SiteItem::server()));
    }
}

Health SiteTreeModel::refreshSensors(int line)
{
    const SensorRegistry::Line &port = lineOf(line);
    Health worst = Health::Off;
    int first = -1;
    int last = -1;
    for (const int sensor : port.sensors) {
        const Health health = sensorHealth(sensorOf(sensor), port.status.state);
        worst = std::max(worst, health);
        if (std::exchange(m_sensorHealth[static_cast<std::size_t>(sensor)], health) != health) {
            first = first < 0 ? sensor : first;
            last = sensor;
        }
    }
    if (first >= 0) {
        announce(indexOf(SiteItem::sensor(first)), indexOf(SiteItem::sensor(last)));
    }
    return worst;
}

void SiteTreeModel::announce(const QModelIndex &first, const QModelIndex &last)
{
    Q_EMIT dataChanged(first, last, {Qt::DecorationRole, Qt::ForegroundRole, Qt::ToolTipRole});
}

} // namespace gorizont
