#pragma once

#include <QList>
#include <QWidget>

class QTableWidget;

namespace gorizont {

/// Settings of an L-VIMS that are not the same in use (CUR), prepared (MUT) and in the form, one row each. GUI thread.
class VimsComparison : public QWidget
{
    Q_OBJECT

public:
    explicit VimsComparison(QWidget *parent = nullptr);

    /// All of a module each; empty: it is not known.
    void compare(const QList<quint16> &inUse, const QList<quint16> &prepared, const QList<quint16> &wanted);
    int differences() const;
    QWidgetList tabOrder() const;

private:
    QTableWidget *m_table;
};

} // namespace gorizont
