#include "core/registry/journal.h"

namespace gorizont {

void Journal::add(JournalKind kind, const QString &text)
{
    append({kind, utcNow(), text});
}

void Journal::append(const JournalEntry &entry)
{
    m_entries.push_back(entry);
    if (m_entries.size() > capacity) {
        m_entries.pop_front();
    }
    ++m_total;
    Q_EMIT added(entry);
}

} // namespace gorizont
