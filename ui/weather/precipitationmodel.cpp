#include "ui/weather/precipitationmodel.h"

#include "ui/models/valuetext.h"

namespace gorizont {

void PrecipitationModel::setSpells(const QList<Precipitation> &spells, precipitation::StationClock clock)
{
    if (spells == m_spells && clock == m_clock) {
        return;
    }
    beginResetModel();
    m_spells = spells;
    m_clock = clock;
    endResetModel();
}

void PrecipitationModel::setNow(qint64 now)
{
    if (now == m_now) {
        return;
    }
    m_now = now;
    if (!m_spells.isEmpty() && m_spells.constFirst().isGoingOn) {
        Q_EMIT dataChanged(index(0, Duration), index(0, Duration));
    }
}

int PrecipitationModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_spells.size());
}

int PrecipitationModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString PrecipitationModel::time(std::optional<qint64> seconds) const
{
    return seconds ? precipitation::localTime(*seconds, m_clock).toString(QStringLiteral("dd.MM.yyyy HH:mm:ss"))
                   : valuetext::absent();
}

QString PrecipitationModel::text(const Precipitation &spell, int column) const
{
    switch (column) {
    case Begin: return time(spell.begin);
    case End: return spell.isGoingOn ? tr("goes on") : time(spell.end);
    default: break;
    }
    const auto end = spell.isGoingOn ? std::optional(m_now) : spell.end;
    // The clock of a station may be behind ours, or have been set back meanwhile.
    return spell.begin && end && *end >= *spell.begin ? valuetext::duration(std::chrono::seconds(*end - *spell.begin))
                                                      : valuetext::absent();
}

QVariant PrecipitationModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    switch (role) {
    case Qt::DisplayRole: return text(m_spells.at(index.row()), index.column());
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::AlignVCenter | (index.column() == Duration ? Qt::AlignRight : Qt::AlignLeft));
    default: return {};
    }
}

QVariant PrecipitationModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    const bool isTip = role == Qt::ToolTipRole;
    if (role == Qt::TextAlignmentRole) {
        return QVariant::fromValue(Qt::AlignVCenter | (section == Duration ? Qt::AlignRight : Qt::AlignLeft));
    }
    if (role != Qt::DisplayRole && !isTip) {
        return {};
    }
    switch (section) {
    case Begin: return isTip ? tr("When it began to rain, local time, by the clock of the station") : tr("Rain began");
    case End: return isTip ? tr("When the rain ended, local time, by the clock of the station") : tr("Rain ended");
    case Duration: return isTip ? tr("How long it rained, h:mm:ss") : tr("Duration");
    default: return {};
    }
}

} // namespace gorizont
