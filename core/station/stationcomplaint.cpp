#include "core/station/stationcomplaint.h"

#include <QCoreApplication>

namespace gorizont::station {

namespace {

struct Station
{
    Q_DECLARE_TR_FUNCTIONS(Station)
};

} // namespace

QString StationComplaint::text() const
{
    QStringList place{file};
    if (line > 0) {
        place.append(Station::tr("line %1").arg(line));
    }
    if (field > 0) {
        place.append(
            Station::tr("field %1").arg(field)
            + (fieldName.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(fieldName)));
    }
    return place.join(QStringLiteral(", ")) + QStringLiteral(": ") + problem
        + (action.isEmpty() ? QString() : u' ' + action);
}

void Complaints::add(const StationComplaint &complaint)
{
    if (m_list.size() < limit) {
        m_list.append(complaint);
    } else {
        ++m_omitted;
    }
}

QList<StationComplaint> Complaints::list() const
{
    QList<StationComplaint> all = m_list;
    if (m_omitted > 0) {
        StationComplaint more;
        more.file = m_list.last().file;
        more.problem = Station::tr("… and %1 more.").arg(m_omitted);
        all.append(more);
    }
    return all;
}

QString quoted(const QString &text)
{
    constexpr qsizetype longest = 60;
    QString shown = text.size() > longest ? text.left(longest) + u'…' : text;
    for (QChar &character : shown) {
        if (!character.isPrint()) {
            character = u'·';
        }
    }
    return u'“' + shown + u'”';
}

} // namespace gorizont::station
