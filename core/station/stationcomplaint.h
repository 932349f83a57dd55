#pragma once

#include <QList>
#include <QString>

namespace gorizont::station {

/// Something in the files of a station that is not as it should be. Never fatal: the station starts with what is good.
struct StationComplaint
{
    QString file; ///< `ACK.PAR`, as the station names it
    int line = 0; ///< 1…; 0: about the whole file
    int field = 0; ///< 1…, the place in the line; 0: about the whole line
    QString fieldName; ///< in the language of the user; empty: about the whole line
    QString problem; ///< one sentence: what is wrong
    QString action; ///< one sentence: what was done; empty: nothing had to be

    /// Worth knowing, but nothing is wrong.
    bool isRemark() const { return action.isEmpty(); }
    /// All of it in one line for the journal: `ACK.PAR, line 3, field 9 (left limit): … …`
    QString text() const;
    bool operator==(const StationComplaint &) const = default;
};

/// Collects complaints; more than \a limit are only counted: a file that is none of ours must not fill the journal.
class Complaints
{
public:
    static constexpr qsizetype limit = 200;

    void add(const StationComplaint &complaint);
    /// In the order in which they were found; `… and N more` last.
    QList<StationComplaint> list() const;

private:
    QList<StationComplaint> m_list;
    qsizetype m_omitted = 0;
};

/// \a text from a file for a sentence: in one line, without control characters, not longer than a glance.
QString quoted(const QString &text);

} // namespace gorizont::station
