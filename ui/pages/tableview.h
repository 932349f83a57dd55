#pragma once

#include <QTableView>

namespace gorizont {

class TableColumns;

/// A table as all pages show it: rows of one height, whole rows selected, copied as lines of TAB-separated fields, and
/// a sentence instead of rows while there are none. GUI thread.
class TableView : public QTableView
{
    Q_OBJECT

public:
    explicit TableView(const QString &objectName, QWidget *parent = nullptr);

    TableColumns &columns() const { return *m_columns; }

    struct Rows
    {
        int first = 0;
        int last = -1;
    };
    /// The rows that can be seen now; none: first > last.
    Rows visibleRows() const;

    /// From now on the newest row stays in sight until somebody scrolls away from the end.
    void followEnd();

    /// Shown while there are no rows: why there are none, or what will bring them.
    void setEmptyText(const QString &text);
    QString emptyText() const { return m_emptyText; }

    /// The selected rows, in the order of the screen.
    QString selectionAsText() const;
    /// All rows, below their headings if the table shows any.
    QString tableAsText() const;

public Q_SLOTS:
    void copyCell();
    void copySelection();
    void copyTable();

Q_SIGNALS:
    /// Double click or Enter.
    void rowChosen(const QModelIndex &index);

protected:
    void rowsAboutToBeRemoved(const QModelIndex &parent, int first, int last) override;
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    void addActions();
    QAction *addCopyAction(const QString &title, const char *objectName, void (TableView::*copy)());
    void updateActions();

    TableColumns *m_columns;
    QString m_emptyText;
    QAction *m_copyCell = nullptr;
    QAction *m_copyRows = nullptr;
    QAction *m_copyTable = nullptr;
};

} // namespace gorizont
