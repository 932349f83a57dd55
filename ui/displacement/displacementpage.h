#pragma once

#include "core/registry/sensorregistry.h"
#include "ui/displacement/profilezero.h"

#include <QWidget>

#include <functional>

class QComboBox;
class QLabel;
class QPushButton;
class QTimer;

namespace gorizont {

class ProfileModel;
class ProfilePlot;
class TableView;

/// The tab <Перемещения>: the shape of a chain of tilt sensors in both planes, now and against a stored zero, and the
/// same as a table. GUI thread.
class DisplacementPage : public QWidget
{
    Q_OBJECT

public:
    /// \a zeroFolder: where the zeros are kept; it is made when the first is stored. The registry outlives the page.
    DisplacementPage(const SensorRegistry &registry, const QString &zeroFolder, QWidget *parent = nullptr);

    /// Draws the chosen chain by the last readings; twice a second by itself while the page is seen.
    void refresh();

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void build();
    QWidget *makeBar();
    void choose(int row);
    void storeZero();
    void keep(const ProfileZero &zero);
    void removeZero();
    void ask(const char *name, const QString &text, const QString &yes, const std::function<void()> &go);
    void forgetZero();
    void tellZero();
    void warn(const QString &text);

    const SensorRegistry &m_registry;
    ProfileZeroFiles m_files;
    std::optional<ProfileZero> m_zero; ///< of the chosen chain
    std::vector<ChainNode> m_nodes; ///< as last drawn
    QComboBox *m_chain;
    QPushButton *m_store;
    QPushButton *m_remove;
    QLabel *m_zeroText;
    ProfilePlot *m_x;
    ProfilePlot *m_y;
    ProfileModel *m_model;
    TableView *m_table;
    QTimer *m_tick; ///< while the page is seen
};

} // namespace gorizont
