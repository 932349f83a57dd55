#pragma once

#include "core/values/journalentry.h"

#include <QObject>

#include <deque>

namespace gorizont {

/// The user's journal: the events of this run, newest last. Main thread. The file half is a consumer of added().
class Journal : public QObject
{
    Q_OBJECT

public:
    /// Keeps this many entries for the window; the file keeps all.
    static constexpr std::size_t capacity = 10000;

    using QObject::QObject;

    const std::deque<JournalEntry> &entries() const { return m_entries; }

    /// Number of entries ever added: the index of the first kept one is total() − entries().size().
    quint64 total() const { return m_total; }

    void add(JournalKind kind, const QString &text);

public Q_SLOTS:
    void append(const gorizont::JournalEntry &entry);

Q_SIGNALS:
    void added(const gorizont::JournalEntry &entry);

private:
    std::deque<JournalEntry> m_entries;
    quint64 m_total = 0;
};

} // namespace gorizont
