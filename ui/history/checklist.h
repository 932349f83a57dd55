#pragma once

#include "core/values/sensorconfig.h"

#include <QWidget>

class QCheckBox;
class QListWidget;

namespace gorizont {

/// A list of things with a mark each, and one mark for all of them. GUI thread.
class CheckList : public QWidget
{
    Q_OBJECT

public:
    /// \a all is the title of the mark for all.
    CheckList(const QString &objectName, const QString &all, QWidget *parent = nullptr);

    void add(const QString &title, int id); ///< marked
    void setChosen(const QList<int> &ids); ///< these, and no others
    QList<int> chosen() const; ///< ids, in the order of the list

Q_SIGNALS:
    void changed();

private:
    void markAll(bool isMarked);
    void follow();

    QCheckBox *m_all;
    QListWidget *m_list;
};

} // namespace gorizont
