#pragma once

#include "core/registry/sensorregistry.h"
#include "ui/displacement/profilezero.h"

#include <QAbstractTableModel>

namespace gorizont {

/// The table of a chain, one row a node, the top of the building in the first row. GUI thread.
class ProfileModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Number, Place, Height, TiltX, TiltY, OwnX, OwnY, SumX, SumY, ChangeX, ChangeY, ColumnCount };

    explicit ProfileModel(const SensorRegistry &registry, QObject *parent = nullptr);

    void setNodes(const std::vector<ChainNode> &nodes, const std::optional<ProfileZero> &zero);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString text(const ChainNode &node, int column) const;
    std::optional<Displacement> change(const ChainNode &node) const;

    const SensorRegistry &m_registry;
    std::vector<ChainNode> m_nodes; ///< from the bottom
    std::optional<ProfileZero> m_zero;
};

} // namespace gorizont
