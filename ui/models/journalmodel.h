#pragma once

#include "core/registry/journal.h"

#include <QAbstractListModel>
#include <QIcon>
#include <QSortFilterProxyModel>

#include <bitset>

namespace gorizont {

/// The tab <Журнал>: the events of the journal, newest last, coloured by kind (spec/gorizont.md, section 3). GUI thread.
class JournalModel : public QAbstractListModel
{
    Q_OBJECT

public:
    static constexpr int KindRole = Qt::UserRole; ///< JournalKind as int

    explicit JournalModel(const Journal &journal, QObject *parent = nullptr);

    int rowCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;

private:
    void follow();
    const JournalEntry *entryAt(int row) const;

    const Journal &m_journal;
    quint64 m_first; ///< number of the first row's entry, counted from the start of the journal
    quint64 m_end; ///< number after that of the last row's entry
};

/// Only the kinds that are switched on, and of them what holds the text looked for.
class JournalFilter : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    explicit JournalFilter(QObject *parent = nullptr);

    void setShown(JournalKind kind, bool isShown);
    void setText(const QString &text); ///< in whatever case; empty: everything

    /// Something of what the journal holds may be left out.
    bool isFiltering() const { return !m_isShown.all() || !m_text.isEmpty(); }

protected:
    bool filterAcceptsRow(int row, const QModelIndex &parent) const override;

private:
    std::bitset<4> m_isShown{0b1111};
    QString m_text;
};

/// Shape of a kind, so that its colour is not alone.
QIcon journalIcon(JournalKind kind);

/// Colour of a kind on a light or a dark background; invalid: that of all text.
QColor journalColour(JournalKind kind, bool isDark);

} // namespace gorizont
