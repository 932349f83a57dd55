#include "ui/pages/tabletext.h"

#include <QAbstractItemModel>
#include <QHeaderView>
#include <QStringList>

namespace gorizont::tabletext {

namespace {

QList<int> columnsOnScreen(const QHeaderView &header)
{
    QList<int> columns;
    for (int place = 0; place < header.count(); ++place) {
        const int column = header.logicalIndex(place);
        if (!header.isSectionHidden(column)) {
            columns += column;
        }
    }
    return columns;
}

} // namespace

QString cell(const QString &text)
{
    QString field = text;
    for (const QChar end : {u'\t', u'\n', u'\r'}) {
        field.replace(end, u' ');
    }
    return field;
}

QString headings(const QHeaderView &header)
{
    QStringList fields;
    for (const int column : columnsOnScreen(header)) {
        fields += cell(header.model()->headerData(column, Qt::Horizontal).toString());
    }
    return fields.join(u'\t');
}

QString rows(const QHeaderView &header, const QList<int> &rows)
{
    const QList<int> columns = columnsOnScreen(header);
    QStringList lines;
    for (const int row : rows) {
        QStringList fields;
        for (const int column : columns) {
            fields += cell(header.model()->index(row, column).data().toString());
        }
        lines += fields.join(u'\t');
    }
    return lines.join(u'\n');
}

} // namespace gorizont::tabletext
