#include "ui/weather/stationfilesmodel.h"

#include "ui/models/valuetext.h"

namespace gorizont {

namespace {

QString placeText(int place)
{
    return place > 0 ? QString::number(place) : valuetext::absent();
}

QString text(const StationFileComplaint &complaint, int column)
{
    switch (column) {
    case StationFilesModel::File: return complaint.file;
    case StationFilesModel::Line: return placeText(complaint.line);
    case StationFilesModel::Field:
        return complaint.fieldName.isEmpty()
            ? placeText(complaint.field)
            : QStringLiteral("%1 (%2)").arg(placeText(complaint.field), complaint.fieldName);
    case StationFilesModel::Problem: return complaint.problem;
    case StationFilesModel::Action: return valuetext::orAbsent(complaint.action);
    default: return {};
    }
}

} // namespace

void StationFilesModel::setComplaints(const QList<StationFileComplaint> &complaints)
{
    if (complaints != m_complaints) {
        beginResetModel();
        m_complaints = complaints;
        endResetModel();
    }
}

int StationFilesModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_complaints.size());
}

int StationFilesModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant StationFilesModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole: return text(m_complaints.at(index.row()), index.column());
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::AlignVCenter | (index.column() == Line ? Qt::AlignRight : Qt::AlignLeft));
    default: return {};
    }
}

QVariant StationFilesModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return QVariant::fromValue(Qt::AlignVCenter | (section == Line ? Qt::AlignRight : Qt::AlignLeft));
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case File: return tr("File");
    case Line: return tr("Line");
    case Field: return tr("Field");
    case Problem: return tr("What is wrong");
    case Action: return tr("What was done");
    default: return {};
    }
}

} // namespace gorizont
