#include "ui/models/attentionmodel.h"

#include "core/alarms/alarmtext.h"
#include "ui/models/valuetext.h"

#include <algorithm>

namespace gorizont {

namespace {

QString text(const Alarm &alarm, int column)
{
    switch (column) {
    case AttentionModel::Began: return valuetext::clock(alarm.began);
    case AttentionModel::Subject: return alarm.title;
    case AttentionModel::Place: return alarm.place.isEmpty() ? valuetext::absent() : alarm.place;
    case AttentionModel::Meaning: return alarmtext::meaning(alarm);
    case AttentionModel::Advice: return alarmtext::advice(alarm);
    default: return {};
    }
}

/// Sensors by N, whole ports before them; what is alike keeps the order of its time.
QVariant sortKey(const Alarm &alarm, int column)
{
    switch (column) {
    case AttentionModel::Began: return alarm.id;
    case AttentionModel::Subject: return alarm.isWholePort() ? alarm.port - 1000 : alarm.number;
    default: return text(alarm, column);
    }
}

bool contains(const Alarms &alarms, quint64 id)
{
    const auto found = std::lower_bound(alarms.begin(), alarms.end(), id, [](const Alarm &alarm, quint64 wanted) {
        return alarm.id < wanted;
    });
    return found != alarms.end() && found->id == id;
}

} // namespace

void AttentionModel::setAlarms(const Alarms &alarms)
{
    removeMissing(alarms);
    // What is left stands at the beginning of the new list, because ids only grow.
    const auto kept = m_alarms.size();
    for (qsizetype i = 0; i < kept; ++i) {
        if (m_alarms.at(i) != alarms.at(i)) {
            m_alarms[i] = alarms.at(i);
            const auto row = static_cast<int>(i);
            Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
        }
    }
    if (alarms.size() > kept) {
        beginInsertRows({}, static_cast<int>(kept), static_cast<int>(alarms.size()) - 1);
        m_alarms = alarms;
        endInsertRows();
    }
}

/// In runs from the end, so that accepting a whole site is one removal.
void AttentionModel::removeMissing(const Alarms &alarms)
{
    for (qsizetype last = m_alarms.size() - 1; last >= 0; --last) {
        if (contains(alarms, m_alarms.at(last).id)) {
            continue;
        }
        qsizetype first = last;
        while (first > 0 && !contains(alarms, m_alarms.at(first - 1).id)) {
            --first;
        }
        beginRemoveRows({}, static_cast<int>(first), static_cast<int>(last));
        m_alarms.remove(first, last - first + 1);
        endRemoveRows();
        last = first;
    }
}

int AttentionModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_alarms.size());
}

int AttentionModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant AttentionModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole: return text(alarmAt(index.row()), index.column());
    case SortRole: return sortKey(alarmAt(index.row()), index.column());
    default: return {};
    }
}

QVariant AttentionModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant::fromValue(Qt::Alignment(Qt::AlignVCenter | Qt::AlignLeft));
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case Began: return tr("Since");
    case Subject: return tr("Sensor or port");
    case Place: return tr("Place");
    case Meaning: return tr("What has happened");
    case Advice: return tr("What to do");
    default: return {};
    }
}

} // namespace gorizont
