#pragma once

#include "ui/plots/cursormodel.h"

#include <QWidget>

class QLabel;

namespace gorizont {

class TableView;

/// Below a trend: where the cursors are and what the curves do between them. GUI thread.
class CursorPanel : public QWidget
{
    Q_OBJECT

public:
    explicit CursorPanel(QWidget *parent = nullptr);

    void setRows(const QList<CursorModel::Row> &rows, TiltUnit unit);
    void setMoments(UtcTime first, UtcTime second);

private:
    void setColumns();

    CursorModel *m_model;
    QLabel *m_moments;
    TableView *m_view;
};

} // namespace gorizont
