#pragma once

#include "core/registry/journal.h"

#include <QWidget>

class QHBoxLayout;

namespace gorizont {

class JournalFilter;
class TableView;

/// The tab <Журнал>: the events, which kinds of them are shown, and a text to find in them. GUI thread.
class JournalPage : public QWidget
{
    Q_OBJECT

public:
    explicit JournalPage(const Journal &journal, QWidget *parent = nullptr);

private:
    void addKind(QHBoxLayout *bar, JournalKind kind, const QString &title, const QString &objectName);

    void addSearch(QHBoxLayout *bar);
    void onFilterChanged();

    JournalFilter *m_filter;
    TableView *m_view;
};

} // namespace gorizont
