#include "ui/models/journalmodel.h"

#include "ui/models/colours.h"
#include "ui/models/icons.h"
#include "ui/models/valuetext.h"

#include <QColor>
#include <QGuiApplication>
#include <QPalette>

namespace gorizont {

JournalModel::JournalModel(const Journal &journal, QObject *parent)
    : QAbstractListModel(parent)
    , m_journal(journal)
    , m_first(journal.total() - journal.entries().size())
    , m_end(journal.total())
{
    connect(&journal, &Journal::added, this, &JournalModel::follow);
}

/// The journal has grown by one, and may have dropped its oldest entry.
void JournalModel::follow()
{
    const quint64 first = m_journal.total() - m_journal.entries().size();
    if (first > m_first) {
        beginRemoveRows({}, 0, static_cast<int>(first - m_first) - 1);
        m_first = first;
        endRemoveRows();
    }
    if (m_journal.total() > m_end) {
        beginInsertRows({}, rowCount(), static_cast<int>(m_journal.total() - m_first) - 1);
        m_end = m_journal.total();
        endInsertRows();
    }
}

const JournalEntry *JournalModel::entryAt(int row) const
{
    const quint64 dropped = m_journal.total() - m_journal.entries().size();
    const quint64 number = m_first + static_cast<quint64>(row);
    return number < dropped ? nullptr : &m_journal.entries()[static_cast<std::size_t>(number - dropped)];
}

int JournalModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_end - m_first);
}

QVariant JournalModel::data(const QModelIndex &index, int role) const
{
    const JournalEntry *entry = index.isValid() ? entryAt(index.row()) : nullptr;
    if (!entry) {
        return {};
    }
    switch (role) {
    case Qt::DisplayRole: return QStringLiteral("%1   %2").arg(valuetext::clock(entry->time), entry->text);
    case Qt::ToolTipRole: return entry->text;
    case Qt::ForegroundRole: {
        const QColor colour = journalColour(entry->kind, colours::isDark(QGuiApplication::palette()));
        return colour.isValid() ? QVariant(colour) : QVariant();
    }
    case Qt::DecorationRole: return journalIcon(entry->kind);
    case KindRole: return static_cast<int>(entry->kind);
    default: return {};
    }
}

JournalFilter::JournalFilter(QObject *parent)
    : QSortFilterProxyModel(parent)
{
}

void JournalFilter::setShown(JournalKind kind, bool isShown)
{
    m_isShown.set(static_cast<std::size_t>(kind), isShown);
    invalidateRowsFilter();
}

void JournalFilter::setText(const QString &text)
{
    m_text = text.trimmed();
    invalidateRowsFilter();
}

bool JournalFilter::filterAcceptsRow(int row, const QModelIndex &parent) const
{
    const QModelIndex index = sourceModel()->index(row, 0, parent);
    const int kind = index.data(JournalModel::KindRole).toInt();
    return m_isShown.test(static_cast<std::size_t>(kind))
        && (m_text.isEmpty() || index.data().toString().contains(m_text, Qt::CaseInsensitive));
}

QIcon journalIcon(JournalKind kind)
{
    switch (kind) {
    case JournalKind::On: return icons::state(Health::Good);
    case JournalKind::Off: return icons::state(Health::Off);
    case JournalKind::Error: return icons::state(Health::Error);
    case JournalKind::Info: break;
    }
    return icons::information();
}

QColor journalColour(JournalKind kind, bool isDark)
{
    switch (kind) {
    case JournalKind::On: return isDark ? QColor(0x6c, 0xd0, 0x8a) : QColor(0x1a, 0x7f, 0x37);
    case JournalKind::Off: return isDark ? QColor(0x7d, 0xb4, 0xff) : QColor(0x0b, 0x57, 0xb0);
    case JournalKind::Error: return isDark ? QColor(0xff, 0x84, 0x84) : QColor(0xc0, 0x1c, 0x28);
    case JournalKind::Info: break;
    }
    return {};
}

} // namespace gorizont
