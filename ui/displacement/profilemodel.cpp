#include "ui/displacement/profilemodel.h"

#include "ui/models/valuetext.h"

namespace gorizont {

namespace {

constexpr int millimetreDigits = 2;

template <double Displacement::*member> QString millimetres(const std::optional<Displacement> &shift)
{
    return valuetext::signedFixed(shift ? std::optional((*shift).*member) : std::nullopt, millimetreDigits);
}

} // namespace

ProfileModel::ProfileModel(const SensorRegistry &registry, QObject *parent)
    : QAbstractTableModel(parent)
    , m_registry(registry)
{
}

void ProfileModel::setNodes(const std::vector<ChainNode> &nodes, const std::optional<ProfileZero> &zero)
{
    const bool isSameShape = nodes.size() == m_nodes.size();
    if (!isSameShape) {
        beginResetModel();
    }
    m_nodes = nodes;
    m_zero = zero;
    if (!isSameShape) {
        endResetModel();
    } else if (!m_nodes.empty()) {
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    }
}

int ProfileModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_nodes.size());
}

int ProfileModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

std::optional<Displacement> ProfileModel::change(const ChainNode &node) const
{
    const auto before = m_zero ? m_zero->at(node) : std::nullopt;
    if (!before || !node.sum) {
        return {};
    }
    return Displacement{node.sum->x - before->x, node.sum->y - before->y};
}

QString ProfileModel::text(const ChainNode &node, int column) const
{
    const int index = m_registry.indexOf(node.number);
    const SensorRegistry::Sensor &sensor = m_registry.sensors()[static_cast<std::size_t>(index)];
    const auto tilt = validTilt(sensor.reading);
    switch (column) {
    case Number: return QString::number(node.number);
    case Place: return valuetext::orAbsent(sensor.config.place);
    case Height: return valuetext::fixed(node.height, 2);
    case TiltX: return valuetext::degrees(tilt ? std::optional(tilt->x) : std::nullopt);
    case TiltY: return valuetext::degrees(tilt ? std::optional(tilt->y) : std::nullopt);
    case OwnX: return millimetres<&Displacement::x>(node.own);
    case OwnY: return millimetres<&Displacement::y>(node.own);
    case SumX: return millimetres<&Displacement::x>(node.sum);
    case SumY: return millimetres<&Displacement::y>(node.sum);
    case ChangeX: return millimetres<&Displacement::x>(change(node));
    case ChangeY: return millimetres<&Displacement::y>(change(node));
    default: return {};
    }
}

QVariant ProfileModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    switch (role) {
    case Qt::DisplayRole:
        return text(m_nodes[m_nodes.size() - 1 - static_cast<std::size_t>(index.row())], index.column());
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::AlignVCenter | (index.column() >= Height ? Qt::AlignRight : Qt::AlignLeft));
    default: return {};
    }
}

QVariant ProfileModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant::fromValue(Qt::AlignVCenter | (section >= Height ? Qt::AlignRight : Qt::AlignLeft));
    }
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) {
        return {};
    }
    const bool isTip = role == Qt::ToolTipRole;
    switch (section) {
    case Number: return isTip ? tr("Number of the sensor") : tr("No.");
    case Place: return isTip ? tr("Where the sensor is installed") : tr("Place");
    case Height: return isTip ? tr("Upper end of the link over the foot of the chain, m") : tr("H, m");
    case TiltX: return isTip ? tr("Tilt along X, degrees") : tr("Mx, °");
    case TiltY: return isTip ? tr("Tilt along Y, degrees") : tr("My, °");
    case OwnX: return isTip ? tr("Displacement along X over the link, L·sin α, mm") : tr("Link X, mm");
    case OwnY: return isTip ? tr("Displacement along Y over the link, L·sin α, mm") : tr("Link Y, mm");
    case SumX: return isTip ? tr("Displacement along X over the foot of the chain, mm") : tr("X, mm");
    case SumY: return isTip ? tr("Displacement along Y over the foot of the chain, mm") : tr("Y, mm");
    case ChangeX: return isTip ? tr("Displacement along X since the zero was stored, mm") : tr("ΔX, mm");
    case ChangeY: return isTip ? tr("Displacement along Y since the zero was stored, mm") : tr("ΔY, mm");
    default: return {};
    }
}

} // namespace gorizont
