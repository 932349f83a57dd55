#pragma once

#include <QAbstractTableModel>

namespace gorizont {

/// What the files of a station that runs in this program have wrong (spec/mk14.md, "Files of the station").
struct StationFileComplaint
{
    QString file; ///< `ACK.PAR`
    int line = 0; ///< 1…; 0: the whole file
    int field = 0; ///< 1…; 0: the whole line
    QString fieldName; ///< empty: not known
    QString problem; ///< a sentence
    QString action; ///< a sentence: what was done
    bool operator==(const StationFileComplaint &) const = default;
};

/// Complaints about the files of a station, one row each. GUI thread.
class StationFilesModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { File, Line, Field, Problem, Action, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    void setComplaints(const QList<StationFileComplaint> &complaints);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QList<StationFileComplaint> m_complaints;
};

} // namespace gorizont
