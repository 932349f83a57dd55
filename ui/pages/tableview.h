#pragma once

#include <QTableView>

namespace gorizont {

/// A table as all pages show it: rows of one height, whole rows selected, copied as lines of TAB-separated fields. GUI
/// thread.
class TableView : public QTableView
{
    Q_OBJECT

public:
    explicit TableView(const QString &objectName, QWidget *parent = nullptr);

    struct Rows
    {
        int first = 0;
        int last = -1;
    };
    /// The rows that can be seen now; none: first > last.
    Rows visibleRows() const;

    /// Width of a column from its heading and the widest text it is going to hold; cells are never measured.
    void setColumnSample(int column, const QString &widest);

    /// Column \a column takes what the others leave, but never less than \a least needs: then the table scrolls.
    void setElasticColumn(int column, const QString &least);

    /// From now on the newest row stays in sight until somebody scrolls away from the end.
    void followEnd();

    /// The selected rows, or the current one, in the order of the screen.
    QString selectionAsText() const;

public Q_SLOTS:
    void copySelection();

Q_SIGNALS:
    /// Double click or Enter.
    void rowChosen(const QModelIndex &index);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    bool isAtEnd() const;
    int sampleWidth(int column, const QString &widest) const;
    void stretchElasticColumn();

    int m_elasticColumn = -1; ///< −1: none
    int m_elasticWidth = 0; ///< at least
    bool m_wasAtEnd = true;
};

} // namespace gorizont
