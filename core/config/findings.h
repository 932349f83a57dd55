#pragma once

#include "core/config/serverconfig.h"

namespace gorizont {

/// What the readers of the ini find out beside the values: complaints and the values they could not use.
class Findings
{
public:
    /// More are only counted: a file that is none of ours must not fill the journal.
    static constexpr qsizetype limit = 200;

    void add(const Complaint &complaint);
    void addReplaced(const QString &section, const QString &key, const QString &asWritten);

    /// In the order of the lines; those about the whole file first, `… and N more` last.
    QList<Complaint> complaints() const;
    const QHash<QString, QString> &replaced() const { return m_replaced; }

private:
    QList<Complaint> m_complaints;
    qsizetype m_omitted = 0;
    QHash<QString, QString> m_replaced;
};

/// \a text from the file for a sentence: in one line, without control characters, not longer than a glance.
QString quoted(const QString &text);

} // namespace gorizont
