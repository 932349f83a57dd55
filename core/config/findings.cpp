#include "core/config/findings.h"

#include <QCoreApplication>

#include <algorithm>

namespace gorizont {

namespace {

QString printable(QString text)
{
    constexpr qsizetype longest = 60;
    if (text.size() > longest) {
        text = text.left(longest) + u'…';
    }
    for (QChar &character : text) {
        if (!character.isPrint()) {
            character = u'·';
        }
    }
    return text;
}

} // namespace

QString Complaint::text() const
{
    QStringList place;
    if (!section.isEmpty()) {
        place.append(u'[' + printable(section) + u']');
    }
    if (!key.isEmpty()) {
        place.append(printable(key));
    }
    QString where = place.join(u' ');
    if (line > 0) {
        const QString inLine = QCoreApplication::translate("ServerConfig", "line %1").arg(line);
        where += where.isEmpty() ? inLine : QStringLiteral(", ") + inLine;
    }
    if (!where.isEmpty()) {
        where += QStringLiteral(": ");
    }
    return where + (action.isEmpty() ? problem : problem + u' ' + action);
}

void Findings::add(const Complaint &complaint)
{
    if (m_complaints.size() < limit) {
        m_complaints.append(complaint);
    } else {
        ++m_omitted;
    }
}

void Findings::addReplaced(const QString &section, const QString &key, const QString &asWritten)
{
    constexpr qsizetype longestShown = 200; // characters
    m_replaced.insert(QString(section + u'/' + key).toLower(), asWritten.left(longestShown));
}

QList<Complaint> Findings::complaints() const
{
    QList<Complaint> sorted = m_complaints;
    std::stable_sort(sorted.begin(), sorted.end(), [](const Complaint &a, const Complaint &b) {
        return a.line < b.line;
    });
    if (m_omitted > 0) {
        sorted.append({{}, {}, 0, QCoreApplication::translate("ServerConfig", "… and %1 more.").arg(m_omitted), {}});
    }
    return sorted;
}

QString quoted(const QString &text)
{
    return u'“' + printable(text) + u'”';
}

} // namespace gorizont
