#pragma once

#include <QObject>

class QTableView;

namespace gorizont {

/// Keeps the newest row of a table in sight until somebody scrolls away from the end, and again once he is back there.
/// What he reads meanwhile stays where it is, also when old rows go. GUI thread.
class EndFollower : public QObject
{
    Q_OBJECT

public:
    /// The model of \a table is set.
    explicit EndFollower(QTableView *table);

private:
    void onRangeChanged(int maximum);
    void onRowsRemoved(int first, int count);

    QTableView *m_table;
    bool m_isFollowing = true;
};

} // namespace gorizont
