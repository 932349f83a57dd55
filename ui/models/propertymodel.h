#pragma once

#include "ui/models/property.h"

#include <QAbstractTableModel>

namespace gorizont {

/// Names and values of one thing, with headings between them. GUI thread.
class PropertyModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Name, Value, Note, ColumnCount };

    /// \a hasNotes: a third column is shown; otherwise the notes stand in the tool tips.
    explicit PropertyModel(bool hasNotes, QObject *parent = nullptr);

    /// Announces only the rows whose value has changed, or a reset if the names are others.
    void setProperties(const Properties &properties);
    const Properties &properties() const { return m_properties; }

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;

private:
    bool hasSameNames(const Properties &properties) const;

    Properties m_properties;
    bool m_hasNotes;
};

} // namespace gorizont
