#pragma once

#include "ui/models/health.h"
#include "ui/models/siteitem.h"

#include <QAbstractItemModel>
#include <QMimeData>

#include <vector>

namespace gorizont {

/// Server → ports → sensors, over the registry (manual 000, section 4.1). Nothing is drawn anew until refresh() finds
/// a node whose state has changed. GUI thread.
class SiteTreeModel : public QAbstractItemModel
{
    Q_OBJECT

public:
    explicit SiteTreeModel(const SensorRegistry &registry, QObject *parent = nullptr);

    SiteItem itemAt(const QModelIndex &index) const;
    QModelIndex indexOf(SiteItem item) const;

    /// Compares the state of every node with the one last shown; announces only those that differ.
    void refresh();

    Health shownHealth(SiteItem item) const;

    QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    QModelIndex parent(const QModelIndex &child) const override;
    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;

    /// Sensors are dragged, and a port with all of its sensors: their numbers in decimal with blanks between.
    QStringList mimeTypes() const override { return {sensorsFormat()}; }
    QMimeData *mimeData(const QModelIndexList &indexes) const override;
    static QString sensorsFormat() { return QStringLiteral("application/x-gorizont-sensors"); }
    static QList<int> sensorsOf(const QMimeData &data);

private:
    const SensorRegistry::Line &lineOf(int index) const { return m_registry.lines()[static_cast<std::size_t>(index)]; }
    const SensorRegistry::Sensor &sensorOf(int index) const
    {
        return m_registry.sensors()[static_cast<std::size_t>(index)];
    }
    QString title(SiteItem item) const;
    QString toolTip(SiteItem item) const;
    Health refreshSensors(int line);
    void announce(const QModelIndex &first, const QModelIndex &last);

    const SensorRegistry &m_registry;
    std::vector<int> m_rowOfSensor; ///< within its port
    std::vector<Health> m_sensorHealth; ///< as last shown
    std::vector<Health> m_lineHealth;
    Health m_serverHealth = Health::Off;
};

} // namespace gorizont
