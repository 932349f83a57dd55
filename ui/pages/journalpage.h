#pragma once

#include "core/registry/journal.h"

#include <QWidget>

class QHBoxLayout;

namespace gorizont {

class JournalFilter;

/// The tab <Журнал>: the events and which kinds of them are shown. GUI thread.
class JournalPage : public QWidget
{
    Q_OBJECT

public:
    explicit JournalPage(const Journal &journal, QWidget *parent = nullptr);

private:
    void addKind(QHBoxLayout *bar, JournalKind kind, const QString &title, const QString &objectName);

    JournalFilter *m_filter;
};

} // namespace gorizont
