#include "ui/history/gapmodel.h"

#include "ui/models/statetext.h"
#include "ui/models/valuetext.h"

#include <algorithm>

namespace gorizont {

void GapModel::setGaps(const QList<Gap> &gaps, UtcTime now)
{
    beginResetModel();
    m_gaps = gaps;
    m_now = now;
    endResetModel();
}

int GapModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_gaps.size());
}

int GapModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

UtcTime::duration GapModel::lengthOf(const Gap &gap) const
{
    return std::max(gap.to.value_or(m_now) - gap.from, UtcTime::duration::zero());
}

QString GapModel::text(const Gap &gap, int column) const
{
    switch (column) {
    case Sensor: {
        const auto found = std::find_if(m_sensors.begin(), m_sensors.end(), [&gap](const SensorConfig &sensor) {
            return sensor.number == gap.number;
        });
        return found == m_sensors.end() ? QString::number(gap.number) : statetext::sensorTitle(*found);
    }
    case From: return valuetext::clock(gap.from);
    case To: return gap.to ? valuetext::clock(*gap.to) : tr("goes on");
    case Length: return valuetext::duration(lengthOf(gap));
    case Reason: return gapReasonText(gap.reason);
    case FilledFrom: return valuetext::orAbsent(gap.filledFrom);
    default: return {};
    }
}

QVariant GapModel::sortKey(const Gap &gap, int column) const
{
    switch (column) {
    case Sensor: return gap.number;
    case From: return qint64(gap.from.time_since_epoch().count());
    case To: return qint64(gap.to.value_or(UtcTime::max()).time_since_epoch().count());
    case Length: return qint64(lengthOf(gap).count());
    case FilledFrom: return gap.filledFrom.isEmpty() ? QVariant() : QVariant(gap.filledFrom);
    default: return text(gap, column);
    }
}

QVariant GapModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const Gap &gap = m_gaps.at(index.row());
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole: return text(gap, index.column());
    case SortRole: return sortKey(gap, index.column());
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::AlignVCenter | (index.column() == Length ? Qt::AlignRight : Qt::AlignLeft));
    default: return {};
    }
}

QVariant GapModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant::fromValue(Qt::AlignVCenter | (section == Length ? Qt::AlignRight : Qt::AlignLeft));
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case Sensor: return tr("Sensor");
    case From: return tr("From");
    case To: return tr("To");
    case Length: return tr("Length");
    case Reason: return tr("Reason");
    case FilledFrom: return tr("Filled from");
    default: return {};
    }
}

QString gapReasonText(GapReason reason)
{
    switch (reason) {
    case GapReason::SensorOff: return GapModel::tr("the sensor was off");
    case GapReason::PortOff: return GapModel::tr("the port was off");
    case GapReason::PortError: return GapModel::tr("the port was not available");
    case GapReason::NoAnswer: return GapModel::tr("no answer");
    case GapReason::Crc: return GapModel::tr("wrong check sums");
    case GapReason::DeviceFault: return GapModel::tr("the sensor reported a fault");
    case GapReason::Service: return GapModel::tr("service mode");
    case GapReason::ProgramStopped: return GapModel::tr("the program was not running");
    case GapReason::Clock: return GapModel::tr("the clock was set");
    case GapReason::Disk: return GapModel::tr("the disk could not be written");
    }
    return {};
}

} // namespace gorizont
