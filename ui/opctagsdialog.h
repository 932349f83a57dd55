#pragma once

#include <QDialog>

class QLineEdit;
class QSortFilterProxyModel;

namespace gorizont {

/// The tags of OPC DA, to look through, copy and save for a SCADA system. Work goes on behind it. GUI thread.
class OpcTagsDialog : public QDialog
{
    Q_OBJECT

public:
    /// \a list: name, type and description of each tag, parted by tabs, a line each. \a message: what was done just now; may be
    /// empty.
    OpcTagsDialog(const QString &list, const QString &message, QWidget *parent = nullptr);

private:
    QWidget *makeTable();
    QWidget *makeButtons();
    void askWhereToSave();
    void save(const QString &path);

    const QString m_list;
    QLineEdit *m_search;
    QSortFilterProxyModel *m_found;
};

} // namespace gorizont
