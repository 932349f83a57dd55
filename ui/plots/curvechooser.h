#pragma once

#include "ui/plots/curvemodel.h"

#include <QWidget>

class QSortFilterProxyModel;
class QTreeView;

namespace gorizont {

class SearchField;

/// The list beside a trend, in which curves are ticked, with a field to find a sensor in it. GUI thread.
class CurveChooser : public QWidget
{
    Q_OBJECT

public:
    explicit CurveChooser(const SensorRegistry &registry, QWidget *parent = nullptr);

    CurveModel &model() const { return *m_model; }

private:
    void find(const QString &text);
    void showChosen();

    CurveModel *m_model;
    QSortFilterProxyModel *m_found;
    SearchField *m_search;
    QTreeView *m_view;
};

} // namespace gorizont
